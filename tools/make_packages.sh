#!/usr/bin/env bash
# Usage: tools/make_packages.sh
# Writes three packages to build/release, from the program and the game there: a Debian package, an archive that can be
# unpacked anywhere, and temblor-light-*.tar.xz, which mappers unpack over the other archive to compile light.
# TEMBLOR_QUICK_PACKAGES=1 compresses them quickly instead of well: `make check` only unpacks them.
set -euo pipefail
preset=9e deb_type=xz
if [ -n "${TEMBLOR_QUICK_PACKAGES:-}" ]; then preset=0 deb_type=gzip; fi
cd "$(dirname "$0")/../build/release"

# compress TAR: writes the archive as xz to the output. cpack can only compress with a window of 8 MB. xz compresses better
# with a window that covers the archive, because levels share their textures, and with a filter for machine code. Sounds and
# models lie together in folders of their own. Each folder is a stream, with filters for samples of two bytes, and for
# vertices of four.
compress() {
  local tar=$1 begin kind end options
  # Where a kind of file begins, in blocks of 512 bytes, and the end of the archive.
  mapfile -t parts < <(tar -tRf "$tar" | awk '
    { kind = /\/sound\// ? "sound" : /\/progs\// ? "progs" : "other" }
    kind != last { print $2 + 0, kind; last = kind }')
  parts+=("$(($(stat -c %s "$tar") / 512)) end")
  for ((i = 0; i + 1 < ${#parts[@]}; ++i)); do
    read -r begin kind <<<"${parts[i]}"
    read -r end _ <<<"${parts[i + 1]}"
    case "$kind" in
      sound) options=(--delta=dist=2 --lzma2="preset=$preset,lp=1,pb=1") ;;
      progs) options=(--delta=dist=4 --lzma2="preset=$preset,lc=1,lp=2") ;;
      *) options=(--x86 --lzma2="preset=$preset,lc=4") ;;
    esac
    dd if="$tar" bs=512 skip="$begin" count=$((end - begin)) status=none | xz "${options[@]}"
  done
}

# make_archive NAME PART: writes NAME-VERSION.tar.xz. The archives contain the same top folder, so cpack gives them the
# same name.
make_archive() {
  local name=$1 part=$2 packed
  rm -rf "packages/$part"
  cpack -G TGZ -D PART="$part" -B "packages/$part"
  packed=$(basename "packages/$part"/temblor-*.tar.gz .tar.gz)
  gzip -d "packages/$part/$packed.tar.gz"
  compress "packages/$part/$packed.tar" >"$name${packed#temblor}.tar.xz"
  rm -r "packages/$part"
}

jobs=()
cpack -G DEB -D CPACK_DEBIAN_COMPRESSION_TYPE="$deb_type" & jobs+=($!)
make_archive temblor game & jobs+=($!)
make_archive temblor-light light & jobs+=($!)
for job in "${jobs[@]}"; do wait "$job"; done
