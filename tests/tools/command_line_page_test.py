"""docs/command_line.md is what the program says of its commands and options."""

import os
import pathlib
import sys
import unittest

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])
PROGRAM = os.environ["LATTICEWORLD_PROGRAM"]
sys.path.insert(0, str(ROOT / "scripts"))
import command_line_page

HELP = """Does it.
Usage: latticeworld do [OPTIONS] FILE

Positionals:
  FILE FILE REQUIRED          What is done.
  NAME TEXT ...               Whose.

Options:
  --help                      Tells what there is and ends.
  --short                     At once.
  --longest-of-all-options N  Up to the column.
  --longer-than-there-is-room NUMBER
                              Below it.

"""


class CommandLinePageTest(unittest.TestCase):
    def test_the_page_is_what_the_program_says(self):
        page = (ROOT / "docs/command_line.md").read_text(encoding="utf-8")
        self.assertEqual(command_line_page.page_of(PROGRAM), page, "make it anew: "
                         "scripts/command_line_page.py PROGRAM > docs/command_line.md")

    def test_names_of_every_length_are_read(self):
        self.assertEqual([("--help", "Tells what there is and ends."), ("--short", "At once."),
                          ("--longest-of-all-options N", "Up to the column."),
                          ("--longer-than-there-is-room NUMBER", "Below it.")],
                         command_line_page.entries_of(HELP, "Options"))
        self.assertEqual(["- `FILE` (needed): What is done.", "- `NAME TEXT ...`: Whose."],
                         [command_line_page.item_of(*entry)
                          for entry in command_line_page.entries_of(HELP, "Positionals")])


if __name__ == "__main__":
    unittest.main()
