#!/usr/bin/python3
"""Time, steps, resets, frames and robots of a running world."""

import random

import rospy
import tf2_ros
from geometry_msgs.msg import Point, Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock

from latticeworld.msg import AgentStates, Status
from world_client import TIMEOUT_S, Collector, WorldTest, run

STEP_S = 0.01


class SimulationTest(WorldTest):
    def test_step_makes_exactly_n_steps(self):
        self.assertTrue(self.world.pause().success)
        for n in (1, 7, 250):
            stamp = self.assert_ok(self.world.step(steps=1)).stamp
            before = self.assert_ok(self.world.get_world())
            after = self.assert_ok(self.world.step(steps=n))
            self.assertEqual(before.step + n, after.step)
            self.assertEqual(before.episode_step + n, after.episode_step)
            self.assertEqual(round(n * STEP_S * 1e9), (after.stamp - stamp).to_nsec())
            self.assertEqual(after.step, self.world.get_world().step)

    def test_step_publishes_the_state_it_ends_with(self):
        self.assertTrue(self.world.pause().success)
        states = Collector("agents", AgentStates)
        states.wait_until_connected()
        after = self.assert_ok(self.world.step(steps=3))
        last = states.wait_for(lambda m: m.step == after.step)
        self.assertEqual(after.stamp, last.header.stamp)
        states.close()

    def test_step_is_refused_while_running_and_beyond_its_limits(self):
        self.assert_refused(self.world.step(steps=1), Status.FAILED_PRECONDITION, "pause")
        self.assertTrue(self.world.pause().success)
        self.assert_refused(self.world.step(steps=100001), Status.OUT_OF_RANGE, "100001", "100000")

    def test_reset_gives_back_the_start_state(self):
        self.assertTrue(self.world.pause().success)
        start = self.assert_ok(self.world.reset_world())
        began = self.world.get_world()
        self.assertEqual(0, began.episode_step)
        first = self.assert_ok(self.world.step(steps=200, hash=True))
        self.assertNotEqual(start.state_hash, first.state_hash)
        self.assertEqual(start.state_hash, self.assert_ok(self.world.reset_world()).state_hash)
        again = self.assert_ok(self.world.step(steps=200, hash=True))
        self.assertEqual(first.state_hash, again.state_hash)
        # ROS time and the count of steps went on.
        self.assertGreater(again.stamp, first.stamp)
        self.assertEqual(first.step + 200, again.step)
        self.assertEqual(200, again.episode_step)

    def test_reset_with_another_seed_goes_another_way(self):
        self.assertTrue(self.world.pause().success)
        self.assertEqual(11, self.assert_ok(self.world.reset_world(seed=11)).seed)
        one = self.world.step(steps=300, hash=True).state_hash
        self.assert_ok(self.world.reset_world(seed=12))
        self.assertNotEqual(one, self.world.step(steps=300, hash=True).state_hash)

    def test_one_seed_gives_one_world_and_one_run(self):
        self.assertTrue(self.world.pause().success)
        runs = []
        for seed in (21, 21, 22):
            world = self.world.generate(seed=seed)
            self.assertEqual(seed, world.seed)
            self.assertTrue(self.world.get_world().paused)
            runs.append((world.world_id, self.world.step(steps=300, hash=True).state_hash))
        self.assertEqual(runs[0], runs[1])
        self.assertNotEqual(runs[0][0], runs[2][0])
        self.assertNotEqual(runs[0][1], runs[2][1])

    def test_clock_never_falls_over_steps_resets_and_worlds(self):
        clock = Collector("/clock", Clock)
        clock.wait_for(lambda m: True)
        self.assert_ok(self.world.reset_world())
        self.world.generate(seed=31)
        self.assertTrue(self.world.pause().success)
        end = self.assert_ok(self.world.step(steps=10)).stamp
        clock.wait_for(lambda m: m.clock >= end)
        times = [message.clock for message in clock.messages()]
        self.assertGreater(len(times), 10)
        self.assertEqual(sorted(times), times)
        clock.close()

    def test_clock_goes_on_while_a_world_is_made(self):
        clock = Collector("/clock", Clock)
        clock.wait_for(lambda m: True)
        before = len(clock.messages())
        first = clock.messages()[-1].clock
        self.world.generate(seed=32, size=512.0)
        during = clock.messages()[before:]  # told between the request and its answer
        self.assertGreater(len(during), 3)
        self.assertGreater(during[-1].clock, first)
        clock.close()

    def test_tf_of_every_agent_follows_its_stamped_state(self):
        buffer = tf2_ros.Buffer(rospy.Duration(60.0))
        listener = tf2_ros.TransformListener(buffer)
        states = Collector("agents", AgentStates)
        # From here on the listener has heard, so that the states to come have their transforms.
        buffer.lookup_transform("map", "robot/base_link", rospy.Time(0), rospy.Duration(TIMEOUT_S))
        for _ in range(5):
            state = states.wait_for_next()
            self.assertGreater(len(state.agents), 5)
            self.assertTrue(any(agent.controllable for agent in state.agents))
            for agent in state.agents:
                base = agent.name + "/base_link"
                transform = buffer.lookup_transform("map", base, state.header.stamp,
                                                    rospy.Duration(TIMEOUT_S)).transform
                at, q = agent.pose.position, agent.pose.orientation
                for name in "xyz":
                    self.assertAlmostEqual(getattr(at, name),
                                           getattr(transform.translation, name), places=6)
                r = transform.rotation
                self.assertAlmostEqual(1.0, abs(q.x * r.x + q.y * r.y + q.z * r.z + q.w * r.w),
                                       places=6)
                if agent.controllable:
                    frames = buffer.lookup_transform(agent.name + "/odom", base, state.header.stamp)
                    self.assertEqual(agent.name + "/odom", frames.header.frame_id)
        listener.unregister()
        states.close()

    def test_cmd_vel_drives_the_robot_over_the_ground(self):
        # Out in the open: houses stand around the one that every world has.
        robot = self.assert_ok(self.world.spawn_agent(place="upper right", controllable=True)).name
        truth = Collector(robot + "/ground_truth", Odometry)
        odom = Collector(robot + "/odom", Odometry)
        command = rospy.Publisher(robot + "/cmd_vel", Twist, queue_size=1)
        first = truth.wait_for(lambda m: True)
        odom.wait_for(lambda m: True)
        twist = Twist()
        twist.linear.x = 1.0
        twist.angular.z = 0.2

        def far(message):
            command.publish(twist)  # a robot without a new command stops
            dx = message.pose.pose.position.x - first.pose.pose.position.x
            dy = message.pose.pose.position.y - first.pose.pose.position.y
            return dx * dx + dy * dy > 9.0

        truth.wait_for(far)
        messages = truth.messages()
        answer = self.assert_ok(self.world.query_terrain(
            points=[message.pose.pose.position for message in messages]))
        for message, sample in zip(messages, answer.samples):
            above = message.pose.pose.position.z - sample.height
            self.assertGreater(above, -0.1, "it sinks")
            self.assertLess(above, 0.4, "it floats")
        self.assertEqual("map", messages[-1].header.frame_id)
        self.assertEqual(robot + "/base_link", messages[-1].child_frame_id)
        self.assertEqual(robot + "/odom", odom.messages()[-1].header.frame_id)
        # Without a new command it stops by itself.
        truth.wait_for(lambda m: m.header.stamp > messages[-1].header.stamp + rospy.Duration(1.0)
                       and abs(m.twist.twist.linear.x) < 0.05)
        for collector in (truth, odom):
            collector.close()

    def test_spawned_robot_has_topics_that_end_with_it(self):
        spawned = self.assert_ok(self.world.spawn_agent(place="upper right", controllable=True,
                                                        species="wheeled_robot", name="scout"))
        self.assertEqual("scout", spawned.name)
        truth = Collector("scout/ground_truth", Odometry)
        truth.wait_for(lambda m: m.child_frame_id == "scout/base_link")
        self.assert_refused(self.world.spawn_agent(name="scout", place="center"),
                            Status.ALREADY_EXISTS, "scout")
        self.assert_ok(self.world.remove_agent(name="scout"))
        self.assertNotIn("/scout/odom", [name for name, _ in rospy.get_published_topics()])
        states = Collector("agents", AgentStates)
        after = states.wait_for(lambda m: True)
        self.assertNotIn("scout", [agent.name for agent in after.agents])
        self.assert_refused(self.world.remove_agent(name="scout"), Status.NOT_FOUND, "scout",
                            after.agents[0].name)
        truth.close()
        states.close()

    def test_nothing_is_spawned_where_it_cannot_live(self):
        self.assert_refused(self.world.spawn_agent(species="dragon", place="nowhere"),
                            Status.INVALID_ARGUMENT, "dragon", "sheep", "nowhere", "upper left")
        self.assert_refused(self.world.spawn_agent(position=Point(x=65.0)), Status.OUT_OF_RANGE)
        self.assert_refused(self.world.spawn_agent(position=Point(x=float("nan"))),
                            Status.INVALID_ARGUMENT, "nan")
        self.assert_refused(self.world.spawn_agent(name="no name", place="center"),
                            Status.INVALID_ARGUMENT, "no name")
        # In deep water, found by asking.
        source = random.Random(1)
        points = [Point(x=source.uniform(-60, 60), y=source.uniform(-60, 60)) for _ in range(5000)]
        samples = self.assert_ok(self.world.query_terrain(points=points)).samples
        depth, lake = max((sample.water_depth, i) for i, sample in enumerate(samples))
        self.assertGreater(depth, 0.5)
        answer = self.world.spawn_agent(position=points[lake], species="sheep")
        self.assert_refused(answer, Status.FAILED_PRECONDITION, "deep")


if __name__ == "__main__":
    run("simulation_test", SimulationTest)
