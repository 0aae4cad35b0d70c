"""Many worlds with Gymnasium's interface of vectors."""

import gymnasium
import numpy as np
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from .learning.errors import ServerError

INFO_FIELDS = {"yaw_rad": 3, "health": 6, "contact_n": 7}  # places in _core.ROBOT_FIELDS
ALIVE = 8


class LatticeWorldVectorEnv(gymnasium.vector.VectorEnv):
    """One robot in each of many worlds; sub-environment i is what LatticeWorldEnv over world i is,
    bit for bit.

    batch: a Batch of one robot. Observations are a dict of float32 arrays, (num_envs, ...), which
    are views of one array, or copies of them where copy is true. infos: "position_m" (num_envs, 2),
    "yaw_rad", "alive", "health", "contact_n", "events" where there are some, "state_hash" where
    it is wanted, and what the task tells. Ends: by autoreset_mode, as Gymnasium has it.
    """

    metadata = {"render_modes": []}

    def __init__(self, batch, autoreset_mode=AutoresetMode.NEXT_STEP, copy=True):
        if len(batch.robots) != 1:
            raise ValueError(f"robots is {batch.robots}; legal with Gymnasium's interface is one "
                             "(interface=\"pettingzoo\" takes several)")
        self.batch, self.copy = batch, copy
        self.num_envs = len(batch)
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self.metadata = dict(self.metadata, autoreset_mode=self.autoreset_mode)
        self.single_action_space = batch.action_space
        self.single_observation_space = batch.observation_spaces[batch.robots[0]]
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self._rngs = [None] * self.num_envs
        self._begun = np.zeros(self.num_envs, bool)
        self._ended = np.zeros(self.num_envs, bool)  # by the last step

    def reset(self, *, seed=None, options=None):
        """seed: of sub-environment 0, and one more for each further one; or a list. options:
        {"reset_mask": bools} for some alone."""
        self._must_be_open()
        options = dict(options or {})
        mask = self._legal_mask(options.pop("reset_mask", None))
        seeds = self._legal_seeds(seed)
        self.batch.check(begins_all=mask.all())
        for i in np.flatnonzero(mask):
            if seeds[i] is not None or self._rngs[i] is None:
                self._rngs[i], _ = seeding.np_random(seeds[i])
        self._begun[mask] = False
        self.batch.advance(mask, self._rngs)
        self._begun[mask], self._ended[mask] = True, False
        return self._observed(), self._infos(mask, {})

    def step(self, actions):
        self._must_be_open()
        self.batch.check()
        if not self._begun.all():
            raise RuntimeError("reset() comes before step()")
        begin = np.zeros(self.num_envs, bool)
        if self.autoreset_mode == AutoresetMode.NEXT_STEP:
            begin = self._ended
        elif self._ended.any():  # DISABLED
            raise RuntimeError("the episodes of sub-environments "
                               f"{np.flatnonzero(self._ended).tolist()} have ended; reset them "
                               "first: reset(options={\"reset_mask\": ...})")
        actions = self.batch.legal(actions, ~begin[:, None])
        judged = self.batch.advance(begin, self._rngs, actions, ~begin[:, None])
        rewards = np.zeros(self.num_envs)
        terminations, truncations = np.zeros((2, self.num_envs), bool)
        told = {}
        for (i, _), (rewards[i], terminations[i], truncations[i], told[i]) in judged.items():
            pass
        ended = terminations | truncations
        infos = {}
        if self.autoreset_mode == AutoresetMode.SAME_STEP and ended.any():
            self._tell_final(ended, told, infos)
            self.batch.advance(ended, self._rngs)
            self._ended = np.zeros(self.num_envs, bool)
            told = {i: info for i, info in told.items() if not ended[i]}
        else:
            self._ended = ended
        return (self._observed(), rewards, terminations, truncations,
                {**self._infos(np.ones(self.num_envs, bool), told), **infos})

    def close_extras(self, **_):
        self.batch.close()

    def _observed(self):
        parts = {name: self.batch.part(name)[:, 0] for name in self.batch.parts}
        return {name: part.copy() for name, part in parts.items()} if self.copy else parts

    def _tell_final(self, ended, told, infos):
        observed = self._observed()
        final = np.full(self.num_envs, None, object)
        for i in np.flatnonzero(ended):
            final[i] = {name: part[i].copy() for name, part in observed.items()}
        infos["final_obs"], infos["_final_obs"] = final, ended.copy()
        infos["final_info"] = self._infos(ended, told)
        infos["_final_info"] = ended.copy()

    def _infos(self, of, told):
        """of: a bool a sub-environment. told: {sub-environment: info of its task}."""
        rows = self.batch.rows()[:, 0]
        infos = {"position_m": np.where(of[:, None], rows[:, :2], 0.0),
                 "alive": of & (rows[:, ALIVE] > 0.0)}
        for name, column in INFO_FIELDS.items():
            infos[name] = np.where(of, rows[:, column], 0.0)
        infos.update({f"_{name}": of.copy() for name in list(infos)})
        robot = self.batch.robots[0]
        for name, told_of in _by_name(told).items():
            infos[name], infos[f"_{name}"] = _gathered(told_of, self.num_envs)
        for i in np.flatnonzero(of):
            info = {}
            events = self.batch.episodes[i].view(robot).events
            if events:
                info["events"] = events
            if self.batch.options.state_hash:
                info["state_hash"] = self.batch.state_hash(i)
            if info:
                infos = self._add_info(infos, info, i)
        return infos

    def _legal_seeds(self, seed):
        if seed is None:
            return [None] * self.num_envs
        if isinstance(seed, (int, np.integer)):
            return [int(seed) + i for i in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"there are {len(seed)} seeds; legal is one a sub-environment: "
                             f"{self.num_envs}")
        return [None if one is None else int(one) for one in seed]

    def _legal_mask(self, mask):
        if mask is None:
            return np.ones(self.num_envs, bool)
        mask = np.asarray(mask)
        if mask.dtype != np.bool_ or mask.shape != (self.num_envs,) or not mask.any():
            raise ValueError(f"reset_mask is {mask!r}; legal is an array of {self.num_envs} bools, at "
                             "least one of them true")
        return mask

    def _must_be_open(self):
        if self.closed:
            raise ServerError("the environment is closed; make another one")


def _by_name(told):
    """{sub-environment: {name: value}} the other way round."""
    found = {}
    for i, info in told.items():
        for name, value in info.items():
            found.setdefault(name, {})[i] = value
    return found


def _gathered(told, count):
    """(values, which are told), as Gymnasium has infos. told: {sub-environment: value}."""
    places, values = list(told), list(told.values())
    kinds = {type(value) for value in values}
    plain = len(kinds) == 1 and kinds <= {bool, int, float}
    array = np.zeros(count, kinds.pop()) if plain else np.full(count, None, object)
    if plain:
        array[places] = values
    else:
        for i, value in told.items():
            array[i] = value
    mask = np.zeros(count, bool)
    mask[places] = True
    return array, mask
