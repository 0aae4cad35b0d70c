"""What a robot is rewarded for."""

import math

import numpy as np
from gymnasium import spaces


class Task:
    """What users replace. One task serves one robot; it keeps what belongs to the episode."""

    def spaces(self, server):
        """What the task adds to the robot's observation: {name: gymnasium space}. server: the
        world, with size_m, world_id, footprint_radius(), occupancy() and free_space()."""
        raise NotImplementedError

    def begin(self, view, rng, server):
        """An episode begins. rng: numpy Generator; all that is drawn has to come from it."""
        raise NotImplementedError

    def observe(self, view):
        """{name: value in its space}."""
        raise NotImplementedError

    def judge(self, before, after):
        """(reward, whether the episode ends here, dict for info) of one action."""
        raise NotImplementedError


class GoalTask(Task):
    """Reach a place.

    The goal is drawn among the free places that the robot can get to on the map, clearance_m (None:
    the radius of the robot's footprint) away from what is not free, at a distance in distance_m
    (least, most) from the robot. With d the distance to it in the plane before and after an action,

        reward = (d_before - d_after) - time_cost + bonus [d_after < radius_m] - penalty [dead]

    and the episode ends when the goal is reached or the robot is dead. Observed is "goal": where it
    lies in the robot's base_link (x forward, y left) [m].
    """

    def __init__(self, radius_m=0.7, distance_m=(3.0, 10.0), clearance_m=None, time_cost=0.01,
                 bonus=10.0, penalty=10.0, goal=None):
        """goal: (x, y) in map [m], where it shall be the same in every episode; None: drawn."""
        if not 0.0 < radius_m < distance_m[0] <= distance_m[1]:
            raise ValueError(f"radius_m {radius_m} and distance_m {distance_m} are not legal; "
                             "legal is 0 < radius_m < least distance <= most distance")
        self.radius_m, self.distance_m, self.clearance_m = radius_m, distance_m, clearance_m
        self.time_cost, self.bonus, self.penalty = time_cost, bonus, penalty
        self.goal = goal
        self._is_fixed = goal is not None
        self._space = None
        self._world_id = None  # that the space is of

    def spaces(self, server):
        reach_m = np.float32(2.0 * server.size_m)
        return {"goal": spaces.Box(-reach_m, reach_m, (2,), np.float32)}

    def begin(self, view, rng, server):
        if self._is_fixed:
            return
        if self._world_id != server.world_id:
            clearance_m = self.clearance_m
            if clearance_m is None:
                clearance_m = server.footprint_radius(view.name)
            self._space = server.free_space(clearance_m)
            self._world_id = server.world_id
        self.goal = self._space.draw(view.x_m, view.y_m, *self.distance_m, rng)

    def observe(self, view):
        dx, dy = self.goal[0] - view.x_m, self.goal[1] - view.y_m
        cos, sin = math.cos(view.yaw_rad), math.sin(view.yaw_rad)
        return {"goal": np.array([cos * dx + sin * dy, cos * dy - sin * dx], dtype=np.float32)}

    def judge(self, before, after):
        distance_m = self._distance(after)
        success = after.alive and distance_m < self.radius_m
        reward = self._distance(before) - distance_m - self.time_cost
        if success:
            reward += self.bonus
        if not after.alive:
            reward -= self.penalty
        return reward, success or not after.alive, {"is_success": success,
                                                    "distance_m": distance_m}

    def _distance(self, view):
        return math.hypot(self.goal[0] - view.x_m, self.goal[1] - view.y_m)
