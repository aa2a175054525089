#!/usr/bin/env bash
# Makes the Debian packages and the archive of a finished build of the preset `dist`, and checks them:
# lintian finds no error; a program is built against the library's packages; in a bare Debian the
# packages are installed, used and purged, and nothing is left; installed once more as users do, with what they
# recommend, they are enough for all that the documents tell users to do; the archive has the licence,
# and its program runs where it was unpacked; the wheel has what it needs but NumPy.
#
# The bare system is made from the mirror that apt is configured with. Needs root, and what
# `scripts/install-deps.sh packages` installs.
#
# usage: scripts/check-packages.sh [BUILD_DIR [DESTINATION]]
#   DESTINATION: a folder to which packages and archive are copied
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "${1:-build-dist}")
destination=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "check-packages: $*" >&2
  exit 1
}

echo "== packages"
# In a copy, as building packages writes into packaging/debian/.
mkdir "$work/source"
cp -r packaging/debian "$work/source"
(cd "$work/source" && VOROPROOF_BUILD=$build DEB_BUILD_OPTIONS=noautodbgsym \
  dpkg-buildpackage --build=binary --no-pre-clean --no-sign > "$work/build.log" 2>&1) ||
  { cat "$work/build.log"; fail "no packages"; }
lintian --fail-on error --tag-display-limit 0 "$work"/*.changes

echo "== library"
for package in "$work"/libvoroproof*.deb; do dpkg-deb -x "$package" "$work/library"; done
library=$(dirname "$(find "$work/library" -name libvoroproof.so)")
# shellcheck disable=SC2046  # words, by purpose
c++ -std=c++17 tests/library/consumer/main.cpp -o "$work/consumer" \
  $(PKG_CONFIG_PATH=$library/pkgconfig pkg-config --cflags --libs voroproof)
LD_LIBRARY_PATH=$library "$work/consumer" > "$work/consumer.txt"

echo "== archive"
cpack --config "$build/CPackConfig.cmake" -B "$work/archive" > "$work/cpack.log" || { cat "$work/cpack.log"; fail "no archive"; }
archive=$(echo "$work"/archive/*.tar.gz)
mkdir "$work/unpacked"
tar -xzf "$archive" -C "$work/unpacked" --strip-components=1
cmp LICENSE "$work/unpacked/share/doc/voroproof/LICENSE"
"$work/unpacked/bin/voroproof" --version

echo "== wheel"
python=$(sed -n 's/^VOROPROOF_PYTHON_FOUND:[A-Z]*=//p' "$build/CMakeCache.txt")
VOROPROOF_BUILD=$build "$python" -m pip wheel . --no-deps --quiet -w "$work"
wheel=$(echo "$work"/voroproof-*.whl)
[ "$(stat -c %s "$wheel")" -le 20000000 ] || fail "the wheel is too large: $(stat -c %s "$wheel") bytes"

if [ -n "$destination" ]; then
  mkdir -p "$destination"
  cp "$work"/*.deb "$archive" "$wheel" "$destination"
fi

echo "== bare system"
root=$work/root
# One line for each index that apt knows: "deb URI bookworm main".
apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
  sort -u > "$work/sources.list"
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
apt-config dump | grep '^Acquire::' > "$work/apt.conf"
mmdebstrap --quiet --variant=minbase --mode=root --aptopt="$work/apt.conf" \
  "$release" "$root" - < "$work/sources.list"
cp "$work/apt.conf" "$root/etc/apt/apt.conf.d/99check"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages"
cp "$work"/*.deb "$root/packages"

# All files but those that apt and dpkg keep of their work, and what tells of times.
files() {
  (cd "$root" && find . -xdev \( -path ./var/cache -o -path ./var/log -o -path ./var/lib/apt -o \
    -path ./var/lib/dpkg -o -path ./proc -o -path ./sys -o -path ./tmp \) -prune -o -print | sort)
}
# /proc is there for as long as the command runs.
inside() {
  unshare --mount sh -ec 'mount -t proc proc "$0/proc"; exec chroot "$0" "$@"' "$root" \
    /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"
}

inside apt-get update -qq
files > "$work/before"
inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/*.deb' > "$work/install.log" 2>&1 ||
  { cat "$work/install.log"; fail "the packages cannot be installed"; }

echo "== use"
version=$(sed -n '1s/.*(\(.*\)-.*).*/\1/p' packaging/debian/changelog)
[ "$(inside voroproof --version)" = "voroproof $version" ] || fail "another version than $version"
inside sh -ec '
  cd "$(mktemp -d)"
  voroproof generate reference --n 20 --seed 1 --horizon 20 -o a.scene.json
  voroproof simulate a.scene.json -o a.history.jsonl --quiet
  voroproof certify a.scene.json a.history.jsonl
  voroproof certify a.scene.json a.history.jsonl --truth recorded --kernel
  voroproof-kernel a.scene.json a.history.jsonl
  voroproof page -o a.html
  voroproof corpus run --family few
  VOROPROOF_VARIANT=baseline voroproof corpus run --family few
  python3 -c "import voroproof as v; s = v.Scene.read(\"a.scene.json\"); assert v.certify(s, v.simulate(s)).certified"
  printf "mmsi,timestamp,lat,lon\n1,0,52,4\n1,10,52,4.01\n2,0,52.1,4\n2,10,52.1,4\n" |
    python3 -m voroproof.importers ais - --radius 50 -o tracks.csv
  voroproof clearance tracks.csv --required 0
  test -f /usr/share/doc/voroproof/docs/formats.md
  rm -r "$PWD"'

echo "== purge"
inside sh -c 'dpkg-query -W -f "\${Package}\n" "*voroproof*" | xargs apt-get purge -y -qq --autoremove' \
  > "$work/purge.log" 2>&1 || { cat "$work/purge.log"; fail "the packages cannot be purged"; }
files > "$work/after"
diff "$work/before" "$work/after" || fail "that is what purging leaves"
if inside dpkg-query -W -f '${Package} ${db:Status-Status}\n' '*voroproof*' 2>/dev/null | grep .; then
  fail "packages are left"
fi
echo "== wheel without the packages"
inside apt-get install -y -qq --no-install-recommends python3-numpy python3-pip > "$work/numpy.log" 2>&1 ||
  { cat "$work/numpy.log"; fail "no NumPy"; }
cp "$wheel" "$root/packages"
inside sh -ec 'pip install --quiet --root-user-action=ignore --no-deps --no-index --break-system-packages --target /wheel /packages/*.whl
  cd /
  PYTHONPATH=/wheel python3 -c "
import voroproof as v
scene = v.Scene.reference(n=20, seed=1, horizon=20)
assert v.certify(scene, v.simulate(scene)).certified
assert len(v.voronoi([[0, 0], [4, 0], [1, 3]], [1, 0.5, 0.25]).vertices) == 1"'
echo "== paths of users"
mkdir "$root/paths"
cp tests/docs/blocks.py tests/docs/installed_test.py "$root/paths"
inside sh -ec 'apt-get install -y -qq /packages/*.deb
  apt-get install -y -qq --no-install-recommends g++ pkg-config' > "$work/paths.log" 2>&1 ||
  { cat "$work/paths.log"; fail "the packages cannot be installed with what they recommend"; }
inside python3 -B /paths/installed_test.py
echo "check-packages: $(ls "$work"/*.deb | wc -l) packages, an archive and a wheel made, installed and used"
