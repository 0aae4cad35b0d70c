#!/usr/bin/env python3
"""Random actions, to see that everything is there, and how fast it goes.

Usage: random_policy.py [--actions N] [--seed S]
"""

import argparse
import time

from latticeworld_gym import LatticeWorldEnv


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--actions", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    env = LatticeWorldEnv()
    env.action_space.seed(arguments.seed)
    try:
        env.reset(seed=arguments.seed)
        total = 0.0
        begin = time.monotonic()
        for _ in range(arguments.actions):
            _, reward, terminated, truncated, _ = env.step(env.action_space.sample())
            total += reward
            if terminated or truncated:
                env.reset()
        print(f"{arguments.actions} actions, {arguments.actions / (time.monotonic() - begin):.0f} a "
              f"second, rewards {total:.1f}")
    finally:
        env.close()


if __name__ == "__main__":
    main()
