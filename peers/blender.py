"""Blender imports exports --to glb."""
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
path, out = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=path)
meshes = [o for o in bpy.data.objects if o.type == "MESH"]
ground = next(o for o in bpy.data.objects if o.name.startswith("ground") and o.type == "MESH")
points = [list(ground.matrix_world @ v.co) for v in ground.data.vertices]
away = sum((o.matrix_world.translation.length > 1.0) for o in meshes)
json.dump({"meshes": len(meshes), "away": away, "points": points[::61],
           "assets": sum("asset" in o.keys() for o in bpy.data.objects)}, open(out, "w"))
"""


def main():
    version = run("blender", "--version").stdout.split("\n")[0].split()[-1]
    peer = Peer("Blender", version, "`--to glb`, `--expand`",
                "`--expand`: it refuses instances. Debian's has no USD")
    ground = Ground(export("heights", "heights"))
    (FOLDER / "import.py").write_text(SCRIPT)
    found = {}
    for name, options in (("instanced.glb", ()), ("expanded.glb", ("--expand",))):
        out = FOLDER / f"{name}.json"
        said = run("blender", "--background", "--factory-startup", "--python-exit-code", "1",
                   "--python", FOLDER / "import.py", "--", export("glb", name, *options), out)
        if out.exists():
            found = json.loads(out.read_text())
            peer.check(name, options and found["assets"] == len(assets()),
                       f"{found['meshes']} meshes, {found['assets']} things with their numbers")
        else:
            lines = [line for line in said.stdout.splitlines() if line.strip()]
            reason = [line for line in lines if "xtension" in line] or lines[-3:]
            peer.check(name, not options, "refused: " + reason[-1].strip()[:120])
    points = [p for p in found["points"]
              if abs(p[0]) < ground.width / 2 and abs(p[1]) < ground.depth / 2][:1000]
    ground.check(peer, [p[2] for p in points], [p[:2] for p in points])
    peer.finish()


main()
