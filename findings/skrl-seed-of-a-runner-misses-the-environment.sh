#!/usr/bin/env bash
# The seed in the configuration of skrl's Runner never reaches the environment, which begins with seed 0.
#
# Versions: skrl 2.1.1, jax 0.10.2, flax 0.12.8, optax 0.2.8, gymnasium 1.4.0 from PyPI.
# Expected: skrl resets an environment with the framework's seed, and Runner(env, {"seed": 7, ...}) sets that seed: the
# environment is reset with 7, and two runs with one seed are the same run.
# Observed: The wrapper takes the seed when the environment is wrapped, which comes before the Runner is made. So every
# run is reset with what was set before: 0 in a new process, whatever the configuration says, so that runs meant to
# differ share their episodes; and the seed of the run before in a process that makes several, so that two runs with one
# seed differ. The log says the configured seed each time. Calling skrl.utils.set_seed before wrap_env avoids it.
# Since: 2.1.1 is the only version that was tried; its PyTorch and Warp wrappers have the same order of lines.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check skrl==2.1.1 jax==0.10.2 jaxlib==0.10.2 flax==0.12.8 optax==0.2.8 gymnasium==1.4.0

JAX_PLATFORMS=cpu venv/bin/python - 2> messages.txt <<'PY' | tee seen.txt
import gymnasium
import numpy
from skrl.envs.wrappers.jax import wrap_env
from skrl.utils import set_seed
from skrl.utils.runner.jax import Runner

LAYERS = [{"name": "net", "input": "OBSERVATIONS", "layers": [4], "activations": "elu"}]


class Walk(gymnasium.Env):
    """It tells the seed of its first reset."""

    observation_space = gymnasium.spaces.Box(-1, 1, (2,), numpy.float32)
    action_space = gymnasium.spaces.Box(-1, 1, (1,), numpy.float32)
    given = "none"

    def reset(self, seed=None, options=None):
        super().reset(seed=seed)
        if self.given == "none":
            self.given = seed
        return numpy.zeros(2, numpy.float32), {}

    def step(self, action):
        return numpy.zeros(2, numpy.float32), 0.0, False, False, {}


def given(seed):
    """The seed that the environment of a run is reset with."""
    env = Walk()
    Runner(wrap_env(env, wrapper="gymnasium", verbose=False), {
        "seed": seed,
        "models": {"separate": True,
                   "policy": {"class": "GaussianMixin", "network": LAYERS, "output": "ACTIONS"},
                   "value": {"class": "DeterministicMixin", "network": LAYERS, "output": "ONE"}},
        "memory": {"class": "RandomMemory", "memory_size": -1},
        "agent": {"class": "PPO", "rollouts": 4, "learning_epochs": 1, "mini_batches": 1,
                  "experiment": {"write_interval": 0, "checkpoint_interval": 0}},
        "trainer": {"class": "SequentialTrainer", "timesteps": 2, "headless": True,
                    "disable_progressbar": True}}).run("train")
    return env.given


print("a first run with seed 7: the environment got", given(7))
print("a second run with seed 7: the environment got", given(7))
print("a third run with seed 8: the environment got", given(8))
set_seed(9)
print("a run with seed 9 after set_seed(9): the environment got", given(9))
PY

grep -q '^a first run with seed 7: the environment got 0$' seen.txt
grep -q '^a second run with seed 7: the environment got 7$' seen.txt
grep -q '^a third run with seed 8: the environment got 7$' seen.txt
grep -q '^a run with seed 9 after set_seed(9): the environment got 9$' seen.txt
echo "The behaviour is as described."
