"""scripts/compare_models.py on a small benchmark with the real program.

LATTICEWORLD_PROGRAM: latticeworld. LATTICEWORLD_ROOT: the sources.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import tiny_talks
import torch
from latticeworld_training import export_gguf, llama

ROOT = os.environ["LATTICEWORLD_ROOT"]
SCRIPT = os.path.join(ROOT, "scripts", "compare_models.py")
LAYOUT = {
    "id": "X1",
    "vocabulary": "suburb",
    "voice": "plain",
    "instruction": "A lake in the north.",
    "claims": [{"kind": "present", "subject": "W", "words": "A lake"}],
}
ENVIRONMENT = {
    "id": "X2",
    "layout": "field",
    "vocabulary": "suburb",
    "voice": "plain",
    "instruction": "It rains.",
    "claims": [{"kind": "coarse", "attribute": "weather", "values": ["rain"], "words": "rains"}],
}


SAID = [
    {"kind": "layout", "author": "a", "voice": "v", "vocabulary": "suburb", "text": "A lake in the north.",
     "sentences": ["A lake in the north", "No houses"]},
    {"kind": "environment", "author": "a", "voice": "v", "text": "It rains.", "sentences": ["Weather: rain"]},
    {"kind": "environment", "author": "a", "voice": "v", "text": "Of another benchmark.", "sentences": []},
]


class CompareModelsTest(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        os.mkdir(self.path("layouts"))
        with open(self.path("layouts/field.txt"), "w", encoding="utf-8") as file:
            file.write((32 * "G" + "\n") * 32)
        for kind, item in (("layout", LAYOUT), ("environment", ENVIRONMENT)):
            with open(self.path(kind + "_development.json"), "w", encoding="utf-8") as file:
                json.dump([item], file)
        torch.manual_seed(1)
        tokenizer = tiny_talks.tiny_tokenizer()
        sizes = tiny_talks.tiny_sizes(len(tokenizer))
        sizes.context = 2048
        export_gguf.export(llama.Llama(sizes), tokenizer, self.path("tiny.gguf"), "f16", "tiny")

    def path(self, name):
        return os.path.join(self.directory.name, name)

    def run_script(self, *more, said=()):
        command = [sys.executable, SCRIPT, "--program", os.environ["LATTICEWORLD_PROGRAM"]]
        command += ["--benchmark", self.directory.name, "--part", "development", "--out", self.path("models.md")]
        command += ["--said", *said, *more]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)

    def test_one_command_writes_the_table(self):
        done = self.run_script("--local-model", self.path("tiny.gguf"), "--local-environment-model", "grounded")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("models.md"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("| | rules | local |", page)
        # A model that knows nothing draws legal layouts all the same.
        self.assertEqual(page.count("| valid answers | 1 of 1 (1.000) | 1 of 1 (1.000) |"), 2)
        self.assertRegex(page, r"\| present \| 1 of 1 \(1\.000\) \| \d of 1 ")
        self.assertIn("| coarse | 1 of 1 (1.000) | 1 of 1 (1.000) |", page)
        self.assertRegex(page, r"\| local \| [1-9]\d* MB \|")

    def test_what_was_said_by_hand_is_read_as_it_stands_and_what_hands_wrote_is_kept(self):
        with open(self.path("said.jsonl"), "w", encoding="utf-8") as file:
            file.write("".join(json.dumps(example) + "\n" for example in SAID))
        done = self.run_script(said=[self.path("said.jsonl")])
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("models.md"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("| | rules | controlled |", page)
        self.assertIn("1 layouts and 1 environments of the development part", " ".join(page.split()))
        self.assertIn("| coarse | 1 of 1 (1.000) | 1 of 1 (1.000) |", page)
        self.assertNotIn("`local`", page)
        self.assertNotIn("written by hand", page)
        hand = "<!-- What follows is written by hand; scripts/compare_models.py keeps it. -->\n\n## Why\n\nBecause.\n"
        with open(self.path("models.md"), "a", encoding="utf-8") as file:
            file.write("\nOf yesterday.\n\n" + hand)
        self.assertEqual(self.run_script().returncode, 0)
        with open(self.path("models.md"), encoding="utf-8") as file:
            page = file.read()
        self.assertTrue(page.endswith("\n\n" + hand), page)
        self.assertNotIn("Of yesterday", page)
        self.assertNotIn("controlled", page)

    def test_an_unknown_option_is_named(self):
        done = self.run_script("--lcal-model", "x")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--lcal-model", done.stderr)

    def test_a_score_that_fails_is_told_and_nothing_is_written(self):
        done = self.run_script("--local-model", self.path("none.gguf"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("none.gguf", done.stderr)
        self.assertFalse(os.path.exists(self.path("models.md")))


if __name__ == "__main__":
    unittest.main()
