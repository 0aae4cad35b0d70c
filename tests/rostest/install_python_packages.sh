#!/usr/bin/env bash
# Puts the PyPI packages that tests need (requirements.txt) into a virtual environment that sees
# ROS's Python packages too. Quick when all is there. Usage: install_python_packages.sh DIRECTORY
set -euo pipefail
export PATH="/usr/bin:${PATH}"

requirements=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/requirements.txt
directory=${1:?usage: install_python_packages.sh DIRECTORY}

if cmp -s "$requirements" "$directory/installed" && [ -x "$directory/bin/python" ]; then
  echo "all of $requirements is there"
  exit 0
fi
echo "fetching what tests/rostest/requirements.txt names from PyPI (50 MB)"
/usr/bin/python3 -m venv --clear --system-site-packages "$directory"
"$directory/bin/python" -m pip install --quiet --disable-pip-version-check -r "$requirements"
cp "$requirements" "$directory/installed"
echo "all of $requirements is installed"
