#!/usr/bin/env bash
# Fails where a room includes a header of a room that it may not use (README.md, "Rooms"), and
# prints the lines: FILE:LINE:#include ...
#
# usage: scripts/check-layers.sh [ROOT]
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"

failed=0
# check ROOM ALLOWED...: the project headers that files below ROOM include; ALLOWED are rooms or headers.
check() {
  local room=$1
  shift
  [ -d "$room" ] || return 0
  local allowed
  allowed=$(IFS='|'; echo "$*")
  # Includes in quotes are the project's own.
  local found
  found=$(grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$room" |
    grep -vE "include[[:space:]]*\"($allowed)[/\"]" || true)
  if [ -n "$found" ]; then
    echo "$found"
    echo "  $room/ may include: $*"
    failed=1
  fi
}

check exact exact
check filtered exact filtered
check topology exact topology
check history exact history
check kinetic exact filtered topology kinetic
check planning exact filtered topology history kinetic planning
# The certifier judges the engine: it shares no code with it beyond the definitions.
check certify exact filtered topology history certify
# The kernel is a second checker: it shares nothing with the first.
check kernel kernel
# A third party's look at what the certifier prints: nothing of the code that finds it.
check evidence exact history certify/certificate.h evidence
check queries exact filtered topology history queries
check corpus exact history corpus
# The oracles are a second way to the truth: they share nothing.
check tests/oracle tests/oracle

exit $failed
