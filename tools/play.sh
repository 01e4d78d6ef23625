#!/usr/bin/env bash
# `make play`: builds the program and draws a level to out/play.png: `start` of the game data in TEMBLOR_DATA, or
# the small level that Temblor makes in code.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh build
cmake --preset release >/dev/null
cmake --build --preset release --target temblor
if command -v fteqcc >/dev/null; then cmake --build --preset release --target game; fi

mkdir -p out
if [ -n "${TEMBLOR_DATA:-}" ]; then
  build/release/temblor --basedir "$TEMBLOR_DATA" render --map start -o out/play.png
else
  build/release/temblor render -o out/play.png
fi
echo "There is no game to open a window for yet; what it would show is in $PWD/out/play.png"
