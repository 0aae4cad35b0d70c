#!/usr/bin/python3
"""Commands, steps and observations in one call: what a loop that learns or plans relies on."""

import contextlib
import math

import numpy
import rospy
from geometry_msgs.msg import Point, Twist, Vector3
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

from latticeworld import srv
from latticeworld.msg import AgentCommand, JournalEntry, Status
from server_process import Server
from world_client import Collector, ServerTest, World, run, service, wait_until

WORLD = {"layout": "Flat grassland everywhere.",
         "environment": "A sunny summer noon. A wheeled robot waits in the center. "
                        "A sheep grazes in the upper left.",
         "size": 64.0, "seed": 3}
STEP_S = 0.01
# Of a sweep at 40 Hz after a reset, whatever step it begins with.
STEPS_TO_A_SCAN = 6


def told(agent, forward=0.0, yaw_rate=0.0):
    return AgentCommand(agent, Twist(linear=Vector3(x=forward), angular=Vector3(z=yaw_rate)))


def value_of(observation):
    """All of an observation, to the bit, but for stamps, which go on over resets."""
    bumper = observation.bumper
    return (str(observation.state), observation.alive, str(observation.odom), bumper.pressed,
            bumper.force, bumper.bearing, *bits_of(observation.scan))


def bits_of(scan):
    """A beam that was lost is NaN, which equals nothing."""
    return tuple(numpy.array(values, numpy.float32).tobytes()
                 for values in (scan.ranges, scan.intensities))


def vector(message):
    return message.x, message.y, message.z


def tilt_of(orientation):
    """Angle between the z axis of what is turned so and that of its frame [rad]."""
    return math.acos(1.0 - 2.0 * (orientation.x ** 2 + orientation.y ** 2))


class Client(World):
    def __init__(self):
        super().__init__()
        self.lockstep = service("lockstep", srv.Lockstep)

    def episode(self, seed, calls=30):
        """What is observed of the robot on its way, and the hashes of the states."""
        assert self.reset_world(seed=seed).status.code == Status.OK
        observed = []
        for i in range(calls):
            answer = self.lockstep(commands=[told("robot", 1.0, math.sin(0.4 * i))], steps=2,
                                   scan=True, hash=True)
            assert answer.status.code == Status.OK, answer.status.message
            observed.append((answer.state_hash, value_of(answer.observations[0])))
        return observed


@contextlib.contextmanager
def server(suite="scanner"):
    with Server(sensor_suite=suite, start_paused=True):
        client = Client()
        client.generate(**WORLD)
        yield client


class LockstepTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        with contextlib.ExitStack() as stack:
            cls.world = stack.enter_context(server())
            cls.addClassCleanup(stack.pop_all().close)

    def setUp(self):
        self.assertTrue(self.world.pause().success)
        self.assert_ok(self.world.reset_world())

    def lockstep(self, *commands, **fields):
        return self.assert_ok(self.world.lockstep(commands=commands, **fields))

    def test_the_observation_is_of_the_last_step(self):
        with Collector("robot/ground_truth", Odometry) as truths, \
                Collector("robot/odom", Odometry) as odoms:
            truths.wait_until_connected()
            odoms.wait_until_connected()
            answer = self.lockstep(told("robot", 1.0, 0.3), steps=37)
            self.assertEqual(37, answer.episode_step)
            observation, = answer.observations
            truth = truths.wait_for(lambda m: m.header.stamp == answer.stamp)
            odom = odoms.wait_for(lambda m: m.header.stamp == answer.stamp)
        self.assertEqual(truth.twist.twist, observation.state.twist)
        for wanted, pose in ((truth, observation.state.pose), (odom, observation.odom)):
            wanted = wanted.pose.pose
            self.assertLess(math.dist(vector(wanted.position), vector(pose.position)), 1e-9)
            # Both signs of a quaternion are the same rotation.
            turns = numpy.dot([*vector(wanted.orientation), wanted.orientation.w],
                              [*vector(pose.orientation), pose.orientation.w])
            self.assertAlmostEqual(1.0, abs(turns), places=9)
        self.assertGreater(observation.state.twist.linear.x, 0.3)
        self.assertGreater(observation.odom.position.x, 0.05)
        self.assertTrue(observation.alive)

    def spawn_on_a_slope(self):
        """Spawns a robot, "climber", on a slope of 12 to 25 degrees; the slope there [rad]."""
        places_m = range(-55, 56, 5)
        points = [Point(x=float(x), y=float(y)) for x in places_m for y in places_m]
        samples = self.assert_ok(self.world.query_terrain(points=points)).samples
        for point, sample in zip(points, samples):
            if not math.radians(12.0) < sample.slope < math.radians(25.0):
                continue
            spawned = self.world.spawn_agent(name="climber", species="wheeled robot",
                                             position=point, controllable=True)
            if spawned.status.code == Status.OK:
                return sample.slope
        raise AssertionError("no robot can be spawned on a slope")

    def test_odometry_of_a_robot_on_a_slope_begins_level(self):
        self.addCleanup(self.world.generate, **WORLD)
        self.world.generate(layout="A high mountain in the center.", environment="A summer noon.",
                            size=128.0, seed=3)
        with Collector("/tf", TFMessage) as transforms, \
                Collector("climber/odom", Odometry) as odoms:
            transforms.wait_until_connected()
            slope = self.spawn_on_a_slope()
            odoms.wait_until_connected()
            answer = self.lockstep(observe=["climber"])
            message = transforms.wait_for(lambda m: m.transforms[0].header.stamp == answer.stamp)
            odom = odoms.wait_for(lambda m: m.header.stamp == answer.stamp)
        transform = next(t.transform for t in message.transforms
                         if (t.header.frame_id, t.child_frame_id) == ("map", "climber/odom"))
        self.assertLess(abs(transform.rotation.x), 1e-9)
        self.assertLess(abs(transform.rotation.y), 1e-9)
        observation, = answer.observations
        for pose in (odom.pose.pose, observation.odom):
            self.assertAlmostEqual(slope, tilt_of(pose.orientation), delta=math.radians(3.0))

    def test_the_scan_is_the_last_complete_sweep_as_published(self):
        with Collector("robot/scan", LaserScan) as scans:
            scans.wait_until_connected()
            for _ in range(10):
                answer = self.lockstep(told("robot", 0.5, 1.0), steps=3, scan=True)
                scan = answer.observations[0].scan
                if not scan.ranges:
                    self.assertLess(answer.episode_step, STEPS_TO_A_SCAN)
                    continue
                published = scans.wait_for(lambda m, scan=scan: m.header.stamp == scan.header.stamp)
                self.assertEqual(bits_of(published), bits_of(scan))
                end_s = (scan.header.stamp + rospy.Duration(scan.scan_time)).to_sec()
                age_s = answer.stamp.to_sec() - end_s
                self.assertTrue(-1e-6 < age_s < scan.scan_time, age_s)
                # Sweeps follow each other from the episode's begin, between two steps too.
                sweeps = (answer.episode_step * STEP_S - age_s) / scan.scan_time
                self.assertAlmostEqual(round(sweeps), sweeps, places=4)

    def test_a_scan_needs_no_listener_and_is_not_of_before_the_reset(self):
        answer = self.lockstep(observe=["robot"], steps=STEPS_TO_A_SCAN, scan=True)
        self.assertEqual(1081, len(answer.observations[0].scan.ranges))
        again = self.lockstep(observe=["robot"], scan=True)  # goes on from call to call
        self.assertTrue(again.observations[0].scan.ranges)
        self.assertFalse(self.lockstep(observe=["robot"]).observations[0].scan.ranges)
        self.assert_ok(self.world.reset_world())
        self.assertFalse(self.lockstep(observe=["robot"], scan=True).observations[0].scan.ranges)

    def test_a_request_with_anything_wrong_in_it_changes_nothing(self):
        before = self.world.get_world()
        with Collector("world/journal", JournalEntry) as journal:
            journal.wait_until_connected()
            refused = {
                ("nobody",): (Status.NOT_FOUND, dict(observe=["robot", "nobody"])),
                ("sheep_1", "external"): (Status.FAILED_PRECONDITION,
                                          dict(commands=[told("robot", 1.0), told("sheep_1")])),
                ("finite",): (Status.INVALID_ARGUMENT, dict(commands=[told("robot", math.nan)])),
                ("twice",): (Status.INVALID_ARGUMENT, dict(commands=[told("robot")] * 2)),
                ("2 things", "nobody", "ghost"): (Status.INVALID_ARGUMENT,
                                                  dict(strikes=["nobody"], observe=["ghost"])),
                ("100001",): (Status.OUT_OF_RANGE,
                              dict(commands=[told("robot", 1.0)], steps=100001)),
            }
            for words, (code, fields) in refused.items():
                self.assert_refused(self.world.lockstep(**fields), code, *words)
            after = self.world.get_world()
            self.assertEqual((before.state_hash, before.step), (after.state_hash, after.step))
            self.lockstep(told("robot", 0.25))  # the first one that is told
            entry = journal.wait_for(lambda m: True)
        self.assertIn("0.25", entry.call)

    def test_a_call_of_an_episode_that_is_over_is_refused(self):
        mine = self.assert_ok(self.world.reset_world()).episode
        self.assertGreater(mine, 0)
        self.lockstep(observe=["robot"], episode=mine)
        others = self.assert_ok(self.world.reset_world()).episode
        self.assertGreater(others, mine)
        before = self.world.get_world()
        self.assert_refused(self.world.lockstep(observe=["robot"], episode=mine),
                            Status.FAILED_PRECONDITION, f"episode {mine} is over", str(others))
        self.assertEqual(before.step, self.world.get_world().step)
        self.lockstep(observe=["robot"], episode=others)
        self.lockstep(observe=["robot"])  # of whatever runs

    def test_it_is_refused_while_time_runs(self):
        self.assertTrue(self.world.unpause().success)
        self.assert_refused(self.world.lockstep(observe=["robot"]), Status.FAILED_PRECONDITION,
                            "pause")

    def test_nothing_is_swept_for_calls_once_time_runs(self):
        self.lockstep(observe=["robot"], steps=STEPS_TO_A_SCAN, scan=True)
        self.assertTrue(self.world.unpause().success)
        step = self.world.get_world().step
        wait_until(lambda: self.world.get_world().step > step + 10, "ten steps")
        self.assertTrue(self.world.pause().success)
        # A sweep that went on would be complete.
        self.assertFalse(self.lockstep(observe=["robot"], scan=True).observations[0].scan.ranges)

    def test_a_bump_is_felt_and_told(self):
        pose = self.lockstep(observe=["robot"]).observations[0].state.pose
        yaw = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
        place = Point(x=pose.position.x + 2.0 * math.cos(yaw),
                      y=pose.position.y + 2.0 * math.sin(yaw))
        self.assert_ok(self.world.spawn_element(kind="loose stone", name="rock", position=place,
                                                heading=yaw, size=Vector3(1.5, 1.5, 1.5)))
        events, bumps = [], []
        for _ in range(30):
            answer = self.lockstep(told("robot", 1.0), steps=10)
            events += answer.events
            bumps += [o.bumper for o in answer.observations if o.bumper.pressed]
        collision = next(event for event in events if event.kind == "collided")
        self.assertEqual(("robot", "rock"), (collision.agent, collision.other))
        self.assertTrue(bumps)
        self.assertGreater(bumps[0].force, 0.0)
        self.assertLess(abs(bumps[0].bearing), 0.8)  # before it
        self.assertEqual("robot/base_link", bumps[0].header.frame_id)

    def test_events_are_those_of_the_calls_own_steps_and_of_whom_it_observes(self):
        self.assert_ok(self.world.spawn_agent(name="scout", place="lower left", controllable=True))
        answer = self.lockstep(observe=["robot"])
        self.assertEqual([], [event for event in answer.events if event.agent == "scout"])
        self.assertEqual(["robot"], [o.state.name for o in answer.observations])

    def test_agents_decided_for_from_outside_are_commanded_and_carry_nothing(self):
        self.assert_ok(self.world.spawn_agent(name="led", species="goblin", place="lower left",
                                              policy="external"))
        before, = self.lockstep(observe=["led"]).observations
        answer = self.lockstep(told("led", 1.0), told("robot"), strikes=["led"], steps=40)
        self.assertEqual(["led", "robot"], [o.state.name for o in answer.observations])
        moved = math.hypot(answer.observations[0].state.pose.position.x
                           - before.state.pose.position.x,
                           answer.observations[0].state.pose.position.y
                           - before.state.pose.position.y)
        self.assertGreater(moved, 0.1)
        topics = {name for name, _ in rospy.get_published_topics("/led")}
        self.assertIn("/led/ground_truth", topics)
        self.assertFalse(topics & {"/led/scan", "/led/imu", "/led/bumper"}, topics)

    def test_the_same_seed_and_commands_are_observed_alike(self):
        self.lockstep(observe=["robot"])  # without a scan: the second one follows one with scans
        first = self.world.episode(seed=5)
        self.assertEqual(first, self.world.episode(seed=5))
        self.assertNotEqual(first, self.world.episode(seed=6))  # at least the noise
        self.assertGreater(len({value for _, value in first}), 20)


class ServersTest(ServerTest):
    """Each with a server of its own."""

    @classmethod
    def setUpClass(cls):
        pass

    def test_two_servers_observe_alike(self):
        episodes = []
        for _ in range(2):
            with server() as client:
                episodes.append(client.episode(seed=5))
        self.assertEqual(episodes[0], episodes[1])

    def test_a_suite_without_a_scanner_is_named(self):
        with server(suite="none") as client:
            self.assert_refused(client.lockstep(observe=["robot"], scan=True),
                                Status.FAILED_PRECONDITION, '"none"', "2D lidar")
            self.assert_ok(client.lockstep(observe=["robot"]))


class AllTests(LockstepTest):
    """rostest's results have one name: the tests with servers of their own come last."""

    def test_z_servers(self):
        type(self).doClassCleanups()
        for name in ("test_two_servers_observe_alike", "test_a_suite_without_a_scanner_is_named"):
            with self.subTest(name):
                getattr(ServersTest(name), name)()


if __name__ == "__main__":
    run("lockstep_test", AllTests)
