#!/usr/bin/env python3
"""Holds the pages against the sources: links lead somewhere, docs/index.md has every page, and what
CONTRIBUTING.md names is there.

Usage: pages_test.py SOURCE_DIR
"""

import pathlib
import re
import sys
import tempfile
import unittest

# Pages whose prose is still wider than 100 columns; a page that is wrapped leaves the list.
STILL_WIDE = {"docs/data_card.md", "docs/models.md", "docs/small_language.md", "docs/llama_exchange.md",
              "models/README.md", "training/examples/README.md", "benchmarks/fidelity/README.md"}
FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)")
# What a path of the sources begins with.
ROOTS = ("benchmarks", "clients", "cmake", "docs", "examples", "launch_cfg", "models", "msg",
         "scripts", "src", "srv", "tests", "training", "web")


def pages_below(source):
    """Every page of ours; not what a build or a package manager put there."""
    patterns = ("*.md", "docs/*.md", "models/*.md", "training/examples/*.md", "benchmarks/**/*.md")
    return sorted(page for pattern in patterns for page in source.glob(pattern))


def anchors_of(text):
    """The anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", FENCED.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(page):
    """The targets of a page's links that are not there."""
    text = re.sub(r"`[^`\n]*`", "", FENCED.sub("", page.read_text(encoding="utf-8")))
    broken = []
    for target in LINK.findall(text):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = page.parent / name if name else page
        if not file.exists():
            broken.append(target)
        elif anchor and anchor not in anchors_of(file.read_text(encoding="utf-8")):
            broken.append(target)
    return broken


def named_paths(text):
    """What stands in back quotes and is a path of the sources; <name> and * stand for any name."""
    quoted = re.findall(r"`([^`\n ]+)`", FENCED.sub("", text))
    return [re.sub(r"<[^>]*>", "*", path) for path in quoted if path.split("/")[0] in ROOTS]


class PagesTest(unittest.TestCase):
    def test_every_link_leads_somewhere(self):
        pages = pages_below(SOURCE)
        self.assertGreater(len(pages), 25)
        broken = {str(page.relative_to(SOURCE)): broken_links(page) for page in pages}
        self.assertEqual({}, {page: links for page, links in broken.items() if links})

    def test_the_index_has_every_page_and_the_readme_leads_to_it(self):
        linked = set(LINK.findall((SOURCE / "docs/index.md").read_text(encoding="utf-8")))
        for page in (SOURCE / "docs").glob("*.md"):
            if page.name != "index.md":
                self.assertIn(page.name, linked)
        self.assertIn("](docs/index.md)", (SOURCE / "README.md").read_text(encoding="utf-8"))

    def test_prose_is_at_most_100_columns_wide(self):
        wide = {}
        for page in pages_below(SOURCE):
            name = str(page.relative_to(SOURCE))
            lines = wrap_pages.wide_lines(page.read_text(encoding="utf-8"))
            if lines and name not in STILL_WIDE:
                wide[name] = lines
        self.assertEqual({}, wide, "scripts/wrap_pages.py wraps them")

    def test_wrapping_changes_no_word_and_nothing_the_second_time(self):
        for page in pages_below(SOURCE):
            text = page.read_text(encoding="utf-8")
            once = wrap_pages.wrap(text)
            self.assertEqual(text.split(), once.split(), page)
            self.assertEqual(once, wrap_pages.wrap(once), page)
            self.assertEqual([], wrap_pages.wide_lines(once), page)

    def test_the_first_page_is_short(self):
        self.assertLessEqual(len((SOURCE / "README.md").read_text().splitlines()), 130)

    def test_what_contributors_are_led_to_is_there(self):
        paths = named_paths((SOURCE / "CONTRIBUTING.md").read_text(encoding="utf-8"))
        self.assertGreater(len(paths), 40)
        self.assertEqual([], [path for path in paths if not list(SOURCE.glob(path))])

    def test_what_is_wrong_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("# A page\n[a](none.md) [b](page.md#a-page) [c](#b) `[d](none.md)`\n")
            self.assertEqual(["none.md", "#b"], broken_links(page))
        wide = "x " * 60
        self.assertEqual([wide], wrap_pages.wide_lines(wide + "\n\n| " + "y " * 60 + "|\n"))
        self.assertEqual(["src/*/a.cc"], named_paths("`src/<room>/a.cc` and `other/b.cc`"))


if __name__ == "__main__":
    SOURCE = pathlib.Path(sys.argv.pop(1))
    sys.path.insert(0, str(SOURCE / "scripts"))
    import wrap_pages
    unittest.main()
