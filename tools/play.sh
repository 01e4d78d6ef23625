#!/usr/bin/env bash
# `make play`: builds the program and opens the game with the data in TEMBLOR_DATA. Without data, or where there is no
# display, it draws a level to out/play.png instead: `start` of the data, or the small one that Temblor makes in code.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh build
cmake --preset release >/dev/null
cmake --build --preset release --target temblor
if command -v fteqcc >/dev/null; then cmake --build --preset release --target game; fi

if [ -n "${TEMBLOR_DATA:-}" ] && [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  code=()
  # Data without game code plays with ours.
  own_code=build/release/game/quakec/progs.dat
  if ! ls "$TEMBLOR_DATA"/id1/*.[pP][aA][kK] "$TEMBLOR_DATA"/id1/progs.dat >/dev/null 2>&1 && [ -f "$own_code" ]; then
    code=(--progs "$own_code")
  fi
  exec build/release/temblor --basedir "$TEMBLOR_DATA" play "${code[@]}"
fi

mkdir -p out
if [ -n "${TEMBLOR_DATA:-}" ]; then
  build/release/temblor --basedir "$TEMBLOR_DATA" render --map start -o out/play.png
  echo "There is no display; what the game would show is in $PWD/out/play.png"
else
  build/release/temblor render -o out/play.png
  echo "There is no game data: set TEMBLOR_DATA to a folder that holds id1. A picture is in $PWD/out/play.png"
fi
