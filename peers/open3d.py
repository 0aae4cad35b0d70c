"""Open3D reads exports --to ply and glb --expand."""
# pypi: open3d==0.20.0 numpy==2.4.6

import numpy
import open3d

from ground import Ground
from peer import Peer, assets, export


def main():
    peer = Peer("Open3D", open3d.__version__, "`--to ply`, `--to glb`, `--expand`",
                "`--expand` for glb; `open3d.t.io.read_point_cloud` for labels")
    path = str(export("ply", "points.ply"))
    legacy = open3d.io.read_point_cloud(path)
    tensor = open3d.t.io.read_point_cloud(path)
    peer.check("points", len(legacy.points) == len(tensor.point["positions"]),
               f"{len(legacy.points)} with colours {legacy.has_colors()}")
    kept = sorted(tensor.point)
    peer.check("labels in t.io", "label" in kept, ", ".join(kept))
    places = tensor.point["positions"].numpy().astype(float)
    labels = tensor.point["label"].numpy().ravel()
    truth = Ground(export("heights", "heights"))
    half = numpy.array([truth.width, truth.depth]) / 2
    dry = places[(labels == 0) & (numpy.abs(places[:, :2]) < half).all(axis=1)][::37][:1000]
    truth.check(peer, dry[:, 2], dry[:, :2].tolist(), limit_m=0.01)
    for name, options in (("expanded.glb", ("--expand",)), ("instanced.glb", ())):
        model = open3d.io.read_triangle_model(str(export("glb", name, *options)))
        triangles = sum(len(mesh.mesh.triangles) for mesh in model.meshes)
        peer.check(name, True, f"{len(model.meshes)} meshes, {triangles} triangles")
    peer.finish()


main()
