#!/usr/bin/env python3
"""The program on network file systems: whatever writes a folder does so there, too.

Usage: network_file_systems_test.py PROGRAM LIBRARY (tests/common/network_file_system.cc)
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SMALL = ("--seed", 3, "--size", 64, "--resolution", 2)
CAMPAIGN = """name: tiny
worlds: [{name: meadow, layout: Grassland., seeds: [1], size_m: 64, resolution_m: 2}]
robots: [{stack: way}]
tasks: {count: 1, length_m: [10, 30]}
trials: [{name: calm, seeds: [1]}]
"""


class NetworkFileSystemsTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True,
                              check=False, cwd=self.folder, env=self.environment)

    def must_write(self, folder, *arguments):
        """Runs the program, which makes the folder and leaves nothing of its own in it or beside."""
        run = self.run_program(*arguments)
        self.assertEqual(0, run.returncode, run.stderr)
        self.assertTrue(any((self.folder / folder).iterdir()))
        left = [str(path) for path in self.folder.rglob("*")
                if ".owner" in path.name or (path.is_dir() and path.name.startswith("."))]
        self.assertEqual([], left)

    def write_all(self):
        self.must_write("world", "generate", "--layout", "Grassland.", *SMALL, "--out", "world")
        again = self.run_program("generate", "--layout", "Grassland.", *SMALL, "--out", "world")
        self.assertEqual(1, again.returncode)
        self.assertIn("already exists", again.stderr)
        self.must_write("sdf", "export", "world", "--to", "sdf", "--out", "sdf")
        self.must_write("set", "dataset", "--generate", 3, "--out", "set")
        for count in (1, 2):
            self.must_write("pairs", "sketch-pairs", "--out", "pairs", "--count", count, "--side", 64)
        (self.folder / "tiny.yaml").write_text(CAMPAIGN)
        for more in ((), ("--resume",)):
            self.must_write("tiny", "campaign", "tiny.yaml", "--out", "tiny", *more)

    def test_on_lustre_and_nfs_without_locks(self):
        for locks in ("lustre", "nfs"):
            with self.subTest(locks):
                self.environment = {**os.environ, "LD_PRELOAD": LIBRARY, "LOCKS": locks}
                with tempfile.NamedTemporaryFile() as file:
                    lock = subprocess.run(["flock", "--nonblock", file.name, "true"], text=True,
                                          capture_output=True, check=False, env=self.environment)
                self.assertNotEqual(0, lock.returncode, "the library answers nothing")
                self.setUp()
                self.write_all()


if __name__ == "__main__":
    PROGRAM, LIBRARY = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
