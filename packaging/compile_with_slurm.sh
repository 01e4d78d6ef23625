#!/usr/bin/env bash
# Compiles a level on a cluster with Slurm: submits an array of jobs for each stage, each of which waits for the one before.
# The machines share the folder of the map.
#
#   packaging/compile_with_slurm.sh 48 castle.map --wad /shared/wads
#   SBATCH_PARTITION=night packaging/compile_with_slurm.sh 48 castle.map
#
# TEMBLOR: the program, "temblor" unless set. Prints the number of the last job; the level is complete when it ends.
# All jobs write to temblor-FIRST.log, where FIRST is the number of the first one. If a job fails, Slurm cancels the rest.
#SBATCH --cpus-per-task=1
#SBATCH --output=temblor-%A.log
#SBATCH --open-mode=append
set -euo pipefail
temblor=${TEMBLOR:-temblor}

# In a job, the first word is the part to do. Slurm runs a copy of this script, in the folder from which it was submitted.
case ${1:-} in
  --bsp) exec "$temblor" compile "${@:2}" --only bsp ;;
  --shard) exec "$temblor" compile "${@:4}" --only "$2" --threads 1 --shard "$SLURM_ARRAY_TASK_ID/$3" ;;
  --merge) exec "$temblor" compile "${@:3}" --only "$2" --merge ;;
esac

if [ $# -lt 2 ]; then
  echo "usage: $0 JOBS MAP [options of temblor compile]" >&2
  exit 2
fi
shards=$1
shift

last=""
submit() { # OPTION... -- WORD...: after the job before; if one fails, the rest are canceled
  local options=(--parsable --export=ALL --job-name=temblor)
  [ -z "$last" ] || options+=(--dependency="afterok:$last" --kill-on-invalid-dep=yes --output="$log")
  while [ "$1" != -- ]; do
    options+=("$1")
    shift
  done
  shift
  last=$(sbatch "${options[@]}" "$0" "$@")
  last=${last%%;*} # the number may be followed by the name of the cluster
}

submit -- --bsp "$@"
log=temblor-$last.log
# Visibility is done in rounds, each of which uses what the one before found; fourteen at most.
for _ in $(seq 14); do
  submit --array="1-$shards" -- --shard vis "$shards" "$@"
  submit -- --merge vis "$@"
done
submit --array="1-$shards" -- --shard light "$shards" "$@"
submit -- --merge light "$@"
echo "$last"
