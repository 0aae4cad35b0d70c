#!/usr/bin/env bash
# PyBullet lets bodies fall through a height field that was replaced by a higher one, although rays hit it.
#
# Versions: pybullet 3.2.7 from PyPI.
# Expected: createCollisionShape with replaceHeightfieldIndex changes the heights of an existing terrain, so that bodies
# and rays meet the new surface.
# Observed: Rays meet the new surface, but bodies do not. The bounding box of the terrain's body stays the one of the
# first heights, even after steps of the simulation and after its pose is set again, and it is what contacts are looked
# for with. A ball that rests on the first terrain falls through the same terrain raised by 5 m, without a warning. The new heights are also centred about the middle of the old ones, not
# about their own middle as a fresh shape would be.
# Since: It is seen in 3.2.7 of January 2025, and earlier versions were not tried.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check pybullet==3.2.7 numpy==2.4.6

venv/bin/python - <<'PY' 2>&1 | tee seen.txt
import pybullet


def surface():
    hit = pybullet.rayTest([0.1, 0.2, 100], [0.1, 0.2, -100])[0]
    return round(hit[3][2], 3) if hit[0] >= 0 else None


def drop(start):
    sphere = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=0.3)
    ball = pybullet.createMultiBody(1, sphere, basePosition=[0.1, 0.2, start])
    for _ in range(480):
        pybullet.stepSimulation()
    height = pybullet.getBasePositionAndOrientation(ball)[0][2]
    pybullet.removeBody(ball)
    return round(height, 2)


def shape(heights, **replace):
    return pybullet.createCollisionShape(pybullet.GEOM_HEIGHTFIELD, meshScale=[1, 1, 1], heightfieldData=heights,
                                         numHeightfieldRows=5, numHeightfieldColumns=5, **replace)


pybullet.connect(pybullet.DIRECT)
pybullet.setGravity(0, 0, -10)
first = shape([0.0] * 24 + [2.0])
terrain = pybullet.createMultiBody(0, first, basePosition=[0, 0, 1])
print("before: surface", surface(), "box", *(corner[2] for corner in pybullet.getAABB(terrain)), "ball rests at", drop(2))
shape([5.0] * 24 + [7.0], replaceHeightfieldIndex=first)
pybullet.resetBasePositionAndOrientation(terrain, [0, 0, 1], [0, 0, 0, 1])
pybullet.stepSimulation()
print("after: surface", surface(), "box", *(corner[2] for corner in pybullet.getAABB(terrain)), "ball is at", drop(7))
PY

grep -q '^before: surface 0.0 box 0.0 2.0 ball rests at 0.3' seen.txt
grep -qE '^after: surface 5.0 box 0.0 2.0 ball is at -[0-9.]+$' seen.txt
echo "The behaviour is as described."
