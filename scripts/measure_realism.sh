#!/usr/bin/env bash
# Generates worlds of three kinds (wild land, mountains, mixed land with a village, fields and a
# road) and several seeds, and measures how much their land is like nature's (see `latticeworld
# measure --help`). Build first: scripts/build.sh.
# Usage: scripts/measure_realism.sh [--seeds N] [--kinds "wild mountains mixed"] [--size METRES]
#          [--resolution METRES] [--keep DIR] [REAL ELEVATION...]
# Further paths, as GeoTIFF or .hgt of real land, are measured by themselves for comparison. The
# worlds go to a directory that is removed at the end, or to DIR.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}
program=${LATTICEWORLD_BUILD_DIR:-$root}/devel/lib/latticeworld/latticeworld
[ -x "$program" ] || program=$build/src/tools/latticeworld  # built without ROS

# Of each kind: its words, its vocabulary, and what its slopes are held against.
declare -A layout_of=(
  [wild]="A river winds from the north to the south between dense forest on the left and meadows on the\
 right. A lake lies in the lower left."
  [mountains]="Snow-capped mountains with forest valleys, rocky slopes and a river from the upper left\
 to the lower right."
  [mixed]="A river winds from the north to the south between dense forest in the upper left and\
 farmland on the right. A road runs from the west to the east, with a small village in the center."
)
declare -A vocabulary_of=([wild]=wild [mountains]=wild [mixed]=suburb)
declare -A slopes_of=([wild]=hills [mountains]=mountains [mixed]=hills)

seeds=20
kinds="wild mountains mixed"
size=2048
resolution=4
keep=
real=()
while [ $# -gt 0 ]; do
  case $1 in
    --seeds | --kinds | --size | --resolution | --keep)
      [ $# -ge 2 ] || { echo "$1 needs a value" >&2; exit 2; }
      declare "${1#--}=$2"
      shift 2
      ;;
    -*)
      sed -n '2,9s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
    *)
      real+=("$1")
      shift
      ;;
  esac
done
[[ $seeds =~ ^[1-9][0-9]*$ ]] || { echo "--seeds: a whole number from 1 on, not $seeds" >&2; exit 2; }
for kind in $kinds; do
  [ -n "${layout_of[$kind]:-}" ] || { echo "--kinds: of wild, mountains, mixed, not $kind" >&2; exit 2; }
done
[ -x "$program" ] || { echo "no $program: run scripts/build.sh first" >&2; exit 1; }

worlds=$keep
if [ -z "$worlds" ]; then
  worlds=$(mktemp -d "${TMPDIR:-/tmp}/latticeworld_realism.XXXXXX")
  trap 'rm -rf "$worlds"' EXIT
fi
mkdir -p "$worlds"

measure_kind() {
  local bundles=() bundle seed
  for ((seed = 1; seed <= seeds; ++seed)); do
    bundle=$worlds/$1_$(printf '%02d' "$seed")
    "$program" generate --layout "${layout_of[$1]}" --vocabulary "${vocabulary_of[$1]}" \
      --seed "$seed" --size "$size" --resolution "$resolution" --out "$bundle" >"$worlds/log" 2>&1 ||
      { cat "$worlds/log" >&2; exit 1; }
    bundles+=("${bundle##*/}")
  done
  echo "$1: ${layout_of[$1]}"
  echo "$seeds seeds, vocabulary ${vocabulary_of[$1]}, $size m at $resolution m"
  (cd "$worlds" && "$program" measure --kind "${slopes_of[$1]}" "${bundles[@]}")
  echo
}

for kind in $kinds; do measure_kind "$kind"; done
if [ ${#real[@]} -gt 0 ]; then
  echo "real land"
  "$program" measure "${real[@]}"
fi
