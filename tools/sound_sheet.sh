#!/usr/bin/env bash
# Usage: tools/sound_sheet.sh OUT.png COLUMNS FILE...: draws sounds for review without listening: for each file its waveform
# and below it its spectrogram (time to the right, frequency upward to half of the sample rate).
set -euo pipefail

if [ $# -lt 3 ]; then
  echo "usage: tools/sound_sheet.sh OUT.png COLUMNS FILE..." >&2
  exit 2
fi
out=$1 columns=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
width=${SHEET_WIDTH:-180} height=${SHEET_HEIGHT:-100}

tiles=()
for file in "$@"; do
  tile=$folder/$(printf %04d ${#tiles[@]}).png
  seconds=$(ffprobe -v error -show_entries format=duration -of csv=p=0 "$file")
  ffmpeg -v error -y -i "$file" -filter_complex "
      asplit[a][b];
      [a]showwavespic=s=${width}x36:colors=white,format=rgb24[wave];
      [b]showspectrumpic=s=${width}x${height}:legend=0:scale=log:drange=80:color=magma,format=rgb24[spectrum];
      [wave][spectrum]vstack" -frames:v 1 "$tile"
  name=$(basename "$(dirname "$file")")/$(basename "${file%.*}")
  tiles+=(-label "$name $(printf %.2f "$seconds") s" "$tile")
done
font=$(fc-match -f '%{file}' sans)
montage -font "$font" -background '#202020' -fill white -pointsize 11 -tile "${columns}x" -geometry +2+2 "${tiles[@]}" "$out"
