#!/usr/bin/env python3
"""A stack for campaigns that was learned: heads for the goal by its scanner, without a map.

In a campaign's file: `stack: {command: [python3, drive_by_policy.py, POLICY.onnx], name: learned}`,
for a robot of the suite `scanner`. Needs onnxruntime and NumPy (PyPI). What the policy is given is
said in training/latticeworld_training/policy.py.
"""

import math
import pathlib
import sys

import numpy as np
import onnxruntime

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "latticeworld_stack"))
import latticeworld_stack as lw  # noqa: E402

SECTORS, RANGE_M = 36, 20.0
RIGHTMOST_RAD, VIEW_RAD = math.radians(-135.0), math.radians(270.0)  # of the scanner


def nearest_in_sectors(hits):
    """The nearest return by sector, from right to left [m].

    hits: x, y, z a point, float32, in the sensor's frame.
    """
    points = np.frombuffer(hits, np.float32).reshape(-1, 3)
    sectors = np.full(SECTORS, RANGE_M, np.float32)
    around = (np.arctan2(points[:, 1], points[:, 0]) - RIGHTMOST_RAD) / VIEW_RAD
    places = np.clip((around * SECTORS).astype(int), 0, SECTORS - 1)
    np.minimum.at(sectors, places, np.hypot(points[:, 0], points[:, 1]))
    return sectors


def features(sectors, velocity, goal):
    """(1, 41) float32. velocity: [m/s, rad/s]; goal: in base_link, x forward, y left [m]."""
    distance = max(1e-6, math.hypot(*goal))
    direction = (goal[0] / distance, goal[1] / distance)
    parts = (1.0 / (1.0 + sectors), velocity, direction, [distance / (1.0 + distance)])
    return np.concatenate(parts).astype(np.float32)[None]


class DriveByPolicy(lw.Stack):
    def __init__(self, path):
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = 1
        self.network = onnxruntime.InferenceSession(path, options,
                                                    providers=["CPUExecutionProvider"])

    def begin(self, task):
        self.robot, self.goal = task.robot, task.goal
        self.sectors = np.full(SECTORS, RANGE_M, np.float32)

    def update(self, now):
        east, north = self.goal.x_m - now.x_m, self.goal.y_m - now.y_m
        if math.hypot(east, north) < 0.8 * self.goal.radius_m:
            return lw.ARRIVED
        for scan in now.scans:
            if scan.planar:
                self.sectors = nearest_in_sectors(scan.hits)
        cos, sin = math.cos(now.yaw_rad), math.sin(now.yaw_rad)
        goal = (cos * east + sin * north, cos * north - sin * east)
        given = features(self.sectors, (now.speed_mps, now.turn_rate_radps), goal)
        speed, turn = self.network.run(["action"], {"features": given})[0][0]
        return min(float(speed), self.robot.top_speed_mps), float(turn)


if __name__ == "__main__":
    lw.run(DriveByPolicy(sys.argv[1]))
