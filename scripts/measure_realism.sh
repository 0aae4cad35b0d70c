#!/usr/bin/env bash
# Generates worlds from one instruction and several seeds, and measures how much their land is like
# nature's (see `latticeworld measure --help`). Build first: scripts/build.sh.
# Usage: scripts/measure_realism.sh [--seeds N] [--layout TEXT] [--vocabulary NAME] [--size METRES]
#          [--resolution METRES] [--keep DIR] [REAL ELEVATION...]
# Further paths, as GeoTIFF or .hgt of real land, are measured by themselves for comparison. The
# worlds go to a directory that is removed at the end, or to DIR.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}
program=${LATTICEWORLD_BUILD_DIR:-$root}/devel/lib/latticeworld/latticeworld
[ -x "$program" ] || program=$build/src/tools/latticeworld  # built without ROS

seeds=20
layout="Snow-capped mountains with forest valleys, rocky slopes and a river from the upper left to the\
 lower right."
vocabulary=wild
size=2048
resolution=4
keep=
real=()
while [ $# -gt 0 ]; do
  case $1 in
    --seeds | --layout | --vocabulary | --size | --resolution | --keep)
      [ $# -ge 2 ] || { echo "$1 needs a value" >&2; exit 2; }
      declare "${1#--}=$2"
      shift 2
      ;;
    -*)
      sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
    *)
      real+=("$1")
      shift
      ;;
  esac
done
[[ $seeds =~ ^[1-9][0-9]*$ ]] || { echo "--seeds: a whole number from 1 on, not $seeds" >&2; exit 2; }
[ -x "$program" ] || { echo "no $program: run scripts/build.sh first" >&2; exit 1; }

worlds=$keep
if [ -z "$worlds" ]; then
  worlds=$(mktemp -d "${TMPDIR:-/tmp}/latticeworld_realism.XXXXXX")
  trap 'rm -rf "$worlds"' EXIT
fi
mkdir -p "$worlds"
bundles=()
for ((seed = 1; seed <= seeds; ++seed)); do
  bundle=$worlds/$(printf 'seed_%02d' "$seed")
  "$program" generate --layout "$layout" --vocabulary "$vocabulary" --seed "$seed" --size "$size" \
    --resolution "$resolution" --out "$bundle" >"$worlds/log" 2>&1 || { cat "$worlds/log" >&2; exit 1; }
  bundles+=("$bundle")
done
echo "$layout"
echo "$seeds seeds, vocabulary $vocabulary, $size m at $resolution m"
(cd "$worlds" && "$program" measure "${bundles[@]#"$worlds"/}")
if [ ${#real[@]} -gt 0 ]; then
  echo
  echo "real land"
  "$program" measure "${real[@]}"
fi
