"""scripts/score_paraphrases.py: its changes, and what it counts with the real program on a small benchmark.

LATTICEWORLD_PROGRAM: latticeworld. LATTICEWORLD_ROOT: the sources.
"""

import contextlib
import io
import json
import os
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.environ["LATTICEWORLD_ROOT"], "scripts"))
import score_paraphrases

LAYOUTS = [
    {"id": "X1", "vocabulary": "suburb", "voice": "plain", "instruction": "A lake in the north. A forest.",
     "claims": [{"kind": "present", "subject": "W", "words": "A lake"},
                {"kind": "present", "subject": "F", "words": "A forest"}]},
    {"id": "X2", "vocabulary": "suburb", "voice": "plain", "instruction": "Nothing that is claimed.",
     "claims": [{"kind": "amount", "subject": "D", "least": 0.99, "words": "claimed"}]},
]
ENVIRONMENT = {
    "id": "X3", "layout": "field", "vocabulary": "suburb", "voice": "plain", "instruction": "It rains.",
    "claims": [{"kind": "coarse", "attribute": "weather", "values": ["rain"], "words": "rains"}],
}


class ChangesTest(unittest.TestCase):
    def test_say_the_same_in_other_words(self):
        for name, before, after in (
            ("lower", "A Lake.", "a lake."),
            ("picture words", "In the north-west, west of the SOUTHERN lake", "In the top left, left of the LOWER lake"),
            ("compass", "Top left: a lake right at the bottom edge, trees at the top",
             "North-west: a lake right at the southern edge, trees in the north"),
            ("abbreviations", "in the south-east and Northwest", "in the SE and NW"),
            ("hyphens in corners", "southwest", "south-west"),
            ("commas for stops", "A lake. A forest. 2 m.", "A lake, a forest. 2 m."),
            ("digits", "Two lakes, one of ten, twenty-two", "2 lakes, one of 10, twenty-two"),
            ("words for digits", "2. 3 ponds, 5 %, 1.5 m", "2. three ponds, 5 %, 1.5 m"),
            ("the rest", "Everything else is grass, or the rest", "The rest is grass, or the rest"),
            ("roads", "Roads and a broad road", "Lanes and a broad lane"),
        ):
            self.assertEqual(score_paraphrases.CHANGES[name](before), after, name)

    def test_typing_mistakes_swap_letters_within_words_and_are_always_the_same(self):
        text = "meadows villages mountains forests northern southern"
        changed = score_paraphrases.with_typing_mistakes(text)
        self.assertNotEqual(changed, text)
        self.assertEqual(changed, score_paraphrases.with_typing_mistakes(text))
        for old, new in zip(text.split(), changed.split()):
            self.assertEqual((sorted(old), old[0], old[-1]), (sorted(new), new[0], new[-1]))


class ScriptTest(unittest.TestCase):
    def run_script(self, *arguments):
        with tempfile.TemporaryDirectory() as directory:
            os.mkdir(os.path.join(directory, "layouts"))
            with open(os.path.join(directory, "layouts", "field.txt"), "w", encoding="utf-8") as file:
                file.write((32 * "G" + "\n") * 32)
            for kind, items in (("layout", LAYOUTS), ("environment", [ENVIRONMENT])):
                with open(os.path.join(directory, kind + "_development.json"), "w", encoding="utf-8") as file:
                    json.dump(items, file)
            command = ["score_paraphrases.py", "--program", os.environ["LATTICEWORLD_PROGRAM"], "--benchmark", directory]
            said = io.StringIO()
            with mock.patch.object(sys, "argv", command + list(arguments)), contextlib.redirect_stdout(said):
                score_paraphrases.main()
        return [line.split() for line in said.getvalue().splitlines()]

    def test_counts_the_claims_that_a_change_loses(self):
        # X2's claim never held, so that no change loses it.
        forgetting = {"forgetting": lambda text: text.replace("A lake", "Land").replace("rains", "is"), "lower": str.lower}
        with mock.patch.object(score_paraphrases, "CHANGES", forgetting):
            lines = self.run_script("--misses")
        self.assertEqual(lines[1], ["forgetting", "2", "3", "2"])
        self.assertEqual([line[:2] for line in lines[2:6:2]], [["X1", "present:"], ["X3", "coarse:"]])
        self.assertEqual(lines[-1], ["lower", "3", "4", "0"])

    def test_an_unknown_change_is_named(self):
        error = io.StringIO()
        with self.assertRaises(SystemExit), contextlib.redirect_stderr(error):
            self.run_script("lowr")
        self.assertIn("'lowr' is no change; legal are no full stop, lower", error.getvalue())


if __name__ == "__main__":
    unittest.main()
