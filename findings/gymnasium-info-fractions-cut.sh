#!/usr/bin/env bash
# Gymnasium cuts the fractions off a number in the info of one environment, depending on what another one reported.
#
# Versions: gymnasium 1.4.0 and numpy 2.4.6 from PyPI.
# Expected: A vector environment gathers the values of an info key into an array. If one environment reports the int 0
# and another one 0.75, then the array is one of floats, as numpy would make it of the two values.
# Observed: The type of the array is the one of the first environment that has the key in this step. If this one
# reports an int, then the fractions of all others are cut off without a warning, and 0.75 becomes 0. The type is chosen
# anew in every step, so that the same value is right in the next step if the first environment then reports 1.0, or has
# no such key. The order of the environments decides too. SyncVectorEnv and AsyncVectorEnv behave alike.
# Since: It has been so since at least gymnasium 1.1.0.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check gymnasium==1.4.0 numpy==2.4.6

cat > walk.py <<'PY'
import gymnasium
import numpy
from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv


class Walk(gymnasium.Env):
    """It reports the given values as its progress, one in each step, and no progress for None."""

    observation_space = gymnasium.spaces.Box(0, 9, (1,), numpy.float32)
    action_space = gymnasium.spaces.Discrete(2)

    def __init__(self, values):
        self.values = values

    def reset(self, seed=None, options=None):
        super().reset(seed=seed)
        self.steps = 0
        return numpy.zeros(1, numpy.float32), {}

    def step(self, action):
        value = self.values[self.steps]
        self.steps += 1
        return numpy.zeros(1, numpy.float32), 0.0, False, False, {} if value is None else {"progress": value}


if __name__ == "__main__":
    first, second = (0, 1.0, None), (0.75, 0.75, 0.75)
    for kind in (SyncVectorEnv, AsyncVectorEnv):
        for order in ((first, second), (second, first)):
            envs = kind([lambda values=values: Walk(values) for values in order])
            envs.reset()
            steps = [envs.step(numpy.zeros(2, int))[4]["progress"].tolist() for _ in range(3)]
            envs.close()
            print(f"{kind.__name__}: reported", list(zip(*order)), "gathered", steps)
PY
venv/bin/python walk.py | tee seen.txt

for kind in SyncVectorEnv AsyncVectorEnv; do
    grep -q "^$kind: .*gathered \[\[0, 0\], \[1.0, 0.75\], \[0.0, 0.75\]\]" seen.txt
    grep -q "^$kind: .*gathered \[\[0.75, 0.0\], \[0.75, 1.0\], \[0.75, 0.0\]\]" seen.txt
done
echo "The behaviour is as described."
