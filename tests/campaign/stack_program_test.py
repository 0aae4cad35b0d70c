#!/usr/bin/env python3
"""Drives campaigns by programs of a user's: a good one, and every way to be a bad one."""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

CAMPAIGN = """name: meadow
worlds:
  - {{name: meadow, layout: Grass everywhere., environment: A sunny noon., size_m: 64, resolution_m: 1}}
robots:
  - name: rover
    suite: scanner
    stack: {stack}
tasks: {{count: {tasks}, length_m: [8, 25]}}
trials:
  - {{name: calm, seeds: [1], time_limit_factor: 4}}
"""

# What goes wrong by name, at the first step unless it says otherwise.
BAD = """import json, os, pathlib, sys, time
mode = sys.argv[1]
pathlib.Path("pids").open("a").write(f"{os.getpid()}\\n")
if mode == "deaf":
    time.sleep(600)
if mode == "child":
    import subprocess
    child = subprocess.Popen(["sleep", "600"])
    pathlib.Path("pids").open("a").write(f"{child.pid}\\n")
for line in sys.stdin:
    if json.loads(line)["say"] == "begin" and mode != "refuses":
        print('{"state": "ready"}', flush=True)
        continue
    if mode == "exits":
        sys.exit(3)
    if mode == "silent":
        time.sleep(600)
    answer = {
        "garbage": "go left",
        "no object": "[]",
        "half": '{"state": "driving", "speed_mps": 1}',
        "not a number": '{"state": "driving", "speed_mps": NaN, "turn_rate_radps": 0}',
        "huge speed": '{"state": "driving", "speed_mps": 1e9, "turn_rate_radps": 0}',
        "huge line": "x" * 3000000,
        "talks": '{"state": "driving", "speed_mps": 0, "turn_rate_radps": 0}\\nand on',
        "refuses": '{"state": "failed", "why": "no such robot of mine"}',
        "gives up": '{"state": "failed", "why": "lost the way"}',
        "child": '{"state": "failed", "why": "the child is left"}',
    }[mode]
    print(answer, flush=True)
"""

REASONS = {
    "exits": "the program ended with status 3",
    "silent": "the program did not answer within 0.5 s",
    "deaf": "the program did not answer within 0.5 s",
    "garbage": "go left",
    "no object": "[]",
    "half": "legal is",
    "not a number": "legal is",
    "huge speed": "numbers from -100 to 100",
    "huge line": "a line of more than 1048576 bytes",
    "talks": "something that nobody asked for",
    "refuses": "no such robot of mine",
    "gives up": "lost the way",
    "child": "the child is left",
}


def runs(pid):
    """Whether it is there and not only its name, which waits for its new parent."""
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return False
    return not any(line.startswith("State:\tZ") for line in status.splitlines())


class StackProgramTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "bad.py").write_text(BAD)

    def tearDown(self):
        self.temporary.cleanup()

    def run_campaign(self, stack, out, tasks=1, *arguments):
        file = self.folder / f"{out}.yaml"
        file.write_text(CAMPAIGN.format(stack=json.dumps(stack), tasks=tasks))
        return subprocess.run([PROGRAM, "campaign", str(file), "--out", str(self.folder / out),
                               "--workers", "1", *arguments],
                              capture_output=True, text=True, check=False)

    def trials(self, out):
        with open(self.folder / out / "trials.csv", newline="") as table:
            return list(csv.DictReader(table))

    def test_a_python_class_drives_to_its_goals_and_the_same_again(self):
        example = CLIENTS / "examples" / "head_for_goal.py"
        stack = {"command": ["/usr/bin/python3", str(example)], "name": "mine"}
        rows = []
        for out in ("first", "second"):
            run = self.run_campaign(stack, out, 3)
            self.assertEqual(run.returncode, 0, run.stderr)
            rows.append(self.trials(out))
        self.assertEqual(rows[0], rows[1])
        for row in rows[0]:
            self.assertEqual((row["stack"], row["outcome"]), ("mine", "success"), row)
            self.assertLess(float(row["goal_distance_m"]), 0.5)
        self.assertIn("mine", (self.folder / "first" / "report.html").read_text())

    def test_whatever_a_program_does_wrong_fails_its_trial_with_the_reason(self):
        for mode, reason in REASONS.items():
            with self.subTest(mode):
                out = mode.replace(" ", "_")
                # bad.py is found from the folder of the campaign's file.
                run = self.run_campaign({"command": ["python3", "bad.py", mode],
                                         "answer_time_s": 0.5 if "answer" in reason else 20},
                                        out)
                self.assertEqual(run.returncode, 0, run.stderr)
                [row] = self.trials(out)
                self.assertEqual(row["outcome"], "stack failed", row)
                self.assertIn(reason, row["why"])
        for pid in (self.folder / "pids").read_text().split():
            self.assertFalse(runs(pid), f"process {pid} is left")

    def test_errors_of_the_file_say_what_is_wanted(self):
        for stack, said in (({"command": "python3 bad.py"}, "[program, argument, ...]"),
                            ({"command": []}, "[program, argument, ...]"),
                            ({"name": "mine"}, "command"),
                            ({"command": ["no_such_program"]}, "a name in PATH"),
                            ({"command": ["./bad.py"]}, "a path from the campaign's file"),
                            ({"command": ["python3"], "answer_time_s": 0}, "0.01"),
                            ({"command": ["python3"], "scans": "many"}, "true or false"),
                            ({"command": ["python3"], "colour": 1}, "colour")):
            run = self.run_campaign(stack, "unusable", 1, "--check")
            self.assertEqual(run.returncode, 2, stack)
            self.assertIn(said, run.stderr)
            self.assertIn("/robots/0/stack", run.stderr)


if __name__ == "__main__":
    PROGRAM, CLIENTS = sys.argv[1], pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1], verbosity=2)
