#!/usr/bin/env bash
# Usage: tools/run_tests.sh test|check
#   test   format, spelling, the release build, and its tests, without game data and without other engines
#   check  the same with the game data that TEMBLOR_DATA names, then everything else: the shipped game and its tests, other
#          engines, the address, undefined-behavior, and thread sanitizers, fuzzing, and the packages
# The last line is "N passed, N failed, N skipped" and counts single tests; every skipped test has a reason. The exit status
# is 1 if a test failed. Logs and reports are in build/PRESET/.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

kind=${1:-test}
if [ "$kind" = test ]; then unset TEMBLOR_DATA; fi
CTEST_PARALLEL_LEVEL=$(($(nproc) + 1))  # one more than cores, because some tests wait for other programs
export CTEST_PARALLEL_LEVEL
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # needed to cache sources with a precompiled header
fi
passed=0 failed=0 skipped=0
launcher=()  # runs the next builds and suites
declare -A jobs=()  # the commands that run beside the next steps

step() {
  printf '== %s (%d s)\n' "$*" "$SECONDS"
}
skip() {
  echo "  skipped: $*"
  skipped=$((skipped + 1))
}
# check WHAT COMMAND...: runs the command as one test.
check() {
  local what=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    echo "FAILED: $what"
    failed=$((failed + 1))
    return 1
  fi
}

# configure PRESET [OPTION...]: runs cmake; prints its output only if it fails.
configure() {
  local preset=$1
  shift
  mkdir -p build
  cmake --preset "$preset" "$@" >"build/$preset.log" 2>&1 || { tail -30 "build/$preset.log"; return 1; }
}
# build PRESET [TARGET...]: prints nothing unless it fails, and then the compile errors.
build() {
  local preset=$1 log=build/$1.log
  shift
  "${launcher[@]}" cmake --build --preset "$preset" ${1:+--target "$@"} -- -k 0 >"$log" 2>&1 ||
    { grep -E -A 12 'error|FAILED|Error' "$log" | head -60; return 1; }
}

# show_failures LOG: prints the output of failed tests in a ctest log, and of a test during which its process ended.
show_failures() {
  awk '/^\[ RUN      \]/ { text = ""; running = 1 }
       /^\[       OK \]|^\[  SKIPPED \]/ { text = ""; running = 0; next }
       running { text = text $0 "\n" }
       /^\[  FAILED  \]/ && running { printf "%s", text; text = ""; running = 0 }
       !running && /Failed|Timeout|Exception|ERROR: |runtime error|CHECK/ { print }
       END { if (running) printf "%s", text }' "$1" | head -200
}

# begin NAME NICENESS COMMAND...: runs the command beside the next steps. With niceness 19, it takes the time that they
# leave idle: tests of other engines mostly wait, and the last test of a suite leaves the other cores free. With 5, it has a
# third of a test's share, so that a short command does not end long after them.
begin() {
  local name=$1 niceness=$2
  shift 2
  mkdir -p build
  (renice -n "$niceness" -p "$BASHPID" >/dev/null; "$@") >"build/$name.out" 2>&1 &
  jobs[$name]=$!
}
# finish NAME: waits for it, prints its output, and returns its status.
finish() {
  local status=0
  wait "${jobs[$1]}" || status=$?
  cat "build/$1.out"
  return $status
}

# suite PRESET [CTEST OPTION...]: runs the tests that are built, and counts them.
suite() {
  local preset=$1 report=build/$1/report.xml log=build/$1/ctest.log counts bad
  shift
  rm -rf "$report" "build/$preset/reports"
  "${launcher[@]}" ctest --preset "$preset" --no-tests=error --quiet --output-log "$log" --output-junit "$PWD/$report" "$@"
  if [ ! -s "$report" ]; then
    echo "FAILED: ctest --preset $preset wrote no report"
    failed=$((failed + 1))
    return
  fi
  counts=$(tools/count_tests.sh "$report" "build/$preset/reports")
  sed '$d' <<<"$counts"
  read -r good bad off <<<"$(tail -1 <<<"$counts")"
  passed=$((passed + good)) failed=$((failed + bad)) skipped=$((skipped + off))
  echo "  $good passed, $bad failed, $off skipped"
  if [ "$bad" -ne 0 ]; then show_failures "$log"; fi
}

is_formatted() {
  find src tests bench fuzz \( -name '*.cpp' -o -name '*.h' \) -print0 |
    xargs -0 -P "$(nproc)" -n 100 clang-format-14 --dry-run -Werror
}

check_texts() {
  step "format and spelling"
  if command -v clang-format-14 >/dev/null; then
    check "format (make format fixes it)" is_formatted
  else
    skip "format: clang-format-14 is not installed"
  fi
  if command -v codespell >/dev/null; then
    check "spelling (.codespell-words lists exceptions)" codespell src tests docs game fuzz bench tools cmake README.md CONTRIBUTING.md
  else
    skip "spelling: codespell is not installed"
  fi
}

has_clang() { command -v clang++-16 >/dev/null; }

check_release() {
  step "release: build"
  if ! check "release build" eval 'configure release && build release'; then return; fi
  if [ "$kind" = check ] && has_clang; then begin sanitize 19 build_sanitizers; fi
  step "release: test"
  suite release -LE 'check|peers'
}

check_game() {
  step "shipped game: build it, its tests, the slow tests, and the benchmarks"
  if ! check "shipped game" build release shipped_game check_tests benchmarks; then return; fi
  step "shipped game, slow tests, other engines"
  suite release -L 'check|peers'
}

build_sanitizers() {
  configure sanitize -DTEMBLOR_FUZZ_SECONDS=1 && build sanitize all scripted_player
}
# The build needs only the libraries of the tests that have several threads.
build_threads() {
  configure tsan && build tsan base_test audio_test render_test
}
make_packages() {
  TEMBLOR_QUICK_PACKAGES=1 make --no-print-directory package >build/package.log 2>&1 ||
    { tail -20 build/package.log; return 1; }
  tools/check_packages.sh
}

check_sanitizers() {
  step "sanitize: build with the address and undefined-behavior sanitizers and libFuzzer"
  if ! has_clang; then
    skip "address and undefined-behavior sanitizers, fuzzing: clang++-16 is not installed"
    return
  fi
  if [ -z "${jobs[sanitize]:-}" ]; then begin sanitize 19 build_sanitizers; fi
  if ! check "sanitize build" finish sanitize; then return; fi
  if [ -d build/release/game/id1/maps ]; then begin levels 5 tools/compare_levels.sh build/release build/sanitize; fi
  begin packages 5 make_packages
  begin tsan 19 build_threads
  step "sanitize: test, replay every fuzz corpus, fuzz each target for 1 s"
  suite sanitize -LE peers
  if [ -n "${jobs[levels]:-}" ]; then check "levels and demos are identical with both compilers" finish levels; fi
}

check_threads() {
  step "tsan: build and run the tests of code with several threads"
  if [ -z "${jobs[tsan]:-}" ]; then begin tsan 19 build_threads; fi
  if ! check "tsan build" finish tsan; then return; fi
  # The thread sanitizer of gcc 12 fails if addresses are randomized more; setarch -R turns that off.
  if [ "$(cat /proc/sys/vm/mmap_rnd_bits 2>/dev/null || echo 32)" -gt 28 ]; then launcher=(setarch -R); fi
  if ! "${launcher[@]}" true 2>/dev/null; then
    skip "tsan: this machine randomizes addresses too much, and setarch -R is not allowed"
  else
    suite tsan -R '^(base|audio|render)(\.|$)'
  fi
  launcher=()
}

check_packages() {
  step "packages: build, install, start, and remove them"
  if [ -z "${jobs[packages]:-}" ]; then begin packages 5 make_packages; fi
  finish packages
  case $? in
    0) passed=$((passed + 1)) ;;
    77) skip "packages were not installed (see above)" ;;
    *) echo "FAILED: packages"; failed=$((failed + 1)) ;;
  esac
}

case $kind in
  test | check) ;;
  *) echo "usage: tools/run_tests.sh test|check" >&2; exit 2 ;;
esac
# Jobs ignore an interrupt from the keyboard, so pass it on to the whole process group.
trap 'trap - TERM; kill 0' INT TERM
tools/setup.sh "$kind" || exit 1
check_texts
check_release
if [ "$kind" = check ]; then
  check_game
  check_sanitizers
  check_threads
  check_packages
fi
step "done"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
