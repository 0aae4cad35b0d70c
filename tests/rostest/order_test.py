#!/usr/bin/python3
"""Nodes that start in another order than usual, start again, or take each other's names."""

import signal
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
import rosservice
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from nav_msgs.srv import GetMap, GetMapResponse

from episode_world import FIELD, OtherRecorder, verify
from latticeworld.msg import EpisodeStatus, Status
from navigator_client import Driver, NavigatorProcess, pose_at
from server_process import Server
from world_client import TIMEOUT_S, Collector, World, run, service, wait_until

TAKES_STATIC_MAP = """
import rospy
from nav_msgs.srv import GetMap
rospy.init_node("taker")
service = rospy.Service("static_map", GetMap, lambda _: None)
rospy.spin()
"""


def wait_until_static_map_is_held():
    """A server offers its services one by one: one that is taken too early it would take itself."""
    wait_until(lambda: rosservice.get_service_node("/static_map") == "/world_server",
               "world_server holds the service")


class OrderTest(unittest.TestCase):
    @staticmethod
    def forget_time():
        """As on a fresh master."""
        if rospy.has_param("/use_sim_time"):
            rospy.delete_param("/use_sim_time")

    def test_a_recorder_that_starts_first_lives_in_simulated_time(self):
        self.forget_time()
        with tempfile.TemporaryDirectory() as folder, OtherRecorder("early", folder) as early:
            self.assertIs(True, rospy.get_param("/use_sim_time"))
            with Server():
                self.begin_episode(early.recorder, "first").step(steps=200)
                done = early.recorder.stop_episode()
                self.assertEqual(Status.OK, done.status.code, done.status.message)
            with rosbag.Bag(done.paths[0]) as bag:
                times = [time.to_sec() for _, _, time in bag.read_messages()]
                self.assertGreater(bag.get_message_count("/agents"), 10)
            self.assertLess(max(times), 1000.0)

    def begin_episode(self, recorder, name):
        """An episode of a world that stands still; the world."""
        world = World()
        world.generate(**FIELD)
        self.assertTrue(world.pause().success)
        started = recorder.start_episode(name=name)
        self.assertEqual(Status.OK, started.status.code, started.status.message)
        return world

    def test_a_navigator_that_starts_first_reaches_its_goal(self):
        self.forget_time()
        with NavigatorProcess("navigator_early", robot="robot", odom_timeout=8.0):
            wait_until(lambda: rospy.has_param("/use_sim_time"), "the navigator has begun")
            with Server(real_time_factor=4.0):
                World().generate(**FIELD)
                driver = Driver()
                driver.odometry.wait_for_next()
                wait_until(lambda: self.has_map(driver), "the navigator has a map")
                goal = pose_at(*driver.place_at(4.0))
                self.assertEqual(GoalStatus.SUCCEEDED, driver.go(goal), driver.text)
                driver.close()

    @staticmethod
    def has_map(driver):
        here = driver.pose().position
        try:
            return bool(driver.make_plan(goal=pose_at(here.x + 1.0, here.y)).plan.poses)
        except rospy.ServiceException:
            return False

    def test_a_server_that_starts_again_ends_the_episode_and_is_not_in_it(self):
        with tempfile.TemporaryDirectory() as folder, \
                OtherRecorder("witness", folder) as witness, \
                Collector("/witness/episode/status", EpisodeStatus) as status:
            with Server() as first:
                self.begin_episode(witness.recorder, "cut").step(steps=200)
                first.stop(signal.SIGKILL)  # the master knows its services still
            with Server():
                World().generate(**FIELD)
                ended = status.wait_for(lambda m: m.name == "cut" and m.state == "complete")
            self.assertIn("another world_server", ended.reason)
            with rosbag.Bag(ended.paths[0]) as bag:
                clocks = [m.clock for _, m, _ in bag.read_messages("/clock")]
                end = next(m for _, m, _ in bag.read_messages("/episode/end"))
                self.assertEqual(1, bag.get_message_count("/world/info"))
            self.assertGreater(len(clocks), 10)
            self.assertEqual(sorted(clocks), clocks)
            self.assertIn("another world_server", end.reason)
            code, said = verify(*ended.paths)
            self.assertEqual(0, code, said)

    def test_a_service_that_another_node_takes_is_told_and_held_again_after_it(self):
        def services(message):
            return next(one for one in message.status if one.name == "world_server: services")

        with Server(), Collector("diagnostics", DiagnosticArray) as diagnostics:
            wait_until_static_map_is_held()
            other = rospy.Service("static_map", GetMap, lambda _: GetMapResponse())
            warning = diagnostics.wait_for(lambda m: services(m).level == DiagnosticStatus.WARN)
            self.assertIn(f"{rospy.get_name()} has taken /static_map", services(warning).message)
            other.shutdown()
            wait_until_static_map_is_held()
            with self.assertRaisesRegex(rospy.ServiceException, "generate_world"):
                service("static_map", GetMap)()
            diagnostics.wait_for(lambda m: m.header.stamp > warning.header.stamp and
                                 services(m).level == DiagnosticStatus.OK)

    def test_a_service_of_a_node_that_was_killed_is_held_again(self):
        with Server():
            wait_until_static_map_is_held()
            other = subprocess.Popen([sys.executable, "-c", TAKES_STATIC_MAP])
            try:
                wait_until(lambda: rosservice.get_service_node("/static_map") == "/taker",
                           "the service is taken")
            finally:
                other.kill()  # it takes no leave of the master
                other.wait(TIMEOUT_S)
            wait_until_static_map_is_held()
            with self.assertRaisesRegex(rospy.ServiceException, "generate_world"):
                service("static_map", GetMap)()


if __name__ == "__main__":
    run("order_test", OrderTest)
