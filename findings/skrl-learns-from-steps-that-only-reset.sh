#!/usr/bin/env bash
# skrl records the steps in which a vector of Gymnasium only resets as if their actions had been carried out.
#
# Versions: skrl 2.1.1, jax 0.10.2, flax 0.12.8, optax 0.2.8, gymnasium 1.4.0 from PyPI.
# Expected: Since Gymnasium 1.0 the vectors that make_vec gives reset an ended episode in the next step, in which its
# action is ignored and the reward is 0 (autoreset mode NEXT_STEP, in the vector's metadata). A trainer leaves these steps
# out, or refuses the mode.
# Observed: They are in PPO's memory like all others, with an action that nobody carried out, a reward of 0 and no end of
# an episode, though it goes from the last state of one episode to the first of another. With episodes of 3 steps this is
# a quarter of what is learned from. With SAME_STEP, which skrl's wrapper expects, there is none of it. Nothing is said.
# Since: 2.1.1 is the only version that was tried; the PyTorch wrapper does the same.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check skrl==2.1.1 jax==0.10.2 jaxlib==0.10.2 flax==0.12.8 optax==0.2.8 \
    gymnasium==1.4.0

JAX_PLATFORMS=cpu venv/bin/python - 2> messages.txt <<'PY' | tee seen.txt
import gymnasium
import numpy
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from skrl.envs.wrappers.jax import wrap_env
from skrl.utils.runner.jax import Runner

LAYERS = [{"name": "net", "input": "OBSERVATIONS", "layers": [4], "activations": "elu"}]
STEPS = 16


class Walk(gymnasium.Env):
    """Episodes of 3 actions, each of which is rewarded with 1."""

    observation_space = gymnasium.spaces.Box(0, 3, (1,), numpy.float32)
    action_space = gymnasium.spaces.Box(-1, 1, (1,), numpy.float32)

    def reset(self, seed=None, options=None):
        super().reset(seed=seed)
        self.steps = 0
        return numpy.zeros(1, numpy.float32), {}

    def step(self, action):
        self.steps += 1
        return numpy.full(1, self.steps, numpy.float32), 1.0, self.steps == 3, False, {}


gymnasium.register("Walk-v0", entry_point=Walk)
for name, env in (("make_vec", gymnasium.make_vec("Walk-v0", num_envs=2, vectorization_mode="sync")),
                  ("SAME_STEP", SyncVectorEnv([Walk] * 2, autoreset_mode=AutoresetMode.SAME_STEP))):
    runner = Runner(wrap_env(env, wrapper="gymnasium", verbose=False), {
        "seed": 1,
        "models": {"separate": True,
                   "policy": {"class": "GaussianMixin", "network": LAYERS, "output": "ACTIONS"},
                   "value": {"class": "DeterministicMixin", "network": LAYERS, "output": "ONE"}},
        "memory": {"class": "RandomMemory", "memory_size": -1},
        "agent": {"class": "PPO", "rollouts": STEPS, "learning_epochs": 1, "mini_batches": 1,
                  "experiment": {"write_interval": 0, "checkpoint_interval": 0}},
        "trainer": {"class": "SequentialTrainer", "timesteps": STEPS, "headless": True,
                    "disable_progressbar": True}})
    runner.run("train")
    rewards = numpy.asarray(runner.agent.memory.get_tensor_by_name("rewards"))
    ended = numpy.asarray(runner.agent.memory.get_tensor_by_name("terminated"))
    idle = rewards == 0
    print(f"{name}: {env.metadata['autoreset_mode'].name}, {rewards.size} steps in memory, {idle.sum()} of them without"
          f" a reward, {(idle & ended.astype(bool)).sum()} of these as an episode's end")
PY

grep -q '^make_vec: NEXT_STEP, 32 steps in memory, 8 of them without a reward, 0 of these' seen.txt
grep -q '^SAME_STEP: SAME_STEP, 32 steps in memory, 0 of them without a reward' seen.txt
echo "The behaviour is as described."
