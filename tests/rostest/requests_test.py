#!/usr/bin/python3
"""What world_server refuses, and that the running world goes on meanwhile; bundles; the action."""

import math
import os
import pathlib
import resource
import threading
import xmlrpc.client
import zlib

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Point
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CompressedImage

from latticeworld.msg import (GenerateWorldTaskAction, GenerateWorldTaskActionResult,
                              GenerateWorldTaskGoal, GenerationProgress, Status)
from latticeworld.srv import GenerateWorldRequest
from world_client import ENVIRONMENT, LAYOUT, TIMEOUT_S, Collector, WorldTest, run, wait_until

ROS_HOME = pathlib.Path(os.environ["ROS_HOME"])  # in place of ~/.ros
WORLDS = ROS_HOME / "latticeworld/worlds"
VISUALS = ROS_HOME / "latticeworld/visuals"


class RawText(str):
    """A text whose bytes on the wire are not UTF-8."""

    def encode(self, *_):
        return b"a lake \xff\xfe in the center"


def pgm(width, height, pixels=None):
    """A 16-bit greyscale picture; without pixels only its header."""
    header = b"P5\n%d %d\n65535\n" % (width, height)
    if pixels is None:
        return header
    return header + b"".join(value.to_bytes(2, "big") for value in pixels)


def slope_picture(size=65):
    return pgm(size, size, [1000 * col for _ in range(size) for col in range(size)])


def png_header(width, height):
    return (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR" + width.to_bytes(4, "big")
            + height.to_bytes(4, "big") + b"\x10\x00\x00\x00\x00\x00\x00\x00\x00")


def png(width, height, color_of):
    """A PNG; color_of(col, row) gives red, green and blue, 0 .. 255."""
    def chunk(name, data):
        return (len(data).to_bytes(4, "big") + name + data
                + zlib.crc32(name + data).to_bytes(4, "big"))
    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes((8, 2, 0, 0, 0))
    rows = b"".join(b"\0" + b"".join(bytes(color_of(col, row)) for col in range(width))
                    for row in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows))
            + chunk(b"IEND", b""))


def sketch_picture(ridge=(0, 0, 0), valley=(20, 40, 255)):
    """A ridge in the west, a valley in the east."""
    return png(100, 100, lambda col, row: ridge if 28 <= col < 31 else
               valley if 68 <= col < 71 else (255, 255, 255))


def land_grid(places="xllcorner -105.05\nyllcorner 39.95\ncellsize 0.001\n"):
    """Elevation data, 8 km in degrees, that falls from 1599 m in the north to 1500 m."""
    rows = "\n".join(" ".join([str(1599 - row)] * 100) for row in range(100))
    return f"ncols 100\nnrows 100\n{places}{rows}\n".encode()


class RequestsTest(WorldTest):
    def setUp(self):
        super().setUp()
        self.clock = Collector("/clock", Clock)
        self.addCleanup(self.clock.close)
        self.clock.wait_for_next()

    def assert_untouched(self, call, code, *words):
        """The call is refused so, and the world runs on as if nothing had been."""
        before = self.world.get_world()
        self.assert_refused(call(), code, *words)
        told = self.clock.messages()[-1].clock
        self.clock.wait_for(lambda m: m.clock > told)
        wait_until(lambda: self.world.get_world().step > before.step, "the world goes on")
        after = self.world.get_world()
        self.assertEqual(before.info.world_id, after.info.world_id)
        self.assertEqual(before.info.header.stamp, after.info.header.stamp)

    def refuse(self, code, *words, **fields):
        fields.setdefault("layout_instruction", LAYOUT)
        fields.setdefault("size", 128.0)
        self.assert_untouched(lambda: self.world.generate_world(**fields), code, *words)

    def refuse_picture(self, data, *words, code=Status.INVALID_ARGUMENT):
        self.refuse(code, *words, visual_kind=GenerateWorldRequest.HEIGHT_MAP,
                    visual=CompressedImage(data=data))

    def test_bad_texts(self):
        self.refuse(Status.INVALID_ARGUMENT, "layout_instruction", "relief", layout_instruction="")
        self.refuse(Status.INVALID_ARGUMENT, "UTF-8", layout_instruction=RawText("x"))
        self.refuse(Status.INVALID_ARGUMENT, "UTF-8", environment_instruction=RawText("x"))
        self.refuse(Status.INVALID_ARGUMENT, "16384", layout_instruction="forest " * 150000)

    def test_unknown_names(self):
        self.refuse(Status.INVALID_ARGUMENT, "moon", "suburb", "wild", vocabulary="moon")
        self.refuse(Status.INVALID_ARGUMENT, "oracle", "grounded", generator="oracle")
        self.refuse(Status.INVALID_ARGUMENT, "visual_kind", "4", "NONE", "HEIGHT_MAP",
                    "SKETCH", "ELEVATION", visual_kind=4)

    def test_bad_sizes(self):
        nan, inf = float("nan"), float("inf")
        for size in (-1.0, nan, inf, 1.0, 1e9):
            self.refuse(Status.INVALID_ARGUMENT, "size", size=size)
        for resolution in (-0.5, nan, inf, 1e-9, 1e6):
            self.refuse(Status.INVALID_ARGUMENT, "resolution", resolution=resolution)
        self.refuse(Status.INVALID_ARGUMENT, "cells", size=8192.0, resolution=0.05)

    def test_every_violation_is_told_at_once(self):
        self.refuse(Status.INVALID_ARGUMENT, "visual_kind", "vocabulary", "generator", "size",
                    visual_kind=9, vocabulary="x", generator="y", size=-1.0)

    def test_bad_pictures(self):
        self.refuse_picture(b"", "visual")
        self.refuse_picture(b"no picture at all")
        self.refuse_picture(pgm(1, 1, [7]), "33")
        self.refuse_picture(slope_picture()[:500])
        self.refuse_picture(png_header(30000, 30000), "30000")
        self.refuse_picture(pgm(30000, 30000), "30000")
        self.refuse(Status.INVALID_ARGUMENT, "visual_kind",
                    visual=CompressedImage(data=slope_picture()))

    def test_a_picture_outside_the_allowed_directories(self):
        VISUALS.mkdir(parents=True, exist_ok=True)
        (VISUALS / "link.pgm").symlink_to("/etc/passwd")
        for path in ("/etc/passwd", str(VISUALS / "../../../../etc/passwd"),
                     "../../../../../../etc/passwd", str(VISUALS / "link.pgm")):
            self.refuse(Status.PERMISSION_DENIED, str(VISUALS),
                        visual_kind=GenerateWorldRequest.HEIGHT_MAP, visual_path=path)
        (VISUALS / "link.pgm").unlink()
        self.refuse(Status.NOT_FOUND, "absent", visual_path="absent.pgm",
                    visual_kind=GenerateWorldRequest.HEIGHT_MAP)

    def test_a_picture_gives_the_land_its_shape(self):
        VISUALS.mkdir(parents=True, exist_ok=True)
        (VISUALS / "slope.pgm").write_bytes(slope_picture())
        for fields in ({"visual": CompressedImage(data=slope_picture())},
                       {"visual_path": "slope.pgm"}, {"visual_path": str(VISUALS / "slope.pgm")}):
            self.world.generate(visual_kind=GenerateWorldRequest.HEIGHT_MAP, height_scale=60.0,
                                height_offset=100.0, layout="grassland", environment="", **fields)
            info = self.world.get_world().info
            self.assertGreater(info.max_height - info.min_height, 25.0)
            self.assertGreater(info.min_height, 60.0)

    def test_a_sketch_gives_the_land_its_shape(self):
        VISUALS.mkdir(parents=True, exist_ok=True)
        (VISUALS / "sketch.png").write_bytes(sketch_picture())
        for fields in ({"visual": CompressedImage(data=sketch_picture())},
                       {"visual_path": "sketch.png"}):
            self.world.generate(visual_kind=GenerateWorldRequest.SKETCH, height_scale=40.0,
                                height_offset=10.0, layout="grassland", environment="", **fields)
            info = self.world.get_world().info
            self.assertGreater(info.max_height - info.min_height, 20.0)
            self.assertAlmostEqual(10.0, info.min_height, delta=5.0)
            self.assertTrue(math.isnan(info.latitude) and math.isnan(info.longitude)
                            and math.isnan(info.altitude))
            west, east = (self.mean_height(x) for x in (-26.0, 25.0))
            self.assertGreater(west, east + 5.0)

    def mean_height(self, x):
        points = [Point(x=x, y=y) for y in range(-50, 51, 10)]
        samples = self.assert_ok(self.world.query_terrain(points=points)).samples
        return sum(sample.height for sample in samples) / len(samples)

    def test_bad_sketches(self):
        def refuse(data, *words):
            self.refuse(Status.INVALID_ARGUMENT, *words, visual_kind=GenerateWorldRequest.SKETCH,
                        visual=CompressedImage(data=data))
        refuse(b"", "visual")
        refuse(b"no picture at all")
        refuse(png_header(30000, 30000), "30000")
        refuse(sketch_picture()[:200])
        refuse(png(64, 64, lambda col, row: (255, 255, 255)), "stroke")
        refuse(png(64, 64, lambda col, row: (0, 0, 0)))
        refuse(sketch_picture(ridge=(230, 20, 20), valley=(20, 200, 20)), "blue", "black")

    def test_elevation_gives_the_world_its_heights_and_its_place(self):
        fields = {"visual_kind": GenerateWorldRequest.ELEVATION, "layout": "grassland",
                  "environment": "", "visual": CompressedImage(data=land_grid()), "size": 2048.0,
                  "resolution": 16.0}
        self.world.generate(**fields)
        info = self.world.get_world().info
        self.assertAlmostEqual(40.0, info.latitude, delta=1e-6)
        self.assertAlmostEqual(-105.0, info.longitude, delta=1e-6)
        self.assertAlmostEqual(0.0, info.min_height, delta=1.0)
        self.assertAlmostEqual(1549.5 - 1024 / 111.0, info.altitude, delta=1.0)
        # As wide as 2048 m are in degrees of latitude, a metre a thousandth of one.
        self.assertAlmostEqual(2048 / 111.0, info.max_height - info.min_height, delta=2.0)

        self.world.generate(latitude=40.01, longitude=-104.99, keep_altitude=True, **fields)
        info = self.world.get_world().info
        self.assertEqual((40.01, -104.99, 0.0), (info.latitude, info.longitude, info.altitude))
        self.assertAlmostEqual(1559.5, (info.min_height + info.max_height) / 2, delta=2.0)
        saved = self.assert_ok(self.world.save_world(name="land"))
        self.world.generate()
        self.assertTrue(math.isnan(self.world.get_world().info.latitude))
        self.assertEqual(saved.world_id, self.assert_ok(self.world.load_world(name="land")).world_id)
        self.assertEqual(40.01, self.world.get_world().info.latitude)

    def test_bad_elevation(self):
        def refuse(data, *words, name="", **fields):
            self.refuse(Status.INVALID_ARGUMENT, *words, **fields,
                        visual_kind=GenerateWorldRequest.ELEVATION,
                        visual=CompressedImage(data=data, format=name))
        refuse(b"", "visual")
        refuse(b"no elevation at all", "GeoTIFF")
        refuse(slope_picture(), "PGM", "place on the earth")
        refuse(land_grid()[:5000], "cut off")
        refuse(land_grid(), "legal is a size of at most", size=8192.0, resolution=8.0,
               latitude=40.03, longitude=-105.0)
        refuse(land_grid(), "outside", latitude=-40.0, longitude=10.0)
        refuse(land_grid(), "latitude", latitude=95.0)
        refuse(land_grid(), "longitude", longitude=float("nan"))
        refuse(land_grid("xllcorner 0\nyllcorner 0\ncellsize 10\n"), "no coordinate system",
               latitude=40.0, longitude=-105.0)
        refuse(bytes(2 * 1201 * 1201), "N40W106.hgt", name="mountains.hgt")
        refuse(b"\x80\x00" * (1201 * 1201), "nothing but no-data", name="N40W106.hgt")
        refuse(b"II*\0" + bytes(100))

    def test_bundles(self):
        before = self.world.get_world()
        saved = self.assert_ok(self.world.save_world(name="first"))
        self.assertEqual(before.info.world_id, saved.world_id)
        self.assertEqual(WORLDS / "first", pathlib.Path(saved.path))
        self.assert_untouched(lambda: self.world.save_world(name="first"), Status.ALREADY_EXISTS)
        self.assertIn("first", [bundle.name for bundle in self.world.list_worlds().worlds])
        for name in ("../first", "/tmp/first", "a/b", ".hidden", "x" * 129):
            self.assert_untouched(lambda: self.world.save_world(name=name),
                                  Status.INVALID_ARGUMENT, "name")
            self.assert_untouched(lambda: self.world.load_world(name=name),
                                  Status.INVALID_ARGUMENT, "name")
        self.assert_untouched(lambda: self.world.load_world(name="absent"), Status.NOT_FOUND)

        # Another world, and back: the same as before, and it runs the same way.
        self.assertNotEqual(before.info.world_id, self.world.generate(seed=8).world_id)
        self.assertTrue(self.world.pause().success)
        loaded = self.assert_ok(self.world.load_world(name="first"))
        self.assertEqual(before.info.world_id, loaded.world_id)
        ran = self.assert_ok(self.world.step(steps=100, hash=True)).state_hash
        self.world.generate(seed=7)
        self.assertEqual(ran, self.world.step(steps=100, hash=True).state_hash)

    def test_a_full_disk_leaves_no_bundle(self):
        # A limit on the size of its files stands for the full disk: write fails in the same place.
        server = rosgraph.Master(rospy.get_name()).lookupNode("/world_server")
        pid = xmlrpc.client.ServerProxy(server).getPid(rospy.get_name())[2]
        limits = resource.prlimit(pid, resource.RLIMIT_FSIZE)
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (20000, limits[1]))
        self.addCleanup(resource.prlimit, pid, resource.RLIMIT_FSIZE, limits)
        self.assert_untouched(lambda: self.world.save_world(name="too_large"),
                              Status.RESOURCE_EXHAUSTED, "too_large")
        self.assertEqual([], [path for path in WORLDS.iterdir() if "too_large" in path.name])

    def test_damaged_bundles(self):
        path = pathlib.Path(self.assert_ok(self.world.save_world(name="damaged")).path)
        for name in sorted(file.name for file in path.iterdir() if file.is_file()):
            file = path / name
            whole = file.read_bytes()
            file.write_bytes(whole[:len(whole) // 2] + b"\x00" + whole[len(whole) // 2 + 1:])
            if file.read_bytes() != whole:
                self.assert_untouched(lambda: self.world.load_world(name="damaged"),
                                      Status.DATA_LOSS, name)
            file.unlink()
            code = Status.NOT_FOUND if name == "world.json" else Status.DATA_LOSS
            answer = self.world.load_world(name="damaged")
            self.assertIn(answer.status.code, (code, Status.DATA_LOSS), answer.status.message)
            self.assertIn(name, answer.status.message)
            file.write_bytes(whole)
        self.assert_ok(self.world.load_world(name="damaged"))

    def test_a_second_world_is_refused_while_one_is_made(self):
        progress = Collector("world/progress", GenerationProgress)
        answers = []
        maker = threading.Thread(
            target=lambda: answers.append(self.world.generate(seed=41, size=1024.0)))
        maker.start()
        progress.wait_for(lambda m: True)
        self.assert_untouched(lambda: self.world.generate_world(layout_instruction=LAYOUT),
                              Status.RESOURCE_EXHAUSTED, "one at a time")
        maker.join(TIMEOUT_S)
        self.assertFalse(maker.is_alive())
        self.assertEqual(answers[0].world_id, self.world.get_world().info.world_id)
        progress.close()

    def make_client(self):
        client = actionlib.SimpleActionClient("generate_world_action", GenerateWorldTaskAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(TIMEOUT_S)))
        return client

    def test_action_gives_feedback_and_a_world(self):
        client, feedback = self.make_client(), []
        client.send_goal(GenerateWorldTaskGoal(layout_instruction=LAYOUT, seed=51, size=256.0,
                                               environment_instruction=ENVIRONMENT),
                         feedback_cb=feedback.append)
        self.assertTrue(client.wait_for_result(rospy.Duration(TIMEOUT_S)))
        self.assertEqual(GoalStatus.SUCCEEDED, client.get_state())
        result = client.get_result()
        self.assertEqual(result.world_id, self.world.get_world().info.world_id)
        self.assertLessEqual({"terrain", "scene", "maps"}, {message.stage for message in feedback})
        for message in feedback:
            self.assertTrue(0.0 <= message.fraction <= 1.0)

    def test_action_hears_a_cancel(self):
        client = self.make_client()
        started = threading.Event()
        before = self.world.get_world().info.world_id
        client.send_goal(GenerateWorldTaskGoal(layout_instruction=LAYOUT, seed=52, size=2048.0),
                         feedback_cb=lambda _: started.set())
        self.assertTrue(started.wait(TIMEOUT_S))
        client.cancel_goal()
        self.assertTrue(client.wait_for_result(rospy.Duration(TIMEOUT_S)))
        self.assertEqual(GoalStatus.PREEMPTED, client.get_state())
        self.assertEqual(Status.CANCELLED, client.get_result().status.code)
        self.assertEqual(before, self.world.get_world().info.world_id)
        self.world.generate()  # the next one is made

    def test_action_refuses_what_the_service_refuses(self):
        client = self.make_client()
        # The client itself misses a result that comes before send_goal has returned.
        with Collector("generate_world_action/result", GenerateWorldTaskActionResult) as results:
            results.wait_until_connected()
            client.send_goal(GenerateWorldTaskGoal(layout_instruction="", size=-1.0))
            refused = results.wait_for(lambda m: True)
        self.assertEqual(GoalStatus.ABORTED, refused.status.status)
        self.assertEqual(Status.INVALID_ARGUMENT, refused.result.status.code)
        self.assertIn("size", refused.result.status.message)

    def test_terrain_queries_outside_the_world(self):
        self.assert_refused(self.world.query_terrain(points=[Point(), Point(x=64.1)]),
                            Status.OUT_OF_RANGE, "point 1", "64.1")
        self.assert_refused(self.world.query_terrain(points=[Point(y=float("nan"))]),
                            Status.OUT_OF_RANGE, "nan")
        self.assertEqual([], self.assert_ok(self.world.query_terrain()).samples)


if __name__ == "__main__":
    run("requests_test", RequestsTest)
