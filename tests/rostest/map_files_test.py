#!/usr/bin/python3
"""The occupancy map as map_server's files and as a service, and when latched maps are published."""

import pathlib

import yaml
from grid_map_msgs.msg import GridMap
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from octomap_msgs.msg import Octomap
from octomap_msgs.srv import GetOctomap

from world_client import Collector, WorldTest, run, service

LATCHED = {"map": OccupancyGrid, "octomap_binary": Octomap, "octomap_full": Octomap,
           "world/height_map": GridMap}


def read_pgm(path):
    """Width, height and the grey values from the upper left, of a binary PGM of 8 bits."""
    content = path.read_bytes()
    magic, width, height, largest, _ = content.split(maxsplit=4)
    assert (magic, largest) == (b"P5", b"255")
    pixels = content[-int(width) * int(height):]
    return int(width), int(height), pixels


def occupancy_of(grey, settings):
    """What map_server makes of a pixel, as its documentation says."""
    share = grey / 255.0 if settings["negate"] else (255 - grey) / 255.0
    if share > settings["occupied_thresh"]:
        return 100
    if share < settings["free_thresh"]:
        return 0
    if settings.get("mode", "trinary") == "trinary":
        return -1
    span = settings["occupied_thresh"] - settings["free_thresh"]
    return int(1 + 98 * (share - settings["free_thresh"]) / span)


class MapFilesTest(WorldTest):
    def test_the_files_of_a_bundle_are_the_map_that_is_published(self):
        saved = self.assert_ok(self.world.save_world(name="for_map_server"))
        folder = pathlib.Path(saved.path)
        settings = yaml.safe_load((folder / "map.yaml").read_text(encoding="utf-8"))
        width, height, pixels = read_pgm(folder / settings["image"])
        published = service("static_map", GetMap)().map
        self.assertEqual((published.info.width, published.info.height), (width, height))
        self.assertAlmostEqual(published.info.resolution, settings["resolution"], places=6)
        origin = published.info.origin
        self.assertEqual([origin.position.x, origin.position.y, 0.0], settings["origin"])
        self.assertEqual(1.0, origin.orientation.w)
        # The message begins in the lower left, the picture in the upper left.
        rows = [pixels[row * width:(row + 1) * width] for row in reversed(range(height))]
        read = [occupancy_of(grey, settings) for row in rows for grey in row]
        self.assertEqual(list(published.data), read)
        self.assertGreater(len(set(read)), 10)

    def test_who_comes_late_gets_one_message_and_every_change_brings_one(self):
        collectors = {name: Collector(name, kind) for name, kind in LATCHED.items()}
        for collector in collectors.values():
            collector.wait_for(lambda _: True)
        # None of these changes a map.
        self.assert_ok(self.world.reset_world())
        self.assert_ok(self.world.get_world())
        self.world.pause()
        self.assert_ok(self.world.step(steps=10))
        self.world.generate(seed=8)
        for name, collector in collectors.items():
            first = collector.messages()[0]
            collector.wait_for(lambda m, first=first: m is not first)
            self.assertEqual(2, len(collector.messages()), name)
            collector.close()

    def test_the_octomap_services_answer_as_octomap_server_does(self):
        for name, binary in (("octomap_binary", True), ("octomap_full", False)):
            collector = Collector(name, Octomap)
            published = collector.wait_for(lambda _: True)
            collector.close()
            answer = service(name, GetOctomap)().map
            self.assertEqual("map", answer.header.frame_id)
            self.assertEqual(binary, bool(answer.binary))
            self.assertEqual("OcTree", answer.id)
            self.assertEqual(published.data, answer.data)
            self.assertEqual(published.resolution, answer.resolution)


if __name__ == "__main__":
    run("map_files_test", MapFilesTest)
