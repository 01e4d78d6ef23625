#!/usr/bin/env bash
# `make test`: everything that must hold before a change goes in. Each step counts towards the last line, which is
# "N passed, N failed, N skipped"; exit status 1 if anything failed. Logs and test reports: build/PRESET/.
# Game data, for the tests that want some, is found through TEMBLOR_DATA. TEMBLOR_TEST_SECONDS, where it is set, is the time
# for all of it: what would take longer, on a slow machine, is skipped and said.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

CTEST_PARALLEL_LEVEL=$(($(nproc) + 1))  # some tests wait for other programs
export CTEST_PARALLEL_LEVEL
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # without it what has a precompiled header is not cached
fi
passed=0 failed=0 skipped=0
configure_options=()  # for the next build
launcher=()           # what the next build and suite run under

step() {
  printf '== %s (%d s)\n' "$*" "$SECONDS"
}
skip() {
  echo "skipped: $*"
  skipped=$((skipped + 1))
}
# there_is_time WHAT PERCENT: for what takes that part of the time that the release build and its tests took.
there_is_time() {
  local needed=$((release_s * $2 / 100)) left=$((${TEMBLOR_TEST_SECONDS:-1000000} - SECONDS))
  [ "$needed" -le "$left" ] && return
  skip "$1: takes about $needed s here, and of TEMBLOR_TEST_SECONDS $left are left"
  return 1
}
# check WHAT COMMAND...: one test that is not ctest's.
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

# build PRESET [TARGET...]: quiet unless it fails; then everything that does not compile is said at once.
build() {
  local preset=$1 log=build/$1.log
  shift
  mkdir -p build
  { cmake --preset "$preset" "${configure_options[@]}" && "${launcher[@]}" cmake --build --preset "$preset" ${1:+--target "$@"} -- -k 0; } \
    >"$log" 2>&1 || { grep -E -A 12 'error|FAILED|Error' "$log" | head -60; return 1; }
}

# The first NAME="N" of a JUnit report: an attribute of the whole suite.
suite_count() {
  grep -o "$2=\"[0-9]*\"" "$1" | head -1 | grep -o '[0-9]*'
}

# suite PRESET [CTEST OPTION...]: runs what was built and counts its tests.
suite() {
  local preset=$1 report=build/$1/report.xml log=build/$1/ctest.log bad off all
  shift
  rm -f "$report"
  "${launcher[@]}" ctest --preset "$preset" --no-tests=error --quiet --output-log "$log" --output-junit "$PWD/$report" "$@"
  local status=$?
  if [ ! -s "$report" ]; then
    echo "FAILED: ctest --preset $preset gave no report"
    failed=$((failed + 1))
    return
  fi
  all=$(suite_count "$report" tests) bad=$(suite_count "$report" failures)
  off=$(($(suite_count "$report" skipped) + $(suite_count "$report" disabled)))
  passed=$((passed + all - bad - off)) skipped=$((skipped + off))
  # Tests that could not be started count as skipped in the report, but not here.
  if [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then bad=1; fi
  failed=$((failed + bad))
  echo "$preset: $all tests, $bad failed, $off skipped"
  # GoogleTest's reasons, each with how many tests gave it.
  grep -A 1 -h ': Skipped$' "$report" | grep -v -e ': Skipped$' -e '^--' | sort | uniq -c | sed 's/^/  skipped: /'
  if [ "$bad" -ne 0 ]; then grep -v -E ' Passed |Skipped|^ *Start ' "$log" | head -200; fi
}

formatted() {
  find src tests bench fuzz game \( -name '*.cpp' -o -name '*.h' \) -print0 | xargs -0 clang-format-14 --dry-run -Werror
}

tools/setup.sh develop || exit 1

step "format"
if command -v clang-format-14 >/dev/null; then
  check "format (make format mends it)" formatted
else
  skip "format check: clang-format-14 is not installed"
fi

step "release: build and test"
check "release build" build release && suite release
release_s=$SECONDS

step "asan: build and test with the address and undefined-behavior sanitizers"
if there_is_time asan 140; then check "asan build" build asan && suite asan; fi

step "tsan: build and test what runs on several threads"
# gcc 12's thread sanitizer bears no wider spread of addresses.
if [ "$(cat /proc/sys/vm/mmap_rnd_bits 2>/dev/null || echo 32)" -gt 28 ]; then launcher=(setarch -R); fi
if ! there_is_time tsan 20; then
  :
elif "${launcher[@]}" true 2>/dev/null; then
  check "tsan build" build tsan base_test render_test && suite tsan -R 'Threads|ParallelFor|SamePicture'
else
  skip "tsan: addresses are spread too widely here, and may not be spread less (setarch -R is refused)"
fi
launcher=()

step "fuzz: replay every corpus, then 5 s a target"
if ! there_is_time fuzz 30; then
  :
elif command -v clang++-16 >/dev/null; then
  configure_options=(-DTEMBLOR_FUZZ_SECONDS=5)
  check "fuzz build" build fuzz fuzzers && suite fuzz
else
  skip "fuzzing: clang++-16 is not installed (the corpora were replayed in the suites above)"
fi

step "done"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
