#!/usr/bin/env bash
# Tests the packages that `make package` wrote to build/release:
#   Archives: unpacks them; the program draws a picture and compiles a map with light. It starts in a clean system too.
#   Debian package: installs it in a clean system made by debootstrap; the game starts there without a display, and
#   removing the package leaves no files.
# Without debootstrap or a package mirror, the package is unpacked with `dpkg --root` into an empty folder, where the
# program uses this system's libraries. Exit status 77: the package was not installed, because that needs root.
set -euo pipefail
cd "$(dirname "$0")/.."

build=build/release
work=$(mktemp -d)
is_mounted=
clean_up() {
  if [ -n "$is_mounted" ]; then umount "$work/root/proc"; fi
  rm -rf "$work"
}
trap clean_up EXIT

fail() {
  echo "  $*" >&2
  exit 1
}
only_file() {
  [ $# -eq 1 ] && [ -f "$1" ] || fail "expected one file: $*"
  echo "$1"
}
deb=$(only_file "$build"/temblor_*.deb)
archive=$(only_file "$build"/temblor-[0-9]*.tar.xz)
light=$(only_file "$build"/temblor-light-*.tar.xz)

# try_game COMMAND...: runs the program COMMAND. It draws a level and plays for a second in a window in memory.
try_game() {
  "$@" --version >"$work/version.txt" || fail "$* --version failed"
  "$@" render --map start --size 320x200 -o /tmp/temblor_package_test.png >"$work/render.txt" 2>&1 ||
    { cat "$work/render.txt"; fail "cannot render the level start"; }
  SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy "$@" play --map start --duration 1 >"$work/play.txt" 2>&1 ||
    { cat "$work/play.txt"; fail "the game does not start"; }
}

export HOME=/tmp/temblor_package_home XDG_DATA_HOME=/tmp/temblor_package_home
unset TEMBLOR_DATA LD_LIBRARY_PATH

mkdir "$work/archive"
tar -xf "$archive" -C "$work/archive"
tar -xf "$light" -C "$work/archive"
program=$(only_file "$work"/archive/temblor-*/bin/temblor)
try_game "$program"
cp build/release/levels/maps/b_bh10.map build/release/levels/textures.wad "$work"
(cd "$work" && "$program" compile b_bh10.map --wad textures.wad -o box.bsp) >"$work/compile.txt" 2>&1 ||
  { cat "$work/compile.txt"; fail "the unpacked program cannot compile a level"; }
rm -rf "$HOME" /tmp/temblor_package_test.png
for script in docs/compile_with_parallel.sh packaging/compile_with_slurm.sh; do
  [ -x "$(only_file "$work"/archive/temblor-*/share/doc/temblor/$script)" ] || fail "the archive has no script $script"
done

root=$work/root
kind=
if [ "$(id -u)" -ne 0 ]; then
  echo "  the Debian package was not installed, because that needs root"
  exit 77
fi
codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}")
if command -v debootstrap >/dev/null &&
  debootstrap --variant=minbase "$codename" "$root" http://deb.debian.org/debian >"$work/debootstrap.txt" 2>&1; then
  kind=system
else
  echo "  no clean system (debootstrap): $(tail -1 "$work/debootstrap.txt" 2>/dev/null || echo "it is not installed")"
  kind=folder
fi

if [ $kind = system ]; then
  # This system's package sources have the versions of the libraries that the package was built with.
  rm -f "$root/etc/apt/sources.list"
  cp -a /etc/apt/sources.list /etc/apt/sources.list.d "$root/etc/apt/" 2>/dev/null || true
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  if mount -t proc proc "$root/proc" 2>/dev/null; then is_mounted=1; fi
  printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"  # start no services
  chmod +x "$root/usr/sbin/policy-rc.d"
  inside=(chroot "$root" env DEBIAN_FRONTEND=noninteractive HOME="$HOME" PATH=/usr/sbin:/usr/bin:/sbin:/bin:/usr/games)
  # The program finds the archive's libraries through /proc. The clean system has all others.
  if [ -n "$is_mounted" ]; then
    cp -r "$work/archive" "$root/archive"
    try_game "${inside[@]}" "${program#"$work"}"
    rm -rf "$root/archive"
  fi
  cp "$deb" "$root/temblor.deb"
  "${inside[@]}" sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends /temblor.deb' >"$work/install.txt" 2>&1 ||
    { tail -20 "$work/install.txt"; fail "the Debian package cannot be installed"; }
  rm "$root/temblor.deb"
  "${inside[@]}" dpkg -L temblor >"$work/files.txt"
  try_game "${inside[@]}" temblor
  "${inside[@]}" apt-get purge -y -qq temblor >"$work/purge.txt" 2>&1 || { cat "$work/purge.txt"; fail "the package cannot be removed"; }
  rm -rf "$root$HOME" "$root"/tmp/temblor_package_test.png
else
  mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
  touch "$root/var/lib/dpkg/status"
  dpkg --root="$root" --force-depends -i "$deb" >"$work/install.txt" 2>&1 ||
    { cat "$work/install.txt"; fail "the Debian package cannot be unpacked"; }
  dpkg --root="$root" -L temblor >"$work/files.txt"
  try_game "$root/usr/bin/temblor"
  dpkg --root="$root" --purge temblor >"$work/purge.txt" 2>&1 || { cat "$work/purge.txt"; fail "the package cannot be removed"; }
  rm -rf "$HOME" /tmp/temblor_package_test.png
fi

left=$(while IFS= read -r path; do if [ -e "$root$path" ] && [ ! -d "$root$path" ]; then echo "$path"; fi; done <"$work/files.txt"
  cd "$root" && find . -xdev -iname '*temblor*' -not -path './proc/*' -not -path './var/log/*' -not -path './var/cache/*' -not -path './var/lib/apt/*')
[ -z "$left" ] || fail "removing the package leaves: $left"
echo "  the archives run; the Debian package was installed in a clean $kind, started, and removed"
