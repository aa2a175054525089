#!/usr/bin/env bash
# Certifies every case of cases.txt and compares verdict, exit code and fault with what is expected.
# Fails too where files and cases differ.
#
# usage: corpus/run.sh PROGRAM      (the program is build/voroproof)
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0
count=0
complain() {
  echo "$*"
  failed=1
}

declare -A exit_code=([certified]=0 [refuted]=1 [invalid]=2 [undecided]=3)
declare -A listed=()
while IFS=$'\t' read -r file scene truth kind options; do
  case $file in '#'*) continue ;; esac
  verdict=${file%%/*}
  listed[$file]=1
  listed[scenes/$scene.scene.json]=1
  if [ ! -f "$file" ]; then
    complain "$file: listed, but no such file"
    continue
  fi
  [ "$options" = - ] && options=
  report=$scratch/report.json
  rm -f "$report"
  code=0
  # The options are words of their own.
  # shellcheck disable=SC2086
  "$program" certify "scenes/$scene.scene.json" "$file" --truth "$truth" --report "$report" \
    $options >"$scratch/out" 2>"$scratch/err" || code=$?
  count=$((count + 1))
  last=$(tail -n 1 "$scratch/out")
  if [ "$code" != "${exit_code[$verdict]}" ] || [ "$last" != "s ${verdict^^}" ]; then
    complain "$file ($truth): '$last', exit $code: $(cat "$scratch/err")"
  elif [ "$verdict" = refuted ] && [ "$kind" != '*' ] &&
    ! grep -q "^  \"kind\": \"$kind\",\$" "$report"; then
    complain "$file ($truth): not a '$kind': $(cat "$scratch/err")"
  fi
done <cases.txt

for file in certified/* refuted/* invalid/* undecided/* scenes/*; do
  [ -n "${listed[$file]:-}" ] || complain "$file: in no case"
done
[ $failed = 0 ] && echo "$count cases as expected"
exit $failed
