#!/usr/bin/env python3
"""examples/step_world.cc as a person runs it.

Usage: step_world_test.py STEP_WORLD
"""

import math
import re
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)
REACHED_M = 0.5
LINE = re.compile(r"after (\S+) s the robot is at (\S+), (\S+) m, (\S+) m from its goal\n"
                  r"state ([0-9a-f]{64})\n")


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], text=True, capture_output=True, timeout=120)


class StepWorldTest(unittest.TestCase):
    def drive(self, east, north):
        """(time [s], east [m], north [m], distance to the goal [m]), hash of the state."""
        done = run(str(east), str(north))
        self.assertEqual(0, done.returncode, done.stderr)
        told = LINE.fullmatch(done.stdout)
        self.assertIsNotNone(told, done.stdout)
        return [float(number) for number in told.groups()[:4]], told.group(5)

    def test_the_robot_gets_where_it_is_sent(self):
        for goal in ((12.0, 8.0), (-9.0, 6.0)):
            (time_s, east, north, distance_m), _ = self.drive(*goal)
            self.assertLess(math.dist(goal, (east, north)), REACHED_M + 0.01)
            self.assertLessEqual(distance_m, REACHED_M)
            self.assertLess(time_s, 60.0)

    def test_two_runs_are_the_same_to_the_bit(self):
        self.assertEqual(self.drive(5.0, 3.0), self.drive(5.0, 3.0))

    def test_a_place_that_cannot_be_reached_ends_too(self):
        (time_s, *_, distance_m), _ = self.drive(1000.0, 0.0)
        self.assertAlmostEqual(60.0, time_s, places=3)
        self.assertGreater(distance_m, 900.0)

    def test_what_is_wrong_is_said(self):
        done = run("12")
        self.assertEqual(2, done.returncode)
        self.assertIn("usage", done.stderr)


if __name__ == "__main__":
    unittest.main()
