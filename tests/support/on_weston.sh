#!/usr/bin/env bash
# on_weston.sh SCALE COMMAND...: runs the command on a Wayland display in a window of the X display, and returns its exit
# status. SCALE is the number of the window's pixels for each pixel of the display.
set -euo pipefail
scale=$1
shift
XDG_RUNTIME_DIR=$(mktemp -d)
export XDG_RUNTIME_DIR
trap 'kill "${display:-}" 2>/dev/null && wait "$display" || true; rm -rf "$XDG_RUNTIME_DIR"' EXIT
weston --backend=x11-backend.so --use-pixman --shell=kiosk-shell.so --width=900 --height=700 --scale="$scale" --socket=evening \
  >"$XDG_RUNTIME_DIR/weston.log" 2>&1 &
display=$!
for _ in $(seq 100); do [ -S "$XDG_RUNTIME_DIR/evening" ] && break; sleep 0.1; done
[ -S "$XDG_RUNTIME_DIR/evening" ] || { cat "$XDG_RUNTIME_DIR/weston.log" >&2; exit 1; }
WAYLAND_DISPLAY=evening SDL_VIDEODRIVER=wayland "$@"
