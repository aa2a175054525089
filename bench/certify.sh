#!/usr/bin/env bash
# What certifying costs beside simulating: both in turns, in one run, medians of user and wall time.
# `apart` are two runs on one thread each at the same time: processes that share nothing, so that they
# tell what a second thread could gain at best on this machine.
#
# usage: bench/certify.sh PROGRAM [N [HORIZON [REPEATS]]]
set -euo pipefail
program=$(realpath "$1")
n=${2:-1000}
horizon=${3:-1000}
repeats=${4:-3}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
scene=$scratch/a.scene.json
history=$scratch/a.history.jsonl
"$program" generate reference --n "$n" --seed 1 --horizon "$horizon" -o "$scene"

# measure NAME COMMAND...: appends "user wall kilobytes" to the file of that name.
measure() {
  local name=$1
  shift
  command time -a -o "$scratch/$name" -f '%U %e %M' "$@" >/dev/null
}
for ((k = 0; k < repeats; k++)); do
  measure simulate "$program" simulate "$scene" -o "$history" --quiet
  measure recorded-1 "$program" certify "$scene" "$history" --truth recorded --threads 1 --quiet
  measure recorded-2 "$program" certify "$scene" "$history" --truth recorded --threads 2 --quiet
  measure exact-1 "$program" certify "$scene" "$history" --truth exact --threads 1 --quiet
  measure exact-2 "$program" certify "$scene" "$history" --truth exact --threads 2 --quiet
  pids=()
  for name in apart-a apart-b; do
    measure $name "$program" certify "$scene" "$history" --truth recorded --threads 1 --quiet &
    pids+=($!)
  done
  wait "${pids[@]}"
done
cat "$scratch"/apart-? >"$scratch/apart"

# median NAME COLUMN
median() { sort -n -k "$2" "$scratch/$1" | awk -v c="$2" '{ v[NR] = $c } END { print v[int((NR + 1) / 2)] }'; }
events=$(($(wc -l <"$history") - 2))
echo "n = $n, T = $horizon: $events events; medians of $repeats"
printf '%-12s %8s %8s %10s %22s\n' what 'user s' 'wall s' 'peak MB' 'wall / simulate wall'
base=$(median simulate 2)
for name in simulate recorded-1 recorded-2 apart exact-1 exact-2; do
  printf '%-12s %8s %8s %10s %22s\n' "$name" "$(median $name 1)" "$(median $name 2)" \
    "$(median $name 3 | awk '{ printf "%.1f", $1 / 1024 }')" \
    "$(median $name 2 | awk -v b="$base" '{ printf "%.2f", $1 / b }')"
done
# Of the runs of one turn, which the machine's mood concerns alike.
gain() { paste "$scratch/$3" "$1" | awk -v f="$2" '{ print f * $2 / $5 }' | sort -n |
  awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
paste "$scratch/apart-a" "$scratch/apart-b" | awk '{ print 0, ($2 > $5 ? $2 : $5), 0 }' >"$scratch/both"
printf 'the second thread makes it %.2f times faster (exact truth: %.2f); two processes do twice the work %.2f times as fast\n' \
  "$(gain "$scratch/recorded-2" 1 recorded-1)" "$(gain "$scratch/exact-2" 1 exact-1)" "$(gain "$scratch/both" 2 recorded-1)"
