#!/usr/bin/env python3
"""A first policy that learns: two numbers, changed at random, kept where that is rewarded.

Usage: first_policy.py [--rounds N] [--seed S]
Needs a running world_server, and latticeworld_gym installed (docs/start.md).
"""

import argparse
import math
import sys

import numpy as np

from latticeworld_gym import LatticeWorldEnv, ServerError

GOALS = (1, 2, 3)  # seeds of the episodes that a policy is judged by


def act(gains, observation):
    """(forward [m/s], yaw rate [rad/s]): towards the goal, slower the more there is to turn."""
    x, y = observation["goal"]  # [m] in the robot's frame: x forward, y left
    bearing = math.atan2(y, x)
    return np.array([gains[0] * max(0.0, math.cos(bearing)), gains[1] * bearing], np.float32)


def episode(env, gains, seed):
    """The sum of rewards of one episode. The same seed is the same start, goal and noise."""
    observation, _ = env.reset(seed=seed)
    total, ended = 0.0, False
    while not ended:
        observation, reward, terminated, truncated, _ = env.step(act(gains, observation))
        total += reward
        ended = terminated or truncated
    return total


def score(env, gains):
    """The mean over the episodes that a policy is judged by."""
    return float(np.mean([episode(env, gains, seed) for seed in GOALS]))


def learn(env, rounds, seed):
    """Random search from a policy that hardly moves. Answers its two gains."""
    rng = np.random.default_rng(seed)
    gains = np.array([0.1, 0.1])
    best = score(env, gains)
    print(f"at first: {best:.2f}")
    for number in range(1, rounds + 1):
        tried = np.abs(gains + rng.normal(0.0, 0.5, 2))
        reward = score(env, tried)
        if reward > best:
            gains, best = tried, reward
        print(f"round {number}: {best:.2f} with gains {gains[0]:.2f} and {gains[1]:.2f}")
    return gains


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    try:
        env = LatticeWorldEnv(max_actions=150)
    except ServerError as error:
        sys.exit(f"first_policy.py: {error}")
    try:
        learn(env, arguments.rounds, arguments.seed)
    finally:
        env.close()


if __name__ == "__main__":
    main()
