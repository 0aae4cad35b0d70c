"""Lets a Python class drive the robots of LatticeWorld campaigns, in lockstep with the simulation.

A campaign starts the program that its file names (`stack: {command: [python3, mine.py]}`), tells it
one JSON object a line on its standard input, and waits for one on its standard output. This module
does the talking: derive from Stack, and call run(). It needs nothing but Python, and no ROS. What
the program prints goes to standard error, so that print() does no harm.

Frames and units: SI; `map` is x east, y north, z up; poses are (x, y, z, qx, qy, qz, qw) of a frame
in `map`; the robot's x is forward, and turning left is positive.
"""

import array
import base64
import dataclasses
import json
import math
import sys

FORMAT = 1


@dataclasses.dataclass(frozen=True)
class Map:
    """The occupancy grid of the robot's limits, in the order of nav_msgs/OccupancyGrid."""

    cols: int
    rows: int
    resolution_m: float
    origin_m: tuple  # (x, y) of the south-west corner
    costs: bytes  # (rows * cols), from the south-west, row by row: 0 free .. 100 occupied

    def cost(self, x_m, y_m):
        """0 free .. 100 occupied, or beyond the map."""
        col = math.floor((x_m - self.origin_m[0]) / self.resolution_m)
        row = math.floor((y_m - self.origin_m[1]) / self.resolution_m)
        if not (0 <= col < self.cols and 0 <= row < self.rows):
            return 100
        return self.costs[row * self.cols + col]


@dataclasses.dataclass(frozen=True)
class Robot:
    """What drives, and the limits that its map is made for."""

    name: str
    species: str
    top_speed_mps: float
    turn_rate_radps: float
    radius_m: float
    max_slope_rad: float
    max_step_m: float
    max_fording_depth_m: float


@dataclasses.dataclass(frozen=True)
class Goal:
    """A disc in plan."""

    x_m: float
    y_m: float
    radius_m: float


@dataclasses.dataclass(frozen=True)
class Scan:
    """One revolution of a lidar."""

    time_s: float  # its end
    planar: bool  # of a 2D scanner
    pose: tuple  # of the sensor, at that time
    hits: array.array  # float32 x, y, z a point, in the sensor's frame of that time
    misses: array.array  # the same: ends of beams that met nothing


@dataclasses.dataclass(frozen=True)
class Now:
    """What a robot knows at one moment."""

    time_s: float
    pose: tuple
    speed_mps: float  # by the wheels' encoders
    turn_rate_radps: float
    scans: tuple  # since the last time, by time

    @property
    def x_m(self):
        return self.pose[0]

    @property
    def y_m(self):
        return self.pose[1]

    @property
    def yaw_rad(self):
        _, _, _, x, y, z, w = self.pose
        return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


@dataclasses.dataclass(frozen=True)
class Task:
    robot: Robot
    goal: Goal
    map: Map
    now: Now
    control_hz: float


class Failed(Exception):
    """Raised by a stack that gives up; its text is the trial's reason."""


ARRIVED = "arrived"


class Stack:
    """What drives: one object a trial."""

    def begin(self, task):
        """Told once, before the first update. Raise Failed to refuse the task."""

    def update(self, now):
        """Returns (speed [m/s], turn rate [rad/s]), or ARRIVED. Raise Failed to give up."""
        raise NotImplementedError


def _points(text):
    points = array.array("f")
    points.frombytes(base64.b64decode(text))
    if sys.byteorder == "big":
        points.byteswap()
    return points


def _now(said):
    scans = tuple(Scan(scan["time_s"], scan["planar"], tuple(scan["pose"]),
                       _points(scan["hits"]), _points(scan["misses"])) for scan in said["scans"])
    return Now(said["time_s"], tuple(said["pose"]), said["speed_mps"], said["turn_rate_radps"],
               scans)


def _task(said):
    if said["format"] != FORMAT:
        raise Failed(f"this is format {said['format']}, and the client knows {FORMAT}")
    grid = said["map"]
    return Task(Robot(**said["robot"]), Goal(**said["goal"]),
                Map(grid["cols"], grid["rows"], grid["resolution_m"], tuple(grid["origin_m"]),
                    base64.b64decode(grid["costs"])),
                _now(said["now"]), said["control_hz"])


def _answer(stack, said):
    if said["say"] == "begin":
        stack.begin(_task(said))
        return {"state": "ready"}
    output = stack.update(_now(said["now"]))
    if output == ARRIVED:
        return {"state": ARRIVED}
    speed_mps, turn_rate_radps = output
    return {"state": "driving", "speed_mps": float(speed_mps),
            "turn_rate_radps": float(turn_rate_radps)}


def run(stack):
    """Serves one trial with the stack, until the campaign ends it."""
    answers, sys.stdout = sys.stdout, sys.stderr
    for line in sys.stdin:
        try:
            answer = _answer(stack, json.loads(line))
        except Failed as failed:
            answer = {"state": "failed", "why": str(failed) or "gave up"}
        print(json.dumps(answer), file=answers, flush=True)
