"""Environments of one world, and PettingZoo's interface over many."""

import math
import warnings

import gymnasium.utils.env_checker
import numpy as np
import pettingzoo.test
import pytest

import latticeworld as lw

SPAWN = {"scout": dict(position=(-6.0, 4.0))}


def test_gymnasium_finds_nothing_wrong(world):
    env = lw.make_env(world)
    with warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)
        # It recommends actions within -1 .. 1; ours are metres and radians a second.
        warnings.filterwarnings("ignore", message=".*symmetric and normalized.*")
        warnings.filterwarnings("ignore", message=".*env.spec.*")
        gymnasium.utils.env_checker.check_env(env, skip_render_check=True)
    env.close()


def test_pettingzoo_finds_nothing_wrong(worlds):
    pettingzoo.test.parallel_api_test(
        lw.make_parallel(worlds[0], ["robot", "scout"], spawn=SPAWN, max_actions=20), num_cycles=60)
    pettingzoo.test.parallel_api_test(
        lw.make_vec(2, ["robot", "scout"], interface="pettingzoo", worlds=worlds, spawn=SPAWN,
                    max_actions=20), num_cycles=60)


def test_pettingzoo_takes_them_turn_by_turn_without_a_warning(worlds):
    for env in (lw.make_parallel(worlds[0], ["robot"]),
                lw.make_vec(2, interface="pettingzoo", worlds=worlds)):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            turns = pettingzoo.utils.parallel_to_aec(env)
        turns.reset(seed=1)
        assert turns.agents == env.agents
        turns.close()


def test_pettingzoo_finds_that_a_seed_says_all(worlds):
    pettingzoo.test.parallel_seed_test(
        lambda: lw.make_parallel(worlds[0], ["robot", "scout"], spawn=SPAWN), num_cycles=20)


def test_the_robots_of_many_worlds_do_what_they_do_alone(worlds):
    options = dict(max_actions=5, state_hash=True)
    env = lw.make_vec(2, ["robot", "scout"], interface="pettingzoo", worlds=worlds, spawn=SPAWN,
                      **options)
    alone = [lw.make_parallel(world, ["robot", "scout"], spawn=SPAWN, **options) for world in worlds]
    seen = env.reset(seed=4)
    expected = [one.reset(seed=4 + i) for i, one in enumerate(alone)]
    compare(seen, expected)
    step = 0
    while env.agents:
        actions = {agent: np.array([1.0, math.sin(step + len(agent))]) for agent in env.agents}
        seen = env.step(actions)
        expected = [one.step({robot: actions[f"world_{i}/{robot}"] for robot in one.agents})
                    for i, one in enumerate(alone)]
        compare(seen, expected)
        step += 1
    assert step == 5 and not any(one.agents for one in alone)
    env.close()


def compare(seen, expected):
    """Answers of the many beside those of each world."""
    for part, of_worlds in zip(seen, zip(*expected)):
        flat = {f"world_{i}/{robot}": value for i, answers in enumerate(of_worlds)
                for robot, value in answers.items()}
        assert part.keys() == flat.keys()
        for agent, value in flat.items():
            np.testing.assert_equal(part[agent], value)


def test_agents_of_pettingzoo_are_checked(worlds):
    env = lw.make_vec(2, "robot", interface="pettingzoo", worlds=worlds)
    env.reset(seed=1)
    with pytest.raises(ValueError, match="actions of.*legal are those of all agents"):
        env.step({"world_0/robot": np.zeros(2)})
    with pytest.raises(ValueError, match="world_1/robot.*two finite numbers"):
        env.step({"world_0/robot": np.zeros(2), "world_1/robot": np.zeros(3)})
    with pytest.raises(ValueError, match="world 1.*two finite numbers"):
        env.step({"world_0/robot": np.zeros(2), "world_1/robot": np.array([0.0, math.nan])})
    with pytest.raises(KeyError, match="nobody"):
        env.observation_space("nobody")
    env.close()
    with pytest.raises(RuntimeError, match="closed"):
        env.reset()


def test_a_simple_controller_reaches_its_goal(world):
    env = lw.make_env(world)
    for seed in (1, 2):
        observation, _ = env.reset(seed=seed)
        total, ended = 0.0, False
        while not ended:
            x, y = observation["goal"]
            turn = math.atan2(y, x)
            observation, reward, terminated, truncated, info = env.step(
                (max(0.15, math.cos(turn)), 2.0 * turn))
            total += reward
            ended = terminated or truncated
        assert info["is_success"], info
        assert total > 10.0
    env.close()


def test_two_environments_do_not_know_each_other(world):
    def rollout(env):
        env.reset(seed=1)
        return [env.step((1.0, 0.1))[4]["state_hash"] for _ in range(3)]

    first, second = (lw.make_env(world, state_hash=True) for _ in range(2))
    expected = rollout(first)
    first.reset(seed=1)
    second.reset(seed=2)
    interleaved = []
    for _ in range(3):
        interleaved.append(first.step((1.0, 0.1))[4]["state_hash"])
        second.step((1.0, 0.1))
    assert interleaved == expected


def test_what_is_closed_says_so(world):
    env = lw.make_env(world)
    env.reset(seed=1)
    env.close()
    with pytest.raises(lw.ServerError, match="closed"):
        env.step((0.0, 0.0))
    env = lw.make_parallel(world, ["robot", "scout"], spawn=SPAWN)
    env.reset(seed=1)
    env.close()
    with pytest.raises(lw.ServerError, match="closed"):
        env.step({robot: (0.0, 0.0) for robot in env.agents})
    with pytest.raises(lw.ServerError, match="closed"):
        env.reset(seed=1)
