#!/usr/bin/env bash
# on_display.sh SCREEN COMMAND...: runs the command on an X display of its own, and returns its exit status. SCREEN is the
# size and depth, such as 640x480x24; further options of Xvfb may follow in the same word.
#
# xvfb-run chooses the number of a display before its server takes it, so that two that start together may choose the same
# one. Here, the server chooses. It also does not reset itself, and refuse connections meanwhile, when the last window closes.
# SDL does not start a message bus for the display, which would outlive it.
set -euo pipefail
screen=$1
shift
# shellcheck disable=SC2086
exec 3< <(exec Xvfb -displayfd 1 -noreset -nolisten tcp -screen 0 $screen 2>/dev/null)
server=$!
trap 'kill "$server" 2>/dev/null || true' EXIT
read -r number <&3
DISPLAY=:$number DBUS_SESSION_BUS_ADDRESS=disabled: "$@"
