#!/usr/bin/env bash
# Puts the PyPI package rosbags, a reader of bags that shares no code with ROS, into a virtual
# environment. Quick when all is there. Usage: install_rosbags.sh DIRECTORY
set -euo pipefail
export PATH="/usr/bin:${PATH}"

wanted=rosbags==0.11.9
directory=${1:?usage: install_rosbags.sh DIRECTORY}

if [ "$(cat "$directory/installed" 2>/dev/null)" = "$wanted" ] && [ -x "$directory/bin/python" ]; then
  echo "$wanted is there"
  exit 0
fi
/usr/bin/python3 -m venv --clear "$directory"
"$directory/bin/python" -m pip install --quiet --disable-pip-version-check "$wanted"
echo "$wanted" > "$directory/installed"
echo "$wanted is installed"
