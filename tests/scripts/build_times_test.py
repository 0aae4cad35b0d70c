"""scripts/build_times.py: the table of where a build's time goes, from a small log."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])
sys.path.insert(0, str(ROOT / "scripts"))
import build_times

# begin [ms], end [ms], time stamp, output, hash of the command: as Ninja writes it.
LOG = """# ninja log v5
0\t9000\t1\tsrc/latticeworld/a.o\taa
0\t4000\t2\tsrc/latticeworld/a.o\taa
4000\t5000\t3\tmsg/A.h\tbb
4000\t5000\t3\tmsg/B.h\tbb
5000\t8000\t4\ttests/a_test.o\tcc
8000\t10000\t5\tworld_server\tdd
"""
BUILD = """rule any
  command = true
build src/latticeworld/a.o: any a.cc
build msg/A.h msg/B.h: any a.msg
build tests/a_test.o: any a_test.cc
build world_server: any src/latticeworld/a.o msg/A.h
"""


class BuildTimesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = pathlib.Path(folder.name)
        (self.build / ".ninja_log").write_text(LOG)
        (self.build / "build.ninja").write_text(BUILD)

    def test_a_step_of_two_outputs_counts_once_and_the_newest_run_of_an_output_alone(self):
        self.assertEqual({("src/latticeworld/a.o",): 4.0, ("msg/A.h", "msg/B.h"): 1.0,
                          ("tests/a_test.o",): 3.0, ("world_server",): 2.0},
                         build_times.steps_of(self.build))

    def test_an_output_is_of_the_first_part_that_fits(self):
        self.assertEqual("the core", build_times.part_of("src/latticeworld/common/a.o"))
        self.assertEqual("ROS: libraries", build_times.part_of("src/latticeworld_ros/a.o"))
        self.assertEqual("messages, linking", build_times.part_of("latticeworld_generate_messages"))

    def test_the_table_has_every_part_its_share_and_that_of_the_server(self):
        said = subprocess.run([sys.executable, ROOT / "scripts/build_times.py", self.build],
                              text=True, check=True, stdout=subprocess.PIPE).stdout.splitlines()
        self.assertEqual(["| the core | 1 | 4 | 0.40 | 0.40 |",
                          "| tests and examples | 1 | 3 | 0.30 | 0.00 |",
                          "| messages, linking | 2 | 3 | 0.30 | 0.30 |",
                          "| all | 4 | 10 | 1.00 | 0.70 |"], said[2:])


if __name__ == "__main__":
    unittest.main()
