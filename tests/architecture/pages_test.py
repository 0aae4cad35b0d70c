#!/usr/bin/env python3
"""Holds the pages against the sources: links lead somewhere, docs/index.md has every page, and the
paths that pages name are there.

Usage: pages_test.py SOURCE_DIR
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from floors import FLOOR_OF, folder_in_rooms, sources_below

FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)")
# What a path of the sources begins with.
ROOTS = ("benchmarks", "clients", "cmake", "docs", "examples", "launch_cfg", "models", "msg",
         "scripts", "src", "srv", "tests", "training", "web")
# What begins as a room and is a topic or a message; and the files of data sets, by their ends.
NO_PATHS = {"episode/status", "viewer/address", "latticeworld/Status"}
NO_SOURCES = (".jsonl",)


def pages_below(source):
    """Every page of the repository; not what a build or a package manager put there."""
    names = subprocess.run(["git", "-C", source, "ls-files", "*.md"], text=True, check=True,
                           stdout=subprocess.PIPE).stdout.split()
    return sorted(source / name for name in names)


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


def named_sources(text):
    """What stands in back quotes and is said from the middle of the sources: `terrain/ways/x.h`,
    `terrain/ways`, `ways/x.h` or `x.h`; without an ending where both .h and .cc are meant."""
    found = []
    for path in re.findall(r"`([^`\n ]+)`", FENCED.sub("", text)):
        first = path.split("/")[0]
        if first in ROOTS or path in NO_PATHS or path.endswith(NO_SOURCES) or "::" in path:
            continue
        in_room = "/" in path and (first in FLOOR_OF or first == "latticeworld")
        if in_room or re.search(r"[\w*]\.(h|cc)$", path):
            found.append(re.sub(r"<[^>]*>", "*", path))
    return found


def is_there(source, path):
    """Whether a path of named_paths leads to a file, or to a folder that is not empty."""
    return any(found.is_file() or any(found.iterdir()) for found in source.glob(path))


def is_of_sources(source, path):
    """Whether a path of named_sources leads to something."""
    path = path.rstrip("/")
    if "/" in path and path.split("/")[0] in FLOOR_OF | {"latticeworld": 0}:
        patterns = [f"src/{path}", f"src/latticeworld/{path}"]
    else:
        patterns = [f"tests/**/{path}" if "test" in path else f"src/**/{path}"]
    return any(is_there(source, pattern + end) for pattern in patterns for end in ("", ".h", ".cc"))


def names_of_code(text):
    """The names of classes and functions in back quotes: words that begin with a capital and have
    small letters."""
    quoted = " ".join(re.findall(r"`([^`\n]+)`", FENCED.sub("", text)))
    return set(re.findall(r"\b[A-Z]\w*[a-z]\w*\b", quoted))


def rooms_in_table(text):
    """(room, floor) of each row `| 6 | `scene` | ... |`."""
    return {(room, int(floor))
            for floor, room in re.findall(r"^\| (\d+) \| `(\w+)` \|", text, re.MULTILINE)}


def shelves_in_table(text):
    """'room/shelf' of each row `| `scene/agents`, `props` | ... |`, whose later names are of the
    first one's room."""
    shelves = set()
    for cell in re.findall(r"^\| (`\w+/\w+`[^|]*) \|", text, re.MULTILINE):
        first, *others = re.findall(r"`([^`]+)`", cell)
        shelves |= {first} | {f"{first.split('/')[0]}/{other}" for other in others}
    return shelves


class PagesTest(unittest.TestCase):
    def test_every_link_leads_somewhere(self):
        pages = pages_below(SOURCE)
        self.assertGreater(len(pages), 35)
        broken = {str(page.relative_to(SOURCE)): broken_links(page) for page in pages}
        self.assertEqual({}, {page: links for page, links in broken.items() if links})

    def test_the_index_has_every_page_and_the_readme_leads_to_it(self):
        linked = set(LINK.findall((SOURCE / "docs/index.md").read_text(encoding="utf-8")))
        for page in pages_below(SOURCE):
            name = os.path.relpath(page, SOURCE / "docs")
            if name != "index.md":
                self.assertIn(name, linked)
        self.assertIn("](docs/index.md)", (SOURCE / "README.md").read_text(encoding="utf-8"))

    def test_prose_is_at_most_100_columns_wide(self):
        wide = {}
        for page in pages_below(SOURCE):
            name = str(page.relative_to(SOURCE))
            lines = wrap_pages.wide_lines(page.read_text(encoding="utf-8"))
            if lines:
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

    def test_what_pages_name_of_the_sources_is_there(self):
        gone, count = {}, 0
        for page in pages_below(SOURCE):
            if page.name == "CHANGELOG.md":  # tells of what was
                continue
            text = page.read_text(encoding="utf-8")
            paths, sources = named_paths(text), named_sources(text)
            count += len(paths) + len(sources)
            missing = [path for path in paths if not is_there(SOURCE, path)]
            missing += [path for path in sources if not is_of_sources(SOURCE, path)]
            if missing:
                gone[str(page.relative_to(SOURCE))] = missing
        self.assertGreater(count, 200, "hardly any path was read")
        self.assertEqual({}, gone)

    def test_the_architecture_has_every_room_and_shelf_and_no_other(self):
        text = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
        self.assertEqual({(room, floor + 1) for room, floor in FLOOR_OF.items()},
                         rooms_in_table(text))
        shelves = {"/".join(folder_in_rooms(path).split("/")[:2])
                   for path, _ in sources_below(SOURCE / "src")}
        self.assertEqual({shelf for shelf in shelves if "/" in shelf}, shelves_in_table(text))

    def test_the_architecture_names_nothing_that_is_not_in_the_sources(self):
        names = names_of_code((SOURCE / "docs/architecture.md").read_text(encoding="utf-8"))
        self.assertGreater(len(names), 40)
        code = set(re.findall(r"\w+", " ".join(text for _, text in sources_below(SOURCE / "src"))))
        self.assertEqual(set(), names - code)

    def test_what_is_wrong_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("# A page\n[a](none.md) [b](page.md#a-page) [c](#b) `[d](none.md)`\n")
            self.assertEqual(["none.md", "#b"], broken_links(page))
        wide = "x " * 60
        self.assertEqual([wide], wrap_pages.wide_lines(wide + "\n\n| " + "y " * 60 + "|\n"))
        self.assertEqual(["src/*/a.cc"], named_paths("`src/<room>/a.cc` and `other/b.cc`"))

    def test_rooms_shelves_and_names_are_read(self):
        table = ("| 6 | `scene` | places |\n| 14 | `nodes` | mains |\n"
                 "| `scene/agents`, `props` | of `Scene` |\n| `tools/commands` | `a/b` |\n")
        self.assertEqual({("scene", 6), ("nodes", 14)}, rooms_in_table(table))
        self.assertEqual({"scene/agents", "scene/props", "tools/commands"},
                         shelves_in_table(table))
        self.assertEqual({"Scene", "BuildScene", "Step"},
                         names_of_code("`Scene`, `BuildScene(x)`, `Scene::Step`, `y_L`, Other"))

    def test_sources_that_are_gone_are_seen(self):
        text = ("`terrain/ways/road.h`, `ways/road.h`, `road.cc`, `ways/r*.h`, "
                "`terrain/ways/road`, `terrain/ways/`, `terrain/road.h`, `terrain/lanes`, "
                "`lane.cc`, `episode/status`, `layout/train.jsonl`, `a.json`, `Road::h`, "
                "`src/lane.h`")
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder)
            ways = source / "src/latticeworld/terrain/ways"
            ways.mkdir(parents=True)
            for name in ("road.h", "road.cc"):
                (ways / name).write_text("")
            self.assertEqual(["terrain/road.h", "terrain/lanes", "lane.cc"],
                             [path for path in named_sources(text)
                              if not is_of_sources(source, path)])


if __name__ == "__main__":
    SOURCE = pathlib.Path(sys.argv.pop(1))
    sys.path.insert(0, str(SOURCE / "scripts"))
    import wrap_pages
    unittest.main()
