#!/usr/bin/env bash
# Fuzzes the readers and certify, and prints how often each was run.
#
# usage: scripts/fuzz.sh [MINUTES] [FOLDER]     60 minutes and build-fuzz/finds without arguments
#
# A third of the time goes to libFuzzer, guided by coverage, with address and undefined-behaviour
# sanitizers, by clang++; what it finds new stays in FOLDER/corpus for the next time. The rest goes to
# the driver of the tests without instrumentation, which is many times faster, with new seeds of its
# chance in every round. One process for each processor. Exit code 1 where there is a find, whose bytes
# are in FOLDER then; tests/fuzz/README.md says what to do with it.
set -euo pipefail
cd "$(dirname "$0")/.."

minutes=${1:-60}
out=${2:-build-fuzz/finds}
jobs=$(nproc)
mkdir -p "$out/corpus" "$out/logs"
rm -f "$out"/logs/*

cmake --preset release >/dev/null
cmake --build --preset release -j "$jobs" --target fuzz voroproof
cmake --preset fuzz >/dev/null
mapfile -t targets < <(build/fuzz --targets | cut -d ' ' -f 1)
cmake --build build-fuzz -j "$jobs" --target "${targets[@]/#/fuzz-}"
tests/fuzz/seeds.py build/voroproof "$out/seeds"

# guided TARGET SECONDS
guided() {
  mkdir -p "$out/corpus/$1"
  local kept=()
  [ -d "tests/fuzz/cases/$1" ] && kept=("tests/fuzz/cases/$1")
  "build-fuzz/fuzz-$1" "$out/corpus/$1" "$out/seeds/$1" "${kept[@]}" -max_total_time="$2" \
    -max_len=8192 -timeout=30 -rss_limit_mb=2048 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$out/guided-$1-" >"$out/logs/guided-$1" 2>&1
}

# quick TARGET SECONDS: rounds of the driver, each with another seed.
quick() {
  local round=0 end=$((SECONDS + $2))
  while [ "$SECONDS" -lt "$end" ]; do
    round=$((round + 1))
    build/fuzz "$1" "$out/seeds/$1" --runs "$(($(runs_of "$1") * 5))" --seed "$round$RANDOM" \
      --out "$out" >>"$out/logs/quick-$1" 2>&1 || return 1
  done
}
runs_of() { build/fuzz --targets | awk -v t="$1" '$1 == t { print $2 }'; }

export out
export -f guided quick runs_of
seconds=$((minutes * 60 * jobs / ${#targets[@]}))
failed=0
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c "guided {} $((seconds / 3))" || failed=1
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c "quick {} $((2 * seconds / 3))" || failed=1

printf '%-16s %14s %14s\n' target guided quick
for target in "${targets[@]}"; do
  guided=$(awk '/stat::number_of_executed_units/ { print $2 }' "$out/logs/guided-$target")
  quick=$(awk '$3 == "seeds" { n += $4 } END { print n + 0 }' "$out/logs/quick-$target")
  printf '%-16s %14s %14s\n' "$target" "${guided:-0}" "$quick"
done | tee "$out/table" 
awk '{ n += $2 + $3 } END { printf "%-16s %14s\n", "all", n }' "$out/table"
if [ "$failed" -ne 0 ]; then
  echo "finds:" && ls "$out" | grep -E '^(find|guided)-'
fi
exit "$failed"
