#!/usr/bin/env python3
"""docs/start.md, docs/tour.md and docs/gallery.md: the commands that need no ROS work as they are
shown, services that are called are there, and the programs that the start shows are those of
examples/.

Usage: start_page_test.py SOURCE_DIR LATTICEWORLD MAKE_WORLD STEP_WORLD
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

import start_page

SOURCE = pathlib.Path(sys.argv[1])
PROGRAMS = [pathlib.Path(path).resolve() for path in sys.argv[2:]]
PAGE = (SOURCE / "docs/start.md").read_text(encoding="utf-8")
TOUR = (SOURCE / "docs/tour.md").read_text(encoding="utf-8")
GALLERY = (SOURCE / "docs/gallery.md").read_text(encoding="utf-8")
README = (SOURCE / "README.md").read_text(encoding="utf-8")


class StartPageTest(unittest.TestCase):
    def test_the_commands_without_ros_work(self):
        commands = [line for page in (PAGE, TOUR, GALLERY) for line in start_page.commands_of(page)
                    if not start_page.needs_ros(line)]
        self.assertGreater(len(commands), 8 + 16)
        path = ":".join([*(str(program.parent) for program in PROGRAMS), os.environ["PATH"]])
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "docs").symlink_to(SOURCE / "docs")
            for command in commands:
                done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=folder,
                                      env={**os.environ, "PATH": path}, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                      timeout=120)
                self.assertEqual(0, done.returncode, f"{command}\n{done.stdout}")

    def test_services_and_programs_of_ros_that_are_shown_are_there(self):
        interfaces = (SOURCE / "docs/interfaces.md").read_text(encoding="utf-8")
        nodes = (SOURCE / "src/nodes/CMakeLists.txt").read_text(encoding="utf-8")
        commands = [line for page in (TOUR, README) for line in start_page.commands_of(page)
                    if start_page.needs_ros(line)]
        self.assertGreater(len(commands), 20)
        for command in commands:
            words = shlex.split(command)
            if words[:2] == ["rosservice", "call"]:
                self.assertIn(words[2].lstrip("/"), interfaces, command)
            if words[:2] == ["rosrun", "latticeworld"]:
                self.assertIn(f"latticeworld_node({words[2]} ", nodes, command)

    def test_every_example_is_shown_whole(self):
        shown = start_page.blocks_of(PAGE, "cpp") + start_page.blocks_of(PAGE, "python")
        examples = [path for path in sorted((SOURCE / "examples").iterdir())
                    if path.suffix in (".cc", ".py")]
        self.assertGreater(len(examples), 3)
        for path in examples:
            self.assertIn(path.read_text(encoding="utf-8"), shown, path.name)
        self.assertEqual(len(examples), len(shown))

    def test_what_is_set_up_is_there(self):
        console = "".join(start_page.blocks_of(PAGE, "console"))
        commands = re.findall(r"^\$ (.*)$", console, re.MULTILINE)
        self.assertGreater(len(commands), 4)
        targets = (SOURCE / "examples/CMakeLists.txt").read_text(encoding="utf-8")
        for command in commands:
            words = shlex.split(command, comments=True)
            for word in words:
                if re.match(r"(\./)?(scripts|clients|examples|docs)/", word):
                    self.assertTrue((SOURCE / word).exists(), command)
            if "--target" in words:
                for target in words[words.index("--target") + 1:]:
                    self.assertIn(f"latticeworld_example({target} ", targets, command)
            if words[:2] == ["roslaunch", "latticeworld"]:
                launch = (SOURCE / "launch_cfg" / words[2]).read_text(encoding="utf-8")
                for argument in words[3:]:
                    self.assertIn(f'<arg name="{argument.split(":=")[0]}"', launch, command)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
