#!/usr/bin/env bash
# Usage: tools/setup.sh build|test|check
# Installs the Debian or Ubuntu packages that Temblor needs, if they are missing, and asks for root only then.
#   build  packages to compile the program and its game
#   test   also those for `make test`
#   check  also those for `make check`
set -euo pipefail

build=(g++ make cmake ninja-build pkgconf
  libtbb-dev libhwy-dev libglm-dev libfmt-dev libcli11-dev nlohmann-json3-dev libspng-dev libjpeg62-turbo-dev zlib1g-dev
  libembree-dev libsdl2-dev libegl-dev libgles-dev libwayland-dev libxcb-present-dev libxcb-shm0-dev libxcb-xtest0-dev libsndfile1-dev libsamplerate0-dev
  libvorbis-dev libogg-dev libgtest-dev libgmock-dev libbenchmark-dev fteqcc ffmpeg dpkg-dev file)
# A technique of the laboratory assembles code for this processor; without the package, the technique is missing.
assembler=()
if [ "$(uname -m)" = x86_64 ]; then assembler=(libasmjit-dev); fi
# clang-14 compiles the tests, and mold links them: both are faster than what `build` has. All machines use the same
# versions of clang, so that they format and warn alike. clang-14 takes only 9 MB, because clang-format-14 has its libraries.
test=(git clang-format-14 clang-14 codespell python3-minimal mold)
# Tests play with QuakeSpasm, DarkPlaces, and quakestat. Xvfb and Weston are displays, iproute2 simulates a bad network, and
# debootstrap makes the system in which the package is tested.
check=(parallel iproute2 qstat darkplaces darkplaces-server xvfb xauth xdotool weston quakespasm imagemagick
  clang-16 libclang-rt-16-dev clang-tidy-14 debootstrap)

# Prints the packages that are not installed. Asks dpkg only once, because `make play` waits for the answer.
list_missing() {
  local installed
  [ $# -gt 0 ] || return 0
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p') || true
  printf '%s\n' "$@" | grep -vxF -e "$installed" || true
}

# Prints the packages that exist. Newer distributions lack some of these versions; tests that need them are skipped.
list_available() {
  local name
  for name in "$@"; do
    if apt-cache show "$name" >/dev/null 2>&1; then
      echo "$name"
    else
      echo "setup: this system has no package $name; continuing without it" >&2
    fi
  done
}

case "${1:-}" in
  build) optional=("${assembler[@]}") ;;
  test) optional=("${assembler[@]}" "${test[@]}") ;;
  check) optional=("${assembler[@]}" "${test[@]}" "${check[@]}") ;;
  *) echo "usage: tools/setup.sh build|test|check" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is not Debian or Ubuntu; install the equivalents of: ${build[*]} ${optional[*]}" >&2
  exit 0
fi
mapfile -t needed < <(list_missing "${build[@]}")
mapfile -t wanted < <(list_missing "${optional[@]}")
[ $((${#needed[@]} + ${#wanted[@]})) -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: packages are missing and there is no sudo; run as root: apt-get install ${needed[*]} ${wanted[*]}" >&2
    # Missing optional packages do not stop the build.
    exit $((${#needed[@]} > 0))
  fi
  as_root=(sudo)
fi

export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
mapfile -t wanted < <(list_available "${wanted[@]}")
[ $((${#needed[@]} + ${#wanted[@]})) -gt 0 ] || exit 0
echo "setup: installing ${needed[*]} ${wanted[*]}"
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${needed[@]}" "${wanted[@]}" >/dev/null
