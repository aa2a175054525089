#!/usr/bin/env bash
# Fails where the program of the kernel contains a symbol of the rest of the project, or needs one of
# its libraries, and prints them. All of the project but the kernel is in the namespace voroproof.
#
# usage: scripts/check-kernel.sh PROGRAM      (the program is build/voroproof-kernel)
set -euo pipefail
program=$1

symbols=$(nm --demangle "$program")
if ! grep -q 'voroproof_kernel::' <<<"$symbols"; then
  echo "$program: no symbols to be seen"
  exit 1
fi
if grep -E '(^|[^_[:alnum:]])voroproof::' <<<"$symbols"; then
  exit 1
fi
# Floating-point libraries, threads of its own and the like are not needed either.
if ldd "$program" | grep -E 'libvoroproof|libtbb|libmpfr|libflint|libgmpxx'; then
  exit 1
fi
