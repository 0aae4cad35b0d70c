#!/usr/bin/env python3
"""Holds every #include of src/ against the floors of docs/architecture.md."""

import pathlib
import re
import sys
import tempfile
import unittest

# From the ground up. A file may include its own room and every floor below it: never a room
# above, never another room of its own floor.
FLOORS = [
    ["common"],
    ["geometry"],
    ["geomorphology", "catalogue", "reference_navigator"],
    ["layout", "environment", "relief", "meshes"],
    ["language", "terrain", "species"],
    ["scene"],
    ["mapping", "sensing"],
    ["rendering"],
    ["exporting", "simulation"],
    ["generation"],
    ["navigation", "episode", "learning", "viewer", "dataset"],
    ["campaign"],
    ["latticeworld_ros"],
    ["nodes", "tools"],
]
# Rooms that must not meet although their floors would allow it: (includer, included).
FORBIDDEN = {
    ("simulation", "language"),
    ("rendering", "language"),
    ("exporting", "language"),
    ("mapping", "language"),
    ("sensing", "language"),
    ("scene", "language"),
    ("tools", "latticeworld_ros"),
}
CORE = {room for floor in FLOORS[:-2] for room in floor}
# Parts of a room that must not include each other, whatever the rest of the room does.
APART = [
    {"language/grounded", "language/remote", "language/local"},
    {"language/grounded", "language/chat"},
    {"language/sentences", "language/grounded"},
    {"language/sentences", "language/chat"},
    {"language/reading", "language/remote", "language/local"},
    {"language/grounded/reading", "language/grounded/synthesis", "language/grounded/environment"},
]
# Parts that know nothing of one above them: (part, the part above).
BELOW = [
    ("language/chat", "language/remote"),
    ("language/grounded", "language/reading"),
    ("language/sentences", "language/reading"),
    ("language/reading", "language/drawn"),
    ("language/grounded", "language/drawn"),
]
ROS_HEADER = re.compile(
    r"^(ros|tf2|tf2_ros|actionlib|rosbag|rosgraph_msgs|latticeworld_msgs|octomap_msgs|"
    r"grid_map_msgs|[a-z0-9_]+_(msgs|srvs))/")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

FLOOR_OF = {room: i for i, floor in enumerate(FLOORS) for room in floor}


def room_of(path):
    """'latticeworld/terrain/x.h' -> 'terrain', 'nodes/x.cc' -> 'nodes'; None when it is no room."""
    parts = pathlib.PurePosixPath(path).parts
    if len(parts) >= 3 and parts[0] == "latticeworld":
        return parts[1]
    if len(parts) >= 2 and parts[0] in FLOOR_OF:
        return parts[0]
    return None


def parts_of(path):
    """'latticeworld/language/grounded/reading/x.h' -> {'language/grounded',
    'language/grounded/reading'}."""
    parts = pathlib.PurePosixPath(path).parts
    if parts[0] != "latticeworld":
        return set()
    return {"/".join(parts[1:end]) for end in range(3, len(parts))}


def parts_at_odds(path, included):
    """Whether both are of parts of one room that are to know nothing of each other."""
    inner, outer = parts_of(path), parts_of(included)
    for group in APART:
        for part in group:
            if part in inner and (group - {part}) & outer:
                return True
    return any(below in inner and above in outer for below, above in BELOW)


def violation(path, included):
    """Why the file at `path` (relative to src) must not include `included`; None when it may."""
    room, other = room_of(path), room_of(included)
    if room in CORE and ROS_HEADER.match(included):
        return f"{path} is of the core and includes the ROS header {included}"
    if other is None or room is None or room == other:
        if parts_at_odds(path, included):
            return f"{path} includes {included}, of which it is to know nothing"
        return None
    if other not in FLOOR_OF:
        return f"{path} includes {included}, whose room has no floor"
    if FLOOR_OF[other] >= FLOOR_OF[room]:
        return f"{path} includes {included}: {other} is not on a floor below {room}"
    if (room, other) in FORBIDDEN:
        return f"{path} includes {included}: {room} is never to see {other}"
    return None


def violations_below(src):
    """Every violation of the sources below `src`, and the number of includes read."""
    found, read = [], 0
    for file in sorted(src.rglob("*")):
        if file.suffix not in (".h", ".cc"):
            continue
        path = file.relative_to(src).as_posix()
        if room_of(path) not in FLOOR_OF:
            found.append(f"{path} is in no room that has a floor")
        for included in INCLUDE.findall(file.read_text(encoding="utf-8")):
            read += 1
            reason = violation(path, included)
            if reason:
                found.append(reason)
    return found, read


class IncludesTest(unittest.TestCase):
    def test_no_include_breaks_the_architecture(self):
        found, read = violations_below(SRC)
        self.assertGreater(read, 100, "hardly any include was read: is this the source tree?")
        self.assertEqual([], found)

    def test_forbidden_arrows_are_seen(self):
        for path, included in [
            ("latticeworld/geometry/a.h", "latticeworld/layout/b.h"),
            ("latticeworld/layout/a.h", "latticeworld/environment/b.h"),
            ("latticeworld/language/a.h", "latticeworld/terrain/b.h"),
            ("latticeworld/simulation/a.cc", "latticeworld/generation/b.h"),
            ("latticeworld/simulation/a.cc", "latticeworld/language/b.h"),
            ("latticeworld/scene/a.cc", "latticeworld_ros/b.h"),
            ("latticeworld/scene/a.cc", "ros/ros.h"),
            ("latticeworld/scene/a.cc", "sensor_msgs/Image.h"),
            ("latticeworld/language/grounded/a.cc", "latticeworld/language/remote/b.h"),
            ("latticeworld/language/grounded/reading/a.cc", "latticeworld/language/chat/b.h"),
            ("latticeworld/language/chat/a.cc", "latticeworld/language/remote/b.h"),
            ("latticeworld/language/grounded/reading/a.cc",
             "latticeworld/language/grounded/synthesis/b.h"),
            ("latticeworld/scene/a.cc", "latticeworld/attic/b.h"),
        ]:
            self.assertIsNotNone(violation(path, included), f"{path} -> {included}")

    def test_allowed_arrows_pass(self):
        for path, included in [
            ("latticeworld/layout/a.h", "latticeworld/geometry/b.h"),
            ("latticeworld/simulation/ode/a.cc", "latticeworld/simulation/b.h"),
            ("latticeworld/scene/a.cc", "vector"),
            ("latticeworld/language/grounded/a.cc", "latticeworld/language/generator.h"),
            ("latticeworld_ros/a.cc", "ros/ros.h"),
            ("nodes/a.cc", "latticeworld_ros/b.h"),
        ]:
            self.assertIsNone(violation(path, included), f"{path} -> {included}")

    def test_a_tree_with_a_wrong_include_is_caught(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "latticeworld/geometry/a.h"
            file.parent.mkdir(parents=True)
            file.write_text('#include <vector>\n  #  include "latticeworld/scene/scene.h"\n')
            self.assertEqual(len(violations_below(pathlib.Path(folder))[0]), 1)


if __name__ == "__main__":
    SRC = pathlib.Path(sys.argv.pop(1))
    unittest.main()
