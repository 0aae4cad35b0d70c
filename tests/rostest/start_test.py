#!/usr/bin/python3
"""How world_server starts, answers before there is a world, and ends."""

import json
import os
import pathlib
import resource
import signal
import tempfile
import threading
import unittest

import rospkg
import rospy
import rosservice
import yaml
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Point, Twist
from grid_map_msgs.msg import GridMap
from nav_msgs.msg import OccupancyGrid, Odometry
from nav_msgs.srv import GetMap
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState, NavSatFix, PointCloud2
from sensor_msgs.point_cloud2 import read_points
from std_msgs.msg import Empty
from tf2_msgs.msg import TFMessage

from latticeworld import srv
from latticeworld.msg import AgentStates, GenerationProgress, Status
from server_process import Server
from world_client import TIMEOUT_S, Collector, World, run, service, wait_until

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("latticeworld"))
DEFAULTS = PACKAGE / "launch_cfg/world_server.yaml"
TOLD_BY_ROBOTS = {"odom": Odometry, "ground_truth": Odometry, "joint_states": JointState}
HEARD_BY_ROBOTS = {"cmd_vel": Twist, "joint_command": JointState, "strike": Empty}
VEHICLES = PACKAGE / "src/latticeworld/species/data/vehicles.json"


def descriptors(soft, hard):
    """What a process does first that is to have these limits of open files."""
    return lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


class StartTest(unittest.TestCase):
    def test_without_parameters_it_starts_and_ends(self):
        with Server() as server:
            self.assertEqual(0, server.stop(), server.text())

    def test_it_takes_leave_of_the_master_on_sigterm_too(self):
        with Server() as server:
            self.assertEqual(0, server.stop(signal.SIGTERM), server.text())
            self.assertIsNone(rosservice.get_service_node("/generate_world"))

    def test_the_shipped_parameters_are_the_full_list_and_legal(self):
        parameters = yaml.safe_load(DEFAULTS.read_text(encoding="utf-8"))
        self.assertGreater(len(parameters), 15)
        with Server(**parameters) as server:
            self.assertEqual(0, server.stop(), server.text())

    def test_bad_parameters_are_all_named(self):
        with Server(stepp=0.01, step=-1.0, real_time_factor="fast", generator="oracle",
                    clock_rate=0, visual_directories="one", species="/nowhere",
                    robot_species="dragon") as server:
            self.assertEqual(1, server.process.wait(TIMEOUT_S))
            for word in ("stepp", "step", "real_time_factor", "generator", "oracle", "grounded",
                         "clock_rate", "visual_directories", "/nowhere", "dragon", "tractor"):
                self.assertIn(word, server.text())

    def test_a_users_species_is_what_robots_are(self):
        vehicles = json.loads(VEHICLES.read_text(encoding="utf-8"))["species"]
        rover = {**vehicles[0], "name": "rover"}
        with tempfile.NamedTemporaryFile(mode="w", suffix=".json") as file:
            json.dump({"species": [{**rover, "mass_kg": -1}]}, file)
            file.flush()
            with Server(species=file.name) as server:
                self.assertEqual(1, server.process.wait(TIMEOUT_S))
                for word in ("species", os.path.basename(file.name), "mass_kg", "-1"):
                    self.assertIn(word, server.text())
            file.seek(0)
            file.truncate()
            json.dump({"species": [rover]}, file)
            file.flush()
            with Server(species=file.name, robot_species="rover"):
                world = World()
                states = Collector("agents", AgentStates)
                world.generate(size=64.0)
                self.assertIn("rover", world.get_world().species)
                state = states.wait_for(lambda m: m.agents)
                self.assertEqual({"rover"}, {agent.species for agent in state.agents
                                             if agent.controllable})
                self.assertEqual(Status.OK, world.spawn_agent(place="anywhere").status.code)
                states.wait_for(lambda m: any(agent.name == "rover_1" for agent in m.agents))
                states.close()

    def test_frames_that_others_publish_are_left_out_and_sensors_stay(self):
        with Server(publish_map_to_odom=False, odometry_elsewhere=["scout"]):
            world = World()
            transforms = Collector("/tf", TFMessage)
            fixed = Collector("/tf_static", TFMessage)
            world.generate(size=64.0)
            answer = world.spawn_agent(name="scout", place="anywhere", controllable=True)
            self.assertEqual(Status.OK, answer.status.code, answer.status.message)
            fixed.wait_for(lambda m: any(t.child_frame_id == "scout/imu" for t in m.transforms))
            transforms.wait_for_next()
            transforms.wait_for_next()
            children = {t.child_frame_id for m in transforms.messages() for t in m.transforms}
            self.assertIn("robot/base_link", children)
            self.assertFalse(children & {"robot/odom", "scout/odom", "scout/base_link"}, children)
            transforms.close()
            fixed.close()

    def test_a_trinary_map_is_so_on_topic_and_service_and_in_files(self):
        with tempfile.TemporaryDirectory() as folder:
            with Server(map_values="trinary", worlds_directory=folder):
                world = World()
                maps = Collector("map", OccupancyGrid)
                world.generate(layout="A high mountain in the center, forest around it.", size=64.0)
                published = maps.wait_for(lambda m: True)
                answered = service("static_map", GetMap)().map
                for data in (published.data, answered.data):
                    self.assertEqual({0, 100}, set(data))
                saved = world.save_world(name="three")
                self.assertEqual(Status.OK, saved.status.code, saved.status.message)
                settings = yaml.safe_load((pathlib.Path(saved.path) / "map.yaml").read_text())
                self.assertEqual("trinary", settings["mode"])
                self.assertEqual(Status.OK, world.load_world(name="three").status.code)
                maps.close()

    def test_what_is_larger_than_a_message_is_refused_or_coarser(self):
        limit = 1000000
        with Server(most_message_bytes=limit) as server:
            world = World()
            with Collector("world/height_map", GridMap) as maps:
                world.generate(size=256.0)
                self.assertGreater(maps.wait_for(lambda m: True).info.resolution, 0.5)
            get_world_bundle = service("get_world_bundle", srv.GetWorldBundle)
            refused = get_world_bundle(files=True).status
            self.assertEqual(Status.RESOURCE_EXHAUSTED, refused.code, refused.message)
            for word in (str(limit), "most_message_bytes", "save_world"):
                self.assertIn(word, refused.message)
            self.assertEqual(Status.OK, get_world_bundle(files=False).status.code)
            self.assertIn("world/height_map of", server.text())

    def test_clouds_and_fixes_are_as_the_parameters_say(self):
        undulation_m, revolution_s = 40.0, 0.1
        with Server(sensor_suite="perception", point_times="begin", altitude=0.0,
                    geoid_undulation=undulation_m, start_paused=True):
            world = World()
            world.generate(layout="Flat grassland everywhere.", size=64.0)
            with Collector("robot/points", PointCloud2) as clouds:
                clouds.wait_until_connected()
                end_s = world.step(steps=50).stamp.to_sec()
                last = clouds.wait_for(
                    lambda m: m.header.stamp.to_sec() > end_s - 2.0 * revolution_s + 1e-6)
            times_s = [time for time, in read_points(last, field_names=["time"])]
            self.assertGreaterEqual(min(times_s), 0.0)
            self.assertAlmostEqual(revolution_s, max(times_s), delta=0.01)
            self.assertLessEqual(last.header.stamp.to_sec(), end_s - revolution_s + 1e-6)
            with Collector("robot/fix", NavSatFix) as fixes:
                fixes.wait_until_connected()
                world.step(steps=3000)
                wait_until(lambda: len(fixes.messages()) >= 100, "a hundred fixes")
                altitudes_m = [fix.altitude for fix in fixes.messages()]
            ground_m = world.query_terrain(points=[Point()]).samples[0].height
            # Most of the error of a fix wanders: 4 m, over minutes.
            self.assertAlmostEqual(undulation_m, sum(altitudes_m) / len(altitudes_m) - ground_m,
                                   delta=15.0)

    def test_a_soft_limit_of_descriptors_is_raised_to_the_hard_one(self):
        with Server(before=descriptors(256, 4096)) as server:
            limits = pathlib.Path(f"/proc/{server.process.pid}/limits").read_text(encoding="ascii")
        files = next(line for line in limits.splitlines() if line.startswith("Max open files"))
        self.assertEqual(["4096", "4096"], files.split()[3:5])

    def test_that_descriptors_are_too_few_is_told(self):
        def connections(message):
            return next(one for one in message.status if one.name == "world_server: connections")

        def is_short(message):
            status = connections(message)
            return status.level == DiagnosticStatus.WARN and "are in use" in status.message

        with Server(before=descriptors(256, 256), sensor_suite="none"), \
                Collector("diagnostics", DiagnosticArray) as diagnostics:
            diagnostics.wait_until_connected()
            world = World()
            world.generate(layout="Flat grassland everywhere.", size=128.0)
            names = [f"scout_{i}" for i in range(40)]
            for name in names:
                answer = world.spawn_agent(name=name, species="wheeled robot", place="anywhere",
                                           controllable=True)
                self.assertEqual(Status.OK, answer.status.code, answer.status.message)
            ends = [rospy.Subscriber(f"{name}/{topic}", kind) for name in names
                    for topic, kind in TOLD_BY_ROBOTS.items()]
            ends += [rospy.Publisher(f"{name}/{topic}", kind, queue_size=1) for name in names
                     for topic, kind in HEARD_BY_ROBOTS.items()]
            status = connections(diagnostics.wait_for(is_short))
            for end in ends:
                end.unregister()
            self.assertIn("of 256 file descriptors are in use", status.message)
            self.assertTrue(all(value.value.startswith("/scout_") for value in status.values
                                if value.key == "not delivered"), status)

    def test_worlds_are_saved_on_network_file_systems(self):
        for locks in ("lustre", "nfs"):
            network = {"LD_PRELOAD": os.environ["LATTICEWORLD_NETWORK_FILE_SYSTEM"], "LOCKS": locks}
            with tempfile.TemporaryDirectory() as folder:
                with Server(environment=network, worlds_directory=folder):
                    world = World()
                    world.generate(layout="Grassland.", size=64.0)
                    saved = world.save_world(name="kept")
                    self.assertEqual(Status.OK, saved.status.code, saved.status.message)
                    self.assertEqual(Status.ALREADY_EXISTS,
                                     world.save_world(name="kept").status.code)
                    self.assertEqual(Status.OK, world.load_world(name="kept").status.code)
                self.assertEqual(["kept"], os.listdir(folder))

    def test_use_sim_time_is_set_only_where_it_is_unset(self):
        rospy.delete_param("/use_sim_time")
        with Server():
            self.assertIs(True, rospy.get_param("/use_sim_time"))
        rospy.set_param("/use_sim_time", False)
        with Server():
            self.assertIs(False, rospy.get_param("/use_sim_time"))
        rospy.set_param("/use_sim_time", True)

    def test_before_a_world_services_say_what_to_do(self):
        with Server():
            world = World()
            for answer in (world.get_world(), world.save_world(), world.query_terrain(),
                           world.query_things(),
                           world.spawn_agent(), world.remove_agent(name="a"), world.reset_world(),
                           world.step(), world.set_policy(team=2), world.spawn_element(),
                           world.remove_element(name="a"), world.open_gate(name="a"),
                           world.save_snapshot(), world.restore_snapshot()):
                self.assertEqual(Status.FAILED_PRECONDITION, answer.status.code)
                self.assertIn("generate_world", answer.status.message)
            with self.assertRaisesRegex(rospy.ServiceException, "generate_world"):
                service("static_map", GetMap)()
            self.assertEqual(Status.OK, world.list_worlds().status.code)
            # The clock runs all the same: who waits for it is not stuck.
            clock = Collector("/clock", Clock)
            first = clock.wait_for_next().clock
            clock.wait_for(lambda m: m.clock > first)
            clock.close()

    def test_a_directory_that_cannot_be_written(self):
        # A file in the place of a folder keeps root out as well.
        with tempfile.NamedTemporaryFile() as file:
            with Server(worlds_directory=file.name + "/worlds"):
                world = World()
                world.generate()
                answer = world.save_world(name="first")
                self.assertNotEqual(Status.OK, answer.status.code)
                self.assertIn(file.name, answer.status.message)
                self.assertEqual(Status.OK, world.get_world().status.code)
        if os.path.isdir("/proc/sys"):  # read-only for everybody
            with Server(worlds_directory="/proc/sys"):
                world = World()
                world.generate()
                answer = world.save_world(name="first")
                self.assertNotEqual(Status.OK, answer.status.code)
                self.assertIn("/proc/sys", answer.status.message)

    def test_it_ends_while_a_world_is_made(self):
        with Server() as server:
            world = World()
            world.generate()
            progress = Collector("world/progress", GenerationProgress)
            maker = threading.Thread(target=self.generate_and_lose, args=(world,))
            maker.start()
            progress.wait_for(lambda m: m.stage == "terrain")
            self.assertEqual(0, server.stop(), server.text())
            maker.join(TIMEOUT_S)
            self.assertFalse(maker.is_alive())
            progress.close()

    @staticmethod
    def generate_and_lose(world):
        try:
            world.generate(size=1024.0)
        except (rospy.ServiceException, AssertionError):
            pass  # the server has gone, or said that it was cancelled


if __name__ == "__main__":
    run("start_test", StartTest)
