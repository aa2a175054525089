#!/usr/bin/env bash
# Makes the site of the documents in build/site: by Sphinx, from the documents themselves, with a player
# and a certifier's page that the program writes, the notebooks as they run, and the references of Python and C++.
# Fails where Sphinx or Doxygen warns, a link leads nowhere, or a page would load something from the network.
#
# usage: scripts/site.sh [PROGRAM]     (build/voroproof)
#
# What it takes: scripts/install-deps.sh site. The notebooks run where the Python module is built beside the
# program for the system's python3, and are shown without results elsewhere.
set -euo pipefail
cd "$(dirname "$0")/.."

program=$(realpath "${1:-build/voroproof}")
modules=$(dirname "$program")/python
python=/usr/bin/python3
out=build/site
source=build/site-source
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ -x "$program" ] || {
  echo "site: $program is not built: make" >&2
  exit 1
}
rm -rf "$out" "$source"
mkdir -p "$source"

# The documents and what they link to, in their own layout, as links: nothing is copied.
git ls-files -z --cached --others --exclude-standard -- '*.md' '*.h' docs packaging/schemas LICENSE tests/proofs tests/faults/faults.json |
  while IFS= read -r -d '' file; do
    [[ -e $file && $file != docs/site/* ]] || continue
    mkdir -p "$source/$(dirname "$file")"
    ln -s "$PWD/$file" "$source/$file"
  done
for page in index python-reference cpp-reference; do ln -s "$PWD/docs/site/$page.md" "$source/$page.md"; done
ln -s "$PWD/docs/site/notebooks.md" "$source/docs/notebooks/index.md"

execute=()
if PYTHONPATH=$modules "$python" -c "import voroproof, nbclient, ipykernel" 2>/dev/null; then
  execute=(--execute)
else
  echo "site: without the Python module the notebooks are shown without results"
fi
PYDEVD_DISABLE_FILE_VALIDATION=1 PYTHONPATH=$modules "$python" -m nbconvert --to markdown "${execute[@]}" --log-level WARN \
  --output-dir "$PWD/$source/docs/notebooks" docs/notebooks/*.ipynb

version=$("$program" --version)
VOROPROOF_VERSION=${version##* } "$python" -m sphinx -q -W --keep-going -j auto -c docs/site -d "$work/doctrees" "$source" "$out"

# Pictures that a document has as HTML are none of Sphinx's.
cp docs/gallery/*.png docs/gallery/*.webp "$out/docs/gallery/"

"$program" generate reference --n 30 --seed 1 --horizon 100 -o "$work/a.scene.json"
"$program" simulate "$work/a.scene.json" -o "$work/a.history.jsonl" --quiet
"$program" certify "$work/a.scene.json" "$work/a.history.jsonl" --report "$work/a.report.json" --quiet
"$program" movie "$work/a.scene.json" "$work/a.history.jsonl" --report "$work/a.report.json" -o "$out/player.html"
"$program" page -o "$out/certifier.html"

scripts/api-reference.sh "$work/api"
mv "$work/api/html" "$out/cpp"

"$python" -B scripts/check-links.py --site "$out"
echo "site: $out/index.html"
