#!/usr/bin/python3
"""The bridge of a road over a lake: driven over, passed below, run into, and told on every map."""

import json
import math
import pathlib

import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Point, Twist
from grid_map_msgs.msg import GridMap
from nav_msgs.msg import OccupancyGrid, Odometry

from latticeworld.msg import Status
from navigator_client import Driver, distance, pose_at
from world_client import Collector, ServerTest, run, wait_until

WORLD = {"layout": "A large lake in the center. A road runs from the west to the east across the "
                   "lake. Grassland everywhere else.",
         "environment": "A sunny summer noon. A wheeled robot waits in the middle left.",
         "size": 192.0, "seed": 2}
ROAD_SLOPE = math.atan(0.12)  # roads are no steeper, and so are their ramps
BUMP_RAD = 0.05  # what a wheel on an edge or a breaking robot adds for a moment
RAMP_M = 4.0  # from the deck's ends to where the robot begins and is sent
WHEELS_M = 0.4  # around a robot's middle
AWAY_M = 14.0  # from the deck's middle to where a whale begins
WHALE_RADIUS_M = 3.0


def pitch_of(orientation):
    """Above 0: nose down [rad]."""
    q = orientation
    return math.asin(max(-1.0, min(1.0, 2.0 * (q.w * q.y - q.z * q.x))))


def places_along(path):
    """A place every 0.1 m of a path."""
    for a, b in zip(path.poses, path.poses[1:]):
        a, b = a.pose.position, b.pose.position
        count = max(1, round(math.hypot(b.x - a.x, b.y - a.y) / 0.1))
        for i in range(count):
            yield a.x + i / count * (b.x - a.x), a.y + i / count * (b.y - a.y)


class Bridge:
    """A bridge of bridges.json; its ends are ordered from the west to the east."""

    def __init__(self, fields):
        self.fields = fields
        self.line = [(place["x_m"], place["y_m"]) for place in fields["line"]]
        supports = fields["supports_m"]
        self.length_m = sum(math.dist(a, b) for a, b in zip(self.line, self.line[1:]))
        if self.line[0][0] > self.line[-1][0]:
            self.line.reverse()
            supports = [self.length_m - along for along in reversed(supports)]
        self.supports_m = supports
        self.deck_z_m = fields["deck_z_m"]

    def place(self, along_m, aside_m=0.0):
        """A place along the line, to the left of it, and where the line heads there."""
        for a, b in zip(self.line, self.line[1:]):
            piece_m = math.dist(a, b)
            if along_m <= piece_m or b is self.line[-1]:
                yaw = math.atan2(b[1] - a[1], b[0] - a[0])
                return (a[0] + along_m * math.cos(yaw) - aside_m * math.sin(yaw),
                        a[1] + along_m * math.sin(yaw) + aside_m * math.cos(yaw), yaw)
            along_m -= piece_m
        raise AssertionError("a bridge has a line")

    def is_on(self, x, y):
        """Whether a place is on the deck."""
        for a, b in zip(self.line, self.line[1:]):
            piece_m = math.dist(a, b)
            ux, uy = (b[0] - a[0]) / piece_m, (b[1] - a[1]) / piece_m
            along, aside = ux * (x - a[0]) + uy * (y - a[1]), ux * (y - a[1]) - uy * (x - a[0])
            if 0.0 <= along <= piece_m and abs(aside) <= 0.5 * self.fields["width_m"]:
                return True
        return False


class BridgesTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**WORLD)
        saved = cls.world.save_world(name="bridges")
        with open(pathlib.Path(saved.path, "bridges.json"), encoding="utf-8") as file:
            bridges = json.load(file)
        cls.bridge = Bridge(bridges[0])

    def setUp(self):
        self.assert_ok(self.world.reset_world())
        self.assertTrue(self.world.unpause().success)

    def samples(self, places):
        answer = self.assert_ok(self.world.query_terrain(
            points=[Point(x=place[0], y=place[1]) for place in places]))
        return answer.samples

    def test_a_robot_is_sent_from_bank_to_bank_and_stays_on_the_deck(self):
        bridge = self.bridge
        driver = Driver()
        self.addCleanup(driver.close)
        # The way around the lake is longer: what the navigator takes is the shortest.
        begin = bridge.place(-RAMP_M)
        self.assertEqual(GoalStatus.SUCCEEDED, driver.go(pose_at(*begin[:2])), driver.text)
        first = len(driver.truth.messages())
        end = bridge.place(bridge.length_m + RAMP_M)
        plan = driver.make_plan(goal=pose_at(*end[:2])).plan
        over_m = sum(0.1 for x, y in places_along(plan) if bridge.is_on(x, y))
        self.assertGreater(over_m, 0.95 * bridge.length_m, "the plan leads over the deck")
        self.assertEqual(GoalStatus.SUCCEEDED, driver.go(pose_at(*end[:2])), driver.text)
        self.assertLess(distance(driver.pose(), *end[:2]), 1.0)
        poses = [message.pose.pose for message in driver.truth.messages()[first:]]
        decks = [pose for pose in poses if bridge.is_on(pose.position.x, pose.position.y)]
        self.assertGreater(len(decks), 100)
        for pose in decks:
            self.assertAlmostEqual(bridge.deck_z_m, pose.position.z, delta=0.25)
        on_road = self.on_road(poses)
        self.assertGreater(len(on_road), len(decks), "the ramps are road")
        for pose in on_road:
            self.assertLess(abs(pitch_of(pose.orientation)), ROAD_SLOPE + BUMP_RAD)

    def on_road(self, poses):
        """The poses of a robot whose wheels all stand on the road, on the deck or beside it."""
        places = [(pose.position.x + dx, pose.position.y + dy) for pose in poses
                  for dx in (-WHEELS_M, WHEELS_M) for dy in (-WHEELS_M, WHEELS_M)]
        paved = [sample.surface == "road" or not math.isnan(sample.deck_height)
                 for sample in self.samples(places)]
        return [pose for i, pose in enumerate(poses) if all(paved[4 * i:4 * i + 4])]

    def swim(self, along_m, seconds):
        """Where a whale gets that swims below the deck from the north in so many seconds."""
        x, y, yaw = self.bridge.place(along_m, AWAY_M)
        self.assert_ok(self.world.spawn_agent(name="whale", species="whale", controllable=True,
                                              position=Point(x=x, y=y), heading=yaw - math.pi / 2))
        self.addCleanup(self.world.remove_agent, name="whale")
        command = rospy.Publisher("whale/cmd_vel", Twist, queue_size=1)
        ahead = Twist()
        ahead.linear.x = 1.5
        with Collector("whale/ground_truth", Odometry) as truth:
            begin = truth.wait_for_next().header.stamp
            while truth.wait_for_next().header.stamp < begin + rospy.Duration(seconds):
                command.publish(ahead)
            end = truth.messages()[-1].pose.pose.position
        along, aside = self.bridge.place(along_m)[:2], yaw + math.pi / 2
        return math.cos(aside) * (end.x - along[0]) + math.sin(aside) * (end.y - along[1])

    def opening(self):
        """The middle of the opening that is nearest to the lake's middle."""
        supports = self.bridge.supports_m
        middle = len(supports) // 2
        return 0.5 * (supports[middle - 1] + supports[middle])

    def test_a_whale_passes_below_the_deck(self):
        self.assertLess(self.swim(self.opening(), 24.0), -WHALE_RADIUS_M - 2.0)

    def test_a_pier_stops_a_whale(self):
        supports = self.bridge.supports_m
        self.assertGreater(self.swim(supports[len(supports) // 2], 24.0), WHALE_RADIUS_M - 1.0)

    def test_query_terrain_tells_the_water_and_the_deck_above_it(self):
        bridge = self.bridge
        along = self.opening()
        asides = [0.5 * i for i in range(-20, 21)]
        water = None
        for aside, sample in zip(asides, self.samples(
                [bridge.place(along, aside) for aside in asides])):
            self.assertGreater(sample.water_depth, 0.5, "the water goes on below")
            water = sample.height + sample.water_depth
            if abs(aside) > 0.5 * bridge.fields["width_m"]:
                self.assertTrue(math.isnan(sample.deck_height))
                self.assertTrue(math.isnan(sample.deck_clearance))
                continue
            self.assertAlmostEqual(bridge.deck_z_m, sample.deck_height, delta=1e-6)
            self.assertAlmostEqual(bridge.deck_z_m - bridge.fields["thickness_m"] - water,
                                   sample.deck_clearance, delta=1e-5)
            self.assertEqual(bridge.fields["load_kg"], sample.deck_load)

    def test_maps_have_the_deck_and_grid_map_has_its_height(self):
        bridge = self.bridge
        with Collector("world/height_map", GridMap) as maps, Collector("map", OccupancyGrid) as flats:
            grid = maps.wait_for(lambda m: True)
            flat = flats.wait_for(lambda m: True)
        layer = grid.data[grid.layers.index("bridge_deck")]
        rows = layer.layout.dim[1].size
        decks = 0
        for at, height in enumerate(layer.data):
            x = 0.5 * grid.info.length_x - (at % rows + 0.5) * grid.info.resolution
            y = 0.5 * grid.info.length_y - (at // rows + 0.5) * grid.info.resolution
            if math.isnan(height):
                self.assertFalse(bridge.is_on(x, y))
            elif bridge.is_on(x, y):
                decks += 1
                self.assertAlmostEqual(bridge.deck_z_m, height, delta=1e-4)
        self.assertGreater(decks, 500)
        for along in range(2, int(bridge.length_m) - 1):
            x, y, _ = bridge.place(along)
            col = int((x - flat.info.origin.position.x) / flat.info.resolution)
            row = int((y - flat.info.origin.position.y) / flat.info.resolution)
            self.assertLess(flat.data[row * flat.info.width + col], 50, "the deck is a way")


if __name__ == "__main__":
    run("bridges_test", BridgesTest)
