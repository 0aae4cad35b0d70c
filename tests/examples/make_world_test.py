#!/usr/bin/env python3
"""examples/make_world.cc as a person runs it.

Usage: make_world_test.py MAKE_WORLD
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1))
LAND = "A lake in the upper left, forest in the lower right."
ENVIRONMENT = "A sunny autumn afternoon. Two sheep graze in the center."


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], text=True, capture_output=True, timeout=120)


class MakeWorldTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.picture = pathlib.Path(folder.name) / "world.png"

    def test_words_become_a_picture_and_the_claims_are_told(self):
        done = run(LAND, ENVIRONMENT, self.picture)
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertEqual(b"\x89PNG", self.picture.read_bytes()[:4])
        self.assertIn("kept    A lake in the upper left", done.stdout)
        self.assertRegex(done.stdout, r"world-[0-9a-f]{12} has \d+ plants and things\n$")

    def test_the_same_words_give_the_same_picture(self):
        pictures = set()
        for _ in range(2):
            self.assertEqual(0, run(LAND, ENVIRONMENT, self.picture).returncode)
            pictures.add(self.picture.read_bytes())
        self.assertEqual(1, len(pictures))

    def test_what_is_wrong_is_said(self):
        self.assertEqual(2, run(LAND).returncode)
        nothing = run("", "", self.picture)
        self.assertEqual(1, nothing.returncode)
        self.assertIn("layout_instruction", nothing.stderr)
        nowhere = run(LAND, ENVIRONMENT, self.picture.parent / "none" / "world.png")
        self.assertEqual(1, nowhere.returncode)
        self.assertIn("world.png", nowhere.stderr)


if __name__ == "__main__":
    unittest.main()
