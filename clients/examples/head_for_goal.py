#!/usr/bin/env python3
"""A stack for campaigns: heads for the goal, and slows down before what its scanner sees.

In a campaign's file: `robots: [{stack: {command: [python3, head_for_goal.py], name: head for goal}}]`.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "latticeworld_stack"))
import latticeworld_stack as lw  # noqa: E402


class HeadForGoal(lw.Stack):
    def begin(self, task):
        self.robot, self.goal, self.clear_m = task.robot, task.goal, math.inf

    def update(self, now):
        east, north = self.goal.x_m - now.x_m, self.goal.y_m - now.y_m
        if math.hypot(east, north) < 0.6 * self.goal.radius_m:
            return lw.ARRIVED
        for scan in now.scans:
            ahead = [x for x, y in zip(scan.hits[0::3], scan.hits[1::3])
                     if x > 0.0 and abs(y) < self.robot.radius_m]
            self.clear_m = min(ahead, default=math.inf) - self.robot.radius_m
        off = math.remainder(math.atan2(north, east) - now.yaw_rad, math.tau)
        turn = max(-1.0, min(1.0, 2.0 * off)) * 0.7 * self.robot.turn_rate_radps
        speed = self.robot.top_speed_mps * max(0.0, math.cos(off)) ** 2
        return min(speed, max(0.1, 0.5 * self.clear_m), math.hypot(east, north)), turn


if __name__ == "__main__":
    lw.run(HeadForGoal())
