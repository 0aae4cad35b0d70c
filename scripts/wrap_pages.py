#!/usr/bin/env python3
"""Wraps the prose of Markdown pages at 100 columns. Tables, code, headings and pictures stay as they
are, and so does what a page has behind two spaces at a line's end.

Usage: wrap_pages.py [--check] PAGE ...   (--check: only names the lines that are too long)
"""

import pathlib
import re
import sys
import textwrap

WIDTH = 100
NO_PROSE = re.compile(r"\||    |\t|#|!|>|<|\[[^]]+\]:")
ITEM = re.compile(r"^(\s*)(?:[-*+]|\d+\.) +")


def is_prose(line):
    """Whether a line may be wrapped: not of a table, code, heading, picture, quotation,
    HTML or list of links."""
    return bool(line.strip()) and not NO_PROSE.match(line)


def blocks_of(text):
    """The page in pieces: (is prose, lines). Each item of a list is a piece of its own."""
    pieces, fenced, front = [], False, text.startswith("---\n")
    for number, line in enumerate(text.splitlines()):
        if front:  # YAML before the words
            front = number == 0 or line != "---"
            prose = False
        elif line.lstrip().startswith("```"):
            fenced, prose = not fenced, False
        else:
            in_item = bool(pieces) and pieces[-1][0] and ITEM.match(pieces[-1][1][0])
            prose = not fenced and (is_prose(line) or bool(in_item and line.strip()))
        begins = not pieces or pieces[-1][0] != prose or (prose and ITEM.match(line))
        if begins:
            pieces.append((prose, []))
        pieces[-1][1].append(line)
    return pieces


def wrapped(lines):
    """The lines of one piece of prose at the width."""
    if max(map(len, lines)) <= WIDTH or any(line.endswith("  ") for line in lines):
        return lines
    item = ITEM.match(lines[0])
    first = item.group(0) if item else ""
    indent = " " * len(first)
    words = " ".join([lines[0][len(first):], *(line.strip() for line in lines[1:])])
    return textwrap.wrap(words, WIDTH, initial_indent=first, subsequent_indent=indent,
                         break_long_words=False, break_on_hyphens=False)


def wrap(text):
    """A page with its prose wrapped. A second time changes nothing."""
    lines = []
    for prose, piece in blocks_of(text):
        lines += wrapped(piece) if prose else piece
    return "\n".join(lines) + "\n"


def wide_lines(text):
    """The lines of prose that are too long and can be helped: a word alone may be as long as it is."""
    return [line for prose, piece in blocks_of(text) if prose for line in piece
            if len(line) > WIDTH and len(line.split()) > 1 + bool(ITEM.match(line))]


def main():
    pages = [pathlib.Path(name) for name in sys.argv[1:] if name != "--check"]
    wide = False
    for page in pages:
        text = page.read_text(encoding="utf-8")
        if "--check" not in sys.argv:
            page.write_text(wrap(text), encoding="utf-8")
            continue
        for line in wide_lines(text):
            wide = True
            print(f"{page}: {len(line)} columns: {line}")
    return 1 if wide else 0


if __name__ == "__main__":
    sys.exit(main())
