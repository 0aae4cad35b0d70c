#!/usr/bin/env bash
# trimesh and Open3D load glTF files whose required extension they do not know, and show something else.
#
# Versions: trimesh 5.2.0, open3d 0.20.0 and numpy 2.4.6 from PyPI.
# Expected: glTF 2.0 says that a client must support all of "extensionsRequired" or fail to load the file. A row of 9
# trees as instances of one (EXT_mesh_gpu_instancing, required) is either 9 trees or an error.
# Observed: Both load one tree at the origin, without an error or a warning. It is not about this extension: a name
# that nobody has ever used is passed over alike.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check trimesh==5.2.0 open3d==0.20.0 numpy==2.4.6

venv/bin/python -W ignore - 2> messages.txt <<'PY' | tee seen.txt
import json
import struct

import numpy
import open3d
import trimesh

triangle = numpy.array([[0, 0, 0], [1, 0, 0], [0, 2, 0]], "<f4")
places = numpy.array([[5 + 3 * i, 0, 0] for i in range(9)], "<f4")


def write(name, required):
    binary = triangle.tobytes() + places.tobytes()
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "extensionsUsed": required, "extensionsRequired": required,
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 108}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 2, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 9, "type": "VEC3"}]}
    if required == ["EXAMPLE_nobody_has_this"]:
        del document["nodes"][0]["extensions"]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(name, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)


open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Warning)
write("trees.glb", ["EXT_mesh_gpu_instancing"])
write("unknown.glb", ["EXAMPLE_nobody_has_this"])
for name in ("trees.glb", "unknown.glb"):
    scene = trimesh.load_scene(name)
    print(f"trimesh, {name}: {len(scene.graph.nodes_geometry)} mesh, from x = {scene.bounds[0][0]:g} to {scene.bounds[1][0]:g}")
    mesh = open3d.io.read_triangle_mesh(name)
    box = mesh.get_axis_aligned_bounding_box()
    print(f"open3d, {name}: {len(mesh.triangles)} triangle, from x = {box.min_bound[0]:g} to {box.max_bound[0]:g}")
PY
echo "messages: '$(cat messages.txt)'"

for name in trees unknown; do
    grep -q "^trimesh, $name.glb: 1 mesh, from x = 0 to 1" seen.txt
    grep -q "^open3d, $name.glb: 1 triangle, from x = 0 to 1" seen.txt
done
[ ! -s messages.txt ]
echo "The behaviour is as described."
