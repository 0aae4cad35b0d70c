"""MuJoCo's part of learning_peers.py: learning_mujoco.py LAND SEED SECONDS [hfield | mesh].

What rays meet: the height field that the robot drives on, or, quicker in MuJoCo, a mesh of the same
triangles that nothing else touches.
"""

import sys

import mujoco
import numpy as np
from learning_world import (ANGLES, CHASSIS_M, CLEARANCE_M, MASS_KG, MAX_TORQUE_NM, RANGE_M,
                            SCAN_HEIGHT_M, STEP_S, STEPS, WHEEL_MASS_KG, WHEEL_RADIUS_M,
                            WHEEL_WIDTH_M, WHEELS, Land, actions, measure, wheel_rates)

land = Land(sys.argv[1])
rays_meet_mesh = len(sys.argv) > 4 and sys.argv[4] == "mesh"
rows, columns = land.heights.shape
low, high = float(land.heights.min()), float(land.heights.max())
half_m = 0.5 * (columns - 1) * land.cell_m
x, y = land.start_m
middle_m = CLEARANCE_M + 0.5 * CHASSIS_M[2]
wheels = "".join(
    f'<body pos="{x} {y} {WHEEL_RADIUS_M - middle_m}"><joint name="w{i}" axis="0 1 0"/>'
    f'<geom type="cylinder" size="{WHEEL_RADIUS_M} {0.5 * WHEEL_WIDTH_M}" euler="90 0 0" '
    f'mass="{WHEEL_MASS_KG}" friction="0.8" contype="0" conaffinity="1"/></body>'
    for i, (x, y) in enumerate(WHEELS))
motors = "".join(f'<velocity joint="w{i}" kv="20" forcerange="{-MAX_TORQUE_NM} {MAX_TORQUE_NM}"/>'
                 for i in range(4))


def mesh_of(land):
    """Of the ground, as XML: vertices at the middles of cells, quads split from north-west."""
    east = (np.arange(columns) - 0.5 * (columns - 1)) * land.cell_m
    north = (0.5 * (rows - 1) - np.arange(rows)) * land.cell_m
    vertices = np.dstack([*np.meshgrid(east, north), land.heights]).reshape(-1, 3)
    nw = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    ne, sw, se = nw + 1, nw + columns, nw + columns + 1
    faces = np.concatenate([np.stack([nw, se, ne], 1), np.stack([nw, sw, se], 1)])
    return (f'<mesh name="land" inertia="shell" vertex="{" ".join(f"{v:.6g}" for v in vertices.ravel())}" '
            f'face="{" ".join(map(str, faces.ravel()))}"/>')


mesh, mesh_geom = (mesh_of(land), '<geom type="mesh" mesh="land" group="1" contype="0" '
                   'conaffinity="0"/>') if rays_meet_mesh else ("", "")
model = mujoco.MjModel.from_xml_string(f"""<mujoco>
<option timestep="{STEP_S}" integrator="implicitfast"/>
<asset><hfield name="land" nrow="{rows}" ncol="{columns}" size="{half_m} {half_m} {high - low} 1"/>{mesh}</asset>
<worldbody><geom type="hfield" hfield="land" pos="0 0 {low}" friction="0.8" contype="1" group="0"/>
{mesh_geom}
<body name="robot" pos="{x} {y} {land.around(x, y) + middle_m + 0.02}"><freejoint/>
<geom type="box" size="{' '.join(str(0.5 * side) for side in CHASSIS_M)}"
 mass="{MASS_KG - 4 * WHEEL_MASS_KG}" contype="0" conaffinity="1"/>{wheels}</body></worldbody>
<actuator>{motors}</actuator></mujoco>""")
# Its rows are from the south, its heights shares of the range.
model.hfield_data[:] = ((land.heights[::-1] - low) / (high - low)).ravel()
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
robot = model.body("robot").id
directions = np.stack([np.cos(ANGLES), np.sin(ANGLES), np.zeros_like(ANGLES)], axis=1)
geoms = np.zeros(len(ANGLES), np.int32)
distances = np.zeros(len(ANGLES))
wanted = actions(int(sys.argv[2]))
groups = np.array([not rays_meet_mesh, rays_meet_mesh, 0, 0, 0, 0], np.uint8)  # of geoms, for rays


def decide():
    left, right = wheel_rates(*next(wanted))
    data.ctrl[:] = left, right, left, right
    mujoco.mj_step(model, data, STEPS)
    turn = data.xmat[robot].reshape(3, 3)
    origin = data.xpos[robot] + turn @ [0, 0, SCAN_HEIGHT_M - middle_m]
    mujoco.mj_multiRay(model, data, origin, (directions @ turn.T).ravel(), groups, 1, robot,
                       geoms, distances, None, len(ANGLES), RANGE_M)
    return np.where(distances < 0, RANGE_M, np.minimum(distances, RANGE_M))


def restart():
    mujoco.mj_resetData(model, data)
    mujoco.mj_forward(model, data)


measure(decide, lambda: data.xpos[robot][:2].copy(), restart, float(sys.argv[3]))
