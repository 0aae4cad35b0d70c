"""What both environments do: episodes of some robots on one server."""

import dataclasses

import numpy as np
from gymnasium import spaces

from .errors import ServerError
from .view import View

MAX_SPEED_MPS = 100.0  # bounds of what is observed, not of what robots can do
MAX_YAW_RATE_RADPS = 100.0


@dataclasses.dataclass
class EpisodeOptions:
    """How episodes go."""

    steps_per_action: int = 10  # fixed steps of the simulator for each action
    max_actions: int = 500  # then the episode is truncated
    settle_steps: int = 20  # without a command after a reset: robots come to rest, scanners turn
    forward_mps: tuple = (-0.5, 1.5)  # actions: least and most speed forward
    yaw_rate_radps: tuple = (-1.5, 1.5)
    sectors: int = 36  # of the scan as it is observed; 0: no scan
    max_range_m: float = 20.0
    state_hash: bool = False  # info["state_hash"]

    def __post_init__(self):
        wrong = [f"{name} is {getattr(self, name)!r}; legal is at least {least}"
                 for name, least in (("steps_per_action", 1), ("max_actions", 1),
                                     ("settle_steps", 1), ("sectors", 0))
                 if not (isinstance(getattr(self, name), int) and getattr(self, name) >= least)]
        for name in ("forward_mps", "yaw_rate_radps"):
            low, high = getattr(self, name)
            if not (np.isfinite([low, high]).all() and low < high):
                wrong.append(f"{name} is {(low, high)}; legal are two finite numbers, the lower "
                             "one first")
        if not 0.0 < self.max_range_m < np.inf:
            wrong.append(f"max_range_m is {self.max_range_m}; legal is above 0")
        if wrong:
            raise ValueError("; ".join(wrong))


class Episode:
    """Robots, each with a task. Every random choice is drawn from the generator of begin()."""

    def __init__(self, server, tasks, options, spawn=None):
        """tasks: {robot: Task}. spawn: {robot: fields of the server's spawn()}: those that are made
        after every reset; the others are in the world's start state."""
        self.server, self.tasks, self.options = server, tasks, options
        self._spawn = dict(spawn or {})
        self._views = {}
        self._actions = 0

    def action_space(self):
        low, high = zip(self.options.forward_mps, self.options.yaw_rate_radps)
        return spaces.Box(np.array(low, np.float32), np.array(high, np.float32), (2,), np.float32)

    def observation_space(self, robot):
        limits = np.array([MAX_SPEED_MPS, MAX_YAW_RATE_RADPS], np.float32)
        space = {"velocity": spaces.Box(-limits, limits, (2,), np.float32)}
        if self.options.sectors > 0:
            space["scan"] = spaces.Box(0.0, self.options.max_range_m, (self.options.sectors,),
                                       np.float32)
        space.update(self.tasks[robot].spaces(self.server))
        return spaces.Dict(space)

    # One episode of one world. Where many are advanced side by side their parts are called instead.

    def begin(self, rng):
        """({robot: observation}, {robot: info})."""
        self.server.reset(self.draw_seed(rng))
        self.spawn()
        views, state_hash = self.server.advance({robot: (0.0, 0.0) for robot in self.tasks},
                                                self.options.settle_steps, self.options)
        self.begun(views, rng)
        return ({robot: self.observation(robot) for robot in self.tasks},
                {robot: self.info(robot, state_hash) for robot in self.tasks})

    def advance(self, actions):
        """actions: {robot: (forward [m/s], yaw rate [rad/s])}. Answers observations, rewards,
        terminations, whether the episode is truncated, infos; by robot, but for the fourth."""
        if not self._views:
            raise RuntimeError("reset() comes before step()")
        velocities = {robot: self._legal(robot, action) for robot, action in actions.items()}
        views, state_hash = self.server.advance(velocities, self.options.steps_per_action,
                                                self.options)
        observations, rewards, terminations, infos = {}, {}, {}, {}
        judged, truncated = self.judged(actions, views)
        for robot, (reward, ended, info) in judged.items():
            observations[robot] = self.observation(robot)
            rewards[robot], terminations[robot] = reward, ended
            infos[robot] = {**self.info(robot, state_hash), **info}
        return observations, rewards, terminations, truncated, infos

    def draw_seed(self, rng):
        """That the world is reset to."""
        self._views = {}
        return int(rng.integers(1, 2**31))

    def spawn(self):
        for name, fields in self._spawn.items():
            self.server.spawn(name, **fields)

    def begun(self, views, rng):
        """views: {robot: View} once the robots have settled."""
        missing = sorted(set(self.tasks) - set(views))
        if missing:
            raise ServerError(f"no longer in the world once it has settled: {', '.join(missing)}")
        self._actions = 0
        self._views = dict(views)
        for robot, task in self.tasks.items():
            task.begin(views[robot], rng, self.server)

    def judged(self, robots, views):
        """({robot: (reward, whether it ends, info of the task)}, whether the episode is truncated)
        of those that acted. views: {robot: View} of those that are still there."""
        self._actions += 1
        judged = {}
        for robot in robots:
            before = self._views[robot]
            after = views.get(robot)
            if after is None:  # it was taken out of the world meanwhile
                after = dataclasses.replace(before, alive=False)
            self._views[robot] = after
            reward, ended, info = self.tasks[robot].judge(before, after)
            judged[robot] = (float(reward), bool(ended), info)
        return judged, self._actions >= self.options.max_actions

    def observation(self, robot):
        view: View = self._views[robot]
        limits = (MAX_SPEED_MPS, MAX_YAW_RATE_RADPS)
        observation = {"velocity": np.clip(np.array([view.forward_mps, view.yaw_rate_radps],
                                                    np.float32), np.negative(limits), limits)
                       .astype(np.float32)}
        if self.options.sectors > 0:
            observation["scan"] = view.scan_m
        observation.update(self.tasks[robot].observe(view))
        return observation

    def view(self, robot):
        return self._views[robot]

    def info(self, robot, state_hash=""):
        view = self._views[robot]
        info = {"position_m": (view.x_m, view.y_m), "yaw_rad": view.yaw_rad, "alive": view.alive,
                "health": view.health, "contact_n": view.contact_n, "events": view.events}
        if self.options.state_hash:
            info["state_hash"] = state_hash
        return info

    def _legal(self, robot, action):
        values = np.asarray(action, dtype=np.float64)
        if values.shape != (2,) or not np.isfinite(values).all():
            raise ValueError(f"the action of {robot} is {action!r}; legal are two finite numbers: "
                             "forward [m/s], yaw rate [rad/s]")
        space = self.action_space()
        return np.clip(values, space.low, space.high)
