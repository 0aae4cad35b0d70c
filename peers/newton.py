"""newton takes exports --to heights, mjcf and usd."""
# pypi: newton[importers]==1.8.0 mujoco==4.0.0 trimesh==5.2.0 scipy==1.17.1 pillow==13.0.0 numpy==2.4.6

import collections

import newton
import numpy
import warp as wp

from ground import Ground
from peer import Peer, assets, export


def shapes(builder):
    """Kinds of shapes and how many, and how many of the meshes stand away from the origin."""
    kinds = collections.Counter(newton.GeoType(kind).name for kind in builder.shape_type)
    return kinds, ", ".join(f"{count} {name}" for name, count in sorted(kinds.items()))


def rest_on(heightfield, xform, places):
    """Heights where balls of 0.2 m come to rest over a height field, with MuJoCo's solver."""
    builder = newton.ModelBuilder()
    builder.add_shape_heightfield(xform=xform, heightfield=heightfield)
    for x, y, z in places:
        body = builder.add_body(xform=wp.transform((x, y, z + 0.4), wp.quat_identity()))
        builder.add_shape_sphere(body, radius=0.2)
    model = builder.finalize()
    states = model.state(), model.state()
    control, solver = model.control(), newton.solvers.SolverXPBD(model)
    for _ in range(240):
        contacts = model.collide(states[0])
        states[0].clear_forces()
        solver.step(states[0], states[1], control, contacts, 1 / 240)
        states = states[1], states[0]
    return states[0].body_q.numpy()[:, :3]


def main():
    wp.config.quiet = True
    peer = Peer("newton", newton.__version__, "`--to heights`, `--to mjcf`, `--to usd`, `--expand`",
                "`--expand` for usd: of a PointInstancer it shows one copy a model, at the origin. "
                "`newton[importers]`, trimesh, SciPy and Pillow have to be there")
    ground = Ground(export("heights", "heights"))
    h, about = ground.heights, ground.about
    field = newton.Heightfield(data=h[::-1], nrow=h.shape[0], ncol=h.shape[1],
                               hx=ground.width / 2, hy=ground.depth / 2)
    xform = wp.transform((*about["center"], 0.0), wp.quat_identity())
    starts = [(x, y, ground.at(x, y)) for x, y in ground.places(20, margin_m=20)]
    off = [z - 0.2 - ground.at(x, y) for x, y, z in rest_on(field, xform, starts)]
    peer.check("20 balls on the height field", max(map(abs, off)) < 0.05,
               f"{min(off):.3f} to {max(off):.3f} m above the ground after 1 s")
    large = sum(row["kind"] not in ("grass_tuft", "flower", "crop") for row in assets())
    builder = newton.ModelBuilder()
    builder.add_mjcf(str(export("mjcf", "mjcf") / "world.xml"))
    kinds, text = shapes(builder)
    peer.check("mjcf", kinds["MESH"] == large + 1 and kinds["HFIELD"] == 1, text)
    for name, options, whole in (("usd", (), False), ("usd_expanded", ("--expand",), True)):
        builder = newton.ModelBuilder()
        builder.add_usd(str(export("usd", name, *options) / "world.usda"))
        kinds, text = shapes(builder)
        peer.check(name, (kinds["MESH"] == len(assets()) + 2) == whole, text)
    peer.finish()


main()
