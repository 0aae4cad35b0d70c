"""trimesh loads exports --to glb, expanded and with instances, and ply."""
# pypi: trimesh==5.2.0 numpy==2.4.6 scipy==1.17.1

import numpy
import trimesh

from ground import Ground
from peer import Peer, assets, export


def numbers_in(scene):
    """Numbers of things, from what the file says of its nodes."""
    edges = scene.graph.transforms.edge_data.values()
    return {edge["metadata"]["asset"] for edge in edges if "asset" in edge.get("metadata", {})}


def main():
    peer = Peer("trimesh", trimesh.__version__, "`--to glb`, `--expand`, `--to ply`",
                "`--expand`: of instances it shows one copy a model, at the origin. Numbers of things "
                "are in `scene.graph.transforms.edge_data[...]['metadata']`")
    expanded = trimesh.load_scene(export("glb", "expanded.glb", "--expand"))
    peer.check("things", numbers_in(expanded) == set(range(len(assets()))),
               f"{len(numbers_in(expanded))} of {len(assets())}, by number; unit {expanded.units}")
    truth = Ground(export("heights", "heights"))
    points = numpy.asarray(expanded.geometry["ground"].vertices)[:, [0, 2, 1]] * [1, -1, 1]
    inside = (numpy.abs(points[:, :2]) < [truth.width / 2, truth.depth / 2]).all(axis=1)
    chosen = points[inside][::61][:1000]
    truth.check(peer, chosen[:, 2], chosen[:, :2].tolist())
    instanced = trimesh.load_scene(export("glb", "instanced.glb"))
    peer.check("with instances", len(numbers_in(instanced)) == 0,
               f"{len(instanced.graph.nodes_geometry)} meshes in place of "
               f"{len(expanded.graph.nodes_geometry)}, no word of it")
    cloud = trimesh.load(export("ply", "points.ply"))
    fields = cloud.metadata["_ply_raw"]["vertex"]["data"].dtype.names
    peer.check("ply", "label" in fields, f"{len(cloud.vertices)} points, in `_ply_raw` {fields}")
    peer.finish()


main()
