#!/usr/bin/env bash
# tools/readme_film.sh OUT.gif: the README's moving picture, from pieces of the shipped game's recordings (level, first and
# last frame at 30 a second). Recordings change with levels and rules: look at it, and choose other pieces.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:?a file for the picture}
pieces=("t1 50 95" "t1 1660 1710" "t2 100 150" "t2 780 830" "t3 550 600" "t3 1715 1760")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
inputs=()
for i in "${!pieces[@]}"; do
  read -r level first last <<<"${pieces[$i]}"
  build/release/temblor --basedir build/release/game render --demo "$level" --size 1440x810 --nosound \
    --frames "$first:$last" -o "$folder/$i.mp4"
  inputs+=(-i "$folder/$i.mp4")
done
# Drawn large and made small, it has smooth edges; few colors and a fixed pattern of dots keep it small.
small="concat=n=${#pieces[@]},fps=9,scale=360:-1:flags=area,split[a][b]"
colors="[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle"
ffmpeg -v error -y "${inputs[@]}" -filter_complex "$small;$colors" "$out"
