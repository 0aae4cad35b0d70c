"""MuJoCo loads exports --to mjcf, whole and of a region, steps one and drives over it."""
# pypi: mujoco==4.0.0 numpy==2.4.6

import time

import mujoco
import numpy

from ground import Ground
from peer import Peer, assets, export

GROUND = numpy.array([1, 0, 0, 0, 0, 0], dtype=numpy.uint8)  # its group of geoms
WHEELS = "".join(
    f'<body pos="{x} {y} 0"><joint name="{name}" axis="0 1 0" damping="0.1"/>'
    f'<geom type="sphere" size="0.12" mass="1"/></body>'
    for name, x, y in (("fl", .2, .2), ("fr", .2, -.2), ("rl", -.2, .2), ("rr", -.2, -.2)))
CAR = f"""<mujoco><worldbody><body name="chassis" pos="0 0 0.15"><freejoint/>
<geom type="box" size="0.25 0.12 0.05" mass="8"/>{WHEELS}</body></worldbody><actuator>
{"".join(f'<velocity joint="{name}" kv="5"/>' for name in ("fl", "fr", "rl", "rr"))}
</actuator></mujoco>"""


def ray_height(model, data, x, y):
    found = numpy.zeros(1, dtype=numpy.int32)
    distance = mujoco.mj_ray(model, data, numpy.array([x, y, 5000.0]),
                             numpy.array([0.0, 0.0, -1.0]), GROUND, 1, -1, found)
    return 5000.0 - distance if distance >= 0 else float("nan")


def check_heights(peer, model, ground):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    middle = model.numeric("map_origin").data
    places = ground.places(1000)
    ground.check(peer, [ray_height(model, data, x - middle[0], y - middle[1]) for x, y in places],
                 places)


def check_things(peer, model):
    """Solid things stand where the number of their geom has them in assets.csv."""
    names = [model.geom(i).name for i in range(model.ngeom)]
    rows = assets()
    worst = 0.0
    for i, name in enumerate(names):
        if name.startswith("asset_"):
            row = rows[int(name.split("_")[1])]
            place = float(row["x_m"]), float(row["y_m"])
            worst = max(worst, float(numpy.abs(model.geom_pos[i][:2] - place).max())
                        if name.endswith("_solid") else 0.0)
    solid = sum(name.endswith("_solid") for name in names)
    seen = sum(name.startswith("asset_") for name in names) - solid
    large = sum(row["kind"] not in ("grass_tuft", "flower", "crop") for row in rows)
    peer.check("things", seen == large and worst < 1e-3,
               f"{seen} of {large} seen, {solid} solid, off by {worst:.2g} m at most")


def check_drive(peer, path, ground):
    spec = mujoco.MjSpec.from_file(str(path))
    site = next(site for site in spec.sites if site.name == "start_robot")
    spec.attach(mujoco.MjSpec.from_string(CAR), prefix="car_", site=site)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.body("car_chassis").xpos.copy()
    data.ctrl[:] = 8.0  # rad/s
    clearances, frictions = [], set()
    begin = time.perf_counter()
    while data.time < 4.0:
        mujoco.mj_step(model, data)
        frictions |= {round(float(contact.friction[0]), 6) for contact in data.contact
                      if "ground" in (model.geom(contact.geom1).name,
                                      model.geom(contact.geom2).name)}
        x, y, z = data.body("car_chassis").xpos
        clearances.append(z - ground.at(x, y))
    step_ms = (time.perf_counter() - begin) / 2.0
    way = float(numpy.linalg.norm(data.body("car_chassis").xpos - start))
    wanted = round(float(model.geom("ground").friction[0]), 6)
    peer.check("a car from start_robot",
               way > 1.0 and 0.0 < min(clearances) and max(clearances) < 0.4
               and frictions == {wanted},
               f"{way:.1f} m in 4 s, {min(clearances):.2f} to {max(clearances):.2f} m above the "
               f"ground, friction {wanted:.3g}, {step_ms:.2f} ms a step")


def main():
    peer = Peer("MuJoCo", mujoco.__version__, "`--to mjcf`, whole and a region",
                "attach a robot at a site `start_<agent>`")
    path = export("mjcf", "mjcf") / "world.xml"
    model = mujoco.MjModel.from_xml_path(str(path))
    ground = Ground(export("heights", "heights"))
    check_heights(peer, model, ground)
    check_things(peer, model)
    earth = ground.about["earth"]
    off = abs(model.numeric("geo").data[:2] - [earth["latitude_deg"], earth["longitude_deg"]])
    peer.check("place on the earth", off.max() < 1e-9, f"{model.numeric('geo').data.round(6)}")
    check_drive(peer, path, ground)
    region = "--region=-30,-20,20.3,40"
    part = export("mjcf", "mjcf_region", region) / "world.xml"
    check_heights(peer, mujoco.MjModel.from_xml_path(str(part)),
                  Ground(export("heights", "heights_region", region)))
    peer.finish()


main()
