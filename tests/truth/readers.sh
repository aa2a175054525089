#!/usr/bin/env bash
# The three readers of the truth set give one table for the same arithmetic, and refuse a bad line.
#
# usage: readers.sh C-COMPILER C++-COMPILER
set -euo pipefail
c=$1
cxx=$2
readers=$(cd "$(dirname "$0")/../../corpus/truth/readers" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$c" -std=c99 -Wall -Wextra -Wpedantic -Werror -O2 -ffp-contract=off "$readers/judge.c" -o "$scratch/judge" -lm
"$cxx" -std=c++17 -Wall -Wextra -Werror -fsyntax-only -x c++ "$readers/voroproof_truth.h"

# Without the nanoseconds.
table() { sed -E 's/ +[0-9]+$//; s/ +ns.query$//'; }
for file in "$readers"/../short/*.txt.gz; do
  text=$scratch/$(basename "$file" .gz)
  gzip -dc "$file" > "$text"
  "$scratch/judge" --engine double "$text" | table > "$scratch/c"
  python3 -B "$readers/voroproof_truth.py" "$text" | table > "$scratch/python"
  diff "$scratch/c" "$scratch/python"
  if command -v node > /dev/null; then
    node "$readers/voroproof_truth.mjs" "$text" | table > "$scratch/javascript"
    diff "$scratch/c" "$scratch/javascript"
  fi
  sed '3s/ [^ ]*$//' "$text" > "$scratch/bad"
  if "$scratch/judge" "$scratch/bad" > /dev/null 2> "$scratch/why"; then exit 1; fi
  grep -q "line 3, field" "$scratch/why"
done
