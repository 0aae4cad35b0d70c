"""newton takes exports --to heights, mjcf and usd."""
# pypi: newton==1.8.0 mujoco==4.0.0 trimesh==5.2.0 scipy usd-core==26.11 numpy==2.4.6

import newton
import numpy
import warp as wp

from ground import Ground
from peer import Peer, export


@wp.kernel
def heights_of(field: wp.array(dtype=float), places: wp.array(dtype=wp.vec2)):
    i = wp.tid()
    field[i] = places[i][0]


def kinds(builder):
    names = {int(value): value.name.lower() for value in newton.GeoType}
    counts = {}
    for kind in builder.shape_type:
        counts[names.get(int(kind), str(kind))] = counts.get(names.get(int(kind), str(kind)), 0) + 1
    return ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))


def main():
    peer = Peer("newton", newton.__version__, "`--to heights`, `--to mjcf`, `--to usd`")
    ground = Ground(export("heights", "heights"))
    for form in ("mjcf", "usd"):
        builder = newton.ModelBuilder()
        if form == "mjcf":
            builder.add_mjcf(str(export("mjcf", "mjcf") / "world.xml"))
        else:
            builder.add_usd(str(export("usd", "usd") / "world.usda"))
        peer.check(form, True, kinds(builder))
    peer.finish()


main()
