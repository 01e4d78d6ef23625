#!/usr/bin/env bash
# A contact sheet of a level, from the places in tools/level_views.txt. Usage: tools/level_sheet.sh LEVEL OUT.jpg [BSP]
# (BSP: another file than the shipped level). Items, monsters and flames are not in it: those are the game code's.
set -euo pipefail

if [ $# -lt 2 ]; then
  echo "usage: tools/level_sheet.sh LEVEL OUT.jpg [BSP]" >&2
  exit 2
fi
level=$1 out=$2
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../build/release
map=${3:-$build/game/id1/maps/$level.bsp}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

tiles=()
while read -r of place angles; do
  if [ "$of" != "$level" ]; then continue; fi
  tile=$folder/$(printf %03d ${#tiles[@]}).png
  "$build/temblor" --basedir "$build/game" render --map "$map" --pos="$place" --angles="$angles,0" --size 640x360 \
    --time 3 -o "$tile" >/dev/null
  tiles+=("$tile")
done <"$here/level_views.txt"
if [ ${#tiles[@]} = 0 ]; then
  echo "level_sheet.sh: no views of $level in tools/level_views.txt" >&2
  exit 1
fi
montage -background '#181818' -tile 3x -resize 320x180 -geometry +2+2 -strip -quality 78 "${tiles[@]}" "$out"
