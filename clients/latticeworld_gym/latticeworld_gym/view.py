"""What a robot is seen to be after a lockstep call."""

import math
from dataclasses import dataclass, field
from typing import List

import numpy as np


@dataclass
class View:
    """One robot after the last step of a call; frame map, SI."""

    name: str
    x_m: float
    y_m: float
    yaw_rad: float
    forward_mps: float
    yaw_rate_radps: float
    alive: bool
    health: float  # 0 .. 1
    contact_n: float  # hardest bump of the last step with what it does not stand on; 0: none
    scan_m: np.ndarray  # (sectors,), float32, from right to left; nearest return, or the largest range
    events: List[str] = field(default_factory=list)  # kinds, of the call's steps, in order


def sectors_of(scan, sectors, max_range_m):
    """The nearest return in each of so many equal parts of a sensor_msgs/LaserScan.

    Returns (sectors,) float32 in 0 .. max_range_m; the largest where nothing is, and everywhere
    while there is no sweep yet.
    """
    ranges = np.asarray(scan.ranges, dtype=np.float32)
    if sectors == 0 or ranges.size == 0:
        return np.full(sectors, max_range_m, dtype=np.float32)
    # Too near, too far and nothing at all are inf or NaN there (REP 117).
    ranges = np.where(ranges >= scan.range_min, ranges, np.float32(max_range_m))
    begins = np.linspace(0, ranges.size, sectors, endpoint=False).astype(int)
    return np.clip(np.minimum.reduceat(ranges, begins), 0.0, max_range_m).astype(np.float32)


def view_of(observation, events, sectors, max_range_m):
    """observation: latticeworld/Observation; events: latticeworld/AgentEvent of the same call."""
    state = observation.state
    q = state.pose.orientation
    return View(name=state.name, x_m=state.pose.position.x, y_m=state.pose.position.y,
                yaw_rad=math.atan2(2.0 * (q.w * q.z + q.x * q.y),
                                   1.0 - 2.0 * (q.y * q.y + q.z * q.z)),
                forward_mps=state.twist.linear.x, yaw_rate_radps=state.twist.angular.z,
                alive=observation.alive, health=state.health,
                contact_n=observation.bumper.force,
                scan_m=sectors_of(observation.scan, sectors, max_range_m),
                events=[event.kind for event in events if event.agent == state.name])
