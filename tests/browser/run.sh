#!/usr/bin/env bash
# Runs a test in Node.js; exit code 77, which ctest takes for skipped, where a program that it needs is missing.
#
# usage: run.sh "PROGRAM..." TEST [ARGUMENT...]    TEST below tests/; the program `module` is the file MODULE
set -euo pipefail
cd "$(dirname "$0")/.."
for needed in $1; do
  if [ "$needed" = module ]; then needed=${MODULE:-the module of the page}; fi
  [ -f "$needed" ] || command -v "$needed" >/dev/null || {
    echo "$needed is missing: scripts/install-deps.sh test browser"
    exit 77
  }
done
exec node "${@:2}"
