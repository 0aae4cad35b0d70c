#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test; the last lines are CTest's summary.
# Usage: scripts/test.sh [further arguments for ctest, as -R terrain]
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

"$root/scripts/build.sh" -DLATTICEWORLD_BUILD_TESTS=ON
cd "$build"
ctest --output-on-failure --parallel "$(nproc)" --no-tests=error "$@"
