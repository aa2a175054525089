#!/usr/bin/env bash
# Makes the pictures of docs/gallery and its index, docs/gallery/README.md: counterparts of the
# paper's figures, and what the program draws besides. Needs the built program, chromium for the
# stills of movies and matplotlib (with PIL) (scripts/install-deps.sh browser plots); a minute or two, and an
# hour on two processors for the experiments.
#
# usage: scripts/gallery.sh [PROGRAM [FOLDER]]
#
# FOLDER keeps the results of the experiments, SET.json: what it has is not run again.
#
# A figure is a `figure` line and a `panel` line for each of its pictures. What a panel's command
# draws goes into the file that it gets as its last argument.
set -euo pipefail
cd "$(dirname "$0")/.."

program=$(realpath "${1:-build/voroproof}")
out=docs/gallery
index=$out/README.md
work=$(mktemp -d)
experiments=${2:-$work}
mkdir -p "$experiments"
trap 'rm -rf "$work"' EXIT
/usr/bin/python3 -c "import matplotlib" 2>"$work/import" || {
  echo "gallery: matplotlib is not installed: scripts/install-deps.sh plots" >&2
  exit 1
}
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

# planned NAME: the plan of that preset, its report and its scene.
planned() {
  "$program" plan --preset "$1" -o "$work/$1.scene.json" --report "$work/$1.plan.json" --quiet
}

# ---- Pictures; the last argument is the file to write

# diagram NAME TIME SIZE FILE
diagram() {
  "$program" snapshot "$work/$1.scene.json" "$work/$1.history.jsonl" --at "$2" \
    -o "$work/diagram.json"
  "$program" render "$work/diagram.json" --size "$3" -o "$4"
}

# probed NAME TIME RADIUS SIZE FILE: where a probe of that radius fits.
probed() {
  "$program" snapshot "$work/$1.scene.json" "$work/$1.history.jsonl" --at "$2" \
    -o "$work/diagram.json"
  "$program" render "$work/diagram.json" --probe "$3" --size "$4" -o "$5"
}

# measured SET FILE: an experiment of the paper's at its full size, and its plots. Only those of the
# initial speed have a panel of predictions, which take longer than all else.
measured() {
  local predictions=()
  [ "$1" != speed ] || predictions=(--predictions)
  [ -e "$experiments/$1.json" ] ||
    PYTHONPATH=$(dirname "$program")/python bench/paper/experiment.py "$program" "$1" --scale 1 --seeds 5 \
      --threads "$(nproc)" "${predictions[@]}" -o "$experiments/$1.json"
  bench/paper/plot.py "$experiments/$1.json" -o "$work"
  mv "$work/$1.png" "$2"
}

# ways PRESET SIZE FILE: starts, goals and ways of a plan.
ways() {
  "$program" plan --preset "$1" -o "$work/ways.scene.json" --size "$2" --picture "$3" --quiet
}

# moments PRESET TIMES FILE: the plan at these times, with what it avoids about then.
moments() { /usr/bin/python3 scripts/plot-plan.py --times "$2" "$work/$1.plan.json" "$3"; }

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
    --screenshot="$(realpath -m "$4")" "file://$work/movie.html#$2" >"$work/browser.log" 2>&1
}

# film NAME FROM TO STEPS SIZE WIDTH FILE: the movie played from one time to another in so many steps, as a WebP that moves,
# stands for four seconds at its last picture and begins again. WIDTH is in pixels.
film() {
  local k t
  mkdir -p "$work/film"
  rm -f "$work/film"/*
  for ((k = 0; k <= $4; k++)); do
    t=$(awk -v a="$2" -v b="$3" -v k="$k" -v n="$4" 'BEGIN { printf "%.6f", a + (b - a) * k / n }')
    still "$1" "t=$t" "$5" "$work/film/$(printf %04d "$k").png"
  done
  /usr/bin/python3 - "$work/film" "$6" "$7" <<'PYTHON'
import pathlib, sys
from PIL import Image
width, pictures = int(sys.argv[2]), []
for path in sorted(pathlib.Path(sys.argv[1]).iterdir()):
    picture = Image.open(path).convert("RGB")
    pictures.append(picture.resize((width, picture.height * width // picture.width), Image.LANCZOS))
pictures[0].save(sys.argv[3], save_all=True, append_images=pictures[1:], duration=[200] * (len(pictures) - 1) + [4000],
                 loop=0, quality=35, method=6)
PYTHON
}

# evidence NAME FILE: what refutes its history.
evidence() { "$program" explain "$work/$1.report.json" -o "$2" >"$work/words"; }

# at_rest NAME TABLE [OPTION...]: the diagram of x, y and radius, disk by disk, as $work/rest/NAME.png.
at_rest() {
  local name=$1 table=$2
  shift 2
  mkdir -p "$work/rest"
  tr ' ' '\n' <<<"$table" >"$work/disks.csv"
  "$program" diagram "$work/disks.csv" "$@" --size 300 -o "$work/rest/$name.png"
}

# degenerate FILE: six of them, three in a row.
degenerate() {
  at_rest 1 "$(for x in 0 4 8 12; do for y in 0 4 8 12; do printf '%s' "$x,$y,1 "; done; done | sed 's/ $//')"
  at_rest 2 "25,0,4 7,24,4 -7,24,4 -25,0,4 -24,-7,4 0,-25,4 15,-20,4 24,7,4"
  at_rest 3 "0,0,1 4,0,1 8,0,1 12,0,1 16,0,1" --box=-2,-10,18,10
  at_rest 4 "0,0,6 1,1,2 1,1,2 2,-3,1 14,0,3 14,0,3 5,12,0 5,12,0"
  at_rest 5 "0,0,5 3,0,2 -4,0,1 12,3,2 12,4,1 3,12,1"
  at_rest 6 "0,0,1 3,0,2 0,4,3" --frame 3,4,6
  /usr/bin/python3 - "$work/rest" "$1" <<'PYTHON'
import pathlib, sys
from PIL import Image
whole = Image.new("RGB", (900, 600), "white")
for k, path in enumerate(sorted(pathlib.Path(sys.argv[1]).iterdir())):
    whole.paste(Image.open(path), (300 * (k % 3), 300 * (k // 3)))
whole.quantize(96, dither=Image.Dither.NONE).save(sys.argv[2], optimize=True)
PYTHON
}

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
  printf '<img src="%s" width="%s" alt="%s">\n' "$file" "$width" "$description" >>"$index"
  open_row=yes
}

mkdir -p "$out"
cat >"$index" <<'TEXT'
# Gallery

`scripts/gallery.sh` makes this page: counterparts of the paper's figures, and more.

TEXT

# ---- The figures

scene probed reference --n 30 --seed 3 --density 0.2 --horizon 60
figure "Figure 2: offsets, voids and tunnels" \
  "The rows show 30 disks at t = 0 and 40: the diagram, then where probes of radius 5 and 7 fit (\`voroproof render DIAGRAM --probe R\`). Red is the offset, strong lines are tunnels."
for t in 0 40; do
  panel "figure2-t$t.png" 270 "Diagram at t=$t" diagram probed "$t" 400
  for radius in 5 7; do
    panel "figure2-t$t-probe$radius.png" 270 "Probe radius $radius, t=$t" \
      probed probed "$t" "$radius" 400
  done
  close_row
done

figure "Figures 18 to 22: the experiments" \
  "These are the paper's data sets at full size ([experiments.md](../experiments.md)). Bars are standard deviations over five seeds, but among the disks for distances and speeds. Predictions are all roots of a flip polynomial."
panel figure18.png 820 "Fig. 18, number of disks: seconds" measured reference
close_row
panel figure19.png 820 "Fig. 19, initial speed: seconds, events, predictions" measured speed
close_row
panel figure20.png 820 "Fig. 20, greatest radius: events, distances, speeds" measured size
close_row
panel figure21.png 820 "Fig. 21, density: events, distances, speeds" measured density
close_row
panel figure22.png 820 "Fig. 22, restitution: flips and collisions" measured restitution

figure "Figure 23: five vehicles" \
  "\`voroproof plan --preset five -o SCENE --picture FILE\` draws this. At even speeds vehicle 0 would hit vehicle 1 at t = 8 (violet cross). It waits at the orange dot instead. Red is the nearest approach."
panel figure23.png 480 "Five vehicles and their ways" ways five 600

planned square-to-circle
figure "Figure 24a: ways from square to circle" \
  "The preset is \`square-to-circle\`; \`voroproof render REPORT\` draws the same. Orange dots are changes of speed."
panel figure24a.png 560 "Twenty straight ways" ways square-to-circle 720

"$program" simulate "$work/square-to-circle.scene.json" -o "$work/square-to-circle.history.jsonl" --quiet
figure "Figure 24: from a square to a circle" \
  "They start at t = 0 and end at t = 60."
for t in 0 60; do
  panel "figure24-t$t.png" 400 "Diagram at t=$t" diagram square-to-circle "$t" 480
done

figure "Figure 25: on the way" "The same flight is shown at t = 22, 34 and 46."
for t in 22 34 46; do
  panel "figure25-t$t.png" 270 "Diagram at t=$t" diagram square-to-circle "$t" 420
done

figure "Figure 26: speeds change and ways do not" \
  "\`scripts/plot-plan.py\` draws the plan of Figure 24a from its report. An ellipse holds a pair with a conjunction predicted within a unit of that time; the vehicle that changes its speed is red. The plan keeps gaps of 0.5."
panel figure26.png 820 "The flight at six times" moments square-to-circle 0,22,30,40,48,60

scene small reference --n 30 --seed 1 --horizon 100
certified small
figure "The movie" \
  "\`voroproof movie\` makes a page that plays a history, here a flip."
panel movie-flip.webp 820 "A flip of the edge between the wall and disk 9" still small "event=118" 1200,780

scene large reference --n 1000 --seed 1 --horizon 60
certified large
figure "A thousand disks" "Cells are coloured by their number of neighbours."
panel movie-thousand.webp 640 "1000 disks in the player" still large "t=40&colours=neighbours&bare" 900,800

without_flip small wrong 100
certified wrong
figure "A refutation" \
  "This history lacks one flip, and is refuted where four disks touch one circle."
panel movie-refuted.webp 560 "The refuted history, played up to its fault" film wrong 48.956677 52.956677 16 1200,780 720
panel refutation.png 260 "The evidence, as explain draws it" evidence wrong

scene flight formation --preset h-to-y
certified flight
figure "A flight in formation" "19 vehicles turn an H into a Y. Every tie of their events is proved."
panel movie-formation.webp 820 "From H to Y, coloured by speed" still flight "t=7&colours=speed" 1200,780

figure "Degenerate diagrams at rest" \
  "\`voroproof diagram\` draws a grid, disks on a circle and on a line, nested and coinciding ones, some hidden at tangency (broken rims), and disks that touch each other and their frame."
panel degenerate.png 820 "Six diagrams" degenerate

scene show formation --preset drones2018
figure "A show of 2018 drones" "This is the third figure of the preset \`drones2018\`."
panel drones2018.png 560 "2018 disks" diagram show 40 720
close_row

for picture in "$out"/*.png "$out"/*.webp; do
  size=$(stat -c %s "$picture")
  [ "$size" -lt 250000 ] || echo "gallery: $picture has $size bytes" >&2
done
