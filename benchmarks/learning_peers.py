#!/usr/bin/env python3
"""Decisions a second of a learner's robots: ours beside PyBullet, MuJoCo and our own server.

The same bare land of 128 m (their height map is ours), a four-wheel robot of the same mass and
size, steps of 10 ms with 10 a decision, a scan of 360 rays of 30 m, episodes of 50 decisions. Each
peer as its documentation does it, one process a core; ours is one process with a thread a core over
WORLDS worlds. Prints a table: decisions a second of all cores, processor time of a decision, and ratios
of the latter, which hold on a machine that others use too. Also the memory of a further world of ours.

Usage: learning_peers.py [--seconds S] [--worlds N] [--cores N] [--folder DIR]
                         [--peers-python PYTHON] (3.8 .. 3.11: PyBullet has wheels for those alone)
                         [--devel DIR] (that of a build: its world_server too, asked over ROS)
Run by a Python that has latticeworld installed; peers get virtual environments below the folder.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from learning_world import ENVIRONMENT, LAYOUT, RANGE_M, RAYS, SIZE_M

import latticeworld as lw

HERE = pathlib.Path(__file__).resolve().parent
PACKAGES = {"pybullet": ["pybullet==3.2.7", "numpy==1.26.4"],
            "mujoco": ["mujoco==4.0.0", "numpy==2.2.6"]}
PEERS = {"PyBullet 3.2.7, rayTestBatch": ("pybullet", []),
         "MuJoCo 4.0.0, mj_multiRay on its height field": ("mujoco", ["hfield"]),
         "MuJoCo 4.0.0, mj_multiRay on a mesh of it": ("mujoco", ["mesh"])}


def make_land(folder):
    world = lw.World.generate(LAYOUT, ENVIRONMENT, seed=1, size_m=SIZE_M)
    world.save(folder / "world")
    np.save(folder / "heights.npy", world.heights)
    start = world.agents[0]
    (folder / "land.json").write_text(json.dumps({
        "cell_m": world.resolution_m, "start_m": [start["x_m"], start["y_m"]]}))
    (folder / "sensors.json").write_text(
        lw.Scanner(beams=RAYS, max_range_m=RANGE_M).sensor_file())


def python_with(name, folder, python):
    made = folder / name / "bin" / "python"
    if not made.exists():
        subprocess.run([python, "-m", "venv", folder / name], check=True)
        subprocess.run([made, "-m", "pip", "install", "--quiet", *PACKAGES[name]], check=True)
    return made


def run(commands):
    """Their reports, all at once, one process a core."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                       PYTHONDONTWRITEBYTECODE="1")
    processes = [subprocess.Popen([str(part) for part in command], stdout=subprocess.PIPE, text=True,
                                  env=environment) for command in commands]
    reports = []
    for process in processes:
        text, _ = process.communicate()
        if process.returncode != 0:
            sys.exit(f"{process.args} failed")
        reports.append(json.loads(text[text.index("{"):text.index("}") + 1]))
    return reports


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--cores", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--peers-python", default="/usr/bin/python3")
    parser.add_argument("--devel", type=pathlib.Path)
    arguments = parser.parse_args()
    folder = arguments.folder or pathlib.Path(tempfile.mkdtemp(prefix="latticeworld_peers_"))
    folder.mkdir(parents=True, exist_ok=True)
    land = folder / "land"
    if not land.exists():
        land.mkdir()
        make_land(land)

    ours = run([[sys.executable, HERE / "learning_latticeworld.py", land, 1, arguments.seconds,
                 arguments.worlds, arguments.cores]])[0]
    print("| | decisions a second | processor time of one | speed | returns | ratio of time |\n"
          "|---|---|---|---|---|---|")

    def show(name, rate, reports):
        means = {key: np.mean([report[key] for report in reports]) for key in reports[0]}
        print(f"| {name} | {rate:.0f} | {means['cpu_us_a_decision']:.0f} us | "
              f"{means['speed_mps']:.2f} m/s | {100 * means['share_of_returns']:.0f} % | "
              f"{means['cpu_us_a_decision'] / ours['cpu_us_a_decision']:.1f} |", flush=True)

    show(f"latticeworld, {arguments.worlds} worlds, {arguments.cores} threads",
         ours["decisions_per_s"], [ours])
    for name, (package, extra) in PEERS.items():
        python = python_with(package, folder, arguments.peers_python)
        reports = run([[python, HERE / f"learning_{package}.py", land, seed, arguments.seconds,
                        *extra] for seed in range(1, arguments.cores + 1)])
        show(name, sum(report["decisions_per_s"] for report in reports), reports)
    if arguments.devel:
        devel = arguments.devel.resolve()
        asked = [devel / "env.sh", "/usr/bin/python3", HERE / "ros/learning_lockstep.py", land, 1,
                 arguments.seconds, devel / "lib/latticeworld/world_server"]
        reports = run([asked])
        show("lockstep over ROS, one world", reports[0]["decisions_per_s"], reports)
    print(f"\na further world of {SIZE_M:.0f} m: {ours['mb_a_further_world']:.1f} MB")


if __name__ == "__main__":
    main()
