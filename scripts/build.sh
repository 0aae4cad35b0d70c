#!/usr/bin/env bash
# Installs what is missing and builds LatticeWorld (Release, Ninja, ccache).
# Usage: scripts/build.sh [--with GROUP] ... [--only TARGET] ... [further arguments for cmake]
#   --with GROUP   tests, benchmarks, training, cluster, python: what scripts/packages/GROUP.txt
#                  names, and what is built with it
#   --only TARGET  builds only that, as world_server, and installs only what the world server needs
# The build goes to build/ and devel/, or to $LATTICEWORLD_BUILD_DIR and devel/ in it.
set -euo pipefail
export PATH="/usr/bin:${PATH}"  # Debian's python before any other: ROS is installed for it

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

groups=(world page)
targets=()
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --with)
      groups+=("${2:?--with needs the name of a group}")
      case $2 in
        tests) options+=(-DLATTICEWORLD_BUILD_TESTS=ON) ;;
        benchmarks) options+=(-DLATTICEWORLD_BUILD_BENCHMARKS=ON) ;;
        training) options+=(-DLATTICEWORLD_TEST_TRAINING=ON) ;;
        cluster) options+=(-DLATTICEWORLD_TEST_CLUSTER=ON) ;;
        python) options+=(-DLATTICEWORLD_BUILD_PYTHON=ON) ;;
        *)
          echo "--with $2: it is one of tests, benchmarks, training, cluster, python" >&2
          exit 2
          ;;
      esac
      shift 2
      ;;
    --only)
      groups=(world)
      targets+=(--target "${2:?--only needs the name of a target}")
      shift 2
      ;;
    *)
      options+=("$1")
      shift
      ;;
  esac
done

# What is fetched the first time beside Debian's packages.
fetched_once() {
  [[ " ${groups[*]} " != *" $1 "* ]] || [ -e "$build/$2" ] || echo "the build fetches once: $3"
}
fetched_once page web/installed "17 MB from npm, of which the page is made"
fetched_once python python_tools/installed "50 MB from PyPI, for the module for Python"
"$root/scripts/install_dependencies.sh" "${groups[@]}"
log=$build/configure.log
mkdir -p "$build"
cmake -G Ninja -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release "${options[@]}" >"$log" 2>&1 || {
  cat "$log" >&2
  exit 1
}
grep -A 3 "^CMake Warning" "$log" >&2 || true
/usr/bin/python3 "$root/scripts/show_progress.py" "$build" "${targets[@]}"
