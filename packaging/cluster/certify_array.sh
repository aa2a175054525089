#!/bin/sh
# One shard of a history, as a task of a Slurm array; voroproof certify --merge joins them afterwards.
#
# usage: sbatch --array=1-N packaging/cluster/certify_array.sh SCENE HISTORY FOLDER [OPTIONS OF certify...]
#
# Task I writes FOLDER/I-of-N.json. Where that is there already, of these bytes, these options and this version, nothing
# is done, and what a lost task has left is taken up. VOROPROOF is the program, else voroproof. It fails where no
# certificate could be made; a history that is refuted or undecided is no failure of the array.
#SBATCH --ntasks=1
#SBATCH --output=%x-%A-%a.out
set -u
scene=$1 history=$2 folder=$3
shift 3
shards=$SLURM_ARRAY_TASK_COUNT
certificate=$folder/$SLURM_ARRAY_TASK_ID-of-$shards.json
mkdir -p "$folder"
said=$("${VOROPROOF:-voroproof}" certify "$scene" "$history" --truth recorded --quiet \
  --part "$SLURM_ARRAY_TASK_ID/$shards" --resume --report "$certificate" "$@")
code=$?
printf '%s\n' "$said"
case $code in
  # A limit that ends the run leaves no certificate, and no verdict on a shard.
  0 | 1 | 3) printf '%s\n' "$said" | grep -q "^s SHARD $SLURM_ARRAY_TASK_ID/$shards " ;;
  *) exit $code ;;
esac
