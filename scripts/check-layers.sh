#!/usr/bin/env bash
# Fails where a room (docs/README.md, "Rooms") includes a header of a room that it may not use, and
# prints the lines: FILE:LINE:#include ...
#
# usage: scripts/check-layers.sh [ROOT]
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"

failed=0
# Rooms in the folder of another room. They are no part of it: who may include the one may not include these.
inner=(exact/topology corpus/truth corpus/truth/readers certify/kernel certify/evidence library/include library/queries library/planning)
# check ROOM ALLOWED...: the project headers that files of ROOM include; ALLOWED are rooms or headers.
check() {
  local room=$1
  shift
  [ -d "$room" ] || return 0
  local allowed other skipped=none refused=none
  allowed=$(IFS='|'; echo "$*")
  for other in "${inner[@]}"; do
    [[ $other != "$room"/* ]] || skipped+="|$other"
    [[ " $* " == *" $other"[\ /]* ]] || refused+="|$other"
  done
  # Includes in quotes are the project's own.
  local found
  found=$(grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$room" |
    grep -vE "^($skipped)/" |
    awk -F'"' -v allowed="^($allowed)(/|$)" -v refused="^($refused)/" '$2 !~ allowed || $2 ~ refused' || true)
  if [ -n "$found" ]; then
    echo "$found"
    echo "  $room/ may include: $*"
    failed=1
  fi
}

check exact exact
check filtered/numbers exact filtered/numbers
check filtered/motion exact filtered/numbers filtered/motion
check filtered/search exact filtered/numbers filtered/motion filtered/search
check filtered/computed exact filtered
check filtered/worlds exact filtered/numbers filtered/worlds
check exact/topology exact exact/topology
check history exact history
check engine exact exact/topology filtered engine
check library/planning exact exact/topology filtered history engine library/planning
# The certifier judges the engine: nothing of its queue, its order of events or its construction of
# the first diagram. Numbers, motion and searches are shared (docs/certificate.md, section 10).
check certify exact exact/topology filtered history certify
# The kernel is a second checker: it shares nothing with the first.
check certify/kernel certify/kernel
# A third party's look at what the certifier prints: nothing of the code that finds it.
check certify/evidence exact history certify/certificate.h certify/evidence
check library/queries exact exact/topology filtered history library/queries
check corpus exact history corpus
# Its makers ask the engine, and the certifier whether it is right.
check corpus/truth exact exact/topology filtered engine certify corpus/truth
# For everybody: they stand alone.
check corpus/truth/readers voroproof_truth.h voroproof_truth_score.h judge_plain.h
# Headers for others see each other only.
check library/include voroproof
# What Python sees is what others see.
check python voroproof python
check library exact exact/topology filtered history engine certify certify/evidence corpus library library/queries library/planning voroproof

# Below apps/ no subject knows a verb, and none but its own folder and those named here.
rooms="exact exact/topology filtered history engine certify certify/evidence corpus library library/queries library/planning"
check apps/cli $rooms apps/cli
check apps/run $rooms certify/kernel/kernel.h apps/cli apps/run
check apps/answers $rooms voroproof/certify_diagram.h apps/answers
check apps/draw $rooms voroproof/static_diagram.h apps/answers apps/draw
check apps/certifier $rooms certify/kernel apps/draw apps/certifier
check apps/corpus $rooms apps/run apps/draw apps/corpus
check apps/paper $rooms apps/paper
check apps/verbs $rooms corpus/truth voroproof apps
# The library of the command line takes seconds to compile: one file includes it.
if grep -rlE '#include <CLI/' apps | grep -vx apps/cli/parser.cpp; then
  echo "check-layers: includes CLI11, which only apps/cli/parser.cpp may" >&2
  failed=1
fi
# The oracles are a second way to the truth: they share nothing.
check tests/oracle tests/oracle

exit $failed
