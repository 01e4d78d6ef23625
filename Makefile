# `make play` and `make test`, the two commands of the README, install what they need. The other targets are for developers.
.PHONY: play test check bench book package install format lint fuzz clean shipped

SOURCES = find src tests bench fuzz -name '*.cpp' -o -name '*.h'
MAPS = start lq_e0m1 lq_e1m2
# Without game data, the program draws its small built-in level.
WITH_DATA = $(if $(TEMBLOR_DATA),--basedir "$(TEMBLOR_DATA)")
DEMOS = demo1_lite demo2_lite demo3_lite
BENCHED = $(if $(TEMBLOR_DATA),$(addprefix --map ,$(MAPS)) $(addprefix --demo ,$(DEMOS)))

play:
	tools/play.sh
# Format, spelling, the release build, and its tests. Run it before every commit.
test:
	tools/run_tests.sh test
# Everything: also the shipped game, sanitizers, fuzzing, other engines, and packages.
check:
	tools/run_tests.sh check

bench:
	tools/setup.sh build
	cmake --preset release
	cmake --build --preset release --target temblor benchmarks game shipped_game game_tours
	build/release/temblor $(WITH_DATA) bench --report $(BENCHED)
	for color in indexed rgb; do \
	  build/release/temblor $(WITH_DATA) bench --views 64 --threads 2 --color $$color \
	    $(if $(TEMBLOR_DATA),$(addprefix --map ,$(MAPS))) || exit; \
	done
	tools/measure_game.sh
	tools/measure_latency.sh
	$(if $(TEMBLOR_DATA),build/release/bench/compile_bench build/release/temblor)
	-build/release/temblor --basedir build/release/game bench --demo t3 --renderer gl
	build/release/bench/kernel_bench
	build/release/bench/vm_bench
	build/release/bench/server_bench
	$(if $(TEMBLOR_DATA),build/release/bench/client_server_bench build/release/game/id1/progs.dat)
	$(if $(TEMBLOR_DATA),build/release/bench/host_bench build/release/game/id1/progs.dat)

# Compares the laboratory's techniques on three levels of the game. Begin with build/release/book/index.html.
book: shipped
	build/release/temblor --basedir build/release/game lab book --map start --map t1 --map t3 -o build/release/book

# Writes a Debian package and two archives to build/release.
package: shipped
	tools/make_packages.sh
# The default is PREFIX=/usr/local.
install: shipped
	cmake --install build/release --component game --prefix "$(or $(PREFIX),/usr/local)"
shipped:
	tools/setup.sh build
	cmake --preset release
	cmake --build --preset release --target temblor shipped_game

format:
	$(SOURCES) | xargs clang-format-14 -i
lint:
	tools/lint.sh

# Fuzzes each target for a minute. New inputs and crashing inputs are written to build/sanitize/found/.
fuzz:
	tools/setup.sh check
	cmake --preset sanitize -DTEMBLOR_FUZZ_SECONDS=60
	cmake --build --preset sanitize --target fuzz_programs
	ctest --preset sanitize --parallel $$(nproc) -L fuzz

clean:
	rm -rf build out
