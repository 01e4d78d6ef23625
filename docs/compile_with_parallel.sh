#!/usr/bin/env bash
# Compiles a level with several processes, which may be on several machines: GNU parallel starts them, and
# they have nothing in common but the folder.
#
#   docs/compile_with_parallel.sh 8 castle.map --wad ~/wads
#   PARALLEL="--sshlogin a,b,c --workdir ." docs/compile_with_parallel.sh 48 castle.map
#
# TEMBLOR: the program, "temblor" unless set; or the program and options in front of the command, with no
# space in any of them.
set -euo pipefail
if [ $# -lt 2 ]; then
  echo "usage: $0 PROCESSES MAP [options of temblor compile]" >&2
  exit 2
fi
shards=$1
map=$2
shift 2
temblor=("${TEMBLOR:-temblor}")
command -v "${temblor[0]}" >/dev/null || read -r -a temblor <<<"${temblor[0]}"
compile=("${temblor[@]}" compile "$map" "$@")

run_shards() { # of a stage
  parallel --will-cite --halt now,fail=1 --quote "${compile[@]}" --only "$1" --threads 1 --shard "{}/$shards" \
    ::: $(seq "$shards")
}

"${compile[@]}" --only bsp
# Visibility is done in rounds, each of which uses what the one before found; fourteen at most.
for _ in $(seq 14); do
  run_shards vis
  merged=$("${compile[@]}" --only vis --merge)
  echo "$merged"
  [[ $merged == *"run the shards again"* ]] || break
done
run_shards light
"${compile[@]}" --only light --merge
