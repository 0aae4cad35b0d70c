#!/usr/bin/python3
"""Installs what other packages build with into a folder, and builds and runs a package of somebody
else against it.

Usage: out_of_tree_test.py BUILD_DIR
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BUILD = sys.argv.pop()
PACKAGE = pathlib.Path(__file__).resolve().parent / "out_of_tree"


def run(*command, **variables):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **variables}, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}\n{done.stdout[-4000:]}")
    return done.stdout


class OutOfTreeTest(unittest.TestCase):
    def test_a_package_of_somebody_else_uses_our_messages_and_links_the_core(self):
        with tempfile.TemporaryDirectory(prefix="latticeworld_out_of_tree_") as folder:
            prefix, build = pathlib.Path(folder) / "prefix", pathlib.Path(folder) / "build"
            for component in ("messages", "dev"):
                run("cmake", "--install", BUILD, "--component", component, "--prefix", prefix)
            run("cmake", "-S", PACKAGE, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}",
                "-DPYTHON_EXECUTABLE=/usr/bin/python3", PATH="/usr/bin:" + os.environ["PATH"])
            run("cmake", "--build", build)
            program = next(build.glob("**/words_to_message"))
            self.assertRegex(run(program), r"^world-[0-9a-f]{12}\n$")


if __name__ == "__main__":
    unittest.main()
