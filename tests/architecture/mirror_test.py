#!/usr/bin/env python3
"""Holds that tests/ mirrors src/: the test of a source lies where the source lies.

A test X_test.cc is the test of a source X where its first include is X.h, or else where its own
room has an X. The folder src/latticeworld/ROOM/SHELF answers to tests/ROOM/SHELF, and so does
src/ROOM/SHELF of the rooms outside of the core.

Usage: mirror_test.py SOURCE_DIR
"""

import collections
import pathlib
import re
import sys
import tempfile
import unittest

from floors import INCLUDE, folder_in_rooms, sources_below

END = "_test.cc"


def folders_of_sources(src):
    """Source's name without suffix -> the folders, as tests/ has them, that hold one of that
    name."""
    folders = collections.defaultdict(set)
    for path, _ in sources_below(src):
        folders[pathlib.PurePosixPath(path).stem].add(folder_in_rooms(path))
    return folders


def right_folders(path, text, folders):
    """The folders of tests/ where the test at `path` (relative to tests/) may lie; empty: anywhere,
    for it is of no one source."""
    name = pathlib.PurePosixPath(path).name[:-len(END)]
    first = next(iter(INCLUDE.findall(text)), "")
    if re.search(rf"(^|/){re.escape(name)}\.h$", first):
        own = folder_in_rooms(first)
        return {own} if own in folders[name] else set()
    room = path.split("/")[0]
    return {folder for folder in folders[name] if folder.split("/")[0] == room}


def misplaced(source):
    """A sentence on each test below `source`/tests that does not lie where its source does, and
    the number of tests that have a source."""
    folders, found, mirrored = folders_of_sources(source / "src"), [], 0
    for path, text in sources_below(source / "tests"):
        if not path.endswith(END):
            continue
        right = right_folders(path, text, folders)
        mirrored += bool(right)
        if right and str(pathlib.PurePosixPath(path).parent) not in right:
            places = " or ".join(f"tests/{folder}" for folder in sorted(right))
            found.append(f"tests/{path} is to lie in {places}, where its source does")
    return found, mirrored


class MirrorTest(unittest.TestCase):
    def test_tests_lie_where_their_sources_do(self):
        found, mirrored = misplaced(SOURCE)
        self.assertGreater(mirrored, 300, "hardly any test has a source: is this the source tree?")
        if found:
            self.fail("\n" + "\n".join(found))


class RuleTest(unittest.TestCase):
    """The rule itself, on a tree that is made up."""

    def test_only_tests_beside_their_sources_pass(self):
        files = {
            "src/latticeworld/terrain/ways/road.h": "",
            "src/latticeworld/scene/road.cc": "",
            "src/latticeworld/scene/scene.h": "",
            "src/latticeworld_ros/server/door.cc": "",
            "tests/terrain/ways/road_test.cc": "",
            "tests/terrain/road_test.cc": "",
            "tests/scene/road_test.cc": '#include <gtest/gtest.h>\n',
            "tests/mapping/road_test.cc": "",
            "tests/mapping/scene_test.cc": '#include "latticeworld/scene/scene.h"\n',
            "tests/mapping/whole_scene_test.cc": '#include "latticeworld/scene/scene.h"\n',
            "tests/latticeworld_ros/door_test.cc": "",
            "tests/latticeworld_ros/server/door.cc": "",
        }
        with tempfile.TemporaryDirectory() as folder:
            for path, text in files.items():
                file = pathlib.Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            found, mirrored = misplaced(pathlib.Path(folder))
        self.assertEqual([
            "tests/latticeworld_ros/door_test.cc is to lie in tests/latticeworld_ros/server, where "
            "its source does",
            "tests/mapping/scene_test.cc is to lie in tests/scene, where its source does",
            "tests/terrain/road_test.cc is to lie in tests/terrain/ways, where its source does",
        ], found)
        self.assertEqual(5, mirrored)


if __name__ == "__main__":
    SOURCE = pathlib.Path(sys.argv.pop(1))
    unittest.main()
