#!/usr/bin/env python3
"""Runs `latticeworld dataset` as a person does, and reads what it writes with other people's tools."""

import contextlib
import hashlib
import json
import pathlib
import re
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy
import pandas
import PIL.Image
import yaml

SERVER = pathlib.Path(__file__).with_name("answering_server.py")
PLACES = 120  # of the data sets of generated places: three parts
OUTAGE_SEED = 0  # of places whose written words the remote annotator takes as they are


def files_of(folder):
    """SHA-256 of every file, by path."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*")) if path.is_file()}


def instruction_of(record, what="place"):
    """What a person would have said of a place or an environment, out of a record's user message."""
    return record["messages"][-2]["content"].split(f"Description of the {what}:\n")[1].split("\n\n")[0]


class DatasetProgramTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def command(self, out, *arguments):
        return [PROGRAM, "dataset", "--out", str(self.folder / out), *map(str, arguments)]

    def run_dataset(self, out, *arguments, **options):
        return subprocess.run(self.command(out, *arguments), capture_output=True, text=True,
                              check=False, **options)

    def must_run(self, out, *arguments):
        run = self.run_dataset(out, *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    @contextlib.contextmanager
    def server(self, answers, *more):
        """A scripted server: its URL, and the requests that it had, a list that is filled when it is gone."""
        given, asked, requests = self.folder / "answers.json", self.folder / "requests.jsonl", []
        given.write_text(json.dumps(answers))
        asked.write_text("")
        with subprocess.Popen([sys.executable, SERVER, given, asked, *map(str, more)], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, text=True) as process:
            watch = threading.Timer(60, process.kill)
            watch.start()
            yield f"http://127.0.0.1:{process.stdout.readline().strip()}/v1", requests
            process.stdin.close()
            process.wait()
            watch.cancel()
        requests += [json.loads(line) for line in asked.read_text().splitlines()]

    def records(self, out, task, split="train"):
        lines = (self.folder / out / task / f"{split}.jsonl").read_text().splitlines()
        return [json.loads(line) for line in lines]

    def test_pandas_reads_it_and_the_card_lists_it(self):
        run = self.must_run("set", "--generate", PLACES, "--seed", 3)
        self.assertIn(f"{PLACES} instances, {PLACES} records for layout", run.stdout)
        self.assertRegex(run.stderr, r"120 of 120 groups, \d+ a second, 0:00:00 left")
        manifest = json.loads((self.folder / "set/dataset.json").read_text())
        card = (self.folder / "set/README.md").read_text().split("---\n")
        front = yaml.safe_load(card[1])
        self.assertEqual(front["license"], "bsd-3-clause")
        told = {file["path"]: file for file in manifest["files"]}
        listed = {file["path"] for config in front["configs"] for file in config["data_files"]}
        self.assertEqual(listed, set(told))
        names = {}
        for path, file in told.items():
            table = pandas.read_json(self.folder / "set" / path, lines=True)
            self.assertEqual(len(table), file["records"])
            self.assertFalse(table[["id", "group", "vocabulary", "messages"]].isna().any(axis=None))
            for record in table.itertuples():
                self.assertEqual([message["role"] for message in record.messages][-2:],
                                 ["user", "assistant"])
                names.setdefault(record.group, set()).add(file["split"])
                if file["task"] == "layout":
                    rows = record.messages[-1]["content"].split("\n")
                    self.assertEqual([len(row) for row in rows], [32] * 32)
                elif file["task"] == "environment":
                    self.assertIn("coarse", json.loads(record.messages[-1]["content"]))
                self.assertFalse(any("<image>" in message["content"] for message in record.messages))
                kinds = ("height",) if file["task"] == "relief" else ("height", "sketch")
                if record.images:
                    self.assertRegex(" ".join(record.images),
                                     "^" + " ".join(rf"images/\d{{6}}/{record.id}-{kind}\.png" for kind in kinds) + "$")
                for image in record.images:
                    with PIL.Image.open(self.folder / "set" / image) as picture:
                        self.assertEqual(picture.size, (129, 129))
        self.assertTrue(all(len(splits) == 1 for splits in names.values()))
        subprocess.run(["sha256sum", "--quiet", "-c", "images.sha256"], cwd=self.folder / "set",
                       check=True)

    def test_instructions_say_as_much_as_is_asked_for(self):
        places = ("--generate", 40, "--layout", "--no-images")
        lengths = {}
        for facts in ("1,2", "9,12"):
            self.must_run(facts, *places, "--facts", facts)
            lengths[facts] = [len(json.loads(record["claims"])) for record in self.records(facts, "layout")]
        self.assertLess(2 * sum(lengths["1,2"]), sum(lengths["9,12"]))
        self.assertLess(max(lengths["1,2"]), max(lengths["9,12"]))
        run = self.run_dataset("1,2", *places, "--resume")
        self.assertNotEqual(run.returncode, 0, "it went on with an instruction of another kind")
        for facts, told in (("0,4", "facts"), ("5,4", "facts"), ("2.5,4", "whole"), ("3", "two")):
            run = self.run_dataset("no", *places, "--facts", facts)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertRegex(run.stderr, f"--facts.*{told}|--facts.*{facts}")

    def test_environments_that_were_asked_for(self):
        asked = self.folder / "asked.json"
        asked.write_text(json.dumps([
            {"id": "eagles", "vocabulary": "suburb", "instruction": "Snow at night. Four eagles circle in the west."},
            {"id": "other", "vocabulary": "wild", "instruction": "A foggy spring morning, and one goblin."}]))
        arguments = ("--environment-instructions", asked, "--environment", "--no-images", "--answers", 3,
                     "--split", "1,0")
        self.must_run("asked", *arguments)
        records = self.records("asked", "environment")
        self.assertEqual(len(records), 6)
        for record in records:
            self.assertIn("Snow at night" if record["group"] == "eagles" else "foggy",
                          record["messages"][-2]["content"])
            answer = json.loads(record["messages"][-1]["content"])
            if record["group"] != "eagles":
                continue
            self.assertEqual((answer["coarse"]["weather"], answer["coarse"]["time_of_day"]), ("snow", "night"))
            self.assertIn({"category": "eagle", "quantity": 4, "state": "flying", "position": "middle left"},
                          answer["agents"])
        for wrong, told in ((("--generate", 3), "conflict|one of"), (("--remote-url", "http://127.0.0.1:1"), "annotator")):
            run = self.run_dataset("no", *arguments, *wrong)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertRegex(run.stderr, told)
        run = self.run_dataset("no", "--generate", 3, "--answers", 3)
        self.assertEqual(run.returncode, 2, run.stderr)

    def test_killed_again_and_again_it_ends_with_the_same_bytes(self):
        arguments = ("--generate", PLACES, "--threads", 1)
        self.must_run("whole", *arguments)
        for kill in range(2):
            process = subprocess.Popen(
                self.command("killed", *arguments, *(["--resume"] if kill else [])),
                stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
            for line in process.stderr:  # on one thread a part is whole before the next begins
                if int(re.search(r"(\d+) of", line).group(1)) > 50 * (kill + 1):
                    break
            process.send_signal(signal.SIGKILL)
            self.assertEqual(process.wait(), -signal.SIGKILL, "it was not killed in the middle")
            process.stderr.close()
            self.assertFalse((self.folder / "killed/dataset.json").exists())
        run = self.run_dataset("killed", *arguments)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("--resume goes on with it", run.stderr)
        run = self.must_run("killed", *arguments, "--resume")
        self.assertRegex(run.stderr, r"(?m)^\W*(50|100) of 120 groups")
        self.assertEqual(files_of(self.folder / "killed"), files_of(self.folder / "whole"))

    def test_on_a_full_disk_it_says_so_and_goes_on_later(self):
        arguments = ("--generate", 60, "--no-images")
        self.must_run("whole", *arguments)

        def fill():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, 300_000))

        run = self.run_dataset("full", *arguments, preexec_fn=fill)
        self.assertNotEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"cannot write .*/full/parts/00000.: File too large")
        self.assertEqual([], [path for path in (self.folder / "full").rglob("*")
                              if path.is_file() and path.stat().st_size >= 300_000])
        self.assertFalse((self.folder / "full/dataset.json").exists())
        self.must_run("full", *arguments, "--resume")
        self.assertEqual(files_of(self.folder / "full"), files_of(self.folder / "whole"))

    def test_loveda_is_turned_and_what_is_broken_is_told(self):
        base = self.folder / "loveda/Train/Rural"
        (base / "images_png").mkdir(parents=True)
        (base / "masks_png").mkdir()
        for number in range(6):
            random = numpy.random.default_rng(number)
            mask = random.integers(1, 8, (8, 8), dtype=numpy.uint8).repeat(32, 0).repeat(32, 1)
            if number == 3:
                mask[5, 7] = 9
            PIL.Image.new("RGB", (256, 256)).save(base / f"images_png/{number}.png")
            PIL.Image.fromarray(mask).save(base / f"masks_png/{number}.png")
        (base / "masks_png/4.png").write_bytes(b"no picture")
        (base / "masks_png/5.png").unlink()
        run = self.must_run("set", "--loveda", self.folder / "loveda", "--split", "1,0")
        self.assertIn("12 instances", run.stdout)
        self.assertIn("3 left out", run.stdout)
        reasons = {entry["group"]: entry["reason"] for entry in
                   json.loads((self.folder / "set/dataset.json").read_text())["failed"]}
        self.assertEqual(len(reasons), 3)
        for number in (3, 4, 5):
            self.assertTrue(any(f"{number}.png" in reason for reason in reasons.values()), reasons)
        turns = {}
        for record in self.records("set", "layout"):
            rows = record["messages"][-1]["content"].split("\n")
            turns.setdefault(record["group"], []).append(numpy.array([list(row) for row in rows]))
        self.assertEqual(len(turns), 3)
        for layouts in turns.values():
            for quarter, layout in enumerate(layouts):
                self.assertTrue((numpy.rot90(layouts[0], quarter) == layout).all())
        card = (self.folder / "set/README.md").read_text()
        self.assertIn("CC-BY-NC-SA-4.0", card)
        self.assertIn("## Left out", card)

    def test_scenes_are_cut_into_tiles(self):
        scene = self.folder / "scenes/scenes/valley"
        scene.mkdir(parents=True)
        across, down = numpy.meshgrid(numpy.arange(1030), numpy.arange(520))
        heights = (1000 + across + 60 * numpy.sin(down / 40)).astype(numpy.uint16)
        PIL.Image.fromarray(heights).save(scene / "heights.png")
        subprocess.run(["gdal_translate", "-q", "-ot", "Float32", "-a_srs", "EPSG:32613", "-a_ullr",
                        "0", "1040", "2060", "0", scene / "heights.png", scene / "elevation.tif"],
                       check=True)
        classes = numpy.where(across > 500 + 200 * numpy.sin(down / 90), 2, 1).astype(numpy.uint8)
        PIL.Image.fromarray(classes).save(scene / "segmentation.png")
        (self.folder / "scenes/classes.json").write_text(json.dumps(
            {"vocabulary": "wild", "values": {"1": "F", "2": "R"}}))
        run = self.must_run("set", "--scenes", self.folder / "scenes", "--split", "1,0")
        self.assertIn("2 instances", run.stdout)
        self.assertIn("2 records for relief", run.stdout)
        for record in self.records("set", "layout"):
            with PIL.Image.open(self.folder / "set" / record["images"][0]) as picture:
                self.assertEqual(picture.size, (512, 512))

    def test_a_models_untrue_words_go_back_to_it(self):
        self.must_run("written", "--generate", 1, "--layout", "--split", "1,0")
        written = self.records("written", "layout")[0]
        largest = max(written["messages"][-1]["content"].replace("\n", ""),
                      key=written["messages"][-1]["content"].count)
        names = {"A": "farmland", "B": "buildings", "D": "barren land", "F": "forest",
                 "G": "grassland", "R": "roads", "W": "water", "S": "snow"}
        if written["vocabulary"] == "wild":
            names.update({"B": "low bushes", "R": "rocky land"})
        false = f"There is no {names[largest]} anywhere. {instruction_of(written)}"
        with self.server([false, instruction_of(written)]) as (url, requests):
            run = self.must_run("remote", "--generate", 1, "--layout", "--split", "1,0",
                                "--annotator", "remote", "--remote-url", url)
        self.assertIn("1 instances", run.stdout)
        self.assertEqual(instruction_of(self.records("remote", "layout")[0]),
                         instruction_of(written))
        self.assertEqual(len(requests), 2)
        self.assertIn("you wrote", requests[1]["messages"][-1]["content"])
        # Nobody answers any more: nothing counts, and the work can be gone on with.
        run = self.run_dataset("gone", "--generate", 1, "--annotator", "remote", "--remote-url", url)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("no connection", run.stderr)
        self.assertFalse((self.folder / "gone/dataset.json").exists())

    def test_a_server_that_goes_away_loses_little_and_is_gone_on_with_when_it_is_back(self):
        places = ("--generate", 12, "--seed", OUTAGE_SEED, "--threads", 1, "--split", "1,0")
        self.must_run("written", *places)
        answers = {}
        for layout, environment in zip(self.records("written", "layout"), self.records("written", "environment")):
            instruction = instruction_of(layout)
            answers[layout["messages"][-1]["content"]] = instruction
            answers[instruction] = instruction_of(environment, "environment")
        # The port stays the test's own while no server listens on it.
        with socket.socket() as held:
            held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            held.bind(("127.0.0.1", 0))
            port = held.getsockname()[1]
            arguments = (*places, "--annotator", "remote", "--remote-url", f"http://127.0.0.1:{port}/v1")
            with self.server(answers, port) as (_, whole):
                run = self.must_run("whole", *arguments)
            self.assertIn("12 instances, 12 records for layout, 12 records for environment", run.stdout)
            self.assertEqual(len(whole), 24)

            with self.server(answers, port, 17) as (_, before):
                run = self.run_dataset("broken", *arguments)
            self.assertEqual(run.returncode, 1)
            self.assertRegex(run.stderr, r"latticeworld dataset: generated-\S+: .*no connection.*; "
                                         "what is whole stays, and --resume goes on with it")
            self.assertFalse((self.folder / "broken/dataset.json").exists())
            self.assertEqual(before, whole[:17])
            with self.server(answers, port) as (_, after):
                run = self.must_run("broken", *arguments, "--resume")
        self.assertEqual(after, whole[10:], "five groups are kept, seven are asked for")
        self.assertEqual(files_of(self.folder / "broken"), files_of(self.folder / "whole"))

    def test_no_place_of_this_machine_is_told(self):
        asked = self.folder / "asked.json"
        for task, instruction in (("layout", "A lake in the north."), ("environment", "Snow at night.")):
            with self.subTest(task):
                source = "--instructions" if task == "layout" else "--environment-instructions"
                asked.write_text(json.dumps([{"id": "one", "vocabulary": "suburb", "instruction": instruction}]))
                self.must_run(task, source, asked, f"--{task}", "--no-images", "--answers", 1, "--split", "1,0")
                self.assertEqual(len(self.records(task, task)), 1)
                told = {path: path.read_text() for path in (self.folder / task).rglob("*") if path.is_file()}
                self.assertIn(f"{source} FILE", told[self.folder / task / "README.md"])
                self.assertEqual([], [path for path, text in told.items() if str(self.folder) in text])

    def test_what_cannot_be_asked_for_is_named(self):
        for arguments, words in [
                ((), "a source is missing"),
                (("--generate", 0), "--generate"),
                (("--generate", 2, "--loveda", "x"), "--loveda"),
                (("--generate", 2, "--erosion", 0.1), "--scenes"),
                (("--generate", 2, "--relief-share", 2), "--relief-share: must be from 0 to 1"),
                (("--scenes", "x", "--erosion", 3), "--erosion: must be from 0 to 0.5"),
                (("--generate", 2, "--layout", "--environment"), "--environment"),
                (("--generate", 2, "--split", "0.9,0.2"), "--split"),
                (("--generate", 2, "--annotator", "remote"), "--remote-url"),
                (("--generate", 2, "--prompts", "long"), "full, short"),
                (("--loveda", self.folder / "nowhere"), "nowhere"),
                (("--scenes", self.folder), str(self.folder))]:
            with self.subTest(arguments=arguments):
                run = self.run_dataset("bad", *arguments)
                self.assertNotEqual(run.returncode, 0)
                self.assertIn(words, run.stderr)
                self.assertFalse((self.folder / "bad").exists())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
