#!/usr/bin/env bash
# Installs what is missing, builds, fetches the model that reads (93 MB, unless the variable
# LATTICEWORLD_READER_MODEL names one or is empty), starts the world server (and a roscore where
# none runs), generates the README's world and keeps it running until Ctrl-C.
# Usage: scripts/run.sh ["layout instruction" ["environment instruction" [seed]]]
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
devel=${LATTICEWORLD_BUILD_DIR:-$root}/devel

layout=${1:-"A river winds from the north to the south between dense forest in the upper left and\
 farmland on the right. A road runs from the west to the east, with a small village in the center."}
environment=${2:-"A sunny autumn afternoon. Nine sheep graze in the lower left, two\
 goblins patrol near the upper right, an eagle circles above, and a wheeled robot waits in the center."}

seed=${3:-$([ $# -eq 0 ] && echo 37 || echo 0)}  # 37: the README's picture; 0: drawn

# The model that reads is fetched while the compiler works; without it the rules read alone.
reader=${LATTICEWORLD_BUILD_DIR:-$root/build}/models/reader.gguf
fetching=
if [ -z "${LATTICEWORLD_READER_MODEL+named}" ] && [ ! -e "$reader" ]; then
  fetching=soon
  echo "beside what Debian's packages are, the model that reads will be fetched (93 MB, once)"
fi
"$root/scripts/install_dependencies.sh" world
if [ -n "$fetching" ]; then
  "$root/scripts/fetch_reader.sh" &
  fetching=$!
fi

"$root/scripts/build.sh" --only world_server

if [ -n "$fetching" ] && ! wait "$fetching"; then
  echo "No model reads: the rules do, which understand less (docs/language.md)." >&2
fi
if [ -z "${LATTICEWORLD_READER_MODEL+named}" ] && [ -e "$reader" ]; then
  export LATTICEWORLD_READER_MODEL=$reader
fi

set +u  # catkin's setup files read variables that may be unset
# shellcheck disable=SC1091
source "$devel/setup.bash"
set -u
if [ -z "${ROS_IP:-}" ] && [ -z "${ROS_HOSTNAME:-}" ]; then export ROS_IP=127.0.0.1; fi
export ROS_MASTER_URI=${ROS_MASTER_URI:-http://127.0.0.1:11311}

launch_pid=
stop() {
  trap - EXIT INT TERM HUP
  if [ -n "$launch_pid" ] && kill -0 "$launch_pid" 2>/dev/null; then
    kill -INT "$launch_pid"
    wait "$launch_pid" || true
  fi
}
trap 'stop; exit 130' INT
trap 'stop; exit 143' TERM HUP
trap stop EXIT

# roslaunch starts a roscore where none runs and stops it again. In a session of its own, so that
# Ctrl-C reaches it through `stop` alone and once.
log=$(mktemp "${TMPDIR:-/tmp}/latticeworld_run.XXXXXX.log")
setsid roslaunch latticeworld world.launch >"$log" 2>&1 &
launch_pid=$!

/usr/bin/python3 "$root/scripts/generate_world.py" --server-pid "$launch_pid" \
  --layout "$layout" --environment "$environment" --seed "$seed" || {
  echo "the world server's output is in $log" >&2
  exit 1
}
echo
echo "The world is running; the server's output is in $log. Ctrl-C ends it."
wait "$launch_pid"
