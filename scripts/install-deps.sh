#!/usr/bin/env bash
# Installs the Debian packages that the project needs and that are not there yet.
#
# usage: scripts/install-deps.sh [test] [bench] [plots] [python] [ci] [browser] [packages] [proofs] [site] [cluster]
#   without arguments: what building and running the program takes
#   test:  what building the tests takes besides
#   bench: what the benchmarks and the peers they measure take besides
#   plots: what bench/paper/plot.py, plot-growth.py and plot-plan.py take
#   python: what building the Python module takes, and its tests with notebooks
#   ci:    the second compiler, the formatter, the counter of instructions, doxygen, man, shells and an old processor besides
#   packages: what scripts/check-packages.sh takes besides, and the compiler of the certifier's page (large)
#   proofs: Coq, OCaml and the libraries of voroproof-proved, Gappa
#   site:  Sphinx with its theme, what runs the notebooks and makes the references, and the compiler of the certifier's page
#   cluster: what packaging/cluster/ takes, and a Slurm to test it with
#   browser: what making and testing pages and photographing that of `movie` takes besides (large); axe-core, which Debian does
#          not have, from npm into the folder of caches: one file, held against the hash below
#
# Where nothing is missing it neither asks for root nor uses the network.
set -euo pipefail

packages=(
  g++ cmake ninja-build pkg-config
  libgmp-dev libmpfr-dev             # exact numbers
  libflint-dev                       # balls
  libboost-dev libcgal-dev           # spatial sorting; the kernel; evidence; oracles of the tests
  nlohmann-json3-dev libexpat1-dev   # files
  zlib1g-dev libzstd-dev             # compressed files
  libcli11-dev                       # command line
  libssl-dev libcairo2-dev           # SHA-256, pictures
  libtbb-dev                         # threads of the certifier
  liblemon-dev                       # assignment of goals in plans
)
with_axe=false
for group in "$@"; do
  case "$group" in
    test) packages+=(libgtest-dev librapidcheck-dev python3 python3-jsonschema nodejs) ;;
    bench) packages+=(libbenchmark-dev libmpfi-dev) ;;
    plots) packages+=(python3-matplotlib) ;;
    python)
      packages+=(pybind11-dev python3-dev python3-numpy python3-matplotlib python3-pandas python3-pytest
        python3-shapely)
      packages+=(python3-gsd)  # one of the formats that are imported
      packages+=(python3-nbclient python3-nbconvert python3-ipykernel)
      ;;
    ci) packages+=(clang clang-format valgrind doxygen man-db fish zsh qemu-user) ;;
    browser)
      packages+=(chromium emscripten)
      with_axe=true
      # Where Node.js is not Debian's, npm comes with it.
      command -v npm > /dev/null || packages+=(npm)
      ;;
    site)
      packages+=(python3-sphinx python3-myst-parser furo doxygen git python3-numpy python3-matplotlib python3-pandas)
      packages+=(python3-nbclient python3-nbconvert python3-ipykernel emscripten)
      ;;
    packages)
      packages+=(debhelper dh-python emscripten lintian mmdebstrap patchelf pybind11-dev python3-dev python3-numpy python3-pip)
      ;;
    cluster) packages+=(openmpi-bin python3-mpi4py slurmctld slurmd slurm-client munge snakemake) ;;
    proofs)
      packages+=(coq libcoq-stdlib ocaml ocaml-findlib libzarith-ocaml-dev libyojson-ocaml-dev libsha-ocaml-dev gappa)
      ;;
    *)
      echo "install-deps: unknown group '$group' (test, bench, plots, python, ci, browser, packages, proofs, site, cluster)" >&2
      exit 2
      ;;
  esac
done

if ! command -v dpkg-query >/dev/null; then
  echo "install-deps: this is no Debian system; needed are the equivalents of: ${packages[*]}" >&2
  exit 0
fi

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

# Installs those of its arguments that are not there.
updated=false
ensure() {
  local missing=() package as_root=()
  for package in "$@"; do is_installed "$package" || missing+=("$package"); done
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "install-deps: neither root nor sudo; as root, run: apt-get install ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "install-deps: installing ${missing[*]}"
  # The lists on hand may do where fetching new ones fails.
  if ! $updated; then
    "${as_root[@]}" apt-get update -qq || echo "install-deps: apt-get update failed" >&2
    updated=true
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# The version that tests/browser/axe.mjs asks for. Without it that test is skipped.
axe_core() {
  local version=4.10.3 folder=${XDG_CACHE_HOME:-$HOME/.cache}/voroproof work
  local hash=5e6edba515e70d25f6604d9815f064d859c5d1ea7ab661bbc4f87c88779ef0c21cae0abbeb636471ef39e9d62d2582e4b88a1866f19f4ecfcf6d986275e4dc12
  local file=$folder/axe-core-$version.min.js
  if [ -f "$file" ]; then return; fi
  work=$(mktemp -d)
  echo "install-deps: fetching axe-core $version"
  if (cd "$work" && npm pack --silent "axe-core@$version" > /dev/null &&
    echo "$hash  axe-core-$version.tgz" | sha512sum --check --quiet && tar -xzf "axe-core-$version.tgz" package/axe.min.js); then
    mkdir -p "$folder"
    mv "$work/package/axe.min.js" "$file"
  else
    echo "install-deps: no axe-core; the test pages_axe will be skipped" >&2
  fi
  rm -rf "$work"
}

ensure "${packages[@]}"
# Arb is a part of FLINT from version 3 (Debian 13) on, and a package of its own before.
case "$(dpkg-query -W -f '${Version}' libflint-dev)" in
  2.*)
    ensure libflint-arb-dev
    packages+=(libflint-arb-dev)
    ;;
esac
if $with_axe; then axe_core; fi
echo "install-deps: all ${#packages[@]} packages are installed"
