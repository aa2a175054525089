#!/usr/bin/env bash
# Fails where a file names an absolute path of some machine: what is committed must work anywhere. A
# closing tag (</root>) is none.
set -euo pipefail
cd "$(dirname "$0")/.."

if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  list=(git ls-files -z --cached --others --exclude-standard)
else
  list=(find . -type f -not -path './build*' -not -path './demo/*' -print0)
fi
found=$("${list[@]}" | xargs -0 grep -nIE \
  "(^|[^A-Za-z0-9_.:/~}<-])/(home|root|tmp|work|mnt|opt|srv|var|Users|usr/local)(/|[^A-Za-z0-9_]|$)" || true)
[ -z "$found" ] || { echo "$found"; exit 1; }
