#!/bin/sh
# The six ways from a history to a diagram, on three scenes (docs/snapshots.md). Builds what it needs.
#   bench/snapshots.sh [BUILD]      BUILD: the build directory, by default `build`
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build}
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DVOROPROOF_BENCH=ON >/dev/null
cmake --build "$build" --target voroproof voroproof_bench_snapshots
mkdir -p "$build/bench/results"
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT

compare() { # NAME OPTIONS...
  name=$1
  shift
  echo "$name: generate reference $*"
  "$build/voroproof" generate reference "$@" -o "$directory/scene.json"
  "$build/voroproof" simulate "$directory/scene.json" -o "$directory/history.jsonl"
  "$build/voroproof_bench_snapshots" "$directory/scene.json" "$directory/history.jsonl" \
    --json "$build/bench/results/snapshots_$name.json"
  echo
}
compare sparse --n 1000 --seed 1 --horizon 40 --density 0.05
compare dense --n 500 --seed 1 --horizon 10 --density 0.4
compare equal --n 1000 --seed 1 --horizon 40 --density 0.05 --rmin 5 --rmax 5
