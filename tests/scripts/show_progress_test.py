"""scripts/show_progress.py: what a person is told of a build, and what of a failure."""

import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])
sys.path.insert(0, str(ROOT / "scripts"))
import show_progress

FAILING = """cmake_minimum_required(VERSION 3.18)
project(failing NONE)
add_custom_target(good ALL COMMAND ${CMAKE_COMMAND} -E echo "a good step")
add_custom_target(bad ALL COMMAND ${CMAKE_COMMAND} -E echo "its words" COMMAND false)
add_dependencies(bad good)
"""


class Terminal(io.StringIO):
    def isatty(self):
        return True


class ShowProgressTest(unittest.TestCase):
    def test_spans_are_said_in_seconds_and_then_in_minutes(self):
        self.assertEqual("1 s", show_progress.in_words(0.2))
        self.assertEqual("89 s", show_progress.in_words(89.4))
        self.assertEqual("2 min", show_progress.in_words(90))

    def test_what_is_left_is_guessed_between_a_twentieth_and_the_end(self):
        self.assertEqual("built 4 of 100 (4 %), 10 s gone", show_progress.line_of(4, 100, 10))
        self.assertEqual("built 25 of 100 (25 %), 20 s gone, about 60 s left",
                         show_progress.line_of(25, 100, 20))
        self.assertEqual("built 100 of 100 (100 %), 20 s gone", show_progress.line_of(100, 100, 20))

    def test_without_a_terminal_a_line_is_told_each_tenth_and_at_the_end(self):
        out = io.StringIO()
        teller = show_progress.Teller(out)
        for done in range(1, 41):
            teller.tell(done, 40, done)
        teller.end()
        lines = out.getvalue().splitlines()
        self.assertEqual([4 * tenth for tenth in range(1, 11)],
                         [int(line.split()[1]) for line in lines])

    def test_a_terminal_has_one_line_that_each_step_writes_anew(self):
        out = Terminal()
        teller = show_progress.Teller(out)
        teller.tell(1, 3, 1)
        teller.tell(2, 3, 2)
        teller.end()
        self.assertEqual(2, out.getvalue().count("\r\033[K"))
        self.assertEqual(1, out.getvalue().count("\n"))

    def test_of_two_failures_the_first_is_shown_whole_and_nothing_around_it(self):
        log = ["@1/9@ Building a.o", "@2/9@ Building b.o", "FAILED: b.o", "c++ b.cc", "b.cc:1: wrong",
               "@3/9@ Building c.o", "FAILED: c.o", "c++ c.cc", "ninja: build stopped"]
        self.assertEqual(["FAILED: b.o", "c++ b.cc", "b.cc:1: wrong"],
                         show_progress.first_failure(log))
        self.assertEqual(["FAILED: c.o", "c++ c.cc"], show_progress.first_failure(log[5:]))

    def test_where_no_step_failed_the_last_lines_are_shown(self):
        log = [f"line {number}" for number in range(9)]
        self.assertEqual(log[-5:], show_progress.first_failure(log))

    def test_a_build_that_fails_shows_the_one_command_and_keeps_the_rest_in_its_log(self):
        with tempfile.TemporaryDirectory() as folder:
            build = pathlib.Path(folder) / "build"
            (pathlib.Path(folder) / "CMakeLists.txt").write_text(FAILING)
            subprocess.run(["cmake", "-G", "Ninja", "-S", folder, "-B", build], check=True,
                           stdout=subprocess.DEVNULL)
            done = subprocess.run([sys.executable, ROOT / "scripts/show_progress.py", build],
                                  text=True, capture_output=True, check=False)
            self.assertNotEqual(0, done.returncode)
            self.assertIn("FAILED: ", done.stderr)
            self.assertIn("its words", done.stderr)
            self.assertNotIn("a good step", done.stderr)
            self.assertIn("a good step", (build / "build.log").read_text())
            self.assertIn(str(build / "build.log"), done.stderr)


if __name__ == "__main__":
    unittest.main()
