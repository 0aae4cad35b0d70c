#!/usr/bin/env bash
# MuJoCo as a user meets it: peers/mujoco.sh PROGRAM [VERSION]
# PROGRAM: latticeworld. Installs MuJoCo from PyPI in a temporary folder, makes a small world,
# exports it, and has MuJoCo load, step and drive over it; heights are compared with heights.npy at
# a thousand places. Prints what came out; ends with 1 where something is off. Outside CI: it needs
# the network.
set -euo pipefail
program=$(realpath "$1")
version=${2:-4.0.0}
here=$(dirname "$(realpath "$0")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

python3 -m venv "$folder/python"
"$folder/python/bin/pip" install --quiet "mujoco==$version" numpy==2.2.6

run() { "$program" "$@" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }; }
run generate \
  --layout "A lake in the lower left, a wood in the upper left, a road from west to east, a small
village in the center, hills in the upper right." \
  --environment "A sunny summer noon." --seed 4 --size 128 --resolution 0.5 --out "$folder/world"
for format in heights mjcf; do
  run export "$folder/world" --to $format --out "$folder/$format"
  run export "$folder/world" --to $format --region=-30,-20,20.3,40 --out "$folder/${format}_region"
done
"$folder/python/bin/python" "$here/mujoco_world.py" "$folder/world" "$folder/heights" "$folder/mjcf"
"$folder/python/bin/python" "$here/mujoco_world.py" "$folder/world" "$folder/heights_region" \
  "$folder/mjcf_region"
