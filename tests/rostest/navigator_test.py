#!/usr/bin/python3
"""The navigator: goals of move_base's action, by points and by scan; refused ones; its names."""

import math
import pathlib
import threading

import rospkg
import rospy
import yaml
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseActionResult
from nav_msgs.msg import Odometry, Path
from std_srvs.srv import Empty
from tf2_ros import TransformBroadcaster

from navigator_client import (ENDED, GOAL_RADIUS_M, Driver, NavigatorProcess, closed_place, distance,
                              pose_at)
from world_client import TIMEOUT_S, Collector, ServerTest, run, service, wait_until

WORLD = {"layout": "A lake in the lower left, forest in the upper left, grassland everywhere else.",
         "environment": "A sunny summer noon. A wheeled robot waits in the center.",
         "size": 96.0, "seed": 11}
DEFAULTS = pathlib.Path(rospkg.RosPack().get_path("latticeworld"), "launch_cfg/navigator.yaml")
TOLERANCE_M = 0.15  # the robot rolls on for a moment after it was told to stand
STANDING_MPS = 0.05


class NavigatorTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**WORLD)
        cls.driver = Driver()
        cls.driver.odometry.wait_for_next()

    def setUp(self):
        self.assertTrue(self.world.unpause().success)

    def assert_reaches(self, driver, x, y):
        self.assertEqual(GoalStatus.SUCCEEDED, driver.go(pose_at(x, y)), driver.text)
        self.assertLess(distance(driver.pose(), x, y), GOAL_RADIUS_M + TOLERANCE_M)

    def wait_until_standing(self, driver):
        driver.odometry.wait_for(
            lambda m, begin=driver.odometry.messages()[-1].header.stamp: m.header.stamp > begin and
            math.hypot(m.twist.twist.linear.x, m.twist.twist.angular.z) < STANDING_MPS)

    def test_it_reaches_a_goal_on_points_and_tells_its_way(self):
        with Collector("robot/move_base/NavfnROS/plan", Path) as ways:
            with Collector("robot/move_base/current_goal", PoseStamped) as goals:
                x, y = self.driver.place_at(22.0)
                self.assert_reaches(self.driver, x, y)
                self.assertEqual("map", goals.wait_for(
                    lambda m: distance(m.pose, x, y) < 0.01).header.frame_id)
                way = ways.wait_for(lambda m: distance(m.poses[-1].pose, x, y) < GOAL_RADIUS_M)
        self.assertEqual("map", way.header.frame_id)
        self.assertGreater(len(self.driver.feedback), 20)
        begin = self.driver.feedback[0].base_position
        self.assertEqual("map", begin.header.frame_id)
        self.assertGreater(distance(begin.pose, x, y), 20.0)

    def test_a_second_robot_goes_by_its_scan_at_the_same_time(self):
        near = self.driver.place_at(6.0, first_deg=180)
        self.assert_ok(self.world.spawn_agent(
            name="scout", controllable=True, species="wheeled robot",
            position=pose_at(*near).pose.position))
        # The world runs four times as fast as the clock on the wall: a busy machine may keep a
        # process from its messages for longer than the default's half a second there.
        with NavigatorProcess("navigator_scout", robot="scout", sensor="scan", odom_timeout=8.0):
            scout = Driver("scout")
            scout.odometry.wait_for_next()
            goal = scout.place_at(20.0)
            other = self.driver.place_at(10.0, first_deg=270)
            scout.send(pose_at(*goal))
            self.assert_reaches(self.driver, *other)
            self.assertEqual(GoalStatus.SUCCEEDED, scout.wait(), scout.text)
            self.assertLess(distance(scout.pose(), *goal), GOAL_RADIUS_M + TOLERANCE_M)
            # One that is taken away under way: its goal ends and says why.
            scout.send(pose_at(*scout.place_at(20.0)))
            scout.wait_until_active()
            self.assert_ok(self.world.remove_agent(name="scout"))
            self.assertEqual(GoalStatus.ABORTED, scout.wait())
            self.assertIn("/scout/odom", scout.text)
            scout.close()

    def test_a_goal_replaces_the_one_before_and_a_refused_one_does_too(self):
        with Collector("robot/move_base/result", MoveBaseActionResult) as results:
            results.wait_until_connected()
            self.driver.send(pose_at(*self.driver.place_at(20.0)))
            self.driver.wait_until_active()
            self.assert_reaches(self.driver, *self.driver.place_at(4.0))
            ends = [m.status.status for m in results.messages()]
            self.assertEqual([GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED], ends)
            self.driver.send(pose_at(*self.driver.place_at(20.0)))
            self.driver.wait_until_active()
            self.assertEqual(GoalStatus.ABORTED, self.driver.go(pose_at(4000.0, 0.0)))
            results.wait_for(lambda m: len(results.messages()) == 4)
            ends = [m.status.status for m in results.messages()]
            self.assertEqual([GoalStatus.PREEMPTED, GoalStatus.ABORTED], ends[2:])
        self.wait_until_standing(self.driver)

    def test_cancel_stops_the_robot(self):
        self.driver.send(pose_at(*self.driver.place_at(20.0)))
        moving = self.driver.odometry.wait_for_next().header.stamp
        self.driver.odometry.wait_for(
            lambda m: m.header.stamp > moving and m.twist.twist.linear.x > 0.3)
        with Collector("robot/cmd_vel", Twist) as commands:
            commands.wait_until_connected()
            self.driver.client.cancel_goal()
            self.assertEqual(GoalStatus.PREEMPTED, self.driver.wait())
            commands.wait_for(lambda m: m.linear.x == 0.0 and m.angular.z == 0.0)
        self.wait_until_standing(self.driver)

    def test_bad_goals_are_refused_with_what_was_given_and_what_is_legal(self):
        closed = closed_place()
        nan = pose_at(0.0, 0.0)
        nan.pose.position.x = math.nan
        no_length = pose_at(0.0, 0.0)
        no_length.pose.orientation.w = 0.0
        broken = pose_at(0.0, 0.0)
        broken.pose.orientation.z = math.inf
        lying = pose_at(0.0, 0.0)
        lying.pose.orientation.x, lying.pose.orientation.w = 1.0, 0.0
        for goal, words in ((nan, ("nan", "finite")),
                            (no_length, ("orientation", "(0, 0, 0, 0)", "legal")),
                            (broken, ("orientation", "inf", "legal")),
                            (lying, ("upright", "legal")),
                            (pose_at(0.0, 0.0, frame=""), ("frame", "map")),
                            (pose_at(0.0, 0.0, frame="mars"), ("mars", "map")),
                            (pose_at(48.5, 0.0), ("48.5", "OUT_OF_RANGE")),
                            (pose_at(-1e300, 1e300), ("OUT_OF_RANGE",)),
                            (pose_at(*closed), ("FAILED_PRECONDITION",))):
            self.assertEqual(GoalStatus.ABORTED, self.driver.go(goal), words)
            for word in words:
                self.assertIn(word, self.driver.text)

    def test_goals_by_topic_and_in_the_robots_own_frame(self):
        with Collector("robot/move_base/result", MoveBaseActionResult) as results:
            results.wait_until_connected()
            x, y = self.driver.place_at(4.0)
            publisher = rospy.Publisher("robot/move_base_simple/goal", PoseStamped, queue_size=1)
            wait_until(lambda: publisher.get_num_connections() > 0, "the navigator listens")
            publisher.publish(pose_at(x, y))
            result = results.wait_for(lambda m: True)
            self.assertEqual(GoalStatus.SUCCEEDED, result.status.status, result.status.text)
        self.assertLess(distance(self.driver.pose(), x, y), GOAL_RADIUS_M + TOLERANCE_M)
        before = self.driver.pose()
        ahead = self.driver.go(pose_at(0.2, 0.0, frame="robot/base_link"))
        self.assertEqual(GoalStatus.SUCCEEDED, ahead, self.driver.text)
        self.assertLess(distance(self.driver.pose(), before.position.x, before.position.y), 1.0)

    def test_plans_are_made_and_refused(self):
        x, y = self.driver.place_at(15.0)
        plan = self.driver.make_plan(goal=pose_at(x, y)).plan  # from where the robot is
        self.assertEqual("map", plan.header.frame_id)
        here = self.driver.pose().position
        self.assertLess(distance(plan.poses[0].pose, here.x, here.y), 1.0)
        self.assertLess(distance(plan.poses[-1].pose, x, y), GOAL_RADIUS_M)
        for start, goal, words in ((PoseStamped(), pose_at(0.0, 900.0), "900"),
                                   (PoseStamped(), pose_at(*closed_place()), "FAILED_PRECOND"),
                                   (pose_at(0.0, 0.0, frame="mars"), pose_at(x, y), "mars"),
                                   (pose_at(math.nan, 0.0), pose_at(x, y), "nan")):
            with self.assertRaisesRegex(rospy.ServiceException, words):
                self.driver.make_plan(start=start, goal=goal)
        service("robot/move_base/clear_costmaps", Empty)()

    def test_it_waits_with_a_paused_world(self):
        x, y = self.driver.place_at(8.0)
        self.assertTrue(self.world.pause().success)
        self.driver.send(pose_at(x, y))
        self.driver.wait_until_active()  # taken at once, though time stands still
        self.driver.client.cancel_goal()
        self.assertEqual(GoalStatus.PREEMPTED, self.driver.wait())
        self.driver.send(pose_at(x, y))
        self.driver.wait_until_active()
        for _ in range(400):
            heard = len(self.driver.feedback)
            self.assert_ok(self.world.step(steps=10))  # one period of control
            wait_until(lambda before=heard: len(self.driver.feedback) > before or
                       self.driver.client.get_state() in ENDED, "the command for what was stepped")
            if self.driver.client.get_state() in ENDED:
                break
        self.assertEqual(GoalStatus.SUCCEEDED, self.driver.wait(), self.driver.text)

    def test_a_goal_that_comes_before_tf_waits_for_it(self):
        # A robot whose odometry is another's, and whose tf begins when the test lets it.
        broadcaster = TransformBroadcaster()
        odometry = rospy.Publisher("late/odom", Odometry, queue_size=1)
        frame_is_known = threading.Event()

        def forward(message):
            tf = TransformStamped(header=message.header, child_frame_id="late/base_link")
            tf.header.frame_id = "map"
            tf.transform.rotation.w = 1.0
            message.child_frame_id = tf.child_frame_id
            if frame_is_known.is_set():
                broadcaster.sendTransform(tf)
            odometry.publish(message)

        x, y = self.driver.place_at(6.0)
        source = rospy.Subscriber("robot/odom", Odometry, forward, queue_size=1)
        with NavigatorProcess("navigator_late", robot="late", odom_timeout=20.0):
            late = Driver("late")
            late.odometry.wait_for_next()
            # In vain, for odom_timeout; before that there may be no map or odometry yet.
            wait_until(lambda: late.go(pose_at(x, y)) == GoalStatus.ABORTED and
                       "late/base_link" in late.text, "a goal ends for want of tf")
            with Collector("late/move_base/current_goal", PoseStamped) as goals:
                goals.wait_until_connected()
                late.send(pose_at(x, y))
                late.wait_until_active()
                self.assertEqual([], goals.messages())
                frame_is_known.set()
                goals.wait_for(lambda m: distance(m.pose, x, y) < 0.01)
            wait_until(lambda: late.feedback, "the robot is driven")
            late.client.cancel_goal()
            self.assertEqual(GoalStatus.PREEMPTED, late.wait())
            late.close()
        source.unregister()

    def test_before_there_is_a_map_or_a_robot_it_says_so(self):
        with NavigatorProcess("navigator_nobody", robot="nobody"):
            nobody = Driver("nobody")
            self.assertEqual(GoalStatus.ABORTED, nobody.go(pose_at(0.0, 0.0)))
            wait_until(lambda: nobody.go(pose_at(0.0, 0.0)) and "no map" not in nobody.text,
                       "the map is there")
            self.assertIn("/nobody/odom", nobody.text)
            nobody.close()
        with NavigatorProcess("navigator_lost", "map:=nowhere", robot="lost"):
            lost = Driver("lost")
            self.assertEqual(GoalStatus.ABORTED, lost.go(pose_at(0.0, 0.0)))
            self.assertIn("/nowhere", lost.text)
            lost.close()

    def test_the_shipped_parameters_are_the_full_list_and_bad_ones_are_all_named(self):
        parameters = yaml.safe_load(DEFAULTS.read_text(encoding="utf-8"))
        with NavigatorProcess("navigator_defaults", **{**parameters, "robot": "other"}):
            Driver("other").close()
        with NavigatorProcess("navigator_bad", robbot="x", robot="two words", sensor="nose",
                              control_rate=-1.0, robot_radius="wide") as bad:
            self.assertEqual(1, bad.process.wait(TIMEOUT_S))
            for word in ("robbot", "two words", "sensor", "scan, points", "control_rate",
                         "robot_radius", "goal_radius"):
                self.assertIn(word, bad.text())


if __name__ == "__main__":
    run("navigator_test", NavigatorTest)
