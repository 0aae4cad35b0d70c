#!/usr/bin/env python3
"""Holds comments of headers to sentences that do not begin in mid-air: "Of a hit." tells nobody what
a function does.

Usage: comments_test.py SRC
"""

import pathlib
import re
import sys
import tempfile
import unittest

from floors import sources_below

MID_AIR = re.compile(r"(?:^|[.!?:] )(Of [^.!?]*)")


def paragraphs_of(text):
    """(line, paragraph in one line) of every comment that has lines of its own."""
    paragraph = []
    for number, line in enumerate(text.split("\n"), start=1):
        words = line.strip()
        if words.startswith("//") and words.strip("/ "):
            first = number if not paragraph else first
            paragraph.append(words[2:].strip())
        elif paragraph:
            yield first, " ".join(paragraph)
            paragraph = []
    if paragraph:
        yield first, " ".join(paragraph)


def sentences_in_mid_air(src):
    """A sentence on each comment of a header below `src` that has a sentence beginning with Of."""
    return [f"src/{path}:{line}: \"{found.group(1)}\" begins in mid-air: say who does what"
            for path, text in sources_below(src) if path.endswith(".h")
            for line, paragraph in paragraphs_of(text) for found in MID_AIR.finditer(paragraph)]


class CommentsTest(unittest.TestCase):
    def test_no_sentence_in_a_header_begins_with_of(self):
        found = sentences_in_mid_air(SRC)
        if found:
            self.fail("\n" + "\n".join(found))

    def test_comments_are_read_at_all(self):
        count = sum(1 for path, text in sources_below(SRC) if path.endswith(".h")
                    for _ in paragraphs_of(text))
        self.assertGreater(count, 3000, "is this the source tree?")


class RulesTest(unittest.TestCase):
    """The rule itself, on trees that are made up."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.src = pathlib.Path(folder.name)

    def found_in(self, text, name="a.h"):
        (self.src / name).write_text(text)
        return [sentence.partition(" begins")[0] for sentence in sentences_in_mid_air(self.src)]

    def test_a_comment_that_begins_with_of_is_seen(self):
        self.assertEqual(['src/a.h:2: "Of a hit"'],
                         self.found_in("int a;\n  // Of a hit.\n  int F();\n"))

    def test_a_later_sentence_and_a_later_paragraph_are_seen(self):
        self.assertEqual(['src/a.h:1: "Of two the later counts"'],
                         self.found_in("// Adds a wish. Of two\n// the later counts.\nint F();\n"))
        self.assertEqual(['src/a.h:3: "Of many"'], self.found_in("// Adds.\n//\n// Of many.\n"))

    def test_of_within_a_sentence_is_legal(self):
        self.assertEqual([], self.found_in("// The area\n// of it, e.g. of a lake.\nint F();\n"
                                           "int a = 0;  // Of what F returns\n// Often it is 0.\n"))

    def test_sources_are_left_alone(self):
        self.assertEqual([], self.found_in("// Of a hit.\nint F();\n", name="a.cc"))


if __name__ == "__main__":
    SRC = pathlib.Path(sys.argv.pop(1))
    unittest.main()
