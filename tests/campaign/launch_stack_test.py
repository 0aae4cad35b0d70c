#!/usr/bin/python3
"""A campaign whose robot is driven by the nodes of a launch file: the reference navigator's node."""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

CAMPAIGN = """name: launched
worlds:
  - {{name: meadow, layout: Grass everywhere., environment: A sunny noon., size_m: 64, resolution_m: 1}}
robots:
  - {{name: rover, suite: scanner, stack: {stack}}}
tasks: {{count: 1, length_m: [8, 20]}}
trials:
  - {{name: calm, seeds: [1]}}
"""


def command_lines():
    lines = []
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                lines.append((entry / "cmdline").read_bytes().replace(b"\0", b" ").decode())
            except (OSError, UnicodeDecodeError):
                pass
    return lines


class LaunchStackTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.trials = 0
        os.environ.update(HOME=str(self.folder), ROS_HOME=str(self.folder / "ros"))

    def tearDown(self):
        self.temporary.cleanup()

    def trial(self, launch_file, *arguments, answer_time_s=60):
        stack = {"command": ["rosrun", "latticeworld", "launch_stack.py", "--pace", "2",
                             str(launch_file), *arguments], "name": "nodes",
                 "answer_time_s": answer_time_s}
        self.trials += 1
        file, out = self.folder / "launched.yaml", self.folder / f"out{self.trials}"
        file.write_text(CAMPAIGN.format(stack=json.dumps(stack)))
        run = subprocess.run([PROGRAM, "campaign", str(file), "--out", str(out), "--workers", "1"],
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(out / "trials.csv", newline="") as table:
            [row] = csv.DictReader(table)
        return row

    def test_a_node_behind_move_base_drives_to_the_goal_and_nothing_is_left(self):
        # A name of our own tells its processes from everybody else's.
        robot = f"rover_{os.getpid()}"
        launch = self.folder / f"{robot}.launch"
        launch.write_text(f"""<launch>
          <include file="$(find latticeworld)/launch_cfg/campaign_navigator.launch">
            <arg name="robot" value="{robot}"/>
          </include>
        </launch>""")
        row = self.trial(launch, "--robot", robot)
        self.assertEqual(row["outcome"], "success", row)
        self.assertLess(float(row["goal_distance_m"]), 0.5)
        self.assert_nothing_left(robot)
        # Nodes that take no goals of that robot are not waited for longer than the campaign waits.
        row = self.trial(launch, "--robot", "nobody", answer_time_s=6)
        self.assertIn("did not answer within 6 s", row["why"])
        self.assert_nothing_left(robot)

    def assert_nothing_left(self, robot):
        left = [line for line in command_lines()
                if (robot in line or str(self.folder) in line) and "launch_stack_test" not in line]
        self.assertEqual(left, [])

    def test_what_cannot_be_launched_fails_the_trial_with_the_reason(self):
        row = self.trial(self.folder / "nowhere.launch")
        self.assertEqual(row["outcome"], "stack failed")
        self.assertIn("there is no launch file", row["why"])

    def test_a_launch_file_that_ends_fails_the_trial_with_the_reason(self):
        broken = self.folder / "broken.launch"
        broken.write_text("<launch><node")
        row = self.trial(broken)
        self.assertEqual(row["outcome"], "stack failed")
        self.assertIn("ended with status 1", row["why"])


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1], verbosity=2)
