"""Blender imports exports --to glb --expand and usd."""
# debian: blender
# pypi: numpy==2.4.6

import json

from ground import Ground
from peer import FOLDER, Peer, assets, export, run

SCRIPT = """
import json, sys
import bpy, numpy
if "bool" not in vars(numpy):
    numpy.bool = bool  # its importer of glTF names what NumPy dropped in 1.24
kind, path, out = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
if kind == "glb":
    bpy.ops.import_scene.gltf(filepath=path)
else:
    bpy.ops.wm.usd_import(filepath=path)
meshes = [o for o in bpy.data.objects if o.type == "MESH"]
ground = next(o for o in bpy.data.objects if o.name.startswith("ground") and o.type == "MESH")
points = [list(ground.matrix_world @ v.co) for v in ground.data.vertices]
away = sum((o.matrix_world.translation.length > 1.0) for o in meshes)
json.dump({"meshes": len(meshes), "away": away, "points": points[::61],
           "assets": sum("asset" in o.keys() for o in bpy.data.objects)}, open(out, "w"))
"""


def main():
    version = run("blender", "--version").stdout.split("\n")[0].split()[-1]
    peer = Peer("Blender", version, "`--to glb --expand`, `--to usd`, `--to usd --expand`",
                "`--expand` for both")
    ground = Ground(export("heights", "heights"))
    (FOLDER / "import.py").write_text(SCRIPT)
    for name, form, options in (("expanded.glb", "glb", ("--expand",)), ("usd", "usd", ()),
                                ("usd_expanded", "usd", ("--expand",))):
        path = export(form, name, *options)
        path = path / "world.usda" if form == "usd" else path
        out = FOLDER / f"{name}.json"
        done = run("blender", "--background", "--factory-startup", "--python-exit-code", "1",
                   "--python", FOLDER / "import.py", "--", form, path, out)
        if not out.exists():
            peer.check(name, False, done.stdout.strip()[-200:])
            continue
        found = json.loads(out.read_text())
        whole = found["away"] >= len(assets()) - 5
        peer.check(name, whole == ("--expand" in options),
                   f"{found['meshes']} meshes, {found['away']} of them not at the origin, "
                   f"{found['assets']} objects with `asset`")
        points = [p for p in found["points"]
                  if abs(p[0]) < ground.width / 2 and abs(p[1]) < ground.depth / 2][:1000]
        ground.check(peer, [p[2] for p in points], [p[:2] for p in points])
    peer.finish()


main()
