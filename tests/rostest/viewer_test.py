#!/usr/bin/python3
"""world_viewer beside a real world_server: what clients see of it, and what they make it do."""

import math
import struct
import tempfile
import threading
import unittest

import rospy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry, Path

from latticeworld import srv
from server_process import Server
from viewer_client import Socket, Viewer
from world_client import ENVIRONMENT, LAYOUT, Collector, World, run, service

AGENTS, ELEMENTS, POINTS = 1, 2, 3


class ViewerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.worlds = tempfile.TemporaryDirectory()
        cls.server = Server(worlds_directory=cls.worlds.name).__enter__()
        cls.viewer = Viewer().__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.viewer.__exit__()
        cls.server.__exit__()
        cls.worlds.cleanup()

    def generate(self, client, seed="7"):
        client.send(type="generate", id="g", layout=LAYOUT, environment=ENVIRONMENT, seed=seed,
                    size_m=128, resolution_m=1)
        reply = client.wait_for_type("reply", id="g")
        self.assertTrue(reply["ok"], reply)
        return reply

    def generate_and_wait(self, client, seed="7"):
        reply = self.generate(client, seed)
        if (self.viewer.world() or {}).get("id") != reply["world"]:
            client.wait_for(lambda m: isinstance(m, dict) and m.get("type") == "world" and
                            (m["key"] or "").startswith(reply["world"]), "the world is shown")
        self.assertTrue(client.ask(type="unpause")["ok"])
        return reply["world"]

    def show_some_world(self, client):
        """Any world, not paused: the one that is shown, or another."""
        if self.viewer.world() is None:
            self.generate_and_wait(client)
        else:
            self.assertTrue(client.ask(type="unpause")["ok"])

    def test_a_sentence_becomes_a_world_that_all_clients_see(self):
        with Socket(self.viewer) as client, Socket(self.viewer) as other:
            hello = client.wait_for_type("hello")
            self.assertEqual("controller", hello["role"])
            client.send(type="generate", id="g", layout="A lake in the center, forest around it.",
                        seed="11", size_m=96, resolution_m=1)
            progress = client.wait_for_type("progress")
            self.assertIn("eta_s", progress)
            reply = client.wait_for_type("reply", id="g")
            self.assertTrue(reply["ok"], reply)
            for socket in (client, other):
                told = socket.wait_for(
                    lambda m: isinstance(m, dict) and m.get("type") == "world" and
                    (m["key"] or "").startswith(reply["world"]), "the world")
            world = self.viewer.world()
            self.assertEqual(told["key"], world["key"])
            self.assertEqual(service("get_world", srv.GetWorld)().info.world_id, world["id"])
            for name, payload in world["payloads"].items():
                status, body = self.viewer.get(payload["url"])
                self.assertEqual((200, payload["bytes"]), (status, len(body)), name)
            agents = other.wait_for_type("agents")
            self.assertIn("robot", [agent["name"] for agent in agents["agents"]])
            frame = other.wait_for_bytes(AGENTS)
            version, = struct.unpack_from("<I", frame, 4)
            self.assertEqual(agents["version"], version)

    def test_keys_move_the_robot(self):
        with Socket(self.viewer) as client, Collector("/robot/odom", Odometry) as odometry:
            self.show_some_world(client)
            odometry.wait_until_connected()
            start = odometry.wait_for_next().pose.pose.position
            stop = threading.Event()

            def drive():
                while not stop.wait(0.1):
                    client.send(type="drive", robot="robot", linear_mps=0.8, angular_radps=0.1)

            thread = threading.Thread(target=drive)
            thread.start()
            try:
                odometry.wait_for(lambda message: math.hypot(
                    message.pose.pose.position.x - start.x,
                    message.pose.pose.position.y - start.y) > 0.5)
            finally:
                stop.set()
                thread.join()
            client.wait_for_bytes(AGENTS)

    def test_unknown_robots_and_illegal_texts_are_refused_with_reasons(self):
        with Socket(self.viewer) as client:
            self.show_some_world(client)
            reply = client.ask(type="drive", robot="nobody", linear_mps=1)
            self.assertEqual("NOT_FOUND", reply["code"])
            self.assertIn("robot", reply["message"])
            reply = client.ask(type="generate", layout="")
            self.assertEqual("INVALID_ARGUMENT", reply["code"])
            reply = client.ask(type="load_world", name="none of these")
            self.assertFalse(reply["ok"])
            self.assertTrue(reply["message"])

    def test_time_can_be_stopped_stepped_and_sped_up(self):
        with Socket(self.viewer) as client:
            self.show_some_world(client)
            self.assertTrue(client.ask(type="pause")["ok"])
            before = client.wait_for_type("clock", paused=True)["time_s"]
            self.assertTrue(client.ask(type="step", steps=200)["ok"])
            client.wait_for(lambda m: isinstance(m, dict) and m.get("type") == "clock" and
                            m["time_s"] > before + 1.9, "the clock after two seconds")
            self.assertTrue(client.ask(type="speed", factor=3)["ok"])
            client.wait_for_type("clock", speed=3.0)
            self.assertTrue(client.ask(type="reset")["ok"])
            self.assertTrue(client.ask(type="unpause")["ok"])
            client.wait_for_type("clock", paused=False)
            self.assertTrue(client.ask(type="set_weather", weather="fog")["ok"])
            client.wait_for_type("weather", weather="fog")
            self.assertTrue(client.ask(type="speed", factor=1)["ok"])

    def test_worlds_are_saved_listed_and_loaded(self):
        with Socket(self.viewer) as client:
            world = self.generate_and_wait(client)
            self.assertTrue(client.ask(type="save_world", name="kept")["ok"])
            worlds = client.ask(type="list_worlds")["worlds"]
            self.assertIn(("kept", world), [(entry["name"], entry["id"]) for entry in worlds])
            self.generate_and_wait(client, seed="8")
            reply = client.ask(type="load_world", name="kept")
            self.assertEqual((True, world), (reply["ok"], reply["world"]), reply)
            client.wait_for(lambda m: isinstance(m, dict) and m.get("type") == "world" and
                            (m["key"] or "").startswith(world), "the loaded world")

    def test_layers_come_while_somebody_looks(self):
        path = Path()
        path.header.frame_id = "map"
        for x in (1.0, 2.0, 3.0):
            pose = PoseStamped()
            pose.pose.position.x = x
            path.poses.append(pose)
        publisher = rospy.Publisher("/robot/plan", Path, queue_size=1, latch=True)
        with Socket(self.viewer) as client:
            self.show_some_world(client)
            publisher.publish(path)
            client.ask(type="subscribe", layers=["lidar", "paths"], robot="robot")
            shown = client.wait_for_type("path", topic="/robot/plan")
            self.assertEqual([1.0, 2.0, 3.0], [point[0] for point in shown["points_m"]])
            points = client.wait_for_bytes(POINTS)
            count, = struct.unpack_from("<H", points, 2)
            self.assertEqual(len(points), 28 + 7 * count)
            x, y, z = struct.unpack_from("<fff", points, 16)
            self.assertLess(max(abs(x), abs(y)), 64.0)
            publisher.unregister()
            client.wait_for_type("path", topic="/robot/plan", points_m=[])

    def test_a_world_server_that_ends_and_comes_back_is_followed(self):
        with Socket(self.viewer) as client:
            self.generate_and_wait(client)
            self.server.stop()
            told = client.wait_for_type("world", key=None)
            self.assertIn("world_server", told["reason"])
            self.assertIsNone(self.viewer.world())
            self.assertEqual("UNAVAILABLE", client.ask(type="pause")["code"])
            type(self).server = Server(worlds_directory=self.worlds.name).__enter__()
            World()
            self.assertTrue(self.generate_and_wait(client, seed="9"))
            self.assertIsNotNone(self.viewer.world())


if __name__ == "__main__":
    run("viewer_test", ViewerTest)
