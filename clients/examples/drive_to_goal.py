#!/usr/bin/env python3
"""A controller of a few lines that drives robots to their goals.

Usage: drive_to_goal.py [--episodes N] [--seed S]
"""

import argparse
import math

import numpy as np

from latticeworld_gym import LatticeWorldEnv

CLEAR_M = 1.5


def policy(observation):
    """Turns to the goal, the slower the more it has to turn, and away from what is near ahead."""
    x, y = observation["goal"]
    turn = math.atan2(y, x)
    scan = observation["scan"]
    sectors = len(scan)
    ahead = slice(sectors * 4 // 10, sectors * 6 // 10)
    nearest_m = float(np.min(scan[ahead]))
    if nearest_m < min(CLEAR_M, math.hypot(x, y)):
        right = float(np.mean(scan[sectors // 6:sectors // 2]))
        left = float(np.mean(scan[sectors // 2:sectors * 5 // 6]))
        return np.array([0.3, 1.2 if left > right else -1.2], np.float32)
    speed = 1.2 * max(0.15, math.cos(turn))
    return np.array([speed, np.clip(2.0 * turn, -1.5, 1.5)], np.float32)


def drive(env, seed):
    """One episode of one robot. (sum of rewards, last info)."""
    observation, _ = env.reset(seed=seed)
    total, ended = 0.0, False
    while not ended:
        observation, reward, terminated, truncated, info = env.step(policy(observation))
        total += reward
        ended = terminated or truncated
    return total, info


def drive_all(env, seed):
    """One episode of several robots. {robot: whether it reached its goal}."""
    observations, _ = env.reset(seed=seed)
    arrived = {}
    while env.agents:
        observations, _, terminations, _, infos = env.step(
            {robot: policy(observations[robot]) for robot in env.agents})
        arrived.update({robot: infos[robot]["is_success"] for robot in terminations})
    return arrived


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--episodes", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    env = LatticeWorldEnv()
    try:
        for episode in range(arguments.episodes):
            total, info = drive(env, arguments.seed + episode)
            print(f"episode {episode}: {'reached' if info['is_success'] else 'missed'} the goal, "
                  f"{info['distance_m']:.1f} m from it at the end, rewards {total:.1f}")
    finally:
        env.close()


if __name__ == "__main__":
    main()
