#!/usr/bin/env bash
# Fuzzes the readers and certify, and prints how often each was run.
#
# usage: scripts/fuzz.sh [MINUTES] [FOLDER]     60 minutes and build-fuzz/finds without arguments
#
# A third of the time goes to libFuzzer, guided by coverage, with address and undefined-behaviour
# sanitizers, by clang++; what it finds new stays in FOLDER/corpus for the next time. The rest goes to
# the driver of the tests without instrumentation, which is many times faster, with new seeds of its
# chance in every round, and likewise to readers that are no part of the program: the certifier's page
# (where there is node), the proved checker (build/proofs/voroproof-proved, if there) and the importers
# in Python (build/python, if built). One process for each processor. Exit code 1 where there is a find,
# whose bytes are in FOLDER then (of the importers the words and the seed in FOLDER/logs);
# tests/fuzz/README.md says what to do with it.
set -euo pipefail
cd "$(dirname "$0")/.."

minutes=${1:-60}
out=${2:-build-fuzz/finds}
jobs=$(nproc)
mkdir -p "$out/corpus" "$out/logs"
rm -f "$out"/logs/*

cmake --preset release >/dev/null
cmake --build --preset release -j "$jobs" --target fuzz voroproof voroproof-kernel
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

# other READER SECONDS: rounds of a reader that is no part of the program.
other() {
  local round=0 end=$((SECONDS + $2)) code checker=build/voroproof-kernel
  [ "$1" = proved ] && checker=build/proofs/voroproof-proved
  while [ "$SECONDS" -lt "$end" ]; do
    round=$((round + 1))
    code=0
    if [ "$1" = importers ]; then
      importers "$round$RANDOM" || code=$?
    else
      tests/fuzz/checkers.py "$1" build/fuzz build/voroproof "$checker" --runs 1000 --seed "$round$RANDOM" \
        --out "$out" || code=$?
    fi >>"$out/logs/other-$1" 2>&1
    [ "$code" -eq 77 ] && return 0
    [ "$code" -ne 0 ] && return 1
  done
  return 0
}
# importers SEED: eleven formats with 250 changed files each, two others with 60, ten times.
importers() {
  echo "seed $1"
  VOROPROOF_FUZZ_TIMES=10 VOROPROOF_FUZZ_SEED=$1 PYTHONPATH=build/python "$python" -B -m pytest -q -p no:cacheprovider \
    tests/python/test_importers_refuse.py -k whatever_is_broken && echo "importers 28700 runs"
}

python=$(sed -n 's/^VOROPROOF_PYTHON_FOUND:[A-Z]*=//p' build/CMakeCache.txt)
export out python
export -f guided quick runs_of other importers
others=(page proved)
ls build/python/voroproof/_core* >/dev/null 2>&1 && others+=(importers)
seconds=$((minutes * 60 * jobs / (${#targets[@]} + ${#others[@]})))
failed=0
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c "guided {} $((seconds / 3))" || failed=1
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c "quick {} $((2 * seconds / 3))" || failed=1
printf '%s\n' "${others[@]}" | xargs -P "$jobs" -I{} bash -c "other {} $seconds" || failed=1

printf '%-16s %14s %14s\n' target guided quick
for target in "${targets[@]}"; do
  guided=$(awk '/stat::number_of_executed_units/ { print $2 }' "$out/logs/guided-$target")
  quick=$(awk '$3 == "seeds" { n += $4 } END { print n + 0 }' "$out/logs/quick-$target")
  printf '%-16s %14s %14s\n' "$target" "${guided:-0}" "$quick"
done | tee "$out/table"
for other in "${others[@]}"; do
  printf '%-16s %14s %14s\n' "$other" 0 "$(awk '$3 == "runs" { n += $2 } END { print n + 0 }' "$out/logs/other-$other")"
done | tee -a "$out/table"
awk '{ n += $2 + $3 } END { printf "%-16s %14s\n", "all", n }' "$out/table"
if [ "$failed" -ne 0 ]; then
  echo "finds:" && ls "$out" | grep -E '^(find|guided)-'
fi
exit "$failed"
