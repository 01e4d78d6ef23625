# The README's two commands, `make play` and `make test`, do all set-up themselves; the rest is for working on it.
.PHONY: play test bench package install format lint fuzz clean shipped

SOURCES = find src tests bench fuzz game -name '*.cpp' -o -name '*.h'
MAPS = start lq_e0m1 lq_e1m2
# Without game data the program draws the level that it makes in code.
WITH_DATA = $(if $(TEMBLOR_DATA),--basedir "$(TEMBLOR_DATA)")
DEMOS = demo1_lite demo2_lite demo3_lite
BENCHED = $(if $(TEMBLOR_DATA),$(addprefix --map ,$(MAPS)) $(addprefix --demo ,$(DEMOS)))

play:
	tools/play.sh
test:
	tools/run_tests.sh

bench:
	tools/setup.sh build
	cmake --preset release
	cmake --build --preset release --target temblor kernel_bench compile_bench vm_bench server_bench client_server_bench host_bench game
	cmake --build --preset release --target shipped_game game_tours
	build/release/temblor $(WITH_DATA) bench --report $(BENCHED)
	tools/measure_game.sh
	$(if $(TEMBLOR_DATA),build/release/bench/compile_bench build/release/temblor)
	build/release/bench/kernel_bench
	build/release/bench/vm_bench
	build/release/bench/server_bench
	$(if $(TEMBLOR_DATA),build/release/bench/client_server_bench build/release/game/id1/progs.dat)
	$(if $(TEMBLOR_DATA),build/release/bench/host_bench build/release/game/id1/progs.dat)

# In build/release: a Debian package, an archive that may be unpacked anywhere, and temblor-light-*.tar.xz, to be unpacked
# over that by who compiles maps with it.
package: shipped
	cd build/release && cpack -G DEB && cpack -G TXZ && cpack -G TXZ -D PART=light -B light
# PREFIX=/usr/local unless told.
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

# A minute a target; what is found lies in build/fuzz/found/.
fuzz:
	tools/setup.sh develop
	cmake --preset fuzz -DTEMBLOR_FUZZ_SECONDS=60
	cmake --build --preset fuzz --target fuzzers
	ctest --preset fuzz --parallel $$(nproc)

clean:
	rm -rf build out
