#!/usr/bin/env bash
# Builds wheels for Python: latticeworld_gym and latticeworld_stack (clients/, over ROS), and
# latticeworld: the core, without ROS, and every library that it needs. With Python 3.12 or later
# that one serves that and all later ones (abi3), else that version alone. What it was linked with
# decides the platform's tag: manylinux_2_36 on Debian 12.
# Usage: scripts/build_wheel.sh [--clients] [DIRECTORY [PYTHON]]   (dist and python3 unless said)
#   --clients  only those of clients/, which need no compiler
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
clients=
[ "${1:-}" != --clients ] || { clients=yes; shift; }
dist=${1:-$root/dist}
python=${2:-python3}
build=${LATTICEWORLD_WHEEL_DIR:-$root/build-wheel}  # as deep as build/: ccache knows its files

mkdir -p "$dist"
# pip leaves its own folders beside the sources that it packs: it gets a copy.
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$root"/clients/latticeworld_{gym,stack} "$copy"
echo "fetching setuptools from PyPI (1 MB)"
"$python" -m venv "$copy/venv"
"$copy/venv/bin/pip" wheel --quiet --disable-pip-version-check --no-deps --wheel-dir "$dist" \
  "$copy/latticeworld_gym" "$copy/latticeworld_stack"
if [ -n "$clients" ]; then
  ls -l "$dist"/*.whl
  exit 0
fi

PATH="/usr/bin:$PATH" "$root/scripts/install_dependencies.sh" world
"$root/scripts/install_python_tools.sh" "$build/tools" "$python"
export PATH="$build/tools/bin:/usr/bin:$PATH"
export CXX=${CXX:-/usr/bin/c++} CC=${CC:-/usr/bin/cc}  # the names by which other builds fill ccache
rm -rf "$build/plain"
python -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir "$build/plain" \
  -C build-dir="$build" -C cmake.define.LATTICEWORLD_PYTHON="$build/tools/bin/python" \
  "$root/python"
if ! python -m auditwheel repair --strip --wheel-dir "$dist" "$build"/plain/*.whl; then
  cp "$build"/plain/*.whl "$dist"
  echo "auditwheel could not take the libraries along: this wheel works on machines like this one" >&2
fi
ls -l "$dist"/*.whl
