#!/usr/bin/python3
"""What agents do to the world: trees that fall, gates, crates; and the maps that follow."""

import csv
import math
import pathlib

import rospy
import tf2_ros
from geometry_msgs.msg import Point, Twist, Vector3
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from octomap_msgs.msg import Octomap

from latticeworld.msg import AgentEvent, ElementStates, SceneChanges, Status
from world_client import TIMEOUT_S, Collector, ServerTest, run, service, wait_until

WORLD = {"layout": "Flat grassland with a few scattered trees everywhere.",
         "environment": "A sunny summer noon.", "size": 128.0, "seed": 5}
RUN_UP_M = 9.0


class ElementsTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**WORLD)

    def setUp(self):
        self.assert_ok(self.world.reset_world())
        self.assertTrue(self.world.unpause().success)
        self.events = Collector("agent_events", AgentEvent)
        self.events.wait_until_connected()
        self.addCleanup(self.events.close)

    def assets(self):
        """Rows of the bundle's table, in their order."""
        saved = self.world.save_world(name="elements")
        self.assertIn(saved.status.code, (Status.OK, Status.ALREADY_EXISTS))
        with open(pathlib.Path(saved.path, "assets.csv"), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def tractor_before_a_thin_tree(self):
        """The number of the tree that a tractor stands west of, with nothing between."""
        assets = self.assets()
        solid = [(i, float(row["x_m"]), float(row["y_m"]), float(row["trunk_radius_m"]))
                 for i, row in enumerate(assets) if row["kind"] in ("tree", "stone", "building")]
        trees = sorted((radius, i, x, y) for i, x, y, radius in solid
                       if assets[i]["kind"] == "tree" and 0.03 < radius and x > RUN_UP_M - 55.0)
        for radius, number, x, y in trees:
            if any(i != number and x - RUN_UP_M - 3.0 < other_x < x + 12.0
                   and abs(other_y - y) < 3.0 for i, other_x, other_y, _ in solid):
                continue
            answer = self.world.spawn_agent(name="tractor", species="tractor", controllable=True,
                                            position=Point(x=x - RUN_UP_M, y=y))
            if answer.status.code == Status.OK:
                return number
        self.fail("no tree of this world has room for a tractor beside it")

    def test_a_name_answers_with_where_its_thing_is(self):
        self.assert_ok(self.world.spawn_element(kind="crate", name="parcel",
                                                position=Point(x=3.0, y=-50.0)))
        answer = self.world.query_things(names=["parcel"])
        self.assertEqual(Status.OK, answer.status.code, answer.status.message)
        [parcel] = answer.things
        self.assertEqual(("parcel", "crate", "stands"), (parcel.name, parcel.kind, parcel.condition))
        self.assertAlmostEqual(3.0, parcel.pose.position.x, delta=0.1)
        self.assertGreater(parcel.size.z, 0.1)
        self.assert_ok(self.world.remove_element(name="parcel"))
        self.assertEqual(Status.NOT_FOUND, self.world.query_things(names=["parcel"]).status.code)

    def test_a_tractor_fells_a_tree_and_the_maps_follow(self):
        with Collector("map", OccupancyGrid) as maps, Collector("octomap_binary", Octomap) as trees, \
                Collector("world/changes", SceneChanges) as changes:
            # Anew, for the maps that there are may still show what another test left.
            self.world.generate(**WORLD)
            self.assertTrue(self.world.unpause().success)
            began = self.world.get_world().info.header.stamp
            map_before = maps.wait_for(lambda m: m.header.stamp == began)
            trees_before = trees.wait_for(lambda m: m.header.stamp == began)
            changes.wait_for(lambda m: not m.felled)
            number = self.tractor_before_a_thin_tree()
            command = rospy.Publisher("tractor/cmd_vel", Twist, queue_size=1)
            ahead = Twist()
            ahead.linear.x = 4.0

            def told(kind):
                return any(event.kind == kind for event in self.events.messages())

            def fallen():
                if not told("felled_tree"):  # then the tractor may stop
                    command.publish(ahead)
                return told("tree_came_to_rest")

            wait_until(fallen, "the tree falls and comes to rest")
            felled = self.events.wait_for(lambda m: m.kind == "felled_tree")
            self.assertEqual("tractor", felled.agent)
            self.assertEqual(f"tree_{number}", felled.other)
            rest = self.events.wait_for(lambda m: m.kind == "tree_came_to_rest")

            lies = changes.wait_for(
                lambda m: any(tree.asset == number and tree.at_rest for tree in m.felled))
            tree = next(tree for tree in lies.felled if tree.asset == number)
            row = self.assets()[number]
            length = math.dist((tree.foot.x, tree.foot.y, tree.foot.z),
                               (tree.tip.x, tree.tip.y, tree.tip.z))
            self.assertAlmostEqual(float(row["height_m"]), length, delta=0.01 * length)
            self.assertLess(abs(tree.tip.z - tree.foot.z), 0.5 * length)

            map_after = maps.wait_for(lambda m: m.header.stamp >= rest.header.stamp)
            self.assertNotEqual(map_before.data, map_after.data)
            self.assertGreater(lies.map_version, 0)
            trees_after = trees.wait_for(lambda m: m.header.stamp >= rest.header.stamp)
            self.assertNotEqual(trees_before.data, trees_after.data)
            self.assertEqual(map_after.data, service("static_map", GetMap)().map.data)

            # Upright again, and so are the maps.
            self.assert_ok(self.world.reset_world())
            changes.wait_for(lambda m: m.header.stamp > lies.header.stamp and not m.felled)
            maps.wait_for(lambda m: m.header.stamp > map_after.header.stamp
                          and m.data == map_before.data)

    def spawn(self, **fields):
        """An element at the first free place along a row."""
        for x in range(-40, 41, 4):
            answer = self.world.spawn_element(position=Point(x=x, y=-8.0), **fields)
            if answer.status.code != Status.FAILED_PRECONDITION:
                break
        return self.assert_ok(answer).name

    def test_a_gate_opens_and_closes_when_it_is_told_to(self):
        gate = self.spawn(kind="gate")
        with Collector("elements", ElementStates) as elements:
            def opening(message):
                return next((element.opening for element in message.elements
                             if element.name == gate), None)
            self.assertAlmostEqual(0.0, opening(elements.wait_for(lambda m: opening(m) is not None)),
                                   delta=0.02)
            self.assert_ok(self.world.open_gate(name=gate))
            elements.wait_for(lambda m: abs(opening(m) or 0.0) > 1.2)
            opened = self.events.wait_for(lambda m: m.kind == "opened")
            self.assertEqual(gate, opened.agent)
            self.assert_ok(self.world.open_gate(name=gate, close=True))
            self.events.wait_for(lambda m: m.kind == "closed" and m.agent == gate)
            last = elements.wait_for(lambda m: m.header.stamp > opened.header.stamp
                                     and abs(opening(m)) < 0.1)
            self.assertEqual("map", last.header.frame_id)

    def test_elements_have_frames_and_end_with_remove(self):
        crate = self.spawn(kind="crate", name="box", size=Vector3(x=0.5, y=0.5, z=0.5))
        buffer = tf2_ros.Buffer(rospy.Duration(60.0))
        listener = tf2_ros.TransformListener(buffer)
        with Collector("elements", ElementStates) as elements:
            message = elements.wait_for(lambda m: any(e.name == crate for e in m.elements))
            element = next(e for e in message.elements if e.name == crate)
            self.assertEqual(("crate", 0.5), (element.kind, element.size.z))
            # The latest: the listener may have come after that message's stamp.
            frame = buffer.lookup_transform("map", crate, rospy.Time(),
                                            rospy.Duration(TIMEOUT_S)).transform.translation
            self.assertAlmostEqual(element.pose.position.x, frame.x, delta=0.05)
            self.assertAlmostEqual(element.pose.position.y, frame.y, delta=0.05)
            self.assert_ok(self.world.remove_element(name=crate))
            elements.wait_for(lambda m: m.header.stamp > message.header.stamp
                              and all(e.name != crate for e in m.elements))
        listener.unregister()

    def test_elements_that_are_not_legal_are_refused(self):
        refused, nan = self.assert_refused, float("nan")
        spawn = self.world.spawn_element
        refused(spawn(kind="catapult", position=Point(x=nan), mass=-1.0), Status.INVALID_ARGUMENT,
                "catapult", "crate", "gate", "position.x", "mass")
        refused(spawn(position=Point(x=1000.0)), Status.OUT_OF_RANGE, "1000")
        refused(spawn(name="no name"), Status.INVALID_ARGUMENT, "no name")
        refused(spawn(name="robot", position=Point(x=10.0)), Status.ALREADY_EXISTS, "robot")
        refused(self.world.remove_element(name="absent"), Status.NOT_FOUND, "absent")
        refused(self.world.open_gate(name="absent"), Status.NOT_FOUND, "absent")
        crate = self.spawn(kind="crate")
        refused(self.world.open_gate(name=crate), Status.FAILED_PRECONDITION, crate)
        gate = self.spawn(kind="gate")
        for opening in (nan, 7.0):
            refused(self.world.open_gate(name=gate, opening=opening), Status.OUT_OF_RANGE, "1.5")
        refused(self.world.remove_element(name="absent"), Status.NOT_FOUND, "absent", crate, gate)


if __name__ == "__main__":
    run("elements_test", ElementsTest)
