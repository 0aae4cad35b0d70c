#!/usr/bin/env bash
# trimesh stretches a binvox grid of d cells to d / (d - 1) of its size, so that it and octomap disagree about places.
#
# Versions: trimesh 5.2.0 and numpy 2.4.6 from PyPI, octomap-tools 1.9.7+dfsg-3+b1 of Debian 12.
# Expected: The format's description says that the centre of voxel i of d lies at scale * (i + 0.5) / d + translate. A
# grid of 4 cells with scale 4 thus has cells of 1 m whose centres are 0.5, 1.5, 2.5 and 3.5.
# Observed: octomap's binvox2bt follows the description. trimesh puts the first and the last centre on the edges of the
# grid, with 4 / 3 m between the cells: 0, 1.33, 2.67 and 4. It writes files by the same rule, so that reading its own
# files hides the difference: a grid of trimesh with cells of 1 m gets cells of 0.75 m in octomap.
# Since: trimesh 4.5.0 and 4.12.1 place the cells in the same way.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

have=$(dpkg-query -W -f '${Version}' octomap-tools)
[ "$have" = 1.9.7+dfsg-3+b1 ] || { echo "octomap-tools is $have, not 1.9.7+dfsg-3+b1."; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check trimesh==5.2.0 numpy==2.4.6

venv/bin/python - <<'PY' | tee seen.txt
import numpy
import trimesh

# Two of 4 x 4 x 4 cells are occupied. In the file x runs slowest and y fastest, as runs of a value and a length.
cells = numpy.zeros((4, 4, 4), "u1")
cells[3, 0, 0] = cells[0, 2, 1] = 1
runs = bytes(b for value in cells.transpose(0, 2, 1).ravel() for b in (int(value), 1))
with open("given.binvox", "wb") as file:
    file.write(b"#binvox 1\ndim 4 4 4\ntranslate 0 0 0\nscale 4\ndata\n" + runs)
print("trimesh reads the centres", numpy.round(trimesh.load("given.binvox").points, 2).tolist())

grid = trimesh.voxel.VoxelGrid(cells.astype(bool))
grid.export("written.binvox")
print("trimesh writes a grid with the centres", grid.points.tolist())
print("trimesh reads its own file as", trimesh.load("written.binvox").points.tolist())
PY
for name in given written; do
    binvox2bt "$name.binvox" -o "$name.bt" > "$name.log" 2>&1
    bt2vrml "$name.bt" > /dev/null 2>&1
    echo "octomap reads $name.binvox with $(grep -o 'leaf size [0-9.]*' "$name.log") and the centres" \
        "$(grep -oE 'translation [-0-9. e]+' "$name.bt.wrl" | sed 's/translation //; s/ *$//' | paste -sd';')"
done | tee -a seen.txt

grep -q 'trimesh reads the centres \[\[0.0, 2.67, 1.33\], \[4.0, 0.0, 0.0\]\]' seen.txt
grep -q 'trimesh reads its own file as \[\[0.0, 2.0, 1.0\], \[3.0, 0.0, 0.0\]\]' seen.txt
grep -q 'octomap reads given.binvox with leaf size 1 and the centres 3.5 0.5 0.5;0.5 2.5 1.5' seen.txt
grep -q 'octomap reads written.binvox with leaf size 0.75 ' seen.txt
echo "The behaviour is as described."
