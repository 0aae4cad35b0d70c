"""Episodes of an environment, bit for bit, as text; and by itself: those of a world in this process.

Usage: rollouts.py   (with a Python that has latticeworld installed: prints them as JSON)
"""

import hashlib
import json

import numpy

WORLD = {"layout": "Gentle hills of grass, a wood in the lower left, a lake in the upper right.",
         "environment": "A windy autumn morning. A wheeled robot waits in the center. Three sheep "
                        "graze.", "size": 64.0, "seed": 5}
SEEDS, ACTIONS = (1, 2), 30


def bits(observation):
    digest = hashlib.sha256()
    for name in sorted(observation):
        digest.update(numpy.asarray(observation[name]).tobytes())
    return digest.hexdigest()


def rollouts(env):
    """env: with state_hash."""
    seen = []
    for seed in SEEDS:
        observation, info = env.reset(seed=seed)
        seen.append([bits(observation), info["state_hash"]])
        random = numpy.random.default_rng(seed)
        for _ in range(ACTIONS):
            action = random.uniform((-0.5, -1.5), (1.5, 1.5))
            observation, reward, terminated, truncated, info = env.step(action)
            seen.append([bits(observation), info["state_hash"], reward, terminated, truncated,
                         list(info["position_m"]), info["events"]])
    return seen


def main():
    import latticeworld
    fields = dict(WORLD)
    world = latticeworld.World.generate(fields.pop("layout"), fields.pop("environment"),
                                        seed=fields["seed"], size_m=fields["size"])
    env = latticeworld.make_env(world, state_hash=True)
    print(json.dumps({"world": world.id, "seen": rollouts(env)}))


if __name__ == "__main__":
    main()
