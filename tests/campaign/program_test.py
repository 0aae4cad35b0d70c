#!/usr/bin/env python3
"""Runs `latticeworld campaign` as a person does: whole, broken off, by shards, on bad files."""

import csv
import html.parser
import json
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import unittest

CAMPAIGN = """name: tiny
worlds:
  - name: lake
    layout: A lake in the center and forest around it.
    environment: Two sheep graze.
    seeds: [1, 2]
    size_m: 64
    resolution_m: 1
robots: [{stack: way}]
tasks: {count: 2, length_m: [10, 30]}
trials:
  - {name: calm, seeds: [1]}
  - {name: hunted, seeds: [1], adversaries: {count: 1, reach_m: 10}}
"""
TRIALS = 8


class Page(html.parser.HTMLParser):
    """Collects the text of a page, and what is wrong with it."""

    VOID = {"meta", "br", "img"}

    def __init__(self):
        super().__init__()
        self.open, self.wrong, self.asked, self.text = [], [], [], ""

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("src", "href", "data", "action") and not value.startswith(("#", "data:")):
                self.asked.append(value)
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(f"</{tag}> at {self.getpos()}")

    def handle_data(self, data):
        self.text += data


class CampaignProgramTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.file = self.folder / "tiny.yaml"
        self.file.write_text(CAMPAIGN)

    def tearDown(self):
        self.temporary.cleanup()

    def run_campaign(self, *arguments, file=None, **options):
        return subprocess.run([PROGRAM, "campaign", str(file or self.file), *map(str, arguments)],
                              capture_output=True, text=True, check=False, **options)

    def must_run(self, *arguments):
        run = self.run_campaign(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def results(self, out):
        """What has to be the same however the campaign was run."""
        found = {path.name: path.read_bytes() for path in sorted((out / "trials").iterdir())}
        for name in ("trials.csv", "summary.json"):
            found[name] = (out / name).read_bytes()
        found["report"] = (out / "report.html").read_bytes().replace(str(out).encode(), b"OUT")
        return found

    def whole(self, workers=1):
        out = self.folder / f"whole{workers}"
        if not out.exists():
            self.must_run("--out", out, "--workers", workers)
        return out

    def test_results_do_not_depend_on_the_number_of_workers(self):
        one = self.results(self.whole(1))
        self.assertEqual(len(one), TRIALS + 3)
        self.assertEqual(one, self.results(self.whole(2)))

    def test_killed_and_gone_on_with_it_ends_as_if_unbroken(self):
        out = self.folder / "broken"
        kills = 0
        for after in (1, 1, 2, 1):
            process = subprocess.Popen(
                [PROGRAM, "campaign", str(self.file), "--out", str(out), "--workers", "2",
                 "--resume"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            for line in process.stderr:  # "3 of 8 trials, ..."
                if line.split()[0] == str(after):
                    process.send_signal(signal.SIGKILL)
                    kills += 1
                    break
            process.stderr.close()
            process.wait()
        self.assertGreater(kills, 1)
        (out / "trials" / "left.123.part").write_text("half of a res")
        (out / "worlds" / ".lake-1.aBcDeF").mkdir()
        self.must_run("--out", out, "--resume", "--workers", 2)
        self.assertEqual(self.results(self.whole(1)), self.results(out))
        self.assertEqual(sorted(path.name for path in (out / "worlds").iterdir()),
                         ["lake-1", "lake-2"])

    def test_shards_and_their_merge_end_as_one_run(self):
        out = self.folder / "shards"
        self.must_run("--out", out, "--shard", "1/3", "--workers", 1)
        early = self.run_campaign("--out", out, "--merge")
        self.assertEqual(early.returncode, 1)
        self.assertIn("have no result", early.stderr)
        for shard in ("0/3", "2/3"):
            self.must_run("--out", out, "--shard", shard, "--workers", 1)
        self.must_run("--out", out, "--merge")
        self.assertEqual(self.results(self.whole(1)), self.results(out))

    def test_a_job_file_does_the_same_without_slurm(self):
        out, job = self.folder / "job", self.folder / "job.sbatch"
        self.must_run("--out", out, "--slurm", job, "--shards", 2, "--workers", 1)
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith("SLURM")}
        subprocess.run(["bash", str(job)], check=True, capture_output=True, env=environment)
        self.assertEqual(self.results(self.whole(1)), self.results(out))

    def test_a_folder_keeps_to_its_file(self):
        out = self.whole(1)
        again = self.run_campaign("--out", out)
        self.assertEqual(again.returncode, 1)
        self.assertIn("--resume", again.stderr)
        other = self.folder / "other.yaml"
        other.write_text(CAMPAIGN + "control_hz: 20\n")
        changed = self.run_campaign("--out", out, "--resume", file=other)
        self.assertEqual(changed.returncode, 1)
        self.assertIn("another campaign file", changed.stderr)

    def test_the_report_is_whole_and_asks_for_nothing(self):
        out = self.whole(1)
        page = Page()
        page.feed((out / "report.html").read_text())
        page.close()
        self.assertEqual(page.wrong, [])
        self.assertEqual(page.open, [])
        self.assertEqual(page.asked, [])
        ids = self.must_run("--plan").stdout.split()
        self.assertEqual(len(ids), TRIALS)
        for trial in ids:
            self.assertIn(trial, page.text)

    def test_tables_agree_with_each_other_and_with_the_track(self):
        out = self.whole(1)
        with open(out / "trials.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), TRIALS)
        groups = json.loads((out / "summary.json").read_text())["groups"]
        everything = next(group for group in groups if group["by"] == "all")
        self.assertEqual(everything["trials"], TRIALS)
        shares = sum(float(row["success"]) for row in rows) / TRIALS
        self.assertAlmostEqual(everything["success_share"], shares)
        self.assertGreater(shares, 0.0)
        track = self.folder / "track.csv"
        self.must_run("--out", out, "--only", rows[0]["id"], "--track", track)
        with open(track, newline="") as file:
            samples = [{key: float(value) for key, value in row.items()}
                       for row in csv.DictReader(file)]
        places = [(sample["x_m"], sample["y_m"], sample["z_m"]) for sample in samples]
        self.assertAlmostEqual(sum(map(math.dist, places, places[1:])),
                               float(rows[0]["driven_m"]), 6)
        self.assertAlmostEqual(samples[-1]["time_s"], float(rows[0]["time_s"]), 9)

    def test_a_full_disk_is_told(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        run = self.run_campaign("--out", self.folder / "full", "--workers", 1, preexec_fn=limit)
        self.assertEqual(run.returncode, 1)
        self.assertIn("File too large", run.stderr)
        out = self.folder / "full"
        self.assertEqual(list((out / "trials").iterdir()), [])
        self.must_run("--out", out, "--resume")  # once there is room
        self.assertEqual(self.results(self.whole(1)), self.results(out))

    def test_worlds_without_such_tasks_are_errors_and_others_go_on(self):
        file = self.folder / "far.yaml"
        file.write_text(CAMPAIGN.replace("[10, 30]", "[500, 900]"))
        out = self.folder / "far"
        run = self.run_campaign("--out", out, "--workers", 2, file=file)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(out / "trials.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([row["outcome"] for row in rows], ["error"] * TRIALS)
        self.assertIn("length", rows[0]["why"])

    def test_bad_arguments_and_files_are_told(self):
        bad = self.folder / "bad.yaml"
        bad.write_text("name: x\nworlds: []\nspeed: 3\n")
        run = self.run_campaign("--check", file=bad)
        self.assertEqual(run.returncode, 2)
        self.assertIn("line 3: /speed", run.stderr)
        self.assertIn("line 2: /worlds", run.stderr)
        for arguments in (["--shard", "3/3", "--out", "x"], ["--shard", "a", "--out", "x"],
                          ["--workers", "0", "--out", "x"], [], ["--check", "--plan"]):
            self.assertEqual(self.run_campaign(*arguments).returncode, 2, arguments)
        unknown = self.run_campaign("--out", self.whole(1), "--only", "nobody")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("nobody", unknown.stderr)
        missing = self.run_campaign("--check", file=self.folder / "none.yaml")
        self.assertEqual(missing.returncode, 1)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
