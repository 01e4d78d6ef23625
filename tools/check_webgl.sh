#!/usr/bin/env bash
# Usage: tools/check_webgl.sh [FOLDER]: runs the tests of OpenGL in contexts of WebGL 2. FOLDER holds the libraries of ANGLE
# (libEGL.so, libGLESv2.so, and SwiftShader), which Debian's Chromium has inside its program. Without FOLDER, they come from
# npm (68 MB, @sparticuz/chromium), into build/webgl. It takes about ten minutes.
#
# ANGLE checks each call against the rules of WebGL 2, as browsers do, and draws on the CPU.
set -euo pipefail
cd "$(dirname "$0")/.."

fetch_angle() {
  mkdir -p "$1"
  (
    cd "$1"
    npm pack --silent @sparticuz/chromium@147.0.0
    tar xzf sparticuz-chromium-*.tgz package/bin/swiftshader.tar.br
    node -e 'process.stdout.write(require("zlib").brotliDecompressSync(require("fs").readFileSync(process.argv[1])))' \
      package/bin/swiftshader.tar.br | tar x
    rm -r package sparticuz-chromium-*.tgz
  )
}

folder=${1:-build/webgl}
if [ $# -eq 0 ] && [ ! -e "$folder/libEGL.so" ]; then
  if ! command -v npm >/dev/null; then
    echo "webgl: not checked, because npm is not installed; name a folder with ANGLE's libraries"
    exit 0
  fi
  echo "Fetching ANGLE to $folder ..."
  fetch_angle "$folder"
fi
if [ ! -e "$folder/libEGL.so" ]; then
  echo "webgl: $folder has no libEGL.so" >&2
  exit 1
fi
cmake --preset release >/dev/null
cmake --build --preset release --target render_gl_test webgl_egl >/dev/null
TEMBLOR_ANGLE=$(realpath "$folder")
export TEMBLOR_ANGLE LD_LIBRARY_PATH="$PWD/build/release/tests/webgl:$TEMBLOR_ANGLE"
log=build/release/webgl.log
status=0
build/release/tests/render_gl_test --gtest_brief=1 >"$log" 2>&1 || status=$?
if [ $status -gt 1 ] || grep -q 'OpenGL error\|CHECK failed' "$log"; then
  grep 'OpenGL error\|CHECK failed' "$log" | sort -u >&2
  echo "webgl: calls break rules of WebGL 2; see $log" >&2
  exit 1
fi
grep 'PASSED' "$log"
# SwiftShader rounds vertices to 1/16 pixel, so that more pixels at borders differ from the CPU's than on other drivers.
sed -n 's/^\[  FAILED  \] \(.*ms)\)$/pictures differ more than on other drivers: \1/p' "$log"
