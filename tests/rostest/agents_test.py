#!/usr/bin/python3
"""What agents are told from outside: speeds, joints, blows, policies."""

import math

import rosgraph
import rospy
from geometry_msgs.msg import Point, Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from std_msgs.msg import Empty

from latticeworld.msg import AgentEvent, AgentStates, Status
from world_client import Collector, ServerTest, run, wait_until

NAN = float("nan")
MEADOW = {"layout": "Flat grassland everywhere.", "environment": "A sunny summer noon.",
          "size": 64.0, "seed": 5}


def twist(x=0.0, yaw=0.0):
    message = Twist()
    message.linear.x = x
    message.angular.z = yaw
    return message


def publisher(topic, message_type):
    """One that somebody listens to."""
    topic = rospy.Publisher(topic, message_type, queue_size=1)
    wait_until(lambda: topic.get_num_connections() > 0, f"somebody listens to {topic.resolved_name}")
    return topic


class AgentsTest(ServerTest):
    """On a meadow, with whom each test brings along."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**MEADOW)

    def setUp(self):
        self.assert_ok(self.world.reset_world())
        self.assertTrue(self.world.unpause().success)
        self.states = Collector("agents", AgentStates)
        self.events = Collector("agent_events", AgentEvent)
        self.states.wait_for_next()
        self.events.wait_until_connected()
        self.addCleanup(self.states.close)
        self.addCleanup(self.events.close)

    def spawn(self, name, species, x=0.0, y=0.0, **fields):
        """At the free place nearest to (x, y) on its row."""
        for shift in range(16):
            answer = self.world.spawn_agent(name=name, species=species,
                                            position=Point(x=x + shift, y=y), **fields)
            if answer.status.code != Status.FAILED_PRECONDITION:
                break
        self.assert_ok(answer)
        return self.agent(name)

    def agent(self, name):
        """As it is from now on."""
        state = self.states.wait_for_next()
        while not any(agent.name == name for agent in state.agents):
            state = self.states.wait_for_next()
        return next(agent for agent in state.agents if agent.name == name)

    def drive_until(self, condition, *commands):
        """Publishes each (topic, message) again and again."""
        def ask():
            for topic, message in commands:
                topic.publish(message)
            return condition()
        wait_until(ask, "what is commanded happens")

    def test_main_agents_obey_each_its_own_commands(self):
        self.spawn("scout", "wheeled_robot", x=-20.0, y=10.0, controllable=True)
        self.spawn("ranger", "wheeled_robot", x=-20.0, y=-10.0, controllable=True)
        scout = publisher("scout/cmd_vel", Twist)
        ranger = publisher("ranger/cmd_vel", Twist)
        with Collector("scout/ground_truth", Odometry) as truth_of_scout, \
                Collector("ranger/ground_truth", Odometry) as truth_of_ranger:
            first = truth_of_scout.wait_for_next().pose.pose.position
            resting = truth_of_ranger.wait_for_next().pose.pose.position

            def gone(truth, start):
                at = truth.messages()[-1].pose.pose.position
                return math.hypot(at.x - start.x, at.y - start.y)

            self.drive_until(lambda: gone(truth_of_scout, first) > 1.0, (scout, twist(x=1.0)))
            self.assertLess(gone(truth_of_ranger, resting), 0.2)
            self.drive_until(lambda: gone(truth_of_ranger, resting) > 1.0,
                             (ranger, twist(x=1.0)))

    def test_a_robot_strikes_back(self):
        goblin = self.spawn("goblin", "goblin", x=0.0, y=15.0, policy="external")
        robot = self.spawn("robot_2", "wheeled_robot", x=goblin.pose.position.x - 1.6, y=15.0,
                           controllable=True)
        strike = publisher("robot_2/strike", Empty)
        forward = publisher("robot_2/cmd_vel", Twist)
        self.assertEqual((1, 2), (robot.team, goblin.team))
        self.drive_until(lambda: self.agent("goblin").health < 1.0,
                         (strike, Empty()), (forward, twist(x=0.3)))
        hit = self.events.wait_for(lambda m: m.kind == "hit")
        self.assertEqual({"goblin", "robot_2"}, {hit.agent, hit.other})
        self.events.wait_for(lambda m: m.kind == "attacked" and m.agent == "robot_2"
                             and m.other == "goblin")

    def test_a_policy_from_outside_drives_a_goblin(self):
        start = self.spawn("puppet", "goblin", x=-15.0)
        self.assertNotEqual("external", start.policy)
        self.assert_ok(self.world.set_policy(agent="puppet", policy="external"))
        self.assertEqual("external", self.agent("puppet").policy)
        command = publisher("puppet/cmd_vel", Twist)
        start = self.agent("puppet").pose.position

        def gone():
            at = self.agent("puppet").pose.position
            return math.hypot(at.x - start.x, at.y - start.y)

        self.drive_until(lambda: gone() > 1.5, (command, twist(x=1.0)))
        # Without a policy from outside it hears nothing.
        self.assert_ok(self.world.set_policy(agent="puppet"))
        wait_until(lambda: command.get_num_connections() == 0, "its topics end")
        wait_until(lambda: not self.topics_of("puppet"), "those that it publishes, too")
        self.assertEqual(start_policy(self.states, "puppet"), self.agent("puppet").policy)

    @staticmethod
    def topics_of(agent):
        """What it publishes."""
        published, _, _ = rosgraph.Master("/agents_test").getSystemState()
        return sorted(topic for topic, nodes in published
                      if topic.startswith(f"/{agent}/") and "/world_server" in nodes)

    def test_a_policy_from_outside_sees_state_and_joints(self):
        self.spawn("hound", "robotic_dog", x=-10.0, y=5.0, policy="external")
        topics = self.topics_of("hound")
        self.assertIn("/hound/ground_truth", topics)
        self.assertIn("/hound/joint_states", topics)
        self.assertNotIn("/hound/odom", topics)
        with Collector("hound/joint_states", JointState) as joints, \
                Collector("hound/ground_truth", Odometry) as truth:
            stands = joints.wait_for_next()
            self.assertEqual(12, len(stands.name))
            self.assertEqual(12, len(stands.position))
            told = truth.wait_for_next()
            self.assertEqual(("map", "hound/base_link"),
                             (told.header.frame_id, told.child_frame_id))
            state = self.states.wait_for(lambda m: m.header.stamp == told.header.stamp)
            hound = next(agent for agent in state.agents if agent.name == "hound")
            for axis in "xyz":
                self.assertAlmostEqual(getattr(hound.pose.position, axis),
                                       getattr(told.pose.pose.position, axis), places=9)
            for axis in "xyzw":
                self.assertAlmostEqual(getattr(hound.pose.orientation, axis),
                                       getattr(told.pose.pose.orientation, axis), places=9)
            knee = stands.name.index("front_left_knee")
            command = publisher("hound/joint_command", JointState)
            wanted = stands.position[knee] - 0.3
            self.drive_until(
                lambda: abs(joints.wait_for_next().position[knee] - wanted) < 0.1,
                (command, JointState(name=["front_left_knee"], position=[wanted])))
        # A robot of that name has odometry as well.
        self.assert_ok(self.world.remove_agent(name="hound"))
        self.spawn("hound", "robotic_dog", x=-10.0, y=5.0, controllable=True)
        self.assertIn("/hound/odom", self.topics_of("hound"))

    def test_controllable_agents_take_no_policy(self):
        self.spawn("scout", "wheeled_robot", x=-20.0, team=6, controllable=True)
        self.assert_refused(self.world.set_policy(agent="scout", policy="pursuer"),
                            Status.FAILED_PRECONDITION, "scout", "controllable")
        self.assert_refused(self.world.spawn_agent(species="goblin", controllable=True,
                                                   policy="pursuer"),
                            Status.INVALID_ARGUMENT, "controllable", "pursuer")
        # A team's is for the others of the team.
        self.assert_ok(self.world.set_policy(team=6, policy="external"))
        self.spawn("puppet", "goblin", x=10.0, team=6)
        self.assertEqual(("", "external"),
                         (self.agent("scout").policy, self.agent("puppet").policy))

    def test_a_policy_can_be_a_teams(self):
        self.spawn("first", "goblin", x=-15.0, team=7)
        self.spawn("second", "goblin", x=5.0, team=7)
        self.assert_ok(self.world.set_policy(team=7, policy="external"))
        self.spawn("third", "goblin", x=15.0, team=7)
        for name in ("first", "second", "third"):
            self.assertEqual(("external", 7), (self.agent(name).policy, self.agent(name).team))

    def test_joints_of_a_robotic_dog_obey(self):
        self.spawn("dog", "robotic_dog", x=-10.0, controllable=True)
        with Collector("dog/joint_states", JointState) as joints:
            stands = joints.wait_for_next()
            self.assertEqual(12, len(stands.name))
            for values in (stands.position, stands.velocity, stands.effort):
                self.assertEqual(12, len(values))
            knee = stands.name.index("rear_left_knee")
            command = publisher("dog/joint_command", JointState)
            wanted = stands.position[knee] - 0.4
            self.drive_until(
                lambda: abs(joints.wait_for_next().position[knee] - wanted) < 0.1,
                (command, JointState(name=["rear_left_knee"], position=[wanted])))
            # Without new commands its own gait takes the leg back.
            joints.wait_for(lambda m: m.header.stamp > stands.header.stamp + rospy.Duration(1.0)
                            and abs(m.position[knee] - stands.position[knee]) < 0.15)

    def test_commands_that_are_not_legal_are_refused_in_the_log(self):
        self.spawn("scout", "wheeled_robot", x=-20.0, controllable=True)
        speeds = publisher("scout/cmd_vel", Twist)
        joints = publisher("scout/joint_command", JointState)
        cases = ((speeds, twist(x=NAN), ("cmd_vel of scout",)),
                 (joints, JointState(name=["elbow"], velocity=[1.0]),
                  ("joint_command of scout", "elbow", "front_left_wheel")),
                 (joints, JointState(name=["front_left_wheel"], velocity=[NAN]),
                  ("joint_command of scout", "front_left_wheel")),
                 (joints, JointState(name=["front_left_wheel"], velocity=[1.0, 2.0]),
                  ("joint_command of scout", "velocity")))
        for topic, message, words in cases:
            with Collector("/rosout", Log) as log:
                log.wait_until_connected()
                self.drive_until(lambda: any(all(word in entry.msg for word in words)
                                             for entry in log.messages()), (topic, message))
        before = self.agent("scout").pose.position
        after = self.agent("scout").pose.position
        self.assertTrue(math.isfinite(after.x))
        self.assertAlmostEqual(before.x, after.x, delta=0.05)

    def test_requests_that_are_not_legal_name_what_is(self):
        refused, invalid = self.assert_refused, Status.INVALID_ARGUMENT
        spawn = self.world.spawn_agent
        refused(spawn(species="dragon", policy="daydreamer", team=99, heading=NAN), invalid,
                "dragon", "sheep", "tractor", "daydreamer", "external", "99", "1 .. 15", "heading")
        refused(self.world.set_policy(agent="nobody", policy="external"), Status.NOT_FOUND,
                "nobody", "robot")
        refused(self.world.set_policy(agent="robot", policy="daydreamer"), invalid, "daydreamer",
                "external")
        refused(self.world.set_policy(policy="external"), invalid, "agent", "team")
        refused(self.world.set_policy(team=16), invalid, "16", "1 .. 15")
        for factor in (-1.0, 0.001, 1e6, NAN):
            refused(self.world.set_real_time_factor(factor=factor), Status.OUT_OF_RANGE, "factor",
                    "0.01 .. 1000")
        known = self.assert_ok(self.world.get_world())
        self.assertIn("tractor", known.species)
        self.assertIn("external", known.policies)
        # What get_world lists is what is taken.
        for policy in known.policies:
            self.assert_ok(self.world.set_policy(team=9, policy=policy))

    def test_the_real_time_factor_is_kept_over_worlds(self):
        self.assertEqual(1.0, self.assert_ok(self.world.set_real_time_factor(factor=3.0)).before)
        self.assert_ok(self.world.reset_world())
        self.assertEqual(3.0, self.assert_ok(self.world.set_real_time_factor(factor=1.0)).before)


def start_policy(states, name):
    """What the agent followed at first."""
    first = states.wait_for(lambda m: any(agent.name == name for agent in m.agents))
    return next(agent.policy for agent in first.agents if agent.name == name)


if __name__ == "__main__":
    run("agents_test", AgentsTest)
