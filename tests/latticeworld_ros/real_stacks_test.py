#!/usr/bin/env python3
"""The configuration for other people's stacks: it parses, what it names of ours is there, it fits the robot.

Usage: real_stacks_test.py SOURCE_DIR
"""

import json
import math
import pathlib
import re
import sys
import unittest
import xml.etree.ElementTree

import yaml

SOURCE = pathlib.Path(sys.argv.pop(1))
CONFIG = SOURCE / "launch_cfg"
MOVE_BASE = CONFIG / "move_base"
PAGE = SOURCE / "docs" / "real_stacks.md"


def load(path):
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def blocks_of(text):
    """The YAML blocks of a page that begin by naming a node of ours: [(node, parameters)]."""
    found = re.findall(r"```yaml\n# (\w+)\n(.*?)```", text, re.DOTALL)
    return [(node, yaml.safe_load(block)) for node, block in found]


def recipes_of(text):
    """The indented XML of a page, one element a block: that which nodes are started with."""
    lines = re.findall(r"(?:^    .*\n)+", text, re.MULTILINE)
    return [xml.etree.ElementTree.fromstring(block) for block in lines
            if block.lstrip().startswith("<")]


def parameters_of(node):
    """The parameters that a <node> is given, as roslaunch reads them."""
    given = {param.get("name"): yaml.safe_load(param.get("value"))
             for param in node.findall("param")}
    for block in node.findall("rosparam"):
        value = yaml.safe_load(block.text)
        given.update({block.get("param"): value} if block.get("param") else value)
    return given


class RealStacksTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.common = load(MOVE_BASE / "costmap_common.yaml")
        cls.local = load(MOVE_BASE / "local_costmap.yaml")
        cls.global_ = load(MOVE_BASE / "global_costmap.yaml")
        cls.planner = load(MOVE_BASE / "planner.yaml")
        vehicles = json.loads((SOURCE / "src/latticeworld/species/data/vehicles.json")
                              .read_text(encoding="utf-8"))
        cls.robot = next(one for one in vehicles["species"] if one["name"] == "wheeled robot")

    def assert_parameters_of(self, node, given):
        known = load(CONFIG / f"{node}.yaml")
        for name, value in given.items():
            self.assertIn(name, known, f"{node} has no parameter of that name")
            wanted = (int, float) if isinstance(known[name], (int, float)) else type(known[name])
            self.assertIsInstance(value, wanted, name)

    def test_every_file_parses_to_parameters(self):
        for path in MOVE_BASE.glob("*.yaml"):
            self.assertIsInstance(load(path), dict, path)

    def test_every_parameter_of_ours_is_there(self):
        self.assert_parameters_of("world_server", load(MOVE_BASE / "world_server.yaml"))
        blocks = blocks_of(PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(blocks), 3)
        for node, given in blocks:
            self.assert_parameters_of(node, given)

    def test_the_page_says_of_move_base_what_is_shipped(self):
        blocks = blocks_of(PAGE.read_text(encoding="utf-8"))
        self.assertEqual(("world_server", load(MOVE_BASE / "world_server.yaml")), blocks[0])

    def test_the_launch_file_names_files_and_arguments_that_are_there(self):
        tree = xml.etree.ElementTree.parse(MOVE_BASE / "move_base.launch").getroot()
        own = {arg.get("name") for arg in tree.findall("arg")}
        text = (MOVE_BASE / "move_base.launch").read_text(encoding="utf-8")
        files = re.findall(r"\$\(find latticeworld\)/([^\"]+)", text)
        self.assertGreater(len(files), 4)
        for name in files:
            self.assertTrue((SOURCE / name).is_file(), name)
        for path in [MOVE_BASE / "move_base.launch", *MOVE_BASE.glob("*.yaml")]:
            for name in re.findall(r"\$\(arg (\w+)\)", path.read_text(encoding="utf-8")):
                self.assertIn(name, own, path)
        for include in tree.findall("include"):
            included = include.get("file").replace("$(find latticeworld)", str(SOURCE))
            known = {arg.get("name") for arg in
                     xml.etree.ElementTree.parse(included).getroot().findall("arg")}
            for arg in include.findall("arg"):
                self.assertIn(arg.get("name"), known)

    def test_files_that_name_the_robot_are_loaded_with_its_name(self):
        tree = xml.etree.ElementTree.parse(MOVE_BASE / "move_base.launch").getroot()
        for load_ in tree.iter("rosparam"):
            path = load_.get("file").replace("$(find latticeworld)", str(SOURCE))
            if "$(arg" in pathlib.Path(path).read_text(encoding="utf-8"):
                self.assertEqual("true", load_.get("subst_value"), path)

    def test_the_footprint_is_the_robots(self):
        vehicle = self.robot["vehicle"]
        half_length = max(vehicle["chassis_length_m"],
                          vehicle["wheelbase_m"] + 2.0 * vehicle["wheel_radius_m"]) / 2.0
        half_width = max(vehicle["chassis_width_m"],
                         vehicle["track_m"] + vehicle["wheel_width_m"]) / 2.0
        for x, y in self.common["footprint"]:
            self.assertAlmostEqual(half_length, abs(x))
            self.assertAlmostEqual(half_width, abs(y))
            self.assertLess(abs(math.hypot(x, y) - self.robot["radius_m"]), 0.01)
        self.assertGreaterEqual(self.common["inflation_layer"]["inflation_radius"],
                                self.robot["radius_m"])

    def test_the_planners_keep_to_what_the_robot_can(self):
        planner = self.planner["DWAPlannerROS"]
        self.assertLessEqual(planner["max_vel_trans"], self.robot["top_speed_mps"])
        self.assertLessEqual(planner["max_vel_x"], planner["max_vel_trans"])
        self.assertLessEqual(planner["max_vel_theta"], self.robot["turn_rate_radps"])
        self.assertLessEqual(planner["acc_lim_x"], self.robot["acceleration_mps2"])
        self.assertEqual(0.0, planner["max_vel_y"])

    def test_the_scan_counts_wherever_the_ground_lies(self):
        layer = self.common["obstacle_layer"]
        self.assertEqual(["scan"], layer["observation_sources"].split())
        scan = layer["scan"]
        # Elevation data has land from -430 m to 8849 m.
        self.assertLess(scan["min_obstacle_height"], -500.0)
        self.assertGreater(scan["max_obstacle_height"], 9000.0)
        self.assertGreater(layer["max_obstacle_height"], 9000.0)
        self.assertIs(True, scan["inf_is_valid"])
        self.assertIs(True, scan["clearing"])
        self.assertGreater(scan["raytrace_range"], scan["obstacle_range"])
        self.assertLessEqual(scan["raytrace_range"],
                             min(self.local["width"], self.local["height"]) / 2.0)

    def test_a_robot_with_its_nose_at_a_bush_can_back_off(self):
        self.assertLess(self.planner["DWAPlannerROS"]["min_vel_x"], 0.0)

    def test_what_no_run_has_had_is_on_the_page_and_not_in_the_files(self):
        page = PAGE.read_text(encoding="utf-8")
        for behaviour in ("conservative_reset", "aggressive_reset"):
            self.assertNotIn(behaviour, self.planner)
            self.assertRegex(page, rf"`{behaviour}`[^#]*that was not\s+run")
        layers = {plugin["name"] for costmap in (self.local, self.global_)
                  for plugin in costmap["plugins"]}
        for told in re.findall(r"`layer_names: \[(\w+)\]`", page):
            self.assertIn(told, layers)

    def test_ways_are_planned_around_what_the_scan_will_mark(self):
        order = [plugin["name"] for plugin in self.global_["plugins"]]
        self.assertLess(order.index("static_layer"), order.index("plants_layer"))
        plants = self.global_["plants_layer"]
        self.assertEqual("/world/scan_map", plants["map_topic"])
        self.assertIs(True, plants["use_maximum"], "it would take the place of `map`")
        self.assertIs(False, plants["first_map_only"])

    def nodes_on_the_page(self):
        """By name what each <node> of the page's recipes is given."""
        recipes = recipes_of(PAGE.read_text(encoding="utf-8"))
        return {node.get("name"): parameters_of(node)
                for recipe in recipes for node in recipe.iter("node")}

    def test_the_recipes_of_the_page_are_ones_that_roslaunch_can_read(self):
        nodes = self.nodes_on_the_page()
        self.assertLessEqual({"amcl", "slam_gmapping", "ekf_odom", "ekf_map", "navsat_transform",
                              "octomap_server"}, set(nodes))
        self.assertEqual("robot/map", nodes["slam_gmapping"]["map_frame"])

    def test_filters_say_of_each_of_their_fifteen_quantities_whether_it_counts(self):
        nodes = self.nodes_on_the_page()
        for name in ("ekf_odom", "ekf_map"):
            configs = [key for key in nodes[name] if key.endswith("_config")]
            self.assertGreater(len(configs), 1)
            for key in configs:
                self.assertEqual(15, len(nodes[name][key]), f"{name} {key}")
                self.assertLessEqual(set(nodes[name][key]), {True, False})
                self.assertFalse(any(nodes[name][key][12:]), "a bias would be integrated twice")

    def test_the_filter_in_map_knows_where_map_begins_and_how_high_the_robot_is(self):
        nodes = self.nodes_on_the_page()
        self.assertEqual("map", nodes["ekf_map"]["world_frame"])
        self.assertEqual("odometry/gps", nodes["ekf_map"]["odom1"])
        self.assertEqual([True] * 3, nodes["ekf_map"]["odom1_config"][:3])
        navsat = nodes["navsat_transform"]
        self.assertIs(False, navsat["zero_altitude"])
        self.assertIs(True, navsat["wait_for_datum"])
        latitude, longitude, yaw = navsat["datum"]
        self.assertEqual(load(CONFIG / "world_server.yaml")["longitude"], longitude)
        weather = (SOURCE / "docs/weather.md").read_text(encoding="utf-8")
        self.assertIn(f"other worlds that of {latitude:.0f} deg N", weather)
        self.assertEqual(0.0, yaw)

    def test_what_grid_map_visualization_draws_are_layers_of_the_height_map(self):
        given = load(CONFIG / "grid_map_visualization.yaml")
        self.assertEqual("/world/height_map", given["grid_map_topic"])
        drawn = given["grid_map_visualizations"]
        names = [one["name"] for one in drawn]
        self.assertGreater(len(names), 2, "without a list it draws nothing")
        self.assertEqual(len(names), len(set(names)))
        made = (SOURCE / "src/latticeworld_ros/publishing/world_messages.cc").read_text(
            encoding="utf-8")
        for layer in [one["params"]["layer"] for one in drawn if "layer" in one["params"]]:
            self.assertIn(f'{{"{layer}", &', made)
        self.assertIn("launch_cfg/grid_map_visualization.yaml", PAGE.read_text(encoding="utf-8"))

    def test_every_layer_that_is_configured_is_a_plugin(self):
        for costmap in (self.local, self.global_):
            plugins = {plugin["name"] for plugin in costmap["plugins"]}
            layers = {name for name in {**self.common, **costmap} if name.endswith("_layer")}
            self.assertEqual(layers, plugins)
        self.assertIs(False, self.global_["static_layer"]["trinary_costmap"])

    def test_the_index_of_pages_leads_to_the_page(self):
        self.assertIn("(real_stacks.md)", (SOURCE / "docs/index.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
