#!/usr/bin/env bash
# `make lint`: clang-tidy on the sources that differ from origin/main (from the last commit, where there is none).
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh develop
# clang reads no precompiled header of g++.
cmake --preset release -B build/lint -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
base=$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD~1)
mapfile -t sources < <(git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'tests/*.cpp' 'bench/*.cpp')
if [ ${#sources[@]} -eq 0 ]; then
  echo "lint: nothing differs from $base"
  exit 0
fi
# -Wno-unknown-warning-option: the flags are g++'s.
printf '%s\n' "${sources[@]}" |
  xargs -n 1 -P "$(nproc)" clang-tidy-14 -p build/lint --quiet --extra-arg=-Wno-unknown-warning-option
