#!/usr/bin/python3
"""What robots sense, on topics: frames, stamps, rates, what is seen, and who pays for it."""

import math
import struct
import subprocess

import numpy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Point, Vector3
from nav_msgs.msg import Odometry
from sensor_msgs.msg import (CameraInfo, Image, Imu, LaserScan, MagneticField, NavSatFix,
                             PointCloud2)
from tf2_msgs.msg import TFMessage

from latticeworld.msg import Bumper
from world_client import TIMEOUT_S, Collector, ServerTest, run, wait_until

WORLD = {"layout": "Flat grassland everywhere.",
         "environment": "A sunny summer noon. A wheeled robot waits in the center.",
         "size": 64.0, "seed": 3}
STEP_S = 0.01
# Messages in a second of simulated time, frame.
TOPICS = {
    "scan": (LaserScan, 40, "robot/scan"),
    "points": (PointCloud2, 10, "robot/points"),
    "imu": (Imu, 100, "robot/imu"),
    "fix": (NavSatFix, 5, "robot/fix"),
    "magnetic_field": (MagneticField, 50, "robot/magnetic_field"),
    "wheel_odom": (Odometry, 50, "robot/odom"),
    "bumper": (Bumper, 50, "robot/bumper"),
    "camera/color/image_raw": (Image, 10, "robot/camera_optical"),
    "camera/color/camera_info": (CameraInfo, 10, "robot/camera_optical"),
    "camera/depth/image_raw": (Image, 10, "robot/camera_optical"),
    "camera/depth/camera_info": (CameraInfo, 10, "robot/camera_optical"),
    "camera/labels/class": (Image, 10, "robot/camera_optical"),
    "camera/labels/instance": (Image, 10, "robot/camera_optical"),
    "camera/labels/camera_info": (CameraInfo, 10, "robot/camera_optical"),
}
ELEMENT = 9  # of class labels


def bearing(scan, index):
    return scan.angle_min + index * scan.angle_increment


def ranges_ahead(scan, half_width=0.03):
    return [r for i, r in enumerate(scan.ranges) if abs(bearing(scan, i)) < half_width]


def yaw_of(pose):
    q = pose.orientation
    return math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))


class SensorsTest(ServerTest):
    def setUp(self):
        self.world.generate(**WORLD)
        self.assertTrue(self.world.pause().success)
        self.diagnostics = Collector("diagnostics", DiagnosticArray)
        self.addCleanup(self.diagnostics.close)

    def listen(self, topic, message_type):
        collector = Collector(topic, message_type)
        self.addCleanup(collector.close)
        collector.wait_until_connected()
        return collector

    def sensors(self):
        """What the next diagnostics say of the sensors."""
        message = self.diagnostics.wait_for_next()
        status = next(s for s in message.status if s.name == "world_server: sensors")
        return {value.key: value.value for value in status.values}

    def wait_for_listeners(self, count):
        wait_until(lambda: int(self.sensors()["listeners"]) == count, f"{count} listeners")

    def step(self, steps):
        return self.assert_ok(self.world.step(steps=steps))

    def pose(self):
        with Collector("robot/ground_truth", Odometry) as poses:
            poses.wait_until_connected()
            self.step(2)
            return poses.wait_for(lambda m: True).pose.pose

    def ahead(self, distance):
        pose = self.pose()
        yaw = yaw_of(pose)
        return yaw, Point(x=pose.position.x + distance * math.cos(yaw),
                          y=pose.position.y + distance * math.sin(yaw))

    def test_every_topic_delivers_at_its_rate_with_its_frame(self):
        topics = {name: self.listen(f"robot/{name}", row[0]) for name, row in TOPICS.items()}
        self.wait_for_listeners(len(TOPICS))
        begin = self.step(20).stamp  # by then everything is under way
        end = self.step(100).stamp
        for name, (_, rate, frame) in TOPICS.items():

            def within():
                # A scan's stamp is that of its first beam, all else is of when it was complete.
                late = 1.0 / rate if name == "scan" else 0.0
                return [m for m in topics[name].messages()
                        if begin.to_sec() + 1e-6 < m.header.stamp.to_sec() + late
                        <= end.to_sec() + 1e-6]

            wait_until(lambda: len(within()) >= rate, f"{rate} messages of {name}")
            messages = within()
            self.assertEqual(rate, len(messages), name)
            self.assertEqual({frame}, {m.header.frame_id for m in messages}, name)
            stamps = [m.header.stamp.to_nsec() for m in messages]
            self.assertEqual({round(1e9 / rate)}, set(numpy.diff(stamps)), name)
            if (1.0 / STEP_S) % rate == 0:
                offsets = {(end.to_nsec() - stamp) % round(STEP_S * 1e9) for stamp in stamps}
                self.assertEqual({0}, offsets, name)

    def test_a_crate_is_seen_where_it_stands(self):
        yaw, place = self.ahead(4.0)
        self.assert_ok(self.world.spawn_element(kind="crate", name="box", position=place,
                                                heading=yaw, size=Vector3(2.0, 2.0, 2.0)))
        scans = self.listen("robot/scan", LaserScan)
        clouds = self.listen("robot/points", PointCloud2)
        depths = self.listen("robot/camera/depth/image_raw", Image)
        labels = self.listen("robot/camera/labels/class", Image)
        colours = self.listen("robot/camera/color/image_raw", Image)
        self.wait_for_listeners(5)
        self.step(40)
        near = ranges_ahead(scans.wait_for(lambda m: min(ranges_ahead(m)) < 10.0))
        self.assertGreater(len(near), 3)
        for r in near:
            self.assertAlmostEqual(3.0, r, delta=0.15)
        depth = depths.wait_for(lambda m: True)
        pixels = numpy.frombuffer(depth.data, numpy.float32).reshape(depth.height, depth.width)
        self.assertEqual("32FC1", depth.encoding)
        self.assertAlmostEqual(2.85, float(pixels[depth.height // 2 - 10, depth.width // 2]),
                               delta=0.2)  # the camera is 0.15 m before the scanner
        image = labels.wait_for(lambda m: True)
        classes = numpy.frombuffer(image.data, numpy.uint8).reshape(image.height, image.width)
        self.assertEqual("mono8", image.encoding)
        self.assertEqual(ELEMENT, classes[image.height // 2 - 10, image.width // 2])
        colour = colours.wait_for(lambda m: True)
        self.assertEqual("rgb8", colour.encoding)
        rgb = numpy.frombuffer(colour.data, numpy.uint8).reshape(colour.height, colour.width, 3)
        red, _, blue = rgb[colour.height // 2 - 10, colour.width // 2].astype(int)
        self.assertGreater(red, blue + 20)  # wood
        sky = rgb[2, 5].astype(int)
        self.assertGreater(sky[2], sky[0])
        cloud = clouds.wait_for(lambda m: True)
        self.assertEqual(["x", "y", "z", "intensity", "ring", "time"],
                         [field.name for field in cloud.fields])
        points = [struct.unpack_from("<ffffHf", cloud.data, i * cloud.point_step)
                  for i in range(cloud.width)]
        facing = [p for p in points if abs(p[1]) < 0.5 and 0.0 < p[0] < 5.0 and p[2] > -0.3]
        self.assertGreater(len(facing), 20)
        for x, _, _, _, ring, time in facing:
            self.assertAlmostEqual(3.0, x, delta=0.2)
            self.assertLess(ring, 64)
            self.assertTrue(-0.1001 <= time <= 0.0, time)

    def test_nothing_is_computed_while_nobody_listens(self):
        self.wait_for_listeners(0)
        before = self.sensors()
        self.step(100)
        after = self.sensors()
        self.assertEqual(before["steps sensed"], after["steps sensed"])
        self.assertEqual(before["frames"], after["frames"])

    def test_only_what_is_listened_to_is_computed(self):
        first = self.listen("robot/imu", Imu)
        # Another process, for subscribers of one share a connection.
        second = subprocess.Popen(["rostopic", "echo", "-n", "50", "/robot/imu/header/seq"],
                                  stdout=subprocess.PIPE, text=True)
        self.addCleanup(second.wait)
        self.addCleanup(second.kill)
        self.wait_for_listeners(2)
        before = int(self.sensors()["frames"])
        self.step(60)
        made = int(self.sensors()["frames"]) - before
        self.assertTrue(50 <= made <= 61, made)  # one frame for both, of nothing else
        wait_until(lambda: len(first.messages()) == made, f"{made} messages")
        self.assertEqual(50, second.communicate(timeout=TIMEOUT_S)[0].count("---"))

    def test_an_episode_is_sensed_alike_after_every_reset(self):
        readings = self.listen("robot/imu", Imu)
        self.wait_for_listeners(1)
        episodes = []
        for _ in range(2):
            self.assert_ok(self.world.reset_world())
            begin = self.step(1).stamp
            end = self.step(50).stamp

            def episode():
                return [m for m in readings.messages() if begin < m.header.stamp <= end]

            wait_until(lambda: len(episode()) == 50, "the readings of 50 steps")
            episodes.append([(m.angular_velocity.x, m.linear_acceleration.z) for m in episode()])
        self.assertEqual(episodes[0], episodes[1])
        self.assertGreater(len(set(episodes[0])), 10)  # noise, not a constant

    def test_another_world_is_sensed_by_those_who_listened_before(self):
        scans = self.listen("robot/scan", LaserScan)
        self.wait_for_listeners(1)
        self.step(20)
        scans.wait_for(lambda m: True)
        self.world.generate(**dict(WORLD, seed=4))
        self.wait_for_listeners(1)
        begin = self.step(20).stamp
        self.step(20)
        scans.wait_for(lambda m: m.header.stamp > begin)

    def test_a_robot_goes_while_it_is_listened_to(self):
        _, place = self.ahead(6.0)
        self.assert_ok(self.world.spawn_agent(name="scout", position=place, controllable=True))
        scans = self.listen("scout/scan", LaserScan)
        self.wait_for_listeners(1)
        self.step(20)
        scans.wait_for(lambda m: True)
        self.assert_ok(self.world.remove_agent(name="scout"))
        self.wait_for_listeners(0)
        gone = self.step(20).stamp
        self.assert_ok(self.world.spawn_agent(name="scout", position=place, controllable=True))
        self.wait_for_listeners(1)
        self.step(20)
        scans.wait_for(lambda m: m.header.stamp > gone)

    def test_sensors_have_their_places_on_the_robot(self):
        transforms = self.listen("/tf_static", TFMessage)
        message = transforms.wait_for(
            lambda m: any(t.header.frame_id == "robot/base_link" for t in m.transforms))
        edges = {(t.header.frame_id, t.child_frame_id): t.transform for t in message.transforms}
        for name in ("scan", "points", "imu", "fix", "magnetic_field", "wheel_odom", "bumper",
                     "camera"):
            self.assertIn(("robot/base_link", f"robot/{name}"), edges)
        optical = edges[("robot/camera", "robot/camera_optical")].rotation
        # x right, y down, z forward (REP 103).
        turned = (optical.x * optical.w, optical.y * optical.w, optical.z * optical.w)
        self.assertEqual((-0.25, 0.25, -0.25), tuple(round(v, 6) for v in turned))


if __name__ == "__main__":
    run("sensors_test", SensorsTest)
