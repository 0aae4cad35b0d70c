"""Many worlds that are advanced side by side: what both vector interfaces stand on."""

import os

import numpy as np

from . import _core, memory
from .errors import LatticeWorldError
from .learning.episode import MAX_SPEED_MPS, MAX_YAW_RATE_RADPS, Episode
from .local import LocalServer, view_of_row

FORWARD, YAW_RATE, ALIVE = 4, 5, 8  # in _core.ROBOT_FIELDS
GONE = -1.0  # of ALIVE: no longer in the world
MOST_WORLDS = 65535


class Batch:
    """Worlds with the same robots, an Episode each, and one array of what they observe.

    observations: (worlds, robots, values) float32, of which `parts` says where what is. Each world
    does what it would do alone: environments of one world give the same bits.
    """

    def __init__(self, count, robots, make_task, options, worlds, sensors="scanner", threads=0,
                 spawn_fields=None, episodes_per_world=0, **simulation):
        self.robots, self.options = list(robots), options
        self._worlds, self._episodes_per_world = worlds, episodes_per_world
        self._spawn = dict(spawn_fields or {})
        self._process = os.getpid()
        self._whole = True
        if options.sectors == 0:
            sensors = None
        self._crew = _core.Crew(self.robots, options.sectors, options.max_range_m, threads)
        self.servers, self.episodes = [], []
        self._make_worlds(count, make_task, sensors, simulation)
        self._drawn = [0] * count  # worlds that each place has had before
        self._played = [0] * count  # episodes begun in the world at hand
        rows = (count, len(self.robots))
        self._actions = np.zeros((*rows, 2))
        self._acting = np.zeros(rows, bool)
        self._rows = np.zeros((*rows, len(_core.ROBOT_FIELDS)))
        # Two in turn: what a task was shown stays as it was until it has judged.
        self._scans = [np.full((*rows, options.sectors), options.max_range_m, np.float32)
                       for _ in range(2)]
        self._lay_out()

    def __len__(self):
        return len(self.servers)

    def close(self):
        self._worlds.close()
        for server in self.servers:
            server.close()

    # What is made at the start.

    def _make_worlds(self, count, make_task, sensors, simulation):
        used = 0
        for place in range(count):
            world = self._worlds.make(place)
            if place == 0:
                memory.demand(count - 1, memory.LEAST_BYTES_OF_A_CELL * world.heights.size,
                              "further worlds")
            server = LocalServer(world, sensors, **simulation)
            tasks = {robot: make_task(robot) for robot in self.robots}
            episode = Episode(server, tasks, self.options, self._spawn)
            if place == 0:
                self.observation_spaces = {robot: episode.observation_space(robot)
                                           for robot in self.robots}
                self.action_space = episode.action_space()
            self._must_fit(place, episode)
            self.servers.append(server)
            self.episodes.append(episode)
            if place < 2 < count:  # the second one shows what each further one takes
                self._try_out(place)
                if place == 1:
                    memory.demand(count - 2, max(0, memory.used() - used), "further worlds")
                used = memory.used()

    def _must_fit(self, place, episode):
        for robot, space in self.observation_spaces.items():
            if episode.observation_space(robot) != space:
                raise ValueError(f"world {place} is observed by other bounds than world 0: "
                                 f"{episode.observation_space(robot)}, not {space}; legal are "
                                 "worlds of one size")

    def _try_out(self, place):
        """What is made once in a world is made: a first episode without an end."""
        server = self.servers[place]
        server.reset(1)
        for name, fields in self._spawn.items():
            server.spawn(name, **fields)
        server.advance({robot: (0.0, 0.0) for robot in self.robots}, 10, self.options)

    def _lay_out(self):
        """parts: {name: (first column, shape)}, the same for all robots."""
        self.parts, width = {}, 0
        first = self.observation_spaces[self.robots[0]]
        for robot, space in self.observation_spaces.items():
            if list(space.spaces) != list(first.spaces) or any(
                    space[name].shape != first[name].shape for name in space):
                raise ValueError(f"{robot} observes {space}, {self.robots[0]} {first}; legal are "
                                 "tasks that observe the same")
        for name, space in first.items():
            if space.dtype != np.float32:
                raise ValueError(f"the task observes {name} as {space.dtype}; legal is float32")
            self.parts[name] = (width, space.shape)
            width += int(np.prod(space.shape))
        self.observations = np.zeros((len(self), len(self.robots), width), np.float32)

    def part(self, name, array=None):
        """That part of the observations, (worlds, robots, *shape): a view."""
        array = self.observations if array is None else array
        first, shape = self.parts[name]
        width = int(np.prod(shape))
        return array[..., first:first + width].reshape(*array.shape[:-1], *shape)

    # What happens at every call.

    def legal(self, actions, acting):
        """(worlds, robots, 2) numbers within the bounds. acting: whose have to be finite; the others
        are not looked at. Raises ValueError, TypeError."""
        values = np.asarray(actions)
        if values.dtype.kind not in "fiu":
            raise TypeError(f"actions are of {values.dtype}; legal are real numbers")
        legal = self._actions.shape
        if values.size != self._actions.size or values.shape[-1:] != (2,):
            raise ValueError(f"actions have the shape {values.shape}; legal is one pair a robot, "
                             f"(forward [m/s], yaw rate [rad/s]): {legal}")
        values = values.reshape(legal).astype(np.float64)
        wrong = np.argwhere(acting & ~np.isfinite(values).all(axis=-1))
        if wrong.size:
            world, robot = wrong[0]
            raise ValueError(f"the action of {self.robots[robot]} of world {world} is "
                             f"{values[world, robot]}; legal are two finite numbers: forward [m/s], "
                             "yaw rate [rad/s]")
        return np.clip(values, self.action_space.low, self.action_space.high)

    def check(self, begins_all=False):
        """Raises RuntimeError where the batch cannot go on."""
        if os.getpid() != self._process:
            raise RuntimeError("these environments were made before this process was forked off, and "
                               "their threads stayed behind; make them in the new process, or start "
                               "processes by multiprocessing's \"spawn\"")
        if not self._whole and not begins_all:
            raise RuntimeError("the last call was interrupted or failed, and some worlds have moved "
                               "on without the others; call reset()")

    def advance(self, begin, rngs, actions=None, acting=None):
        """Begins an episode in the worlds of `begin` (a bool a world), with their generators, and in
        the others lets the robots of `acting` do their actions.

        Answers {(world, robot's number): (reward, ended, truncated, info of the task)} of those that
        acted. Anything that is raised leaves worlds behind that only reset() makes whole.
        """
        self._whole = False
        begin = np.asarray(begin, bool)
        self._acting[:] = False if acting is None else acting
        self._acting[begin] = True
        self._actions[:] = 0.0 if actions is None else actions
        self._actions[begin] = 0.0
        places = np.flatnonzero(begin)
        self._reset(places, rngs)
        views = self._go([self.options.settle_steps if begun else self.options.steps_per_action
                          for begun in begin])
        judged = {}
        for place, of_place in views.items():
            episode = self.episodes[place]
            if begin[place]:
                episode.begun(of_place, rngs[place])
                continue
            acted = [robot for robot, acts in zip(self.robots, self._acting[place]) if acts]
            answers, truncated = episode.judged(acted, of_place)
            for robot, (reward, ended, info) in answers.items():
                judged[place, self.robots.index(robot)] = (reward, ended, truncated, info)
        self._observe(views)
        self._whole = True
        return judged

    def state_hash(self, place):
        return self.servers[place].simulation.hash()

    def rows(self):
        """(worlds, robots, _core.ROBOT_FIELDS), as after the last call."""
        return self._rows

    def _reset(self, places, rngs):
        for place in places:
            self._change_world(place)
        seeds = [self.episodes[place].draw_seed(rngs[place]) for place in places]
        self._crew.reset([self.servers[place].simulation for place in places], seeds)
        for place in places:
            self.episodes[place].spawn()
            self._played[place] += 1
            if 0 < self._episodes_per_world <= self._played[place]:
                self._worlds.prepare(self._next_number(place))

    def _next_number(self, place):
        return place + len(self) * (self._drawn[place] + 1)

    def _change_world(self, place):
        """A new one where the world at hand has had its episodes."""
        if not 0 < self._episodes_per_world <= self._played[place]:
            return
        self.servers[place].load(self._worlds.take(self._next_number(place)))
        self._must_fit(place, self.episodes[place])
        self._drawn[place] += 1
        self._played[place] = 0

    def _go(self, steps):
        """{world: {robot: View}} of those that act and are still there."""
        self._scans.reverse()
        scans = self._scans[0]
        simulations = [server.simulation for server in self.servers]
        answers = self._crew.advance(simulations, steps, self._actions, self._acting, self._rows,
                                     scans)
        wrong = [f"world {place}: {words}" for place, words in enumerate(answers) if words]
        if wrong:
            raise LatticeWorldError("; ".join(wrong[:10]) + "; call reset()")
        views = {}
        rows = self._rows.tolist()
        for place in np.flatnonzero(self._acting.any(axis=1)).tolist():
            events = simulations[place].events
            views[place] = {
                robot: view_of_row(robot, rows[place][i], scans[place, i], events)
                for i, robot in enumerate(self.robots)
                if self._acting[place, i] and rows[place][i][ALIVE] != GONE}
        return views

    def _observe(self, views):
        """Writes what is observed of those that acted."""
        acting = self._acting & (self._rows[..., ALIVE] != GONE)
        limits = np.array([MAX_SPEED_MPS, MAX_YAW_RATE_RADPS], np.float32)
        speeds = self._rows[..., FORWARD:YAW_RATE + 1].astype(np.float32)
        self.part("velocity")[acting] = np.clip(speeds, -limits, limits)[acting]
        if self.options.sectors > 0:
            self.part("scan")[acting] = self._scans[0][acting]
        for place in views:
            episode = self.episodes[place]
            for i, robot in enumerate(self.robots):
                if not self._acting[place, i]:
                    continue
                row = self.observations[place, i]
                for name, value in episode.tasks[robot].observe(episode.view(robot)).items():
                    first, shape = self.parts[name]
                    value = np.asarray(value, np.float32)
                    row[first:first + value.size] = value.ravel()
