#!/usr/bin/env python3
"""Holds every #include of src/ against the floors of docs/architecture.md, and shelves of a room
against what they may know of each other."""

import pathlib
import re
import sys
import tempfile
import unittest

from floors import FLOOR_OF, INCLUDE, folder_in_rooms, room_of, sources_below

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
WITH_ROS = {"latticeworld_ros", "nodes"}  # the rooms that may include ROS headers
# Shelves (folders of a room) that must not include each other, whatever the rest of the room does.
APART = [
    {"exporting/gltf", "exporting/maps"},
    {"exporting/maps", "exporting/simulators"},
    {"language/grounded", "language/remote", "language/local"},
    {"language/grounded", "language/chat"},
    {"language/sentences", "language/grounded"},
    {"language/sentences", "language/chat"},
    {"language/reading", "language/remote", "language/local"},
    {"language/grounded/reading", "language/grounded/synthesis", "language/grounded/environment"},
    {"latticeworld_ros/episode", "latticeworld_ros/navigator", "latticeworld_ros/viewer"},
    {"relief/elevation", "relief/height_map"},
    {"relief/elevation", "relief/sketch"},
    {"scene/agents", "scene/props", "scene/settlements"},
    {"scene/vegetation", "scene/weather"},
    {"sensing/camera", "sensing/lidar", "sensing/motion"},
    {"simulation/agents", "simulation/ode", "simulation/props"},
]
# Shelves that know nothing of one above them: (shelf, the shelf above).
BELOW = [
    ("exporting/gltf", "exporting/simulators"),
    ("language/chat", "language/remote"),
    ("language/grounded", "language/reading"),
    ("language/sentences", "language/reading"),
    ("language/reading", "language/drawn"),
    ("language/grounded", "language/drawn"),
    ("latticeworld_ros/conversion", "latticeworld_ros/node"),
    ("latticeworld_ros/conversion", "latticeworld_ros/publishing"),
    ("latticeworld_ros/conversion", "latticeworld_ros/running"),
    ("latticeworld_ros/conversion", "latticeworld_ros/server"),
    ("relief/height_map", "relief/sketch"),
    ("scene/vegetation", "scene/props"),
    ("scene/vegetation", "scene/settlements"),
    ("simulation/agents", "simulation/simulator"),
    ("simulation/ode", "simulation/simulator"),
    ("terrain/forms", "terrain/ways"),
    ("terrain/water", "terrain/forms"),
    ("terrain/water", "terrain/ways"),
    ("viewer/payloads", "viewer/server"),
]
ROS_HEADER = re.compile(
    r"^(ros|tf2|tf2_ros|actionlib|rosbag|rosgraph_msgs|latticeworld_msgs|octomap_msgs|"
    r"grid_map_msgs|[a-z0-9_]+_(msgs|srvs))/")


def shelves_of(path):
    """'latticeworld/language/grounded/reading/x.h' -> {'language/grounded',
    'language/grounded/reading'}."""
    parts = folder_in_rooms(path).split("/")
    return {"/".join(parts[:end]) for end in range(2, len(parts) + 1)}


def shelves_at_odds(path, included):
    """Whether both are of shelves of one room that are to know nothing of each other."""
    inner, outer = shelves_of(path), shelves_of(included)
    for group in APART:
        for shelf in group:
            if shelf in inner and (group - {shelf}) & outer:
                return True
    return any(below in inner and above in outer for below, above in BELOW)


def violation(path, included):
    """Why the file at `path` (relative to src) must not include `included`; None when it may."""
    room, other = room_of(path), room_of(included)
    if room not in WITH_ROS and ROS_HEADER.match(included):
        return f"{path} includes the ROS header {included}: only rooms of WITH_ROS may"
    if other is None or room is None or room == other:
        if shelves_at_odds(path, included):
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
    for path, text in sources_below(src):
        if room_of(path) not in FLOOR_OF:
            found.append(f"{path} is in no room that has a floor")
        for included in INCLUDE.findall(text):
            read += 1
            reason = violation(path, included)
            if reason:
                found.append(reason)
    return found, read


def missing_below(src):
    """The rooms and shelves that rules speak of and that hold no source below `src`."""
    there = set()
    for path, _ in sources_below(src):
        there |= {room_of(path)} | shelves_of(path)
    named = set(FLOOR_OF) | {room for pair in FORBIDDEN for room in pair}
    named |= {shelf for group in APART + BELOW for shelf in group}
    return sorted(named - there)


class IncludesTest(unittest.TestCase):
    def test_no_include_breaks_the_architecture(self):
        found, read = violations_below(SRC)
        self.assertGreater(read, 100, "hardly any include was read: is this the source tree?")
        self.assertEqual([], found)

    def test_every_room_and_shelf_that_rules_speak_of_is_there(self):
        self.assertEqual([], missing_below(SRC))

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
            ("tools/a.cc", "ros/ros.h"),
            ("latticeworld/language/grounded/a.cc", "latticeworld/language/remote/b.h"),
            ("latticeworld/language/grounded/reading/a.cc", "latticeworld/language/chat/b.h"),
            ("latticeworld/language/chat/a.cc", "latticeworld/language/remote/b.h"),
            ("latticeworld/language/grounded/reading/a.cc",
             "latticeworld/language/grounded/synthesis/b.h"),
            ("latticeworld/simulation/ode/a.cc", "latticeworld/simulation/agents/ways/b.h"),
            ("latticeworld/terrain/water/a.cc", "latticeworld/terrain/ways/b.h"),
            ("latticeworld_ros/viewer/a.cc", "latticeworld_ros/navigator/b.h"),
            ("latticeworld_ros/conversion/a.cc", "latticeworld_ros/server/b.h"),
            ("latticeworld/scene/a.cc", "latticeworld/attic/b.h"),
        ]:
            self.assertIsNotNone(violation(path, included), f"{path} -> {included}")

    def test_allowed_arrows_pass(self):
        for path, included in [
            ("latticeworld/layout/a.h", "latticeworld/geometry/b.h"),
            ("latticeworld/simulation/ode/a.cc", "latticeworld/simulation/b.h"),
            ("latticeworld/terrain/ways/a.cc", "latticeworld/terrain/water/b.h"),
            ("latticeworld/scene/a.cc", "vector"),
            ("latticeworld/language/grounded/a.cc", "latticeworld/language/generator.h"),
            ("latticeworld_ros/a.cc", "ros/ros.h"),
            ("latticeworld_ros/server/a.cc", "latticeworld_ros/conversion/b.h"),
            ("nodes/a.cc", "latticeworld_ros/b.h"),
        ]:
            self.assertIsNone(violation(path, included), f"{path} -> {included}")

    def test_a_tree_with_a_wrong_include_is_caught(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "latticeworld/geometry/a.h"
            file.parent.mkdir(parents=True)
            file.write_text('#include <vector>\n  #  include "latticeworld/scene/scene.h"\n')
            self.assertEqual(len(violations_below(pathlib.Path(folder))[0]), 1)

    def test_a_rule_of_a_shelf_that_is_gone_is_caught(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "latticeworld/terrain/water/a.h"
            file.parent.mkdir(parents=True)
            file.write_text("")
            missing = missing_below(pathlib.Path(folder))
            self.assertIn("terrain/ways", missing)
            self.assertNotIn("terrain/water", missing)
            self.assertNotIn("terrain", missing)


if __name__ == "__main__":
    SRC = pathlib.Path(sys.argv.pop(1))
    unittest.main()
