#!/usr/bin/env bash
# `make play`: builds the program and the shipped game, then plays it, or the game data that TEMBLOR_DATA names. Options are
# passed on: `tools/play.sh --map t1`. Without a display, it makes a film of the game's demos and a sheet of pictures.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh build
if [ ! build/release/build.ninja -nt CMakePresets.json ]; then cmake --preset release >/dev/null; fi
targets=(temblor)
if command -v fteqcc >/dev/null; then targets+=(shipped_game); fi
cmake --build --preset release --target "${targets[@]}"
program=build/release/temblor

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  options=()
  if [ -n "${TEMBLOR_DATA:-}" ]; then
    options=(--basedir "$TEMBLOR_DATA" play)
    # Game data without game code uses ours.
    own_code=build/release/game/id1/progs.dat
    if ! ls "$TEMBLOR_DATA"/id1/*.[pP][aA][kK] "$TEMBLOR_DATA"/id1/progs.dat >/dev/null 2>&1 && [ -f "$own_code" ]; then
      options+=(--progs "$own_code")
    fi
  else
    options=(play)
  fi
  exec "$program" "${options[@]}" "$@"
fi

mkdir -p out
film=out/play.mp4 sheet=out/play.png
echo "There is no display. Writing a film and a sheet of pictures of the game to"
echo "  $PWD/$film"
parts=()
for level in t1 t2 t3; do
  "$program" --basedir build/release/game render --demo "$level" --size 640x360 --frames 450 -o "out/$level.mp4"
  parts+=(-i "out/$level.mp4")
done
ffmpeg -v error -y "${parts[@]}" -filter_complex 'concat=n=3' "$film"
rm out/t?.mp4
echo "  $PWD/$sheet"
ffmpeg -v error -y -i "$film" -vf 'fps=1/3,scale=480:-1,tile=4x4' -frames:v 1 "$sheet"
