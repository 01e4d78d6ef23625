#!/usr/bin/env bash
# Usage: tools/measure_latency.sh: measures the time from a key press or a movement of the mouse until a window on a display
# in memory (Xvfb, 60 Hz) shows it, and prints a table: Temblor with different settings, and QuakeSpasm, if it is installed.
# Build latency_bench first, and stop other work. Uses the levels of TEMBLOR_DATA, or else those of the shipped game.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v xvfb-run xauth >/dev/null; then
  echo "latency: not measured, because there is no display (xvfb, xauth)"
  exit 0
fi
data=${TEMBLOR_DATA:-build/release/game}
program=build/release/game/id1/progs.dat
export SDL_AUDIODRIVER=dummy SDL_VIDEODRIVER=x11

# row PROGRAM [VARIABLE=VALUE]...: on a display of its own, without other windows.
row() {
  local name=$1
  shift
  tests/support/on_display.sh 1280x720x24 build/release/bench/latency_bench "$name" "$data" "$program" "$@"
}

echo "| program and settings | event | ms: median, 95 of 100, longest | median, frames | ms by scr_showlatency | lost |"
echo "| --- | --- | --- | --- | --- | --- |"
row temblor vid_vsync=1
row temblor vid_vsync=0
row temblor vid_vsync=0 host_maxfps=250
row quakespasm vid_vsync=0 host_maxfps=60
row quakespasm vid_vsync=0 host_maxfps=250
