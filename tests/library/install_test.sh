#!/usr/bin/env bash
# Installs a build into a folder of its own and uses it as others would: a CMake project with
# find_package (shared and static), pkg-config, DESTDIR; each header alone, by C++17, with nothing
# else of this project or of its libraries in sight; and the symbols that the shared library shows.
#
# usage: tests/library/install_test.sh BUILD_DIR CXX
set -euo pipefail
build=$1
cxx=$2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

cmake --install "$build" --prefix "$prefix" > "$work/install.log"
library=$(dirname "$(find "$prefix" -name libvoroproof.so)")

echo "== find_package"
cmake -S "$here/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$cxx" > /dev/null
cmake --build "$work/consumer" > "$work/consumer.log" || { cat "$work/consumer.log"; exit 1; }
"$work/consumer/shared" | tee "$work/shared.txt"
"$work/consumer/static" | cmp - "$work/shared.txt"

echo "== pkg-config"
export PKG_CONFIG_PATH=$library/pkgconfig
# shellcheck disable=SC2046  # words, by purpose
"$cxx" -std=c++17 "$here/consumer/main.cpp" $(pkg-config --cflags --libs voroproof) -o "$work/plain"
LD_LIBRARY_PATH=$library "$work/plain" | cmp - "$work/shared.txt"

echo "== DESTDIR"
DESTDIR=$work/root cmake --install "$build" --prefix /usr > /dev/null
test -x "$work/root/usr/bin/voroproof"

echo "== headers"
for header in "$prefix"/include/voroproof/*.h; do
  echo "#include \"voroproof/$(basename "$header")\"" > "$work/one.cpp"
  "$cxx" -std=c++17 -Wall -Wextra -Werror -fsyntax-only -I "$prefix/include" "$work/one.cpp"
done
if grep -rnE '#include <(gmp|mpfr|arb|flint|tbb|boost|CGAL|thread|mutex|nlohmann)' "$prefix/include/voroproof"; then
  echo "a header shows what the library is made of"
  exit 1
fi

echo "== symbols"
# What is exported is in namespace voroproof and not in voroproof::internal; the rest are templates
# and inline functions of the standard library, which compilers always show.
if nm -DC --defined-only "$library/libvoroproof.so" | cut -d' ' -f3- |
  grep -E 'voroproof' | grep -E 'voroproof::internal' | grep -vE '^(typeinfo|vtable)' | head -5 | grep .; then
  echo "internal symbols are exported"
  exit 1
fi
readelf -d "$library/libvoroproof.so" | grep -q 'SONAME.*libvoroproof.so.0.1'
echo "installed, found, used"
