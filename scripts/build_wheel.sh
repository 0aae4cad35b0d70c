#!/usr/bin/env bash
# Builds a wheel of latticeworld for Python: the core, without ROS, and every library that it needs.
# With Python 3.12 or later it serves that and all later ones (abi3), else that version alone. What
# it was linked with decides the platform's tag: manylinux_2_36 on Debian 12.
# Usage: scripts/build_wheel.sh [DIRECTORY [PYTHON]]   (dist and python3 unless said)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
dist=${1:-$root/dist}
python=${2:-python3}
build=${LATTICEWORLD_WHEEL_DIR:-$root/build-wheel}  # as deep as build/: ccache knows its files

PATH="/usr/bin:$PATH" "$root/scripts/install_dependencies.sh"
"$root/scripts/install_python_tools.sh" "$build/tools" "$python"
export PATH="$build/tools/bin:/usr/bin:$PATH"
export CXX=${CXX:-/usr/bin/c++} CC=${CC:-/usr/bin/cc}  # the names by which other builds fill ccache
rm -rf "$build/plain"
python -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir "$build/plain" \
  -C build-dir="$build" -C cmake.define.LATTICEWORLD_PYTHON="$build/tools/bin/python" \
  "$root/python"
mkdir -p "$dist"
if python -m auditwheel repair --strip --wheel-dir "$dist" "$build"/plain/*.whl; then
  ls -l "$dist"/*.whl
else
  cp "$build"/plain/*.whl "$dist"
  echo "auditwheel could not take the libraries along: this wheel works on machines like this one" >&2
fi
