"""The policy that is shipped (models/goal_policy.onnx) drives in worlds that it has not seen."""

import csv
import importlib.util
import os
import pathlib
import subprocess
import sys

import numpy as np
import onnxruntime

import latticeworld as lw

ROOT = pathlib.Path(__file__).resolve().parents[2]
POLICY = ROOT / "models" / "goal_policy.onnx"
STACK = ROOT / "clients" / "examples" / "drive_by_policy.py"
ENVIRONMENT = "A cloudy spring morning. A wheeled robot waits in the center."
# Neither these words nor these seeds are among those of latticeworld_training/train_policy.py.
WORLDS = [dict(layout=layout, environment=ENVIRONMENT, seed=seed, size_m=64.0, resolution_m=0.5)
          for layout, seed in (("A pasture with three oaks.", 7), ("Clearings between birches.", 8),
                               ("A hamlet among gardens.", 9), ("A common with boulders.", 10))]

CAMPAIGN = """name: learned
worlds:
  - name: pasture
    layout: A pasture with three oaks.
    environment: A cloudy morning.
    seeds: [11, 12]
    size_m: 64
robots:
  - name: rover
    suite: scanner
    stack: {{command: [{python}, {stack}, {policy}], name: learned}}
tasks: {{count: 3, length_m: [8, 20]}}
trials:
  - {{name: calm, seeds: [1]}}
"""


def stack_module():
    """The example of a stack, which makes of scans and goals what the policy is given."""
    spec = importlib.util.spec_from_file_location("drive_by_policy", STACK)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_it_reaches_goals_in_worlds_it_has_not_seen():
    features = stack_module().features
    network = onnxruntime.InferenceSession(POLICY)
    env = lw.make_vec(4, worlds=lambda number: WORLDS[number % 4], autoreset_mode="SameStep",
                      max_actions=400, task=lambda robot: lw.GoalTask(distance_m=(5.0, 20.0)))
    observations, _ = env.reset(seed=5)
    reached = []
    while len(reached) < 40:
        parts = [observations[name] for name in ("scan", "velocity", "goal")]
        given = np.concatenate([features(*of_world) for of_world in zip(*parts)])
        actions = network.run(["action"], {"features": given})[0]
        observations, _, terminated, truncated, infos = env.step(actions)
        over = terminated | truncated
        if over.any():
            reached += list(np.asarray(infos["final_info"]["is_success"], bool)[over])
    env.close()
    assert np.mean(reached) >= 0.85, reached


def test_it_drives_campaigns(tmp_path):
    file = tmp_path / "learned.yaml"
    file.write_text(CAMPAIGN.format(python=sys.executable, stack=STACK, policy=POLICY))
    subprocess.run([os.environ["LATTICEWORLD_PROGRAM"], "campaign", file, "--out", tmp_path / "out",
                    "--workers", "1"], check=True, stdout=subprocess.DEVNULL, timeout=280)
    with open(tmp_path / "out" / "trials.csv", newline="", encoding="utf-8") as file:
        outcomes = [row["outcome"] for row in csv.DictReader(file)]
    assert outcomes.count("success") >= 5, outcomes


def test_scans_of_campaigns_are_those_of_training():
    """Points of a sweep, right to left, fall into the sectors that training observes."""
    nearest = stack_module().nearest_in_sectors
    angles = np.radians(np.arange(-135.0, 135.0, 0.25) + 0.1)
    ranges = np.random.default_rng(2).uniform(0.2, 19.0, len(angles)).astype(np.float32)
    points = np.stack((ranges * np.cos(angles), ranges * np.sin(angles), np.zeros_like(angles)), 1)
    found = nearest(points.astype(np.float32).tobytes())
    np.testing.assert_allclose(found, ranges.reshape(36, 30).min(1), rtol=1e-5)
