#!/usr/bin/env bash
# Runs a test in Node.js; exit code 77, which ctest takes for skipped, where a program that it needs is missing.
#
# usage: run.sh "PROGRAM..." TEST [ARGUMENT...]    TEST below tests/; the programs `module` and `package` are the files
#                                                  MODULE and PACKAGE
set -euo pipefail
cd "$(dirname "$0")/.."
for needed in $1; do
  case $needed in
    module) needed=${MODULE:-the module of the page} ;;
    package) needed=${PACKAGE:-the npm package} ;;
  esac
  [ -f "$needed" ] || command -v "$needed" >/dev/null || {
    echo "$needed is missing: scripts/install-deps.sh test browser"
    exit 77
  }
done
exec node "${@:2}"
