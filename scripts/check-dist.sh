#!/usr/bin/env bash
# Installs the build of the preset `dist` into a folder of its own, and checks that the portable
# program, its faster variant and a library's user run there and give the same bytes, also on an old processor.
#
# usage: scripts/check-dist.sh [BUILD_DIR]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build-dist}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

DESTDIR=$work cmake --install "$build" --prefix /usr > /dev/null
program=$work/usr/bin/voroproof
faster=$(find "$work/usr" -path '*avx2/voroproof')
plain_library=$(find "$work/usr" -name 'libvoroproof.so.*.*.*')
fast_library=$(find "$work/usr" -path '*glibc-hwcaps/x86-64-v3/libvoroproof.so.*')

# Which instructions each has: AVX registers nowhere in the portable ones.
vectors() { objdump -d --no-show-raw-insn "$1" | grep -c '%ymm' || true; }
for file in "$program" "$plain_library"; do
  [ "$(vectors "$file")" = 0 ] || { echo "$file: uses AVX"; exit 1; }
done
for file in "$faster" "$fast_library"; do
  [ "$(vectors "$file")" != 0 ] || { echo "$file: no AVX"; exit 1; }
done

scripts/same-bytes.sh --small "$faster" "$program"
env VOROPROOF_VARIANT=baseline scripts/same-bytes.sh --small "$program" "$faster"

# That the portable program hands over, and only where it may: the linker tells of each program that
# starts.
starts() { LD_DEBUG=files "$@" --version 2>&1 | grep -c 'initialize program:' || true; }
if grep -qw avx2 /proc/cpuinfo && grep -qw fma /proc/cpuinfo; then
  handed=$(starts "$program")
  kept=$(VOROPROOF_VARIANT=baseline starts "$program")
  if [ "$handed" != 2 ] || [ "$kept" != 1 ]; then
    echo "the program does not hand over as it should ($handed, $kept)"
    exit 1
  fi
fi
# And on a processor that has no AVX, where qemu is there to emulate one.
scripts/check-processor.sh "$program" || [ $? = 77 ]
echo "check-dist: same bytes by the portable program and the faster one"
