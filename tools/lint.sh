#!/usr/bin/env bash
# `make lint`: runs clang-tidy on the sources that differ from origin/main, or from the last commit if there is no such branch.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh check
# clang-tidy cannot read g++'s precompiled headers.
cmake --preset release -B build/lint -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
base=$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD~1)
mapfile -t sources < <(git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'tests/*.cpp' 'bench/*.cpp')
if [ ${#sources[@]} -eq 0 ]; then
  echo "lint: no source differs from $base"
  exit 0
fi
# -Wno-unknown-warning-option: the compile flags are for g++.
printf '%s\n' "${sources[@]}" |
  xargs -n 1 -P "$(nproc)" clang-tidy-14 -p build/lint --quiet --extra-arg=-Wno-unknown-warning-option
