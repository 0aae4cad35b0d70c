"""What MuJoCo makes of an exported world: mujoco_world.py BUNDLE HEIGHTS MJCF, three folders.
Prints a line a check; ends with 1 where one fails. peers/mujoco.sh runs it."""

import csv
import json
import pathlib
import sys
import time
import xml.etree.ElementTree

import mujoco
import numpy

POINTS = 1000
GROUND = numpy.array([1, 0, 0, 0, 0, 0], dtype=numpy.uint8)  # its group of geoms
WHEELS = "".join(
    f'<body pos="{x} {y} 0"><joint name="{name}" axis="0 1 0" damping="0.1"/>'
    f'<geom type="sphere" size="0.12" mass="1"/></body>'
    for name, x, y in (("fl", .2, .2), ("fr", .2, -.2), ("rl", -.2, .2), ("rr", -.2, -.2)))
CAR = f"""<mujoco><worldbody><body name="chassis" pos="0 0 0.15"><freejoint/>
<geom type="box" size="0.25 0.12 0.05" mass="8"/>{WHEELS}</body></worldbody><actuator>
{"".join(f'<velocity joint="{name}" kv="5"/>' for name in ("fl", "fr", "rl", "rr"))}
</actuator></mujoco>"""

failed = False


def check(name, ok, figures):
    global failed
    failed = failed or not ok
    print(f"{'ok' if ok else 'FAILED':6} {name}: {figures}")


class Ground:
    """heights.npy as heights.json says that it lies."""

    def __init__(self, folder):
        self.heights = numpy.load(folder / "heights.npy")
        self.about = json.loads((folder / "heights.json").read_text())

    def at(self, x, y):
        """Height [m] at a place of the frame map [m] between the outermost centres."""
        west, north = self.about["origin"]
        col, row = (x - west) / self.about["resolution"], (north - y) / self.about["resolution"]
        c = min(int(col), self.heights.shape[1] - 2)
        r = min(int(row), self.heights.shape[0] - 2)
        u, v = col - c, row - r
        nw, ne = self.heights[r, c:c + 2].astype(float)
        sw, se = self.heights[r + 1, c:c + 2].astype(float)
        if u >= v:
            return nw + u * (ne - nw) + v * (se - ne)
        return nw + v * (sw - nw) + u * (se - sw)

    def places(self, count):
        random = numpy.random.default_rng(1)
        (west, north), (width, depth) = self.about["origin"], self.about["size"]
        return [(west + width * random.random(), north - depth * random.random())
                for _ in range(count)]


def ray_height(model, data, x, y):
    found = numpy.zeros(1, dtype=numpy.int32)
    distance = mujoco.mj_ray(model, data, numpy.array([x, y, 5000.0]),
                             numpy.array([0.0, 0.0, -1.0]), GROUND, 1, -1, found)
    return 5000.0 - distance if distance >= 0 else float("nan")


def check_files(mjcf):
    named = [element.get("file") for element in
             xml.etree.ElementTree.parse(mjcf / "world.xml").iter() if element.get("file")]
    missing = [name for name in named if not (mjcf / name).is_file()]
    check("files that world.xml names", not missing, f"{len(named)} named, {len(missing)} missing")


def check_heights(model, data, ground, middle):
    """Against the true heights and mirrored ones, so that a level world cannot pass."""
    errors, mirrored = [], []
    (west, north), (width, depth) = ground.about["origin"], ground.about["size"]
    for x, y in ground.places(POINTS):
        found = ray_height(model, data, x - middle[0], y - middle[1])
        errors.append(found - ground.at(x, y))
        mirrored.append([found - ground.at(2 * west + width - x, y),
                         found - ground.at(x, 2 * north - depth - y)])
    rms = float(numpy.sqrt(numpy.mean(numpy.square(errors))))
    others = numpy.sqrt(numpy.mean(numpy.square(mirrored), axis=0))
    worst = float(numpy.abs(errors).max())
    check(f"heights at {POINTS} places", worst < 1e-3 and others.min() > 0.1,
          f"rms {rms:.2g} m, largest {worst:.2g} m; mirrored west-east {others[0]:.2f} m, "
          f"north-south {others[1]:.2f} m")


def check_assets(model, bundle, middle):
    """Solid things stand where the number of their geom has them in assets.csv."""
    with open(bundle / "assets.csv", encoding="utf-8") as file:
        assets = list(csv.DictReader(file))
    seen = solid = 0
    worst = 0.0
    for i in range(model.ngeom):
        name = model.geom(i).name
        if not name.startswith("asset_"):
            continue
        if not name.endswith("_solid"):
            seen += 1
            continue
        solid += 1
        asset = assets[int(name.split("_")[1])]
        place = numpy.array([float(asset["x_m"]), float(asset["y_m"])]) - middle[:2]
        worst = max(worst, float(numpy.abs(model.geom_pos[i][:2] - place).max()))
    check("things by their numbers", seen > 0 and worst < 1e-3,
          f"{seen} seen, {solid} solid of {len(assets)} in assets.csv; off by {worst:.2g} m")


def check_steps(model):
    data = mujoco.MjData(model)
    begin = time.perf_counter()
    for _ in range(500):
        mujoco.mj_step(model, data)
    check("500 steps", bool(numpy.isfinite(data.qpos).all()),
          f"{(time.perf_counter() - begin) * 2:.2f} ms a step, {model.nv} degrees of freedom")


def check_drive(path, ground, middle):
    spec = mujoco.MjSpec.from_file(str(path))
    site = next((site for site in spec.sites if site.name == "start_robot"), None)
    if site is None:
        print("       no start_robot in this region")
        return
    spec.attach(mujoco.MjSpec.from_string(CAR), prefix="car_", site=site)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.body("car_chassis").xpos.copy()
    data.ctrl[:] = 8.0  # rad/s
    clearances, frictions = [], set()
    while data.time < 4.0:
        mujoco.mj_step(model, data)
        frictions |= {round(float(contact.friction[0]), 6) for contact in data.contact
                      if "ground" in (model.geom(contact.geom1).name,
                                      model.geom(contact.geom2).name)}
        x, y, z = data.body("car_chassis").xpos
        clearances.append(z - ground.at(x + middle[0], y + middle[1]))
    way = float(numpy.linalg.norm(data.body("car_chassis").xpos - start))
    check("a car from start_robot", way > 1.0 and min(clearances) > 0.0 and max(clearances) < 0.4,
          f"{way:.1f} m in 4 s, middle {min(clearances):.2f} to {max(clearances):.2f} m above it")
    wanted = round(float(model.geom("ground").friction[0]), 6)
    check("friction of its wheels", frictions == {wanted}, f"{sorted(frictions)}, ground {wanted}")


def main():
    bundle, heights, mjcf = (pathlib.Path(argument) for argument in sys.argv[1:4])
    begin = time.perf_counter()
    model = mujoco.MjModel.from_xml_path(str(mjcf / "world.xml"))
    print(f"mujoco {mujoco.__version__}, {mjcf.name}: {model.ngeom} geoms, {model.nmesh} meshes, "
          f"loaded in {time.perf_counter() - begin:.2f} s")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    ground = Ground(heights)
    middle = model.numeric("map_origin").data
    check_files(mjcf)
    check_heights(model, data, ground, middle)
    check_assets(model, bundle, middle)
    check_steps(model)
    check_drive(mjcf / "world.xml", ground, middle)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
