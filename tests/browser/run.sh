#!/usr/bin/env bash
# Runs a test in Node.js; exit code 77, which ctest takes for skipped, where a program that it needs is missing.
#
# usage: run.sh "PROGRAM..." TEST [ARGUMENT...]    TEST below tests/
set -euo pipefail
cd "$(dirname "$0")/.."
for needed in $1; do
  command -v "$needed" >/dev/null || {
    echo "$needed is not installed: scripts/install-deps.sh test browser"
    exit 77
  }
done
exec node "${@:2}"
