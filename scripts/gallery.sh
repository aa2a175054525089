#!/usr/bin/env bash
# Makes the pictures of docs/gallery and its index, docs/gallery/README.md: counterparts of the
# paper's figures, and what the program draws besides. Needs the built program, a minute or so, and
# chromium for the stills of movies (scripts/install-deps.sh browser).
#
# usage: scripts/gallery.sh [PROGRAM]
#
# A figure is a `figure` line and a `panel` line for each of its pictures. What a panel's command
# draws goes into the file that it gets as its last argument.
set -euo pipefail
cd "$(dirname "$0")/.."

program=$(realpath "${1:-build/voroproof}")
out=docs/gallery
index=$out/README.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
command -v chromium >/dev/null || {
  echo "gallery: chromium is not installed: scripts/install-deps.sh browser" >&2
  exit 1
}

# ---- Scenes and what follows from them, in $work under a name

# scene NAME GENERATOR ARGUMENTS...: the scene and its history.
scene() {
  local name=$1
  shift
  "$program" generate "$@" -o "$work/$name.scene.json"
  "$program" simulate "$work/$name.scene.json" -o "$work/$name.history.jsonl" --quiet
}

# certified NAME: the report on its history.
certified() {
  "$program" certify "$work/$1.scene.json" "$work/$1.history.jsonl" --quiet \
    --report "$work/$1.report.json" >"$work/verdict" 2>&1 || tail -n 1 "$work/verdict"
}

# without_flip NAME NEW K: the scene with a history that lacks flip K.
without_flip() {
  local line
  line=$(grep -n '"flip"' "$work/$1.history.jsonl" | sed -n "$3p" | cut -d : -f 1)
  cp "$work/$1.scene.json" "$work/$2.scene.json"
  sed "${line}d" "$work/$1.history.jsonl" >"$work/$2.history.jsonl"
}

# ---- Pictures; the last argument is the file to write

# diagram NAME TIME SIZE FILE
diagram() {
  "$program" snapshot "$work/$1.scene.json" "$work/$1.history.jsonl" --at "$2" \
    -o "$work/diagram.json"
  "$program" render "$work/diagram.json" --size "$3" -o "$4"
}

# still NAME PLACE SIZE FILE: the movie opened at a place such as t=12.5 or event=17&follow=3, in a
# window of so many pixels, as 1200,780; a PNG or a WebP (smaller) by the name of FILE.
still() {
  local report=()
  [ ! -e "$work/$1.report.json" ] || report=(--report "$work/$1.report.json")
  "$program" movie "$work/$1.scene.json" "$work/$1.history.jsonl" "${report[@]}" \
    -o "$work/movie.html"
  # Browsers refuse to run as root, as containers do, with their sandbox on.
  timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars \
    --user-data-dir="$work/profile" --window-size="$3" --virtual-time-budget=2000 \
    --screenshot="$PWD/$4" "file://$work/movie.html#$2" >"$work/browser.log" 2>&1
}

# evidence NAME FILE: what refutes its history.
evidence() { "$program" explain "$work/$1.report.json" -o "$2" >"$work/words"; }

# ---- The index

open_row=
close_row() {
  [ -z "$open_row" ] || printf '\n' >>"$index"
  open_row=
}

# figure TITLE TEXT
figure() {
  close_row
  printf '## %s\n\n%s\n\n' "$1" "$2" >>"$index"
  echo "$1"
}

# panel FILE WIDTH DESCRIPTION COMMAND...: WIDTH is that of the picture on the page, in pixels.
panel() {
  local file=$1 width=$2 description=$3
  shift 3
  "$@" "$out/$file"
  printf '<img src="%s" width="%s" alt="%s" title="%s">\n' \
    "$file" "$width" "$description" "$description" >>"$index"
  open_row=yes
}

mkdir -p "$out"
cat >"$index" <<'TEXT'
# Gallery

Counterparts of the paper's figures, and what else the program draws. `scripts/gallery.sh` makes all of it and this page.

TEXT

# ---- The figures

scene swarm formation --preset figure24
figure "Figure 24: from a square to a circle" \
  "Twenty objects on a square frame (t = 0) fly to a circle (t = 16) on straight lines, and their diagrams."
for t in 0 16; do
  panel "figure24-t$t.png" 400 "The diagram at t = $t" diagram swarm "$t" 480
done

figure "Figure 25: on the way" "The same flight at t = 4, 8 and 12."
for t in 4 8 12; do
  panel "figure25-t$t.png" 270 "The diagram at t = $t" diagram swarm "$t" 420
done

scene small reference --n 30 --seed 1 --horizon 100
certified small
figure "The movie" \
  "\`voroproof movie\` makes a page that plays a history. Here a flip is looked at: the four disks and their common circle."
panel movie-flip.webp 820 "A flip of the edge between the wall and disk 9" still small "event=118" 1200,780

scene large reference --n 1000 --seed 1 --horizon 60
certified large
figure "A thousand disks" "Cells coloured by their number of neighbours; what has just happened flashes."
panel movie-thousand.webp 640 "1000 disks in the player" still large "t=40&colours=neighbours&bare" 900,800

without_flip small wrong 100
certified wrong
figure "A refutation" \
  "A history from which one flip is missing: proved up to there, refuted from there on, with the evidence drawn. The four disks touch one circle at the moment at which the claimed diagram ceases to be one."
panel movie-refuted.webp 560 "The refuted history in the player" still wrong "t=52.9566" 1200,780
panel refutation.png 260 "The evidence, as explain draws it" evidence wrong

scene flight formation --preset h-to-y
certified flight
figure "A flight in formation" "19 vehicles turn an H into a Y. Many events share an instant; each tie is proved."
panel movie-formation.webp 820 "From H to Y, coloured by speed" still flight "t=7&colours=speed" 1200,780

scene show formation --preset drones2018
figure "A show of 2018 drones" "In the third figure of the flight."
panel drones2018.png 560 "2018 disks" diagram show 40 720
close_row

for picture in "$out"/*.png "$out"/*.webp; do
  size=$(stat -c %s "$picture")
  [ "$size" -lt 300000 ] || echo "gallery: $picture has $size bytes" >&2
done
