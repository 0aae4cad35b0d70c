"""latticeworld.make_vec: many worlds at once are what each is alone."""

import gc
import math
import multiprocessing
import weakref

import gymnasium
import numpy as np
import pytest
from conftest import ENVIRONMENT, LAYOUT
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode

import latticeworld as lw
from latticeworld import memory
from latticeworld.learning.episode import Episode, EpisodeOptions

SHORT = dict(max_actions=6, settle_steps=10, state_hash=True)
COUNT = 3


def actions_of(step, count=COUNT):
    random = np.random.default_rng(step)
    return random.uniform((-0.5, -1.5), (1.5, 1.5), (count, 2)).astype(np.float32)


def bits(observation, i=None):
    return {name: np.asarray(value if i is None else value[i]).tobytes()
            for name, value in observation.items()}


class Alone:
    """One sub-environment by itself, with Gymnasium's autoreset as its documentation has it."""

    def __init__(self, place, worlds, mode, episodes_per_world=0):
        self.worlds, self.mode, self.place = worlds, mode, place
        self.episodes_per_world, self.played, self.number = episodes_per_world, 0, place
        self.env = lw.make_env(worlds[place % len(worlds)], **SHORT)
        self.ended = False

    def reset(self, seed=None):
        if 0 < self.episodes_per_world <= self.played:
            self.number += COUNT
            self.env._server.load(self.worlds[self.number % len(self.worlds)])
            self.played = 0
        self.played += 1
        self.ended = False
        return self.env.reset(seed=seed)

    def step(self, action):
        """(observation, reward, terminated, truncated, state hash, final observation or None)."""
        if self.ended and self.mode == AutoresetMode.NEXT_STEP:
            observation, info = self.reset()
            return bits(observation), 0.0, False, False, info["state_hash"], None
        observation, reward, terminated, truncated, info = self.env.step(action)
        self.ended = terminated or truncated
        final = None
        if self.ended and self.mode == AutoresetMode.SAME_STEP:
            final = bits(observation)
            observation, info = self.reset()
            return bits(observation), reward, terminated, truncated, info["state_hash"], final
        return bits(observation), reward, terminated, truncated, info["state_hash"], final


def final_of(infos, i):
    if "final_obs" not in infos or not infos["_final_obs"][i]:
        return None
    return bits(infos["final_obs"][i])


@pytest.mark.parametrize("mode", list(AutoresetMode))
@pytest.mark.parametrize("threads", [1, 2])
def test_each_is_bit_for_bit_what_it_is_alone(worlds, mode, threads):
    env = lw.make_vec(COUNT, worlds=worlds, threads=threads, autoreset_mode=mode, **SHORT)
    alone = [Alone(i, worlds, mode) for i in range(COUNT)]
    observations, infos = env.reset(seed=7)
    for i, one in enumerate(alone):
        observation, info = one.reset(seed=7 + i)
        assert bits(observations, i) == bits(observation)
        assert infos["state_hash"][i] == info["state_hash"]
    ends = 0
    for step in range(15):
        actions = actions_of(step)
        observations, rewards, terminations, truncations, infos = env.step(actions)
        for i, one in enumerate(alone):
            expected = one.step(actions[i])
            got = (bits(observations, i), rewards[i], terminations[i], truncations[i],
                   infos["state_hash"][i], final_of(infos, i))
            assert got == expected, f"step {step}, world {i}"
            ends += got[2] or got[3]
        ended = terminations | truncations
        if mode == AutoresetMode.DISABLED and ended.any():
            observations, _ = env.reset(options={"reset_mask": ended})
            for i in np.flatnonzero(ended):
                assert bits(observations, i) == bits(alone[i].reset()[0])
    assert ends >= 2 * COUNT
    env.close()


def test_new_worlds_come_after_so_many_episodes(worlds):
    drawn = []

    def draw(number):
        drawn.append(number)
        return worlds[number % 2]

    env = lw.make_vec(COUNT, worlds=draw, episodes_per_world=2, autoreset_mode="SameStep", **SHORT)
    alone = [Alone(i, worlds, AutoresetMode.SAME_STEP, episodes_per_world=2) for i in range(COUNT)]
    observations, _ = env.reset(seed=1)
    for i, one in enumerate(alone):
        assert bits(observations, i) == bits(one.reset(seed=1 + i)[0])
    for step in range(26):
        actions = actions_of(step)
        observations, rewards, terminations, truncations, infos = env.step(actions)
        for i, one in enumerate(alone):
            assert (bits(observations, i), rewards[i]) == one.step(actions[i])[:2], (step, i)
    assert {0, 1, 2, 3, 4, 5, 6, 7, 8} <= set(drawn)
    env.close()


def test_worlds_of_words_take_them_in_turn():
    env = lw.make_vec(3, layout=[LAYOUT, "Gentle hills of grass."], environment=ENVIRONMENT,
                      world_seed=20)
    worlds = [server.world for server in env.batch.servers]
    assert [world.seed for world in worlds] == [20, 21, 22]
    assert worlds[0].id == lw.World.generate(LAYOUT, ENVIRONMENT, seed=20, size_m=64.0).id
    assert worlds[1].id == lw.World.generate("Gentle hills of grass.", ENVIRONMENT, seed=21,
                                             size_m=64.0).id
    env.close()


def test_observations_are_views_of_one_array_unless_copied(worlds):
    env = lw.make_vec(2, worlds=worlds, copy=False)
    observations, _ = env.reset(seed=1)
    for part in observations.values():
        assert np.shares_memory(part, env.batch.observations)
    assert env.observation_space.contains(observations)
    before = observations["goal"].copy()
    env.step(np.array([(1.0, 1.0)] * 2, np.float32))
    assert not np.array_equal(before, observations["goal"])
    env.close()
    env = lw.make_vec(2, worlds=worlds)
    observations, _ = env.reset(seed=1)
    before = {name: part.copy() for name, part in observations.items()}
    env.step(np.array([(1.0, 1.0)] * 2, np.float32))
    for name, part in observations.items():
        assert np.array_equal(before[name], part)
    env.close()


def test_gymnasiums_wrappers_take_it(worlds):
    env = gymnasium.wrappers.vector.RecordEpisodeStatistics(
        lw.make_vec(2, worlds=worlds, autoreset_mode="SameStep", max_actions=3))
    env.reset(seed=1)
    told = 0
    for step in range(7):
        *_, infos = env.step(actions_of(step, 2))
        told += "episode" in infos or "episode" in infos.get("final_info", {})
    assert told == 2
    env.close()


def test_a_task_of_ones_own_sees_what_it_sees_alone(worlds):
    class KeepAway(lw.Task):
        """Tells the change of the nearest return: it needs what was seen before, unchanged."""

        def spaces(self, server):
            return {"nearest": gymnasium.spaces.Box(0.0, 20.0, (1,), np.float32)}

        def begin(self, view, rng, server):
            self.offset = rng.random()

        def observe(self, view):
            return {"nearest": np.array([view.scan_m.min()], np.float32)}

        def judge(self, before, after):
            change = float(np.abs(after.scan_m - before.scan_m).sum())
            return change + self.offset, False, {"change": change}

    env = lw.make_vec(2, worlds=worlds, task=lambda robot: KeepAway(), **SHORT)
    alone = [lw.make_env(world, task=KeepAway(), **SHORT) for world in worlds]
    env.reset(seed=3)
    for i, one in enumerate(alone):
        one.reset(seed=3 + i)
    total = 0.0
    for step in range(4):
        actions = actions_of(step, 2)
        observations, rewards, _, _, infos = env.step(actions)
        for i, one in enumerate(alone):
            observation, reward, _, _, info = one.step(actions[i])
            assert bits(observations, i) == bits(observation) and rewards[i] == reward
            assert infos["change"][i] == info["change"]
        total += rewards.sum()
    assert total > 1.0
    env.close()


@pytest.mark.parametrize("actions, error, words", [
    (np.zeros((2, 3)), ValueError, r"shape \(2, 3\); legal is one pair a robot"),
    (np.zeros(3), ValueError, "shape"),
    (np.array([[0.0, math.nan], [0.0, 0.0]]), ValueError, "world 0 is.*two finite numbers"),
    (np.array([[0.0, 0.0], [math.inf, 0.0]]), ValueError, "world 1 is"),
    (np.array([["a", "b"], ["c", "d"]]), TypeError, "legal are real numbers"),
    (np.zeros((2, 2), complex), TypeError, "complex"),
    (None, TypeError, "object"),
])
def test_wrong_actions_are_said_and_change_nothing(worlds, actions, error, words):
    env = lw.make_vec(2, worlds=worlds, **SHORT)
    env.reset(seed=1)
    hashes = [env.batch.state_hash(i) for i in range(2)]
    with pytest.raises(error, match=words):
        env.step(actions)
    assert hashes == [env.batch.state_hash(i) for i in range(2)]
    env.step(np.zeros((2, 2)))
    env.close()


def test_calls_out_of_turn_are_said(worlds):
    env = lw.make_vec(2, worlds=worlds, autoreset_mode="Disabled", **SHORT)
    with pytest.raises(RuntimeError, match="reset.. comes before step"):
        env.step(np.zeros((2, 2)))
    with pytest.raises(ValueError, match="3 seeds"):
        env.reset(seed=[1, 2, 3])
    with pytest.raises(ValueError, match="reset_mask"):
        env.reset(options={"reset_mask": np.zeros(2, bool)})
    env.reset(seed=1)
    for _ in range(SHORT["max_actions"]):
        env.step(np.zeros((2, 2)))
    with pytest.raises(RuntimeError, match=r"sub-environments \[0, 1\] have ended"):
        env.step(np.zeros((2, 2)))
    env.close()
    with pytest.raises(RuntimeError, match="closed"):
        env.step(np.zeros((2, 2)))


@pytest.mark.parametrize("fields, error, words", [
    (dict(n_worlds=0), ValueError, "n_worlds is 0; legal"),
    (dict(n_worlds=2.5), ValueError, "n_worlds is 2.5"),
    (dict(threads=-1), ValueError, "threads is -1"),
    (dict(interface="rllib"), ValueError, "interface"),
    (dict(robots=["a", "b"]), ValueError, "one alone"),
    (dict(robots="nobody"), lw.LatticeWorldError, "nobody"),
    (dict(worlds=[]), TypeError, "not empty"),
    (dict(worlds=lambda number: "a forest"), TypeError, "world 0 is 'a forest'"),
    (dict(worlds=None, size_m=-1.0), ValueError, "size"),
    (dict(layout=[], worlds=None), ValueError, "layout"),
    (dict(episodes_per_world=-2), ValueError, "episodes_per_world"),
    (dict(steps_per_action=0, sectors=-1), ValueError, "steps_per_action is 0.*sectors is -1"),
    (dict(sensors="eyes"), ValueError, "no sensor suite"),
    (dict(autoreset_mode="Sometimes"), ValueError, "Sometimes"),
])
def test_what_cannot_be_made_is_said(worlds, fields, error, words):
    with pytest.raises(error, match=words):
        env = lw.make_vec(**{"n_worlds": 2, "worlds": worlds, **fields})
        env.reset(seed=1)


def test_worlds_of_different_sizes_are_refused(worlds):
    larger = lw.World.generate(LAYOUT, ENVIRONMENT, seed=1, size_m=96.0)
    with pytest.raises(ValueError, match="world 1 is observed by other bounds.*one size"):
        lw.make_vec(2, worlds=[worlds[0], larger])


def test_more_worlds_than_memory_are_refused_before_they_are_made(monkeypatch, worlds):
    made = []

    def draw(number):
        made.append(number)
        return worlds[0]

    with pytest.raises(MemoryError, match="further worlds of .* MB each need .* are available"):
        monkeypatch.setattr(memory, "available", lambda: 1_000_000)
        lw.make_vec(1000, worlds=draw)
    assert made == [0]
    monkeypatch.setattr(memory, "LEAST_BYTES_OF_A_CELL", 0)
    monkeypatch.setattr(memory, "used", iter(range(0, 10**12, 10**9)).__next__)
    with pytest.raises(MemoryError, match="998 further worlds of 1000 MB"):
        lw.make_vec(1000, worlds=draw)
    assert max(made) == 1


def test_a_world_that_fails_is_named_and_only_a_reset_goes_on(worlds):
    env = lw.make_vec(2, worlds=worlds, **SHORT)
    env.reset(seed=1)
    env.batch.servers[1].simulation.remove("robot")
    with pytest.raises(RuntimeError, match="world 1: NOT_FOUND.*robot"):
        env.step(np.zeros((2, 2)))
    with pytest.raises(RuntimeError, match="interrupted or failed.*reset"):
        env.step(np.zeros((2, 2)))
    env.reset(seed=1)
    env.step(np.zeros((2, 2)))
    env.close()


def test_a_call_that_was_interrupted_leaves_it_to_reset(worlds, monkeypatch):
    env = lw.make_vec(2, worlds=worlds, **SHORT)
    env.reset(seed=1)
    goal = env.batch.episodes[1].tasks["robot"]

    def interrupt(before, after):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(goal, "judge", interrupt)
        with pytest.raises(KeyboardInterrupt):
            env.step(np.zeros((2, 2)))
    with pytest.raises(RuntimeError, match="interrupted"):
        env.step(np.zeros((2, 2)))
    env.reset(seed=1)
    env.step(np.zeros((2, 2)))
    env.close()


def step_in_child(env, pipe):
    try:
        env.step(np.zeros((2, 2)))
        pipe.send("it stepped")
    except RuntimeError as error:
        pipe.send(str(error))


def test_after_a_fork_it_is_said_what_to_do(worlds):
    env = lw.make_vec(2, worlds=worlds, threads=2, **SHORT)
    env.reset(seed=1)
    ours, theirs = multiprocessing.Pipe()
    process = multiprocessing.get_context("fork").Process(target=step_in_child, args=(env, theirs))
    process.start()
    process.join(30)
    assert process.exitcode == 0
    assert "forked off" in ours.recv()
    env.step(np.zeros((2, 2)))
    env.close()


def test_what_is_closed_and_dropped_is_gone(worlds):
    world = lw.World.generate(LAYOUT, ENVIRONMENT, seed=77, size_m=64.0)
    env = lw.make_vec(2, worlds=[world], episodes_per_world=1, **SHORT)
    env.reset(seed=1)
    env.step(np.zeros((2, 2)))
    watches = [weakref.ref(server.simulation) for server in env.batch.servers]
    watches.append(weakref.ref(world))
    env.close()
    del env, world
    gc.collect()
    assert [watch() for watch in watches] == [None] * 3


def test_goals_keep_the_disc_of_the_robot_off_the_outermost_cells(worlds):
    server = lw.LocalServer(worlds[0], sensors=None, robot_species="ackermann car")
    options = EpisodeOptions(sectors=0, settle_steps=1)
    radius_m = server.footprint_radius("robot")
    assert radius_m == pytest.approx(1.31, abs=0.005)
    # Far away, so that the edge is within reach.
    task = lw.GoalTask(distance_m=(20.0, 60.0))
    episode = Episode(server, {"robot": task}, options)
    goals = []
    for seed in range(200):
        episode.begin(np.random.default_rng(seed))
        goals.append(task.goal)
    limit_m = 0.5 * server.size_m - worlds[0].resolution_m - radius_m
    assert limit_m - 1.0 < np.abs(goals).max() <= limit_m


def test_goals_are_those_that_python_alone_would_find(worlds):
    from latticeworld.learning.free_space import FreeSpace
    for world in worlds:
        server = lw.LocalServer(world)
        fast, plain = server.free_space(0.6), FreeSpace(server.occupancy(), 0.6)
        for seed in range(20):
            place = np.random.default_rng(seed).uniform(-30, 30, 2)
            drawn = [space.draw(*place, 3.0, 10.0, seeding.np_random(seed)[0])
                     for space in (fast, plain)]
            assert drawn[0] == drawn[1]
