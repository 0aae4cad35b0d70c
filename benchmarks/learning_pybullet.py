"""PyBullet's part of learning_peers.py: learning_pybullet.py LAND SEED SECONDS."""

import math
import sys

import numpy as np
import pybullet as p
from learning_world import (ANGLES, CHASSIS_M, CLEARANCE_M, MASS_KG, MAX_TORQUE_NM, RANGE_M,
                            SCAN_HEIGHT_M, STEP_S, STEPS, WHEEL_MASS_KG, WHEEL_RADIUS_M,
                            WHEEL_WIDTH_M, WHEELS, Land, actions, measure, wheel_rates)

land = Land(sys.argv[1])
p.connect(p.DIRECT)
p.setGravity(0, 0, -9.81)
p.setTimeStep(STEP_S)
rows, columns = land.heights.shape
low, high = float(land.heights.min()), float(land.heights.max())
# Bullet's own grid is rows from the south, and lies with the middle of its heights at the origin.
shape = p.createCollisionShape(p.GEOM_HEIGHTFIELD, meshScale=[land.cell_m, land.cell_m, 1.0],
                               heightfieldData=land.heights[::-1].astype(float).ravel(),
                               numHeightfieldRows=columns, numHeightfieldColumns=rows)
ground = p.createMultiBody(0, shape, basePosition=[0, 0, 0.5 * (low + high)])
p.changeDynamics(ground, -1, lateralFriction=0.8)
chassis = p.createCollisionShape(p.GEOM_BOX, halfExtents=[0.5 * side for side in CHASSIS_M])
wheel = p.createCollisionShape(p.GEOM_CYLINDER, radius=WHEEL_RADIUS_M, height=WHEEL_WIDTH_M)
middle_m = CLEARANCE_M + 0.5 * CHASSIS_M[2]
start = [*land.start_m, land.around(*land.start_m) + middle_m + 0.02]
upright = [0, 0, 0, 1]
lying = p.getQuaternionFromEuler([math.pi / 2, 0, 0])
robot = p.createMultiBody(
    MASS_KG - 4 * WHEEL_MASS_KG, chassis, basePosition=start,
    linkMasses=[WHEEL_MASS_KG] * 4, linkCollisionShapeIndices=[wheel] * 4,
    linkVisualShapeIndices=[-1] * 4,
    linkPositions=[[x, y, WHEEL_RADIUS_M - middle_m] for x, y in WHEELS],
    linkOrientations=[lying] * 4, linkInertialFramePositions=[[0, 0, 0]] * 4,
    linkInertialFrameOrientations=[upright] * 4, linkParentIndices=[0] * 4,
    linkJointTypes=[p.JOINT_REVOLUTE] * 4, linkJointAxis=[[0, 0, -1]] * 4)
for joint in range(4):
    p.changeDynamics(robot, joint, lateralFriction=0.8)
    p.setCollisionFilterPair(robot, robot, -1, joint, 0)
directions = np.stack([np.cos(ANGLES), np.sin(ANGLES), np.zeros_like(ANGLES)], axis=1)
wanted = actions(int(sys.argv[2]))


def decide():
    left, right = wheel_rates(*next(wanted))
    p.setJointMotorControlArray(robot, range(4), p.VELOCITY_CONTROL,
                                targetVelocities=[left, right, left, right],
                                forces=[MAX_TORQUE_NM] * 4)
    for _ in range(STEPS):
        p.stepSimulation()
    place, orientation = p.getBasePositionAndOrientation(robot)
    turn = np.array(p.getMatrixFromQuaternion(orientation)).reshape(3, 3)
    origin = np.array(place) + turn @ [0, 0, SCAN_HEIGHT_M - middle_m]
    ends = origin + RANGE_M * directions @ turn.T
    hits = p.rayTestBatch(np.tile(origin, (len(ends), 1)), ends, numThreads=1)
    return [RANGE_M * hit[2] for hit in hits]


def restart():
    p.resetBasePositionAndOrientation(robot, start, upright)
    p.resetBaseVelocity(robot, [0, 0, 0], [0, 0, 0])
    for joint in range(4):
        p.resetJointState(robot, joint, 0.0, 0.0)


measure(decide, lambda: p.getBasePositionAndOrientation(robot)[0][:2], restart, float(sys.argv[3]))
