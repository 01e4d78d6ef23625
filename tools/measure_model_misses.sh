#!/usr/bin/env bash
# Usage: tools/measure_model_misses.sh D1 TECHNIQUE... [-- OPTION...]: simulates the first-level data cache with
# valgrind while techniques draw models, and prints how many lines are missing in the functions that work on
# vertices and triangles. Pixels are counted apart. D1 is "bytes,ways,line": 8192,2,32 for the first Pentium.
#
#   tools/measure_model_misses.sh 8192,2,32 affine-models stack-meshes -- --models 10 --distance 300
#
# All techniques draw the same number of frames, so compare their numbers with each other.
set -euo pipefail
program="$(dirname "$0")/../build/release/temblor"
cache=$1
shift
techniques=()
while [ $# -gt 0 ] && [ "$1" != "--" ]; do
  techniques+=("$1")
  shift
done
[ $# -gt 0 ] && shift
basedir=()
[ -n "${TEMBLOR_DATA:-}" ] && basedir=(--basedir "$TEMBLOR_DATA")
out=$(mktemp -d)
trap 'rm -r "$out"' EXIT
for technique in "${techniques[@]}"; do
  valgrind --tool=cachegrind --cache-sim=yes "--D1=$cache" "--cachegrind-out-file=$out/cachegrind" \
    "$program" "${basedir[@]}" lab compare "$technique" --size 320x200 --threads 1 "$@" > "$out/log" 2>&1
  cg_annotate --show=D1mr,D1mw --threshold=0 "$out/cachegrind" | python3 -c '
import re, sys
KINDS = {"vertices": r"ProjectVertices|project_vertices|FindFrontTriangles|prepare_alias|StackRoom|draw_groups|draw_commands",
         "triangles": r"DrawTriangles|RowPainter",
         "pixels": r"DrawRows|DrawGroups|look_up_texels"}
sums = dict.fromkeys(KINDS, 0)
for line in sys.stdin:
    parts = re.match(r"\s*([\d,]+) (?:\([^)]*\))?\s*([\d,]+) (?:\([^)]*\))?\s*\S*?:(.*temblor.*)", line)
    for kind, names in KINDS.items():
        if parts and re.search(names, parts[3]):
            sums[kind] += sum(int(number.replace(",", "")) for number in parts.groups()[:2])
            break
print(sys.argv[1], *(f"{kind} {count}" for kind, count in sums.items()))' "$technique"
done
