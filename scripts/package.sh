#!/usr/bin/env bash
# Makes the Debian packages ros-latticeworld, ros-latticeworld-msgs and liblatticeworld-dev, and has
# lintian read them; ends with an error where that finds one.
# Usage: scripts/package.sh [FOLDER]   (build_package/packages where none is given)
# What they are built in is build_package/, or $LATTICEWORLD_BUILD_DIR. What is in them is said by
# cmake/latticeworld_packages.cmake; scripts/try_packages.sh tries them out on a bare system.
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export LATTICEWORLD_BUILD_DIR=${LATTICEWORLD_BUILD_DIR:-$root/build_package}
out=${1:-$LATTICEWORLD_BUILD_DIR/packages}
log=$LATTICEWORLD_BUILD_DIR/cpack.log

"$root/scripts/install_dependencies.sh" world page package
"$root/scripts/build.sh" -DCMAKE_INSTALL_PREFIX=/usr
mkdir -p "$out"
cpack --config "$LATTICEWORLD_BUILD_DIR/CPackConfig.cmake" -B "$out" >"$log" || {
  cat "$log" >&2
  exit 1
}
rm -rf "$out/_CPack_Packages"
lintian --fail-on error --display-level error "$out"/*.deb
ls -s --block-size=1K "$out"/*.deb
