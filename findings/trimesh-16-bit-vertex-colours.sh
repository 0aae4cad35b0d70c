#!/usr/bin/env bash
# trimesh takes the low byte of 16-bit vertex colours of a glTF file, so that mid-grey becomes black.
#
# Versions: trimesh 5.2.0 and numpy 2.4.6 from PyPI.
# Expected: glTF 2.0 allows COLOR_0 as bytes, as 16-bit integers or as floats. 16-bit values are divided by 65535, so
# that 32768 is half bright, which is 128 in a byte.
# Observed: Each value is taken modulo 256. 65535 happens to be right as 255, and so does 0, so that pure colours look
# as they should. But 32768 and 65280 are 0, and 255, which is nearly black, has full brightness. The same colours as
# bytes or as floats are right. Vertex-coloured terrain gets stripes of noise, without a warning.
# Since: trimesh 4.5.0 and 4.12.1 do the same.
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

corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4").tobytes()
exact = numpy.array([[65535, 32768, 0, 65535], [65280, 255, 0, 65535], [256, 16384, 49152, 65535]])
kinds = {"bytes": (5121, numpy.rint(exact / 257).astype("u1"), True), "floats": (5126, (exact / 65535).astype("<f4"), False),
         "16-bit integers": (5123, exact.astype("<u2"), True)}
for kind, (component, colours, normalized) in kinds.items():
    binary = corners + colours.tobytes()
    document = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}}]}],
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": len(binary) - 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": component, "count": 3, "type": "VEC4", "normalized": normalized}]}).encode()
    document += b" " * (-len(document) % 4)
    with open("mesh.glb", "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(document) + len(binary)))
        file.write(struct.pack("<I4s", len(document), b"JSON") + document)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
    (mesh,) = trimesh.load_scene("mesh.glb", process=False).geometry.values()
    print(f"{kind}:", mesh.visual.vertex_colors[:, :3].tolist())
print("exact:", numpy.rint(exact[:, :3] / 257).astype(int).tolist())
PY

grep -q '^16-bit integers: \[\[255, 0, 0\], \[0, 255, 0\], \[0, 0, 0\]\]' seen.txt
grep -q '^bytes: \[\[255, 128, 0\], \[254, 1, 0\], \[1, 64, 191\]\]' seen.txt
grep -q '^exact: \[\[255, 128, 0\], \[254, 1, 0\], \[1, 64, 191\]\]' seen.txt
grep -q '^floats: \[\[255, 12[78], 0\], \[25[34], [01], 0\], ' seen.txt
echo "The behaviour is as described."
