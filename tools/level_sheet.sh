#!/usr/bin/env bash
# Usage: tools/level_sheet.sh LEVEL OUT.jpg [BSP]: draws a contact sheet of a level from the views in tools/level_views.txt.
# BSP replaces the shipped level.
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
  "$build/temblor" --basedir "$build/game" render --map "$map" --entities --pos="$place" --angles="$angles,0" --size 640x360 \
    --time 3 -o "$tile" >/dev/null
  tiles+=("$tile")
done <"$here/level_views.txt"
if [ ${#tiles[@]} = 0 ]; then
  echo "level_sheet.sh: tools/level_views.txt has no views of $level" >&2
  exit 1
fi
montage -background '#181818' -tile 3x -resize 320x180 -geometry +2+2 -strip -interlace Plane -quality 70 "${tiles[@]}" "$out"
