#!/usr/bin/env bash
# Kills, fills up, leaves running and attacks the programs for as long as one has, and writes what
# came of it (docs/reliability.md). Installs what is missing and builds what is not there.
# Usage: scripts/endurance.sh --minutes N [--only PART] ... [--seed N] [--report FILE] [--programs DIR]
#   --only PART     cut_off, filled_up, left_running, let_nobody_in [all]
#   --seed N        of the moments and of the order [1]
#   --report FILE   tables in Markdown [endurance.md in the build folder]
#   --programs DIR  an installation's world_server and the others [those of the build]
# Exit status 1 where a promise was broken.
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}
devel=${LATTICEWORLD_BUILD_DIR:-$root}/devel

"$root/scripts/install_dependencies.sh" world tests
"$root/scripts/build.sh" --only endurance_programs -DLATTICEWORLD_BUILD_TESTS=ON

# It mounts file systems of a few MiB, which only it sees: who is not root may do so in a user
# namespace, where there are such.
apart=()
if [ "$(id -u)" -ne 0 ] && unshare --user --map-root-user true 2>/dev/null; then
  apart=(unshare --user --map-root-user)
fi
exec "${apart[@]}" "$devel/env.sh" /usr/bin/python3 -B "$root/tests/endurance/endurance.py" \
  --programs "$devel/lib/latticeworld" --libraries "$build/tests/endurance" \
  --report "$build/endurance.md" "$@"
