#!/usr/bin/env bash
# Installs what is missing and builds LatticeWorld (Release, Ninja, ccache).
# Usage: scripts/build.sh [further arguments for cmake, as -DLATTICEWORLD_BUILD_BENCHMARKS=ON]
# The build goes to build/ and devel/, or to $LATTICEWORLD_BUILD_DIR and devel/ in it.
set -euo pipefail
export PATH="/usr/bin:${PATH}"  # Debian's python before any other: ROS is installed for it

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

"$root/scripts/install_dependencies.sh"
cmake -G Ninja -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release "$@"
cmake --build "$build" --parallel "$(nproc)"
