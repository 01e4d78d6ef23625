#!/usr/bin/env bash
# Usage: tools/package_licenses.sh PROGRAM FOLDER: copies Debian's copyright file of each library that the program is linked
# with into the folder, for the archive that contains these libraries.
set -euo pipefail
program=$1 folder=$2
mkdir -p "$folder"
ldd "$program" | awk '$3 ~ "^/" { print $3 }' | while read -r library; do
  file=$(readlink -f "$library")
  # dpkg may still list a file of /usr/lib under /lib.
  package=$({ dpkg-query -S "$file" || dpkg-query -S "${file#/usr}"; } 2>/dev/null | head -1 | cut -d: -f1) || true
  if [ -n "$package" ]; then cp "/usr/share/doc/$package/copyright" "$folder/$package.txt"; fi
done
