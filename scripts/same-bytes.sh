#!/usr/bin/env bash
# Fails unless a history has the same bytes whatever computed it: filters on or off, little or much
# precision to begin with, one thread or several, and one program or another of the same version (other
# compilers, other optimization). Every option takes other ways through the code, and every compiler
# other instructions, so a decision that depends on rounding shows as a difference. Each program
# certifies the history under both truths, with one report.
#
# usage: scripts/same-bytes.sh [--small] PROGRAM...
#   PROGRAM  a built voroproof; the first is the one that the others are compared with
#   --small  fewer disks and runs: some seconds for one program (the test "same_bytes")
#
# One line for each scene: its events, the number of histories compared, their SHA-256. For a scene
# with a difference, what each run gave as well. Exit code 1 for any difference, for a scene without
# an event and for a run that fails; 2 for bad usage.
set -euo pipefail

small=false
if [ "${1:-}" = --small ]; then
  small=true
  shift
fi
if [ $# -eq 0 ] || [[ $1 == -* ]]; then
  echo "usage: scripts/same-bytes.sh [--small] PROGRAM..." >&2
  exit 2
fi
programs=("$@")
for program in "${programs[@]}"; do
  if [ ! -f "$program" ] || [ ! -x "$program" ]; then
    echo "same-bytes: no program: $program" >&2
    exit 2
  fi
done

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
scene=$scratch/scene.json
results=$scratch/results
failed=0
scenes=0

sha256_of() { sha256sum <"$1" | cut -d ' ' -f 1; }

# generate PROGRAM OPTIONS...: writes the scene and adds its hash to the results.
generate() {
  local program=$1
  shift
  if "$program" generate "$@" -o "$scene" 2>"$scratch/errors"; then
    echo "$(sha256_of "$scene") $program generate" >>"$results"
  else
    echo "failed $program generate: $(tail -n 1 "$scratch/errors")" >>"$results"
  fi
}

# simulate PROGRAM FILTERS BITS THREADS: computes a history and adds its hash to the results. A run that
# stops early fails: where a budget ends it may depend on these, so there is nothing to compare.
simulate() {
  local program=$1
  shift
  export VOROPROOF_FILTERS=$1 VOROPROOF_START_BITS=$2
  # What an earlier run left must not be taken for this one's.
  rm -f "$scratch/history"
  if "$program" simulate "$scene" -o "$scratch/history" --quiet --threads "$3" 2>"$scratch/errors"; then
    echo "$(sha256_of "$scratch/history") $program $*" >>"$results"
  else
    echo "failed $program $*: $(tail -n 1 "$scratch/errors")" >>"$results"
  fi
}

# certify PROGRAM TRUTH: certifies the last history and adds the hash of the report to the results.
certify() {
  rm -f "$scratch/report"
  if "$1" certify "$scene" "$scratch/history" --truth "$2" --report "$scratch/report" --quiet \
    >/dev/null 2>"$scratch/errors"; then
    echo "$(sha256_of "$scratch/report") $1 certify --truth $2" >>"$results"
  else
    echo "failed $1 certify --truth $2: $(tail -n 1 "$scratch/errors")" >>"$results"
  fi
}

# Of the results so far: whether there is a failed run; whether all are one and the same hash.
any_failed() { grep -q '^failed ' "$results"; }
all_equal() { ! any_failed && [ "$(cut -d ' ' -f 1 "$results" | sort -u | wc -l)" -eq 1 ]; }

# same_bytes FILTERS OPTIONS...: one scene, made with the OPTIONS of generate; FILTERS is "on", or
# "on off" where exact arithmetic alone is fast enough.
same_bytes() {
  local filters=$1
  shift
  local verdict=same program filter bits threads runs events truth hash name="$*"
  scenes=$((scenes + 1))

  # The scene itself is the same by all programs, or their histories need not be.
  : >"$results"
  for program in "${programs[@]}"; do generate "$program" "$@"; done
  if ! all_equal; then
    echo "DIFFERENT SCENES: $name"
    sed 's/^/  /' "$results"
    failed=1
    return
  fi

  : >"$results"
  for program in "${programs[@]}"; do
    for filter in $filters; do
      for bits in "${start_bits[@]}"; do
        for threads in 1 2 5; do
          simulate "$program" "$filter" "$bits" "$threads"
        done
      done
    done
  done
  runs=$(wc -l <"$results")
  # A history is a header, the events and an end, one line each.
  events=0
  if [ -f "$scratch/history" ]; then events=$(($(wc -l <"$scratch/history") - 2)); fi
  if any_failed; then
    verdict=FAILED
  elif ! all_equal; then
    verdict=DIFFERENT
  elif [ "$events" -le 0 ]; then
    verdict="NO EVENTS"
  fi
  hash=$(head -n 1 "$results" | cut -c 1-16)
  if [ "$verdict" = same ]; then
    for truth in exact recorded; do
      : >"$results"
      for program in "${programs[@]}"; do certify "$program" "$truth"; done
      if ! all_equal; then verdict="OTHER REPORTS" && break; fi
    done
  fi
  if [ "$verdict" = same ]; then
    echo "same: $name: $events events, $runs histories, sha256 $hash"
  else
    echo "$verdict: $name"
    sed 's/^/  /' "$results"
    failed=1
  fi
}

# The sizes. Without filters a run costs ten to a hundred times as much, and more with much precision
# to begin with: hence few disks there, and more disks with the filters on.
if $small; then
  start_bits=(64 4096)
  reference=(--n 8 --density 0.2 --horizon 20)
  swarm=(--n 5 --horizon 20)
else
  start_bits=(64 192 1024 4096)
  reference=(--n 20 --density 0.2 --horizon 30)
  swarm=(--n 12 --horizon 20)
fi
# Enough for a run in slices of time.
many=(--n 600 --density 0.2 --horizon 60)

# With restitution 0.8 the speeds, which are all equal at first, differ after the first collisions.
for radii in uniform log equal; do
  for restitution in 1 0.8; do
    kind=(--radii "$radii" --restitution "$restitution" --seed 3)
    same_bytes "on off" reference "${reference[@]}" "${kind[@]}"
    if ! $small; then same_bytes on reference "${many[@]}" "${kind[@]}"; fi
  done
done

# Lattices are made of ties. A common motion ends here just before exact arithmetic exceeds its
# budget, at t = 8.59. A lattice at rest has no events.
same_bytes "on off" grid --motion random --n 9 --horizon 10
same_bytes "on off" grid --motion shear --n 9 --horizon 10
same_bytes "on off" grid --motion common --n 9 --horizon 8.5
same_bytes "on off" swarm "${swarm[@]}"
# All start and stop together: ties at an instant, between flips and for good.
same_bytes "on off" formation --n 8 --flight square,turn,shear,frame,circle --horizon 20
if ! $small; then same_bytes on formation --preset segments58; fi

if [ $failed -ne 0 ]; then
  echo "same-bytes: FAILED: see above"
  exit 1
fi
echo "same-bytes: $scenes scenes, ${#programs[@]} program(s): the same bytes"
