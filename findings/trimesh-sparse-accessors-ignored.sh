#!/usr/bin/env bash
# trimesh loads a glTF mesh with sparse accessors as if nothing had been replaced.
#
# Versions: trimesh 5.2.0 and numpy 2.4.6 from PyPI.
# Expected: Sparse accessors belong to the core of glTF 2.0. An accessor names a base and some elements that replace
# elements of the base. A loader applies them, or says that it cannot.
# Observed: The base comes back unchanged. A plain with one raised summit is a plain, and if the accessor has no base,
# which stands for zeros, then the mesh has shrunk to a point. There is no error and no warning, and the "max" that
# the file gives for the same accessor is not compared. Tools that write sparse accessors do so for meshes that differ
# little from another one, so that exactly the difference is lost.
# Since: trimesh 4.5.0 and 4.12.1 ignore them too, at least for accessors that have a base.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check trimesh==5.2.0 numpy==2.4.6

venv/bin/python - <<'PY' | tee seen.txt
import json
import struct
import numpy
import trimesh

base = numpy.array([[0, 0, 0], [2, 0, 0], [0, 2, 0]], "<f4")
summit = numpy.array([[2, 0, 9]], "<f4")
raised = numpy.array([[0, 0, 0], [2, 0, 9], [0, 2, 0]], "<f4")


def write(name, parts, accessor):
    binary, views = b"", []
    for part in parts:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": part.nbytes})
        binary += part.tobytes()
        binary += bytes(-len(binary) % 4)
    accessor = {"componentType": 5126, "count": 3, "type": "VEC3", **accessor}
    document = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": len(binary)}], "bufferViews": views, "accessors": [accessor]}).encode()
    document += b" " * (-len(document) % 4)
    with open(name, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(document) + len(binary)))
        file.write(struct.pack("<I4s", len(document), b"JSON") + document)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)


def replace(indices, view):
    return {"count": len(indices), "indices": {"bufferView": view, "componentType": 5123}, "values": {"bufferView": view + 1}}


one = numpy.array([1], "<u2")
two = numpy.array([1, 2], "<u2")
write("dense.glb", [raised], {"bufferView": 0, "min": [0, 0, 0], "max": [2, 2, 9]})
write("sparse.glb", [base, one, summit], {"bufferView": 0, "min": [0, 0, 0], "max": [2, 2, 9], "sparse": replace(one, 1)})
write("zeros.glb", [two, raised[1:]], {"min": [0, 0, 0], "max": [2, 2, 9], "sparse": replace(two, 0)})
for name in ("dense", "sparse", "zeros"):
    (mesh,) = trimesh.load_scene(name + ".glb", process=False).geometry.values()
    print(f"{name}:", mesh.vertices.tolist())
PY

grep -q '^dense: \[\[0.0, 0.0, 0.0\], \[2.0, 0.0, 9.0\], \[0.0, 2.0, 0.0\]\]' seen.txt
grep -q '^sparse: \[\[0.0, 0.0, 0.0\], \[2.0, 0.0, 0.0\], \[0.0, 2.0, 0.0\]\]' seen.txt
grep -q '^zeros: \[\[0.0, 0.0, 0.0\], \[0.0, 0.0, 0.0\], \[0.0, 0.0, 0.0\]\]' seen.txt
echo "The behaviour is as described."
