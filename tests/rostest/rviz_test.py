#!/usr/bin/python3
"""The shipped rviz configurations, loaded by rviz on a screen that is none: every display is Ok."""

import os
import pathlib
import shutil
import subprocess
import tempfile

import numpy
import roslib.packages
import rospkg
import yaml

from navigator_client import Driver, pose_at
from world_client import TIMEOUT_S, ServerTest, run

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("latticeworld"))
DISPLAYS = roslib.packages.find_node("latticeworld", "rviz_displays")[0]
WORLD = {"layout": "A lake in the lower left, forest in the upper left, a road from the west to "
                   "the east, grassland everywhere else.",
         "environment": "A sunny summer noon. Five sheep graze near the center, a wheeled robot "
                        "waits in the center.", "size": 128.0, "seed": 7}
PATIENCE_S = 60


class Screen:
    """An X server that draws into memory. A context: the number of its display."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()  # empty: it ended instead
        if not number:
            raise AssertionError(f"Xvfb ended with {self.server.wait(TIMEOUT_S)}")
        return f":{number}"

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait(TIMEOUT_S)


def read_pixels(path):
    """Of a binary PPM, (rows x cols x 3)."""
    magic, size, most, pixels = path.read_bytes().split(b"\n", 3)
    assert (magic, most) == (b"P6", b"255"), path
    width, height = (int(word) for word in size.split())
    return numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 3)


class RvizTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**WORLD)

    def load(self, name):
        """What the displays of a configuration say, the names of those that are switched on, and
        the picture."""
        config = PACKAGE / "launch_cfg" / name
        entries = yaml.safe_load(config.read_text(encoding="utf-8"))
        enabled = [display["Name"] for display in entries["Visualization Manager"]["Displays"]
                   if display["Enabled"]]
        with Screen() as display, tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder, "picture.ppm")
            environment = {**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1",
                           "XDG_RUNTIME_DIR": folder, "QT_QPA_PLATFORM": "xcb"}
            result = subprocess.run([DISPLAYS, str(config), str(picture), str(PATIENCE_S)],
                                    env=environment, stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, text=True, check=False,
                                    timeout=2 * PATIENCE_S)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)
            for one in enabled:
                self.assertIn(f"\n{one} (rviz/", "\n" + result.stdout)
            self.assertNotIn("Warn: ", result.stdout)
            self.assertNotIn("Error: ", result.stdout)
            pixels = read_pixels(picture)
            kept = os.environ.get("LATTICEWORLD_RVIZ_PICTURES")  # a folder, for who wants to look
            if kept:
                shutil.copy(picture, os.path.join(kept, name + ".ppm"))
        return result.stdout, pixels

    def test_the_world(self):
        _, pixels = self.load("world.rviz")
        self.assert_shows(pixels, "grass", lambda r, g, b: (g > r + 20) & (g > b + 20))

    def test_the_robot(self):
        driver = Driver()
        driver.send(pose_at(*driver.place_at(30.0)))
        said, pixels = self.load("robot.rviz")
        for line in ("messages received", "images received", "Map OK"):
            self.assertIn(line, said)
        self.assert_shows(pixels, "grass", lambda r, g, b: (g > r + 20) & (g > b + 20))
        self.assert_shows(pixels, "points", lambda r, g, b: (r > 200) & (g < 80) & (b < 80))
        driver.client.cancel_goal()
        driver.close()

    def assert_shows(self, pixels, what, mask):
        red, green, blue = (pixels[:, :, i].astype(int) for i in range(3))
        share = mask(red, green, blue).mean()
        self.assertGreater(share, 0.002, f"{what} covers {share:.4f} of the picture")


if __name__ == "__main__":
    run("rviz_test", RvizTest)
