#!/usr/bin/env bash
# Gymnasium forgets the returns of all environments of a vector when only some of them are reset by a mask.
#
# Versions: gymnasium 1.4.0 and numpy 2.4.6 from PyPI.
# Expected: With AutoresetMode.DISABLED one resets the ended environments by options={"reset_mask": ...}. The vector
# wrapper RecordEpisodeStatistics has code for this mask, so that the others keep their returns and lengths.
# Observed: The inner vector environment takes the mask out of the options while it resets. The wrapper calls it first
# and looks for the mask afterwards, finds none, and clears everything. In this script one environment has episodes of
# 3 steps and the other has episodes of 5 steps, each with a reward of 1 per step. The longer one is reported with the
# return 2, and later the shorter one with 1: every figure depends on when its neighbours ended. Observations are right.
# The caller's own dictionary is emptied as well, so that a dictionary that is kept resets everything the next time.
# Since: It has been so since at least gymnasium 1.1.0.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check gymnasium==1.4.0 numpy==2.4.6

venv/bin/python - <<'PY' | tee seen.txt
import gymnasium
import numpy
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from gymnasium.wrappers.vector import RecordEpisodeStatistics


class Walk(gymnasium.Env):
    observation_space = gymnasium.spaces.Box(0, 9, (1,), numpy.float32)
    action_space = gymnasium.spaces.Discrete(2)

    def __init__(self, length):
        self.length = length

    def reset(self, seed=None, options=None):
        super().reset(seed=seed)
        self.steps = 0
        return numpy.zeros(1, numpy.float32), {}

    def step(self, action):
        self.steps += 1
        return numpy.full(1, self.steps, numpy.float32), 1.0, self.steps == self.length, False, {}


envs = SyncVectorEnv([lambda: Walk(3), lambda: Walk(5)], autoreset_mode=AutoresetMode.DISABLED)
envs = RecordEpisodeStatistics(envs)
envs.reset()
for _ in range(6):
    _, _, terminated, truncated, info = envs.step(numpy.zeros(2, int))
    ended = terminated | truncated
    for index in numpy.flatnonzero(ended):
        print(f"An episode of {(3, 5)[index]} steps has ended, recorded return {info['episode']['r'][index]:g},",
              f"recorded length {info['episode']['l'][index]}.")
    if ended.any():
        options = {"reset_mask": ended}
        envs.reset(options=options)
print("The options after the last reset:", options)
PY

[ "$(grep -o 'recorded return [0-9]*' seen.txt | cut -d' ' -f3 | paste -sd' ')" = "3 2 1" ]
[ "$(grep -oE 'of [0-9] steps' seen.txt | cut -d' ' -f2 | paste -sd' ')" = "3 5 3" ]
grep -q 'after the last reset: {}' seen.txt
echo "The behaviour is as described."
