#!/usr/bin/env bash
# Makes the reference of the library's headers, for a browser, in DIR (build/api). Fails where
# Doxygen warns.
#
# usage: scripts/api-reference.sh [DIR]
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-build/api}
mkdir -p "$out"
(cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $out") | doxygen -
echo "api-reference: $out/html/index.html"
