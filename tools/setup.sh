#!/usr/bin/env bash
# Installs the Debian or Ubuntu packages that Temblor is built from, where they are missing; asks for root only
# then. Usage: tools/setup.sh build|develop  (develop adds what checks the code: clang, its fuzzer and formatter)
set -euo pipefail

packages=(g++ make cmake ninja-build pkgconf
  libtbb-dev libhwy-dev libglm-dev libfmt-dev libcli11-dev nlohmann-json3-dev libspng-dev libzip-dev
  libembree-dev libsdl2-dev libsndfile1-dev libsamplerate0-dev libvorbis-dev libogg-dev libgtest-dev libgmock-dev
  libbenchmark-dev fteqcc ffmpeg dpkg-dev file)
# Of clang one version, so that every machine formats and warns alike. Without them `make test` skips what needs them.
# DarkPlaces and quakestat are peers to play with, Xvfb the display of the first; iproute2 makes a network bad.
checkers=(git parallel iproute2 fteqcc qstat darkplaces darkplaces-server xvfb xauth xdotool weston quakespasm imagemagick
  clang-16 libclang-rt-16-dev clang-format-14 clang-tidy-14)

# One question for all of them: `make play` waits for the answer.
missing_of() {
  local installed
  [ $# -gt 0 ] || return 0
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p') || true
  printf '%s\n' "$@" | grep -vxF -e "$installed" || true
}

# Left out rather than fatal: a newer distribution has dropped these versions.
only_available() {
  local name
  for name in "$@"; do
    if apt-cache show "$name" >/dev/null 2>&1; then
      echo "$name"
    else
      echo "setup: $name is not in this system's package lists; going on without it" >&2
    fi
  done
}

case "${1:-}" in
  build) optional=() ;;
  develop) optional=("${checkers[@]}") ;;
  *) echo "usage: tools/setup.sh build|develop" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null; then
  echo "setup: not a Debian or Ubuntu system; expecting the equivalents of: ${packages[*]} ${optional[*]}" >&2
  exit 0
fi
mapfile -t needed < <(missing_of "${packages[@]}")
mapfile -t wanted < <(missing_of "${optional[@]}")
[ $((${#needed[@]} + ${#wanted[@]})) -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: packages are missing and there is no sudo; as root: apt-get install ${needed[*]} ${wanted[*]}" >&2
    # Only the checkers missing is no reason to stop.
    exit $((${#needed[@]} > 0))
  fi
  as_root=(sudo)
fi

export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
mapfile -t wanted < <(only_available "${wanted[@]}")
[ $((${#needed[@]} + ${#wanted[@]})) -gt 0 ] || exit 0
echo "setup: installing ${needed[*]} ${wanted[*]}"
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${needed[@]}" "${wanted[@]}" >/dev/null
