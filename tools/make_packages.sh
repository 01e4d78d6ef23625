#!/usr/bin/env bash
# Usage: tools/make_packages.sh
# Writes three packages to build/release, from the program and the game there: a Debian package, an archive that can be
# unpacked anywhere, and temblor-light-*.tar.xz, which mappers unpack over the other archive to compile light.
set -euo pipefail
cd "$(dirname "$0")/../build/release"

# make_archive NAME PART: writes NAME-VERSION.tar.xz. cpack can only compress with a window of 8 MB. xz compresses better with
# a window that covers the archive, because levels share their textures, with a filter for machine code, and with a
# setting for two-byte samples. The archives contain the same top folder, so cpack gives them the same name.
make_archive() {
  local name=$1 part=$2 packed
  rm -rf "packages/$part"
  cpack -G TGZ -D PART="$part" -B "packages/$part"
  packed=$(basename "packages/$part"/temblor-*.tar.gz .tar.gz)
  gzip -dc "packages/$part/$packed.tar.gz" | xz --x86 --lzma2=preset=9e,lp=1 >"$name${packed#temblor}.tar.xz"
  rm -r "packages/$part"
}

jobs=()
cpack -G DEB & jobs+=($!)
make_archive temblor game & jobs+=($!)
make_archive temblor-light light & jobs+=($!)
for job in "${jobs[@]}"; do wait "$job"; done
