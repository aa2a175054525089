#!/usr/bin/env bash
# Installs the module below a prefix of its own and uses it from there, without the build directory or
# any path to the library; and asks where it goes below the prefix of the system.
#
# usage: tests/python/install_test.sh BUILD_DIR PYTHON
set -euo pipefail
build=$1
python=$2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" > /dev/null
package=$(dirname "$(find "$work/prefix" -path '*voroproof/__init__.py')")
test -e "$package/py.typed"
test -e "$package/_core.pyi"
cd "$work"
PYTHONPATH=$(dirname "$package") "$python" -B -c "
import voroproof as vp
assert vp.__file__.startswith('$work'), vp.__file__
scene = vp.Scene.reference(10, horizon=20)
assert vp.certify(scene, vp.simulate(scene)).certified"
printf 'mmsi,timestamp,lat,lon\n1,0,52,4\n1,10,52,4.01\n' |
  PYTHONPATH=$(dirname "$package") "$python" -B -m voroproof.importers ais - -o tracks.csv > /dev/null
grep -q '^1,10,' tracks.csv

echo "== the system's own places"
DESTDIR=$work/root cmake --install "$build" --prefix /usr > /dev/null
found=$(cd "$work/root" && find . -path '*voroproof/__init__.py')
place=/${found#./}
"$python" -c "import site, sys; sys.exit('${place%/voroproof/__init__.py}' not in site.getsitepackages())" ||
  { echo "$place is not on the interpreter's path"; exit 1; }
echo "installed, imported, used"
