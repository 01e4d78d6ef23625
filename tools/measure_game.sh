#!/usr/bin/env bash
# Usage: tools/measure_game.sh [RUNS]: measures the goals of the shipped game and prints a table: how long its levels
# compile, how soon `make play` shows a frame, how large the packages are, and how fast the demo of every level is drawn.
# RUNS: how often each demo is drawn (3); each frame's fastest time counts. Build everything first, and stop other work.
set -euo pipefail
cd "$(dirname "$0")/.."

runs=${1:-3}
build=build/release
game=$build/game
program=$PWD/$build/temblor
levels=(start t1 t2 t3 t4 t5 tdm1 tdm2 tdm3 tdm4 gallery)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

row() { printf '| %s | %s | %s |\n' "$@"; }
seconds_since() { echo "$(date +%s.%N) $1" | awk '{ printf "%.2f", $1 - $2 }'; }

compile_time() {
  local begin level
  begin=$(date +%s.%N)
  for level in "${levels[@]}"; do
    (cd "$build/levels" && "$program" compile --clean "maps/$level.map" --wad textures.wad -o "$folder/$level.bsp") >/dev/null
  done
  row "all levels compiled, two cores" "$(seconds_since "$begin") s" "under 180 s"
}

# Uses a window in memory, so that it works without a display.
play_one_frame() {
  env -u TEMBLOR_DATA SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy DISPLAY=:none HOME="$folder" XDG_DATA_HOME="$folder" \
    tools/play.sh --duration 0.001 >/dev/null
}
first_frame() {
  local begin
  play_one_frame  # build what has changed
  begin=$(date +%s.%N)
  play_one_frame
  row "\`make play\`, already built: until it has drawn a frame and quit" "$(seconds_since "$begin") s" "under 1 s"
}

packages() {
  local file
  for file in "$build"/*.deb "$build"/*.tar.xz; do
    [ -f "$file" ] || continue
    row "${file##*/}" "$(stat -c %s "$file" | awk '{ printf "%.1f", $1 / 1e6 }') MB" "under 30 MB"
  done
}

# measure_demo NAME SIZE GOAL DEMO
measure_demo() {
  "$program" --basedir "$game" bench --threads 2 --runs "$runs" --size "$2" --demo "$4" 2>/dev/null >"$folder/bench.txt"
  row "$1, $2: median, 99th percentile, slowest" \
    "$(awk '$1 == "frame" { printf "%.1f, %.1f, %.1f ms", $2, $5, $7 }' "$folder/bench.txt")" "$3"
}

row "what" "measured" "goal"
row "---" "---" "---"
compile_time
first_frame
packages
for level in start t1 t2 t3 t4 t5; do
  measure_demo "$level, from start to exit" 1920x1080 "6.9 ms (144 per second)" "$game/tours/$level.dem"
done
for level in "${levels[@]}"; do
  measure_demo "$level, menu background" 1920x1080 "6.9 ms (144 per second)" "$level"
done
measure_demo "gallery, menu background" 3840x2160 "16.7 ms (60 per second)" gallery
