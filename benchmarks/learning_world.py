"""What the programs of learning_peers.py have in common: the land, the robot, the scan, the actions."""

import json
import math
import pathlib
import sys
import time

import numpy as np

STEP_S, STEPS = 0.01, 10  # of a decision
EPISODE = 50  # decisions, then the robot is put to its start
RAYS, RANGE_M = 360, 30.0
SIZE_M = 128.0
LAYOUT = "Gentle hills of grass."
ENVIRONMENT = ("A sunny summer noon, no grass, no flowers, no trees, no bushes, no stones. A wheeled robot "
               "waits in the center.")  # the bare ground, as peers have it

# The species "wheeled robot".
MASS_KG, WHEEL_MASS_KG = 24.0, 1.5
WHEEL_RADIUS_M, WHEEL_WIDTH_M = 0.12, 0.06
TRACK_M, WHEELBASE_M = 0.46, 0.36
CHASSIS_M = (0.56, 0.36, 0.24)  # above a clearance of 0.1
CLEARANCE_M = 0.1
MAX_TORQUE_NM = 14.0
SCAN_HEIGHT_M = 0.46  # above the ground
WHEELS = [(x, y) for x in (0.5 * WHEELBASE_M, -0.5 * WHEELBASE_M)
          for y in (0.5 * TRACK_M, -0.5 * TRACK_M)]
ANGLES = np.linspace(-math.pi, math.pi, RAYS, endpoint=False)


def actions(seed):
    """Endless (forward [m/s], yaw rate [rad/s])."""
    random = np.random.default_rng(seed)
    while True:
        yield random.uniform(0.3, 1.5), random.uniform(-1.0, 1.0)


def wheel_rates(forward_mps, yaw_rate_radps):
    """(left, right) [rad/s] of a skid steer."""
    half_m = 0.5 * TRACK_M
    return ((forward_mps - yaw_rate_radps * half_m) / WHEEL_RADIUS_M,
            (forward_mps + yaw_rate_radps * half_m) / WHEEL_RADIUS_M)


class Land:
    """heights.npy, row 0 north, and its cell [m]."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.heights = np.load(folder / "heights.npy")
        about = json.loads((folder / "land.json").read_text())
        self.cell_m, self.start_m = about["cell_m"], about["start_m"]

    def around(self, x, y, reach_m=0.5):
        """The highest of the ground near a place [m]."""
        rows, columns = self.heights.shape
        column = x / self.cell_m + 0.5 * columns - 0.5
        row = 0.5 * rows - 0.5 - y / self.cell_m
        reach = int(reach_m / self.cell_m) + 1
        return float(self.heights[max(0, int(row) - reach):int(row) + reach + 2,
                                  max(0, int(column) - reach):int(column) + reach + 2].max())


def measure(decide, position, restart, seconds):
    """Prints, as JSON, decisions a second of a robot that drives and scans, and how far it got.

    decide: one decision, answering the scan [m]. position: answers (x, y) [m]. restart: puts the
    robot to its start, every EPISODE decisions.
    """
    def episode():
        restart()
        path_m, before, seen = 0.0, position(), 0.0
        for _ in range(EPISODE):
            seen += float((np.asarray(decide()) < RANGE_M).mean()) / EPISODE
            now = position()
            path_m += math.dist(before, now)
            before = now
        return path_m, seen

    episode()
    count, path_m, seen, begin, cpu = 0, 0.0, 0.0, time.perf_counter(), time.process_time()
    while time.perf_counter() - begin < seconds:
        path, share = episode()
        count, path_m, seen = count + 1, path_m + path, seen + share
    report(EPISODE * count, time.perf_counter() - begin, time.process_time() - cpu,
           path_m / (count * EPISODE * STEP_S * STEPS), seen / count)


def report(decisions, wall_s, cpu_s, speed_mps, share_of_returns, **others):
    json.dump({"decisions_per_s": decisions / wall_s, "cpu_us_a_decision": 1e6 * cpu_s / decisions,
               "speed_mps": speed_mps, "share_of_returns": share_of_returns, **others}, sys.stdout)
