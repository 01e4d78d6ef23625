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
# with a window that covers the archive, because levels share their textures, and with a filter for machine code. The
# sounds, which lie together, are a stream of their own with filters for two-byte samples.
compress() {
  local tar=$1 sound_begin sound_end
  # In blocks of 512 bytes; 0 without sounds.
  read -r sound_begin sound_end < <(tar -tRf "$tar" | awk '
    /\/sound\// { if (!begin) begin = $2 + 0; is_sound = 1; next }
    is_sound { end = $2 + 0; is_sound = 0 }
    END { print begin + 0, end + 0 }')
  if [ "$sound_end" -gt 0 ]; then
    dd if="$tar" count="$sound_begin" status=none | xz --x86 --lzma2="preset=$preset"
    dd if="$tar" skip="$sound_begin" count=$((sound_end - sound_begin)) status=none |
      xz --delta=dist=2 --lzma2="preset=$preset,lp=1,pb=1"
  fi
  dd if="$tar" skip="$sound_end" status=none | xz --x86 --lzma2="preset=$preset"
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
