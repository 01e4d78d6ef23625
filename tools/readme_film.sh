#!/usr/bin/env bash
# Usage: tools/readme_film.sh OUT.gif: makes the animation of the README from parts of the shipped demos (level, first and
# last frame at 30 frames per second). Demos change with levels and game rules: look at the result, and choose other parts.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:?usage: tools/readme_film.sh OUT.gif}
parts=("t1 50 95" "t1 1660 1710" "t2 100 150" "t2 780 830" "t3 550 600" "t3 1715 1760")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
inputs=()
for i in "${!parts[@]}"; do
  read -r level first last <<<"${parts[$i]}"
  build/release/temblor --basedir build/release/game render --demo "$level" --size 1440x810 --nosound \
    --frames "$first:$last" -o "$folder/$i.mp4"
  inputs+=(-i "$folder/$i.mp4")
done
# Rendering large and scaling down makes edges smooth. Few colors and ordered dithering keep the file small.
small="concat=n=${#parts[@]},fps=9,scale=360:-1:flags=area,split[a][b]"
colors="[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle"
ffmpeg -v error -y "${inputs[@]}" -filter_complex "$small;$colors" "$out"
