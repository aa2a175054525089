#!/usr/bin/env bash
# That a program which is built for any x86-64 processor runs on an old one, one without AVX, and gives the same bytes there as on
# this machine: scenes, histories, diagrams, and the certificates of both checkers. The old processor is emulated
# (qemu-x86_64 -cpu Nehalem). Exit code 77, which ctest takes for skipped, where qemu-user is not installed.
#
# usage: scripts/check-processor.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
command -v qemu-x86_64 > /dev/null || {
  echo "qemu-x86_64 is not installed: scripts/install-deps.sh ci"
  exit 77
}
ulimit -c 0  # where it fails, it fails by an illegal instruction
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# all FOLDER COMMAND...: what the program, run by the command, makes in a new folder.
all() {
  mkdir "$work/$1"
  (
    cd "$work/$1"
    shift
    "$@" generate reference --n 12 --seed 3 --density 0.2 --horizon 20 -o a.scene.json
    "$@" simulate a.scene.json -o a.history.jsonl --quiet
    "$@" certify a.scene.json a.history.jsonl --truth exact > exact.txt
    "$@" certify a.scene.json a.history.jsonl --truth recorded --kernel > recorded.txt
    "$@" snapshot a.scene.json a.history.jsonl --at 1/3 -o a.diagram.json
    # A lattice: ties, and exact arithmetic.
    "$@" generate grid --n 9 --motion common --horizon 12 -o b.scene.json
    "$@" simulate b.scene.json -o b.history.jsonl --quiet
  )
}

all here "$program"
all old qemu-x86_64 -cpu Nehalem "$program"
diff -r "$work/here" "$work/old" || {
  echo "check-processor: other bytes on the old processor"
  exit 1
}
grep -qx 's CERTIFIED' "$work/old/recorded.txt"
echo "check-processor: $(cat "$work"/old/*.history.jsonl | wc -l) lines of histories with the same bytes on a processor without AVX"
