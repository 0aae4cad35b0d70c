"""PyBullet takes an export --to heights as docs/exports.md shows it."""
# pypi: pybullet==3.2.7 numpy==2.4.6

import importlib.metadata

import pybullet

from ground import Ground
from peer import Peer, export


def drop(x, y, z):
    """Where a ball of 0.2 m comes to rest [m]."""
    ball = pybullet.createMultiBody(1.0, pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=0.2),
                                    basePosition=[x, y, z + 0.5])
    pybullet.changeDynamics(ball, -1, rollingFriction=0.5)
    for _ in range(480):
        pybullet.stepSimulation()
    place, _ = pybullet.getBasePositionAndOrientation(ball)
    pybullet.removeBody(ball)
    return place


def main():
    peer = Peer("PyBullet", importlib.metadata.version("pybullet"), "`--to heights`",
                "turn the rows around; the base stands at the middle of lowest and highest "
                "(docs/exports.md)")
    ground = Ground(export("heights", "heights"))
    h, about = ground.heights, ground.about
    pybullet.connect(pybullet.DIRECT)
    pybullet.setGravity(0, 0, -9.81)
    cx, cy = about["center"]
    res = about["resolution"]
    shape = pybullet.createCollisionShape(
        pybullet.GEOM_HEIGHTFIELD, meshScale=[res, res, 1],
        heightfieldData=h[::-1].ravel().tolist(), numHeightfieldRows=h.shape[1],
        numHeightfieldColumns=h.shape[0])
    pybullet.createMultiBody(0, shape, basePosition=[
        cx, cy, (about["lowest"] + about["highest"]) / 2])
    places = ground.places(1000)
    found = []
    for begin in range(0, 1000, 200):
        part = places[begin:begin + 200]
        found += [hit[3][2] for hit in pybullet.rayTestBatch(
            [(x, y, 1000) for x, y in part], [(x, y, -1000) for x, y in part])]
    ground.check(peer, found, places, limit_m=2e-3)
    depths = []
    for x, y in ground.places(5, margin_m=20):
        x, y, z = drop(x, y, ground.at(x, y))
        depths.append(z - 0.2 - ground.at(x, y))
    peer.check("five balls at rest", all(-0.05 < depth < 0.05 for depth in depths),
               f"{min(depths):.3f} to {max(depths):.3f} m above the ground")
    peer.finish()


main()
