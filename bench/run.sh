#!/bin/sh
# Builds the benchmarks (Release) and runs them all: about a quarter of an hour on a quiet machine.
#   bench/run.sh [BUILD]      BUILD: the build directory, by default `build`
# Tables go to the terminal, results as JSON to BUILD/bench/results.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build}
results=$build/bench/results

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DVOROPROOF_BENCH=ON
cmake --build "$build" --target voroproof_bench_runs voroproof_bench_growth \
  voroproof_bench_rebuild voroproof_bench_slices voroproof_bench_first_diagram voroproof_bench_resting \
  voroproof_bench_dense voroproof_bench_worlds
# Not there without Google Benchmark.
predicates=$build/voroproof_bench_predicates
if cmake --build "$build" --target help | grep -q voroproof_bench_predicates; then
  cmake --build "$build" --target voroproof_bench_predicates
else
  predicates=
fi
mkdir -p "$results"

whole_run() { # NAME OPTIONS...
  name=$1
  shift
  "$build/voroproof_bench_runs" "$@" --json "$results/run_$name.json"
  echo
}
whole_run reference --n 1000 --horizon 1000 --repeats 7
whole_run reference_10000 --n 10000 --horizon 200 --repeats 3
whole_run dense --n 1000 --horizon 100 --density 0.3 --repeats 5
whole_run equal --n 1000 --horizon 200 --rmin 5 --rmax 5 --repeats 5
whole_run nearly_equal --n 1000 --horizon 200 --rmin 5 --rmax 5.000000005 --repeats 3

cmake --build "$build" --target voroproof
"$root/bench/certify.sh" "$build/voroproof" 1000 1000 3 | tee "$results/certify_1000.txt"
"$root/bench/certify.sh" "$build/voroproof" 10000 200 3 | tee "$results/certify_10000.txt"
echo

for n in 30 100 300; do
  "$build/voroproof_bench_rebuild" --n $n --horizon 100 --repeats 3 --json "$results/rebuild_$n.json"
done
echo

for n in 100 1000 10000; do
  "$build/voroproof_bench_worlds" --n $n --horizon 5 --json "$results/worlds_$n.json"
done
echo

"$build/voroproof_bench_first_diagram" --json "$results/first_diagram.json"
echo
"$build/voroproof_bench_resting" --json "$results/resting.json"
echo
"$build/voroproof_bench_slices" --json "$results/slices.json"
echo
"$build/voroproof_bench_dense" --json "$results/dense.json"
echo

# The denser, the shorter.
growth() { # NAME OPTIONS...
  name=$1
  shift
  "$build/voroproof_bench_growth" "$@" --json "$results/growth_$name.json"
  echo
}
growth 0.05 --density 0.05 --horizon 120
growth 0.05_large --density 0.05 --horizon 20 --sizes 100000 300000 1000000 --repeats 1
growth 0.3 --density 0.3 --horizon 5 --sizes 1000 3000 10000 30000 100000
growth 0.5 --density 0.5 --horizon 2 --sizes 1000 3000 10000 30000 100000
"$root/scripts/plot-growth.py" "$results"/growth_*.json -o "$results/growth" ||
  echo "the growth is not drawn: scripts/install-deps.sh plots"
echo

"$root/bench/snapshots.sh" "$build" | tee "$results/snapshots.txt"
echo

if [ -n "$predicates" ]; then
  "$predicates" --benchmark_min_time=0.2 --benchmark_counters_tabular=true \
    --benchmark_out="$results/predicates.json" --benchmark_out_format=json
fi
echo "results: $results"
