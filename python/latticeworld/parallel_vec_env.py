"""Many worlds with PettingZoo's parallel interface."""

import numpy as np
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from .learning.errors import ServerError


class LatticeWorldParallelVecEnv(ParallelEnv):
    """The robots of many worlds, which all act at the same time.

    Agents are named "world_<i>/<robot>"; those of world i do what those of LatticeWorldParallelEnv
    over it do, bit for bit. A robot whose episode has ended leaves `agents`; a world that all have
    left stands still until reset().

    batch: a Batch.
    """

    metadata = {"render_modes": [], "name": "latticeworld_worlds_v0"}
    render_mode = None  # PettingZoo's conversions warn where it is missing

    def __init__(self, batch):
        self.batch = batch
        self._places = {f"world_{world}/{robot}": (world, i) for world in range(len(batch))
                        for i, robot in enumerate(batch.robots)}
        self.possible_agents = list(self._places)
        self.agents = []
        self._rngs = [None] * len(batch)
        self._closed = False

    def observation_space(self, agent):
        return self.batch.observation_spaces[self._robot(agent)]

    def action_space(self, agent):
        return self.batch.action_space

    def reset(self, seed=None, options=None):
        """seed: of world 0, and one more for each further one."""
        self._must_be_open()
        self.batch.check(begins_all=True)
        for world in range(len(self.batch)):
            if seed is not None or self._rngs[world] is None:
                self._rngs[world], _ = seeding.np_random(None if seed is None else seed + world)
        self.agents = []
        self.batch.advance(np.ones(len(self.batch), bool), self._rngs)
        self.agents = list(self.possible_agents)
        return ({agent: self._observation(agent) for agent in self.agents},
                {agent: self._info(agent) for agent in self.agents})

    def step(self, actions):
        """actions: of every robot in `agents`."""
        self._must_be_open()
        self.batch.check()
        if set(actions) != set(self.agents):
            raise ValueError(f"there are actions of {sorted(actions)}; legal are those of all "
                             f"agents: {sorted(self.agents)}")
        if not actions:
            return {}, {}, {}, {}, {}
        values = np.zeros((len(self.batch), len(self.batch.robots), 2))
        acting = np.zeros(values.shape[:2], bool)
        for agent, action in actions.items():
            action = np.asarray(action, np.float64)
            if action.shape != (2,):
                raise ValueError(f"the action of {agent} is {action!r}; legal are two finite "
                                 "numbers: forward [m/s], yaw rate [rad/s]")
            values[self._places[agent]], acting[self._places[agent]] = action, True
        values = self.batch.legal(values, acting)
        judged = self.batch.advance(np.zeros(len(self.batch), bool), self._rngs, values, acting)
        answers = {agent: judged[self._places[agent]] for agent in self.agents}
        observations = {agent: self._observation(agent) for agent in answers}
        rewards = {agent: answer[0] for agent, answer in answers.items()}
        terminations = {agent: answer[1] for agent, answer in answers.items()}
        truncations = {agent: answer[2] for agent, answer in answers.items()}
        infos = {agent: {**self._info(agent), **answer[3]} for agent, answer in answers.items()}
        self.agents = [agent for agent in self.agents
                       if not (terminations[agent] or truncations[agent])]
        return observations, rewards, terminations, truncations, infos

    def close(self):
        if not self._closed:
            self._closed = True
            self.batch.close()

    def _robot(self, agent):
        if agent not in self._places:
            raise KeyError(f"there is no agent {agent!r}; legal are {', '.join(self._places)}")
        return self.batch.robots[self._places[agent][1]]

    def _observation(self, agent):
        place = self._places[agent]
        return {name: self.batch.part(name)[place].copy() for name in self.batch.parts}

    def _info(self, agent):
        world, _ = self._places[agent]
        hash_ = self.batch.state_hash(world) if self.batch.options.state_hash else ""
        return self.batch.episodes[world].info(self._robot(agent), hash_)

    def _must_be_open(self):
        if self._closed:
            raise ServerError("the environment is closed; make another one")
