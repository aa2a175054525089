#!/usr/bin/env bash
# The program makes the lines of a short file of the truth set again: all, with two threads, and a
# slice alone.
#
# usage: same_lines.sh PROGRAM NAME
set -euo pipefail
program=$1
name=$2
folder=$(cd "$(dirname "$0")/../../corpus/truth" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

gzip -dc "$folder/short/$name.txt.gz" > "$scratch/kept"
"$program" truth "$name" --threads 2 -o "$scratch/made"
cmp "$scratch/kept" "$scratch/made"
"$program" truth "$name" --first 7001 --lines 40 -o "$scratch/slice"
cmp <(sed -n '1p;7003,7042p' "$scratch/kept") "$scratch/slice"
sum=$(sha256sum < "$scratch/kept" | cut -d' ' -f1)
grep -qx "$sum  short/$name.txt" "$folder/SHA256SUMS"
