#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests; the last lines are CTest's summary.
# Usage: scripts/test.sh [--with GROUP] ... [further arguments for ctest, as -R terrain]
#   --with GROUP  the tests of what not everybody has: training (PyTorch), cluster (Slurm); with
#                 benchmarks, these are built too. CI runs with all three.
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

groups=(--with tests)
while [ "${1:-}" = --with ]; do
  groups+=(--with "${2:?--with needs the name of a group}")
  shift 2
done
"$root/scripts/build.sh" "${groups[@]}"
cd "$build"
ctest --output-on-failure --parallel "$(nproc)" --no-tests=error "$@"
