#!/usr/bin/python3
"""Descriptions said in the same manner of other things."""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

from latticeworld_training import vary_descriptions

DESCRIPTION = "Six sheep graze in the North-West. A sheep rests; 12 goblins patrol at 17:30, 5 m/s, 40 % fog. SIX more."


class VaryDescriptionsTest(unittest.TestCase):
    def texts(self):
        return [vary_descriptions.varied(DESCRIPTION, random.Random(seed)) for seed in range(200)]

    def test_words_change_and_the_manner_stays(self):
        shape = re.compile(r"^[A-Z][a-z]+ [a-z ]+ in the [A-Z][a-z]+-[A-Z][a-z]+\. A [a-z ]+; \d+ [a-z ]+ at 17:30, "
                           r"5 m/s, 40 % [a-z]+\. [A-Z]+ more\.$")
        for text in self.texts():
            self.assertRegex(text, shape)
        self.assertGreater(len(set(self.texts())), 150)

    def test_the_same_word_becomes_the_same_word(self):
        for text in self.texts():
            first, last = text.split()[0], text.split()[-2]
            self.assertEqual(first.upper(), last)
            one = re.search(r"; \d+ ([a-z ]+?) (?:patrol|attack|hunt|rest|wait|wander|graze) at", text)[1]
            many = re.match(r"[A-Z][a-z]+ ([a-z ]+?) (?:patrol|attack|hunt|rest|wait|wander|graze) in", text)[1]
            self.assertNotEqual(one, many, text)

    def test_singular_and_plural_go_together(self):
        both = "A sheep and an eagle; eagles and sheep."
        for seed in range(50):
            one, other, others, ones = re.match("A (.+) and an (.+); (.+) and (.+)\\.",
                                                vary_descriptions.varied(both, random.Random(seed))).groups()
            self.assertIn(ones, (one, one + "s"))
            self.assertIn(others, (other, other + "s"))

    def test_the_program_leaves_out_what_is_left_out(self):
        given = [{"id": f"e{i}", "vocabulary": "suburb", "voice": "plain", "instruction": f"{word} eagles in winter.", "claims": [{}]}
                 for i, word in enumerate(("Two", "Three", "Some", "Nine"))]
        with tempfile.TemporaryDirectory() as directory:
            file, out = pathlib.Path(directory, "given.json"), pathlib.Path(directory, "varied.json")
            file.write_text(json.dumps(given), encoding="utf-8")
            command = [sys.executable, "-m", "latticeworld_training.vary_descriptions", str(file), "--times", "5",
                       "--leave-out", "2", "--out", str(out)]
            subprocess.run(command, check=True, env=os.environ, capture_output=True)
            made = json.loads(out.read_text(encoding="utf-8"))
            subprocess.run(command, check=True, env=os.environ, capture_output=True)
            self.assertEqual(made, json.loads(out.read_text(encoding="utf-8")))
        self.assertEqual({one["id"].split("-")[0] for one in made}, {"e1", "e3"})
        self.assertEqual(len({one["instruction"] for one in made}), len(made))
        self.assertGreater(len(made), 6)
        self.assertEqual({one["instruction"].count(".") for one in made}, {1, 2}, "some with a sentence of another")
        self.assertTrue(all(not one["claims"] for one in made), "what was claimed of the original")


if __name__ == "__main__":
    unittest.main()
