#!/usr/bin/env bash
# Usage: tools/package_licenses.sh PROGRAM FOLDER: copies into the folder what Debian says of the copyright of each library
# that the program is linked with, for the archive that brings these libraries.
set -euo pipefail
program=$1 folder=$2
mkdir -p "$folder"
ldd "$program" | awk '$3 ~ "^/" { print $3 }' | while read -r library; do
  file=$(readlink -f "$library")
  # Debian's list may still have /lib for what lies in /usr/lib.
  package=$({ dpkg-query -S "$file" || dpkg-query -S "${file#/usr}"; } 2>/dev/null | head -1 | cut -d: -f1) || true
  if [ -n "$package" ]; then cp "/usr/share/doc/$package/copyright" "$folder/$package.txt"; fi
done
