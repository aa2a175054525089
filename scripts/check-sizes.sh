#!/usr/bin/env bash
# A file has one subject and can be read in one sitting: none has more than 400 lines, but for those
# below, with the reason.
#
# usage: scripts/check-sizes.sh
set -euo pipefail
cd "$(dirname "$0")/.."

most=400
excused() {
  case $1 in
    corpus/example/plain_double.cpp) ;; # an engine in one file, to be copied and changed
    *) return 1 ;;
  esac
}

failed=0
while IFS= read -r file; do
  lines=$(wc -l < "$file")
  if [ "$lines" -gt "$most" ] && ! excused "$file"; then
    echo "$file: $lines lines, more than $most"
    failed=1
  fi
done < <(find . -name 'build*' -prune -o -name .git -prune -o \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.py' -o -name '*.sh' \) -print |
  sed 's|^\./||' | sort)
exit "$failed"
