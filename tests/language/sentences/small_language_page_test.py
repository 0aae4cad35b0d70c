"""docs/small_language.md has the tables of the program, and Python's reading of them agrees on every example."""

import os
import pathlib
import unittest

from latticeworld_training import small_language

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])


class SmallLanguagePageTest(unittest.TestCase):
    def test_the_page_has_the_tables(self):
        text = (ROOT / "docs/small_language.md").read_text(encoding="utf-8")
        self.assertTrue(text.endswith(small_language.page()),
                        "make the tables anew: cd training && python3 -m latticeworld_training.small_language")

    def test_every_example_has_its_form(self):
        for kind in ("layout", "environment"):
            for name, _, example in small_language.forms(kind):
                self.assertEqual(small_language.form_of(example.rstrip("."), kind), name, example)

    def test_what_is_no_sentence_has_none(self):
        for text in ("", "A lake lake", "Lovely weather", "A lake in north"):
            self.assertIsNone(small_language.form_of(text, "layout"), text)


if __name__ == "__main__":
    unittest.main()
