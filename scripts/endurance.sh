#!/usr/bin/env bash
# Kills, fills up, leaves running and attacks the programs for as long as one has, and writes what
# came of it (docs/reliability.md). Installs what is missing and builds what is not there.
# Usage: scripts/endurance.sh --minutes N [--only PART] ... [--round NAME] ... [--seed N]
#                             [--ledger FILE] [--report FILE] [--programs DIR]
#   --only PART     cut_off, filled_up, left_running, let_nobody_in [these four], or races: mixed
#                   calls in programs that are built with ThreadSanitizer, in build-races/ or in
#                   $LATTICEWORLD_RACES_BUILD_DIR; alone, for all programs are of one build
#   --round NAME    only rounds whose name begins so, as "disk full" or "training" [all]
#   --seed N        of the moments and of the order [1]
#   --ledger FILE   every round is appended to it as it ends, and the tables are of all that is in
#                   it: runs can be broken off, go on, and go on side by side
#   --report FILE   tables in Markdown [endurance.md in the build folder]
#   --programs DIR  an installation's world_server and the others [those of the build]
# Exit status 1 where a promise was broken.
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}
devel=${LATTICEWORLD_BUILD_DIR:-$root}/devel
programs=$devel/lib/latticeworld

"$root/scripts/install_dependencies.sh" world tests
"$root/scripts/build.sh" --only endurance_programs -DLATTICEWORLD_BUILD_TESTS=ON
if [[ " $* " == *" --only races "* ]]; then
  races=${LATTICEWORLD_RACES_BUILD_DIR:-$root/build-races}
  [ -f "$races/build.ninja" ] ||
    cmake -G Ninja -S "$root" -B "$races" -DCMAKE_BUILD_TYPE=Races -DCMAKE_CXX_FLAGS_RACES=-O1 \
      -DLATTICEWORLD_SANITIZE=thread -DLATTICEWORLD_BUILD_PAGE=OFF >/dev/null
  ninja -C "$races" world_server episode_recorder world_viewer
  programs=$races/devel/lib/latticeworld
fi

# It mounts file systems of a few MiB, which only it sees: who is not root may do so in a user
# namespace, where there are such.
apart=()
if [ "$(id -u)" -ne 0 ] && unshare --user --map-root-user true 2>/dev/null; then
  apart=(unshare --user --map-root-user)
fi
exec "${apart[@]}" "$devel/env.sh" /usr/bin/python3 -B "$root/tests/endurance/endurance.py" \
  --programs "$programs" --libraries "$build/tests/endurance" \
  --report "$build/endurance.md" "$@"
