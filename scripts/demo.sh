#!/usr/bin/env bash
# From nothing to checked pictures: installs what is missing, builds the program, simulates the
# paper's kind of data (30 disks), certifies the result and draws it. Leaves everything in demo/.
#
# usage: scripts/demo.sh [N [SEED [HORIZON]]]   (a whole number each)
set -euo pipefail
cd "$(dirname "$0")/.."

n=${1:-30}
seed=${2:-1}
horizon=${3:-200}
out=demo
program=build/voroproof

say() { printf '\n== %s\n' "$*"; }
run() {
  printf '$ %s\n' "$*"
  "$@"
}

# A fraction of the horizon, as exact text: fraction NUMERATOR DENOMINATOR.
fraction() {
  local product=$((horizon * $1))
  if ((product % $2 == 0)); then echo $((product / $2)); else echo "$product/$2"; fi
}

# The set of edges of a diagram file: the structure, without coordinates.
edges_of() { sed -n '/^"edges":\[/,$p' "$1"; }

# The structure replayed from the history must be the one constructed afresh from the disks alone.
check_history() {
  local scene=$1 history=$2
  shift 2
  local t replayed=$out/replayed.diagram.json fresh=$out/fresh.diagram.json
  run "$program" validate "$scene" "$history"
  for t in "$@"; do
    "$program" snapshot "$scene" "$history" --at "$t" -o "$replayed"
    "$program" snapshot "$scene" --at "$t" -o "$fresh"
    "$program" validate "$replayed" "$fresh" >/dev/null
    if [ -z "$(edges_of "$fresh")" ] ||
      ! cmp -s <(edges_of "$replayed") <(edges_of "$fresh"); then
      echo "t = $t: the history and the construction from scratch DIFFER" >&2
      return 1
    fi
    echo "t = $t: $(edges_of "$fresh" | grep -c '^\[') edges, equal by the history and from scratch"
  done
  rm -f "$replayed" "$fresh"
}

say "Packages"
scripts/install-deps.sh

say "Building $program"
cmake --preset demo
cmake --build --preset demo -j "${JOBS:-$(nproc)}"

mkdir -p "$out"
scene=$out/scene.json
history=$out/scene.history.jsonl

say "A scene: $n disks, density 0.05, unit speed, up to t = $horizon"
run "$program" generate reference --n "$n" --seed "$seed" --horizon "$horizon" -o "$scene"

say "Its history: every flip of an edge and every collision"
run "$program" simulate "$scene" -o "$history" --stats "$out/stats.json"
tail -n 1 "$history"

say "Its certificate: every event proved, and that none is missing"
for truth in exact recorded; do
  run "$program" certify "$scene" "$history" --truth "$truth" --report "$out/$truth.report.json"
done

say "A wrong history: one flip is missing"
flip=$(grep -n -m 1 '"flip"' "$history" | cut -d : -f 1)
if [ -n "$flip" ]; then
  sed "${flip}d" "$history" >"$out/wrong.history.jsonl"
  "$program" certify "$scene" "$out/wrong.history.jsonl" --report "$out/wrong.report.json" ||
    echo "(exit code $?)"
  "$program" explain "$out/wrong.report.json" -o "$out/wrong.svg" | sed -n 1,6p
fi

say "Movies: open them in a browser"
run "$program" movie "$scene" "$history" --report "$out/exact.report.json" -o "$out/movie.html"
if [ -n "$flip" ]; then
  run "$program" movie "$scene" "$out/wrong.history.jsonl" --report "$out/wrong.report.json" \
    -o "$out/wrong.html"
fi

say "A second check: the diagram replayed from the history, and constructed from the disks alone"
times=()
for percent in 0 10 25 50 75 90 100; do times+=("$(fraction "$percent" 100)"); done
check_history "$scene" "$history" "${times[@]}"

say "Pictures"
for k in 0 1 2 3; do
  picture=$out/frame$k
  run "$program" snapshot "$scene" "$history" --at "$(fraction "$k" 3)" -o "$picture.diagram.json"
  run "$program" render "$picture.diagram.json" -o "$picture.svg"
  run "$program" render "$picture.diagram.json" -o "$picture.png"
done

say "Done: a scene, its history and certificates, movies, statistics and four diagrams with pictures"
ls "$out"
