"""vision_training as a person runs it: killed in the middle of each stage and started again, it ends as if it had never
been, and what it made is exported by one command."""

import hashlib
import os
import signal
import subprocess
import sys
import tempfile
import unittest

import tiny_lands
import torch
from latticeworld_training import checkpoint, export_eyes, export_gguf, train_language_model

STAGES = ["contrast", "align", "together"]
STEPS = 6  # of each stage: 16 pictures, 8 at once, 3 epochs; a checkpoint after every second one

# The program, which kills itself at a moment: "step" after so many steps of the optimizer, "saving" when so many
# checkpoints are written but not yet in place, "saved" when the last of them is in place and nothing else is done.
KILLED = """
import os, signal, sys
import torch
from latticeworld_training import vision_training

moment, left = sys.argv[1], int(sys.argv[2])

def count():
    global left
    left -= 1
    if left == 0:
        os.kill(os.getpid(), signal.SIGKILL)

def replace(source, target, replace=os.replace):
    saves = target.endswith("checkpoint.pt")
    if saves and moment == "saving":
        count()
    replace(source, target)
    if saves and moment == "saved":
        count()

class AdamW(torch.optim.AdamW):
    def step(self):
        super().step()
        if moment == "step":
            count()

os.replace = replace
torch.optim.AdamW = AdamW
vision_training.main(sys.argv[3:])
"""


class VisionProgramTest(unittest.TestCase):
    def setUp(self):
        torch.set_num_threads(1)
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        self.set = os.path.join(self.folder, "set")
        self.language_model = os.path.join(self.folder, "language")

    def write_set(self):
        for task, said_of in (("relief", tiny_lands.caption_of), ("layout", tiny_lands.layout_of)):
            for split, count, seed in (("train", 16, 0), ("validation", 4, 16)):
                tiny_lands.write_split(self.set, task, split, count, seed, said_of)

    def train_language_model(self):
        data = os.path.join(self.set, "relief", "train.jsonl")
        arguments = ["--data", data, "--out", self.language_model, "--most-words", "60", "--most-steps", "2"]
        arguments += ["--width", "32", "--layers", "1", "--heads", "2", "--kv-heads", "2", "--hidden", "32"]
        arguments += ["--context", "128"]
        train_language_model.main(arguments)

    def arguments(self, out):
        arguments = ["--data", self.set, "--language-model", self.language_model, "--out", self.out(out)]
        arguments += ["--side", "16", "--batch-size", "8", "--checkpoint-steps", "2"]
        for stage in STAGES:
            arguments += [f"--{stage}-epochs", "3"]
        return arguments

    def out(self, name, *parts):
        return os.path.join(self.folder, name, *parts)

    def run_python(self, *arguments, status=0):
        done = subprocess.run([sys.executable, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        self.assertEqual(done.returncode, status, done.stdout)
        return done.stdout

    def train(self, out):
        return self.run_python("-m", "latticeworld_training.vision_training", *self.arguments(out))

    def train_killed(self, out, moment, count):
        return self.run_python("-c", KILLED, moment, str(count), *self.arguments(out), status=-signal.SIGKILL)

    def steps_done(self, out):
        """By stage, what its checkpoint says."""
        paths = {stage: self.out(out, stage, "checkpoint.pt") for stage in STAGES}
        return {stage: checkpoint.read_checkpoint(path)["rest"]["step"]
                for stage, path in paths.items() if os.path.exists(path)}

    def file_of(self, *path):
        with open(self.out(*path), "rb") as file:
            return file.read()

    def digest_of(self, *path):
        return hashlib.sha256(self.file_of(*path)).hexdigest()

    def expect_equal_runs(self, one, other):
        for stage in STAGES:
            with self.subTest(stage):
                self.assertEqual(self.file_of(one, stage, "loss.csv"), self.file_of(other, stage, "loss.csv"))
                ours, others = (checkpoint.read_checkpoint(self.out(run, stage, "checkpoint.pt"))["model"]
                                for run in (one, other))
                self.assertEqual(list(ours), list(others))
                for name, weights in ours.items():
                    self.assertTrue(torch.equal(weights, others[name]), name)

    def export(self, run):
        model = self.out(run + ".gguf")
        export_gguf.main([self.language_model, "--vision", self.out(run), "--type", "f32", "--out", model])
        return [self.digest_of(path) for path in (model, export_eyes.eyes_path(model))]

    def test_killed_in_every_stage_it_ends_as_if_it_had_never_been(self):
        self.write_set()
        self.train_language_model()
        self.train("whole")
        self.assertEqual(self.steps_done("whole"), {stage: STEPS for stage in STAGES})
        for stage in STAGES:
            lines = self.file_of("whole", stage, "loss.csv").decode().splitlines()
            self.assertEqual([line.split(",")[0] for line in lines], ["step", "2", "4", "6"])

        # Two checkpoints of the first stage are there, and a step after them is lost.
        self.train_killed("killed", "step", 5)
        self.assertEqual(self.steps_done("killed"), {"contrast": 4})
        # Of the second stage, one; it had no time to write more.
        said = self.train_killed("killed", "saved", 2)
        self.assertIn("goes on at step 4", said)
        self.assertEqual(self.steps_done("killed"), {"contrast": STEPS, "align": 2})
        # Of the third stage one, and the second is half written.
        said = self.train_killed("killed", "saving", 4)
        self.assertIn("goes on at step 2", said)
        self.assertEqual(self.steps_done("killed"), {"contrast": STEPS, "align": STEPS, "together": 2})
        self.assertEqual(self.train("killed").count("goes on at step"), 3)
        self.expect_equal_runs("whole", "killed")
        self.assertEqual(self.export("whole"), self.export("killed"))

        # What is whole stays, to the bit.
        files = [(stage, name) for stage in STAGES for name in ("checkpoint.pt", "loss.csv")]
        before = [self.digest_of("killed", *file) for file in files]
        self.train("killed")
        self.assertEqual(before, [self.digest_of("killed", *file) for file in files])

    def test_what_there_is_nothing_to_learn_from_is_named(self):
        for task in ("relief", "layout"):
            with self.subTest(task):
                self.run_without(task)

    def test_a_model_of_hugging_face_is_refused(self):
        self.write_set()
        os.makedirs(self.language_model)
        for name in ("config.json", "tokenizer.json"):
            with open(os.path.join(self.language_model, name), "w", encoding="utf-8") as file:
                file.write("{}")
        said = self.run_python("-m", "latticeworld_training.vision_training", *self.arguments("out"), status=2)
        self.assertIn(f"{self.language_model} is no run of train_language_model", said)
        self.assertFalse(os.path.exists(self.out("out")))

    def run_without(self, task):
        self.write_set()
        self.train_language_model()
        os.remove(os.path.join(self.set, task, "train.jsonl"))
        said = self.run_python("-m", "latticeworld_training.vision_training", *self.arguments("out"), status=2)
        self.assertIn(os.path.join(self.set, task, "train.jsonl") + ": no record with a height map", said)
        self.assertFalse(os.path.exists(self.out("out")))


if __name__ == "__main__":
    unittest.main()
