#!/usr/bin/env bash
# Makes a virtual environment with what building, testing and packing latticeworld for Python takes
# from PyPI (python/requirements.txt). Quick when all is there.
# Usage: scripts/install_python_tools.sh DIRECTORY [PYTHON]
set -euo pipefail

requirements=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/python/requirements.txt
directory=${1:?usage: install_python_tools.sh DIRECTORY [PYTHON]}
python=${2:-python3}

if cmp -s "$requirements" "$directory/installed" && [ -x "$directory/bin/python" ]; then
  exit 0
fi
echo "fetching what python/requirements.txt names from PyPI (50 MB)"
"$python" -m venv --clear "$directory"
"$directory/bin/python" -m pip install --quiet --disable-pip-version-check -r "$requirements"
cp "$requirements" "$directory/installed"
