#!/usr/bin/env bash
# Checks the proofs (docs/proved.md) and tries the program that is extracted from them:
#   - nothing is admitted, no axiom is ours, and the theorem rests on those of the standard library's real numbers alone;
#   - the right histories of the corpus are accepted, but for those of tests/proofs/undecided.txt, for the reason given there;
#   - its wrong histories are not accepted, but for those of tests/proofs/wrong-under-exact-only.txt, which are wrong under
#     the exact truth and right under the recorded one: the kernel must certify these;
#   - histories of simulated scenes of several kinds are accepted, and not accepted with a line left out;
#   - certify --proved certifies a right history;
#   - histories that a certifier with a fault certifies are not accepted (tests/proofs/faults.py);
#   - of 500 wrong worlds none is accepted, where proved_worlds (tests/adversary) is built;
#   - of files made by hand each has the verdict that tests/proofs/attempts.py says.
#
# usage: scripts/check-proofs.sh VOROPROOF [BUILD]      (build/voroproof, with voroproof-kernel beside it; build/proofs)
#        scripts/check-proofs.sh --record VOROPROOF [BUILD]   writes the two lists anew
set -euo pipefail
record=false
[ "${1:-}" = --record ] && record=true && shift
voroproof=$(realpath "$1")
kernel=$(dirname "$voroproof")/voroproof-kernel
cd "$(dirname "$0")/.."
build=$(realpath -m "${2:-build/proofs}")
proved=$build/voroproof-proved
lists=tests/proofs

make -s -C certify/proofs BUILD="$build" all axioms >"/dev/null"

failed=0
complain() {
  echo "$*"
  failed=1
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# No holes, no axioms of ours. Comments of these files do not use the words.
if grep -nwE 'Admitted|admit|Axiom|Axioms|Parameter|Conjecture|Abort|Unset' certify/proofs/*.v | grep -v '^certify/proofs/Audit.v'; then
  complain "proofs: not everything is proved"
fi
axioms=$(grep -oE '^[A-Za-z_.]+' "$build/axioms.txt" | grep -v '^Axioms' | sort -u | tr '\n' ' ')
expected="ClassicalDedekindReals.sig_forall_dec ClassicalDedekindReals.sig_not_dec FunctionalExtensionality.functional_extensionality_dep "
[ "$axioms" = "$expected" ] || complain "the theorem rests on other axioms: $axioms"

# verdict SCENE HISTORY: the last line without "s ", and the reason.
verdict() {
  local code=0
  timeout 600 "$proved" "$1" "$2" >"$scratch/out" 2>"$scratch/err" || code=$?
  local last reason
  last=$(tail -n 1 "$scratch/out")
  reason=$(tail -n 2 "$scratch/out" | head -n 1 | sed -E 's/^c (line [0-9]+: )?//')
  case "$last/$code" in
    "s CERTIFIED/0") echo certified ;;
    "s UNDECIDED/3") echo "undecided: $reason" ;;
    "s INVALID/2") echo "invalid: $reason" ;;
    *) echo "error: '$last', exit $code: $(cat "$scratch/err")" ;;
  esac
}

: >"$scratch/undecided"
: >"$scratch/accepted"
right=0
wrong=0
for case in $(cd corpus/cases && ls -d */*/ | LC_ALL=C sort); do
  case=${case%/}
  scene=corpus/cases/$case/scene.scene.json
  if [ -f "corpus/cases/$case/exact.history.jsonl" ]; then
    right=$((right + 1))
    said=$(verdict "$scene" "corpus/cases/$case/exact.history.jsonl")
    [ "$said" = certified ] || printf '%s\t%s\n' "$case" "$said" >>"$scratch/undecided"
  fi
  for history in "corpus/cases/$case"/wrong/*.history.jsonl; do
    [ -f "$history" ] || continue
    wrong=$((wrong + 1))
    said=$(verdict "$scene" "$history")
    case $said in
      certified)
        printf '%s\t%s\n' "$case" "$(basename "$history" .history.jsonl)" >>"$scratch/accepted"
        [ "$("$kernel" "$scene" "$history" | tail -n 1)" = "s CERTIFIED" ] || complain "$history: accepted, and not by the kernel"
        ;;
      error*) complain "$history: $said" ;;
    esac
  done
done
# Histories with known verdicts under the recorded truth.
while IFS=$'\t' read -r file scene truth _ options; do
  [ "$truth" = recorded ] && [ "$options" = - ] || continue
  case $file in refuted/*.jsonl) ;; *) continue ;; esac
  wrong=$((wrong + 1))
  said=$(verdict "corpus/scenes/$scene.scene.json" "corpus/$file")
  case $said in
    certified) complain "corpus/$file: accepted" ;;
    error*) complain "corpus/$file: $said" ;;
  esac
done <corpus/cases.txt

if $record; then
  mkdir -p "$lists"
  cp "$scratch/undecided" "$lists/undecided.txt"
  cp "$scratch/accepted" "$lists/wrong-under-exact-only.txt"
fi
diff "$lists/undecided.txt" "$scratch/undecided" || complain "right histories: other verdicts than in $lists/undecided.txt"
diff "$lists/wrong-under-exact-only.txt" "$scratch/accepted" || complain "wrong histories: others are accepted than in $lists/wrong-under-exact-only.txt"

# Simulated scenes, and the same with one line left out.
simulated=0
while read -r options; do
  # The options are words of their own.
  # shellcheck disable=SC2086
  "$voroproof" generate reference $options -o "$scratch/a.scene.json" >/dev/null
  "$voroproof" simulate "$scratch/a.scene.json" -o "$scratch/a.history.jsonl" --replace >/dev/null
  said=$(verdict "$scratch/a.scene.json" "$scratch/a.history.jsonl")
  simulated=$((simulated + 1))
  [ "$said" = certified ] || complain "reference $options: $said"
  python3 - "$scratch/a.history.jsonl" "$scratch/b.history.jsonl" <<'END'
import json, sys

lines = open(sys.argv[1]).read().splitlines()
left_out = json.loads(lines.pop(len(lines) // 2))
end = json.loads(lines[-1])
end["end"]["flips" if "flip" in left_out else "collisions"] -= 1
lines[-1] = json.dumps(end)
open(sys.argv[2], "w").write("\n".join(lines) + "\n")
END
  said=$(verdict "$scratch/a.scene.json" "$scratch/b.history.jsonl")
  case $said in
    undecided*) ;;
    *) complain "reference $options, a line left out: $said" ;;
  esac
done <<'END'
--n 30 --seed 1 --horizon 60
--n 60 --seed 2 --horizon 40 --radii equal
--n 60 --seed 3 --horizon 40 --rmin 9.9999999 --rmax 10
--n 60 --seed 4 --horizon 40 --radii log --rmin 0.1 --rmax 30
--n 60 --seed 5 --horizon 20 --density 0.3
--n 60 --seed 6 --horizon 40 --restitution 0.8
END

# Beside the certifier, as its option asks for it.
said=$(PATH="$build:$PATH" "$voroproof" certify "$scratch/a.scene.json" "$scratch/a.history.jsonl" --truth recorded --proved) ||
  complain "certify --proved: $said"
grep -qx 'c proved checker: CERTIFIED' <<<"$said" || complain "certify --proved: $said"

faulty=$(python3 -B tests/proofs/faults.py "$proved") || complain "$faulty"
worlds=$(dirname "$voroproof")/proved_worlds
if [ -x "$worlds" ]; then
  found=$("$worlds" "$proved" --count 500 --seed 1) || complain "$found"
  of_worlds="; $(tail -n 1 <<<"$found")"
fi
by_hand=$(python3 tests/proofs/attempts.py "$proved" "$scratch/attempts") || complain "$by_hand"

[ "$failed" = 0 ] && echo "proved; $right right histories of the corpus, $(wc -l <"$lists/undecided.txt") of them undecided; none of $wrong wrong ones" \
  "accepted that is wrong under the recorded truth; $simulated simulated scenes; $by_hand; $faulty${of_worlds:-}"
exit "$failed"
