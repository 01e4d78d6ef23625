#!/usr/bin/env bash
# Usage: tools/package_licenses.sh LIBRARIES FOLDER: copies Debian's copyright file of each library in the folder LIBRARIES into
# FOLDER, for the archive that contains these libraries.
set -euo pipefail
libraries=$1 folder=$2
mkdir -p "$folder"
mapfile -t files < <(find "$libraries" -name '*.so*' -printf '*/%f\n')
# dpkg-query fails if one of the files is in no package, such as a library that was built here.
{ dpkg-query -S "${files[@]}" 2>/dev/null || true; } | cut -d: -f1 | sort -u | while read -r package; do
  if [ -f "/usr/share/doc/$package/copyright" ]; then cp "/usr/share/doc/$package/copyright" "$folder/$package.txt"; fi
done
