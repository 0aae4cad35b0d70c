"""scripts/score_sentences.py with the real program on a few examples.

LATTICEWORLD_PROGRAM: latticeworld. LATTICEWORLD_ROOT: the sources.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.join(os.environ["LATTICEWORLD_ROOT"], "scripts", "score_sentences.py")


def layout(*sentences):
    return {"kind": "layout", "author": "a", "voice": "v", "vocabulary": "suburb", "text": "as people say it",
            "sentences": list(sentences)}


class ScoreSentencesTest(unittest.TestCase):
    def score(self, *examples):
        with tempfile.NamedTemporaryFile("w", suffix=".jsonl", encoding="utf-8") as file:
            file.write("".join(json.dumps(example) + "\n" for example in examples))
            file.flush()
            done = subprocess.run([sys.executable, SCRIPT, "--program", os.environ["LATTICEWORLD_PROGRAM"], "--list",
                                   file.name], stdout=subprocess.PIPE, text=True, check=True)
        return done.stdout

    def test_pairs_count_whose_sentences_hold_and_those_that_cannot_are_listed(self):
        said = self.score(layout("A lake in the north", "Forest surrounds the lake"), layout("No water"),
                          layout("Forest covers 90 % of the map", "Farmland covers 90 % of the map"),
                          {"kind": "environment", "author": "a", "voice": "v", "text": "rain", "sentences": ["Weather: rain"]})
        lines = said.splitlines()
        self.assertEqual(lines[1].split()[:4], ["layouts", "3", "2", "0.667"], said)
        self.assertRegex(lines[2], r":3 Forest covers 90 % of the map\. Farmland covers 90 % of the map\.$")
        self.assertRegex(lines[3], r'^      missed: amount: "')
        self.assertEqual(lines[-1].split(), ["environments", "1", "1", "1.000", "1", "1", "1.000", "0"], said)

    def test_what_is_warned_of_is_listed(self):
        said = self.score(layout("Forest in the south", "No forest in the south"))
        self.assertIn("warned: ", said)
        self.assertIn("cannot both be", said)


if __name__ == "__main__":
    unittest.main()
