#!/usr/bin/env bash
# Usage: tools/compare_levels.sh RELEASE_TREE OTHER_TREE
# Tests that the shipped levels and demos depend on neither the compiler nor its flags, so that one build tree can make
# them for all. The program of OTHER_TREE makes some of them again, and the bytes must equal those in RELEASE_TREE.
set -euo pipefail
game=$(realpath "$1")/game
made=$(realpath "$1")/levels
other=$(realpath "$2")
levels=(b_batt0 b_explob tdm1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The leak search of clang 16 crashes half the time in programs that open Embree while they run. The test preset has
# this option too.
export ASAN_OPTIONS=intercept_tls_get_addr=0

scripts=$(cd "$(dirname "$0")/../game" && pwd)
"$other/temblor" art "$scripts/art/textures" -o "$work" >/dev/null
cmp "$work/textures.wad" "$made/textures.wad"
for level in "${levels[@]}"; do
  "$other/temblor" art "$scripts/maps/$level.level" -o "$work" >/dev/null
  cmp "$work/maps/$level.map" "$made/maps/$level.map"
  (cd "$work" && "$other/temblor" compile --clean "maps/$level.map" --wad textures.wad -o "$level.bsp") >/dev/null 2>&1
  cmp "$work/$level.bsp" "$made/maps/$level.bsp"
  if [ -e "$made/maps/$level.lit" ]; then cmp "$work/$level.lit" "$made/maps/$level.lit"; fi
done
if [ -x "$other/scripted_player" ]; then
  # The same options as in game/shipped.cmake. The exit status is about the game, not about the recording.
  "$other/scripted_player" --basedir "$game" --map tdm1 --record "$work/tdm1.dem" --deathmatch 7 --seed 2 --limit 60 >/dev/null || true
  cmp "$work/tdm1.dem" "$game/id1/tdm1.dem"
fi
