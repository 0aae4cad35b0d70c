#!/usr/bin/python3
"""The examples that need a running server, and the commands of docs/start.md that do."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/examples"))

import start_page  # noqa: E402
from world_client import TIMEOUT_S, ServerTest, run  # noqa: E402

WORLD = {"layout": "Flat grassland everywhere.",
         "environment": "A sunny summer noon. A wheeled robot waits in the center.",
         "size": 64.0, "seed": 3}
PYTHON = os.environ.get("LATTICEWORLD_PYTHON")  # one that has Gymnasium


def shell(command, **variables):
    return subprocess.run(["bash", "-euo", "pipefail", "-c", command], text=True,
                          env={**os.environ, **variables}, cwd=os.environ["ROS_HOME"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=2 * TIMEOUT_S)


def rounds_of(done):
    """What first_policy.py prints: "at first: -3.10", "round 1: 2.40 with gains 0.80 and 1.10"."""
    return re.findall(r"^(?:at first|round \d+): .*$", done.stdout, re.MULTILINE)


class ExamplesTest(ServerTest):
    def setUp(self):
        self.world.generate(**WORLD)
        self.assertTrue(self.world.unpause().success)

    def test_a_robot_drives_by_its_scan_for_as_long_as_it_is_told(self):
        done = shell("rosrun latticeworld robot_in_world _seconds:=10")
        self.assertEqual(0, done.returncode, done.stdout)
        driven_m = float(re.search(r"drove (\S+) m$", done.stdout, re.MULTILINE).group(1))
        self.assertGreater(driven_m, 3.0)
        self.assertLess(driven_m, 20.0)

    @unittest.skipUnless(PYTHON, "Gymnasium is of PyPI: -DLATTICEWORLD_TEST_PYPI=ON")
    def test_a_first_policy_learns_and_learns_the_same_again(self):
        paths = ":".join([str(ROOT / "clients/latticeworld_gym"), os.environ.get("PYTHONPATH", "")])
        command = f"'{PYTHON}' '{ROOT}/examples/first_policy.py' --rounds 2 --seed 1"
        first = shell(command, PYTHONPATH=paths)
        self.assertEqual(0, first.returncode, first.stdout)
        rewards = [float(line.split()[2]) for line in rounds_of(first)]
        self.assertEqual(3, len(rewards), first.stdout)
        self.assertEqual(sorted(rewards), rewards)
        self.assertEqual(rounds_of(first), rounds_of(shell(command, PYTHONPATH=paths)))
        self.assertFalse(self.world.get_world().paused)

    @unittest.skipUnless(PYTHON, "Gymnasium is of PyPI: -DLATTICEWORLD_TEST_PYPI=ON")
    def test_the_learning_clients_examples_run_as_programs(self):
        paths = ":".join([str(ROOT / "clients/latticeworld_gym"), os.environ.get("PYTHONPATH", "")])
        for command, told in (
                ("random_policy.py --actions 40 --seed 2", r"^40 actions, \d+ a second, rewards -?\d"),
                ("drive_to_goal.py --episodes 2 --seed 1",
                 r"^episode 0: reached the goal, 0\.\d m from it at the end, rewards \d"
                 r".*\nepisode 1: reached the goal")):
            done = shell(f"'{PYTHON}' '{ROOT}/clients/examples/'{command}", PYTHONPATH=paths)
            self.assertEqual(0, done.returncode, done.stdout)
            self.assertRegex(done.stdout, re.compile(told, re.MULTILINE))
            self.assertFalse(self.world.get_world().paused)

    def test_the_commands_of_the_start_page_work(self):
        page = (ROOT / "docs/start.md").read_text(encoding="utf-8")
        commands = [line for line in start_page.commands_of(page) if start_page.needs_ros(line)]
        self.assertGreater(len(commands), 5)
        for command in commands:
            # Where ROS_HOME is set, nodes keep their files there.
            done = shell(command.replace("~/.ros", os.environ["ROS_HOME"]))
            self.assertEqual(0, done.returncode, f"{command}\n{done.stdout}")
            if command.startswith("rosservice call"):
                self.assertRegex(done.stdout, r"(?m)^ *code: 0$", command)


if __name__ == "__main__":
    run("examples_test", ExamplesTest)
