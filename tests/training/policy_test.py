"""PPO on drivers of robots: lessons, runs that go on, and the file that is shipped."""

import os
import sys
import tempfile
import unittest
from unittest import mock

# Gymnasium comes from PyPI beside a newer NumPy than Debian's PyTorch takes: it is looked for last.
sys.path.append(os.environ["LATTICEWORLD_PYTHON_PACKAGES"])

import numpy as np  # noqa: E402
import onnx  # noqa: E402
import torch  # noqa: E402
from latticeworld_training import policy as policies  # noqa: E402
from latticeworld_training import train_policy  # noqa: E402
from onnx import numpy_helper  # noqa: E402


def run_onnx(path, inputs):
    """What the file's network answers, by its nodes."""
    graph = onnx.load(path).graph
    values = {weight.name: numpy_helper.to_array(weight) for weight in graph.initializer}
    values[graph.input[0].name] = inputs
    for node in graph.node:
        given = [values[name] for name in node.input]
        values[node.output[0]] = {
            "Gemm": lambda x, w=None, b=None: x @ w.T + b, "Tanh": np.tanh, "Clip": np.clip,
            "Mul": np.multiply, "Add": np.add}[node.op_type](*given)
    return values[graph.output[0].name]


def some_observations(count):
    random = np.random.default_rng(1)
    return {"scan": random.uniform(0.1, 20.0, (count, policies.SECTORS)),
            "velocity": random.normal(0, 1, (count, 2)),
            "goal": random.uniform(-20, 20, (count, 2))}


class FakeWorlds:
    """A road on which going forward is rewarded, whatever is seen; episodes of ten steps."""

    def __init__(self, worlds):
        self.worlds, self.step_number = worlds, 0

    def reset(self, seed=None):
        return some_observations(self.worlds), {}

    def step(self, actions):
        self.step_number += 1
        over = np.full(self.worlds, self.step_number % 10 == 0)
        infos = {"final_info": {"is_success": np.ones(self.worlds, bool)}} if over.any() else {}
        never = np.zeros(self.worlds, bool)
        return some_observations(self.worlds), actions[:, 0], over, never, infos

    def close(self):
        pass


class LessonTest(unittest.TestCase):
    def test_advantages_are_discounted_sums_of_surprises(self):
        """As the sums of Schulman et al. 2016 say, to the end of an episode and no further."""
        steps = train_policy.Steps(1)
        random = torch.Generator().manual_seed(3)
        for part in (steps.rewards, steps.values):
            part.copy_(torch.rand(part.shape, generator=random))
        steps.ended[50] = 1.0
        next_value = torch.tensor([0.7])
        found, returns = steps.advantages(next_value)
        values = torch.cat((steps.values[:, 0], next_value))
        discount, trace, last = train_policy.DISCOUNT, train_policy.TRACE, train_policy.STEPS - 1
        to_come = [0.0 if t == 50 else discount * values[t + 1] for t in range(last + 1)]
        surprises = [steps.rewards[t, 0] + to_come[t] - values[t] for t in range(last + 1)]
        for begin, end in ((0, 50), (40, 50), (51, last)):
            expected = sum((discount * trace) ** (t - begin) * surprises[t]
                           for t in range(begin, end + 1))
            self.assertAlmostEqual(float(found[begin, 0]), float(expected), places=4)
            whole = float(expected + values[begin])
            self.assertAlmostEqual(float(returns[begin, 0]), whole, places=4)

    def test_what_is_rewarded_is_done_more(self):
        torch.manual_seed(1)
        policy = policies.Policy()
        optimizer = torch.optim.Adam(policy.parameters(), lr=1e-3)
        driver, steps = train_policy.Driver(FakeWorlds(8), 1), train_policy.Steps(8)
        seen = policies.features(some_observations(8))
        before = policies.action_of(policy.actor(seen))[:, 0].mean()
        for _ in range(12):
            driver.drive(policy, steps)
            train_policy.learn(policy, optimizer, steps, policy.value(driver.inputs).detach())
        after = policies.action_of(policy.actor(seen))[:, 0].mean()
        self.assertGreater(float(after - before), 0.2)
        self.assertEqual(driver.reached, driver.episodes)


class RunTest(unittest.TestCase):
    def train(self, folder, minutes):
        with mock.patch.object(train_policy, "STEPS", 16):
            train_policy.main(["--out", folder, "--worlds", "2", "--minutes", str(minutes)])

    def test_a_run_in_worlds_goes_on_and_becomes_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            self.train(folder, 0.02)
            first = torch.load(os.path.join(folder, "policy.pt"))["rest"]
            self.assertGreaterEqual(first["lessons"], 1)
            self.train(folder, first["spent"] / 60.0 + 0.02)
            second = torch.load(os.path.join(folder, "policy.pt"))
            self.assertGreater(second["rest"]["lessons"], first["lessons"])
            path = os.path.join(folder, "policy.onnx")
            train_policy.main(["--out", folder, "--export", path])
            policy = policies.Policy()
            policy.load_state_dict(second["model"])
            inputs = policies.features(some_observations(64))
            expected = policies.action_of(policy.actor(inputs)).detach().numpy()
            np.testing.assert_allclose(run_onnx(path, inputs.numpy()), expected, atol=1e-5)
            self.assertLess(os.path.getsize(path), 1000000)


if __name__ == "__main__":
    unittest.main()
