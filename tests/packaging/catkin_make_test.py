#!/usr/bin/python3
"""Makes a catkin workspace with a link to LatticeWorld and a package of somebody else beside it, and
runs catkin_make and catkin_make install there.

All of LatticeWorld is configured; of what it compiles, the messages and one room of the core are made,
for the rest compiles as it does outside of a workspace. What is installed is the messages alone.

Usage: catkin_make_test.py SOURCE_DIR
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop()).resolve()
HERE = pathlib.Path(__file__).resolve().parent
JOBS = f"-j{len(os.sched_getaffinity(0))}"


def environment():
    """What a shell has in which nobody has sourced a workspace."""
    kept = {name: value for name, value in os.environ.items()
            if not name.startswith(("ROS_", "CMAKE_PREFIX_PATH", "PYTHONPATH", "LD_LIBRARY_PATH"))}
    # Nobody is asked for at the port of discarded packets.
    return {**kept, "PATH": "/usr/bin:" + kept["PATH"], "ROS_MASTER_URI": "http://127.0.0.1:9"}


def run(*command, cwd):
    done = subprocess.run([str(word) for word in command], cwd=cwd, text=True,
                          env={**environment(), "PWD": str(cwd)},  # catkin_make believes it
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}\n{done.stdout[-4000:]}")
    return done.stdout


class CatkinMakeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="latticeworld_workspace_")
        cls.addClassCleanup(folder.cleanup)
        cls.workspace = pathlib.Path(folder.name)
        (cls.workspace / "src").mkdir()
        (cls.workspace / "src/latticeworld").symlink_to(SOURCE)
        (cls.workspace / "src/out_of_tree").symlink_to(HERE / "out_of_tree")

    def in_space(self, space, *command):
        """What a command says after a space's setup.sh."""
        return run("sh", "-c", f'. {space}/setup.sh && "$@"', "sh", *command, cwd=self.workspace)

    def the_messages_are_those_of(self, space):
        program = next(self.workspace.glob(f"{space}/lib/out_of_tree/layout_listener"))
        said = self.in_space(space, program).strip()
        self.assertRegex(said, r"^latticeworld/Layout [0-9a-f]{32}$")
        md5 = self.in_space(space, "rosmsg", "md5", "latticeworld/Layout").strip()
        self.assertEqual(said.split()[1], md5)
        imported = self.in_space(space, "/usr/bin/python3", "-c", "import latticeworld.srv as srv\n"
                                 "print(srv.__file__, srv.GenerateWorldRequest().seed)")
        self.assertTrue(re.match(rf"{self.workspace}/{space}/.* 0\n$", imported), imported)

    def test_a_workspace_builds_and_installs_with_a_package_beside_us(self):
        targets = ("latticeworld_generate_messages", "latticeworld_common", "layout_listener")
        run("catkin_make", JOBS, *targets, cwd=self.workspace)
        self.the_messages_are_those_of("devel")
        run("catkin_make", "install", JOBS, "-DLATTICEWORLD_MESSAGES_ONLY=ON", cwd=self.workspace)
        self.the_messages_are_those_of("install")
        launch = self.in_space("install", "rospack", "find", "latticeworld").strip()
        self.assertEqual(str(self.workspace / "install/share/latticeworld"), launch)


if __name__ == "__main__":
    unittest.main()
