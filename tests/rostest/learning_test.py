#!/usr/bin/python3
"""The client latticeworld_gym: what Gymnasium and PettingZoo themselves say of it, and that it can
be learned with."""

import math
import os
import pathlib
import sys
import unittest.mock
import warnings

import gymnasium.utils.env_checker
import numpy
import rospy
from geometry_msgs.msg import Point, Vector3
from nav_msgs.msg import OccupancyGrid
from pettingzoo.test import parallel_api_test

CLIENTS = pathlib.Path(__file__).resolve().parents[2] / "clients"
sys.path[:0] = [str(CLIENTS / "latticeworld_gym"), str(CLIENTS / "examples")]

from drive_to_goal import drive, drive_all  # noqa: E402
from latticeworld_gym import (GoalTask, LatticeWorldEnv, LatticeWorldParallelEnv,  # noqa: E402
                              ServerError, Task)
from latticeworld_gym.free_space import FreeSpace  # noqa: E402
from world_client import ServerTest, run  # noqa: E402

WORLD = {"layout": "Flat grassland everywhere, a few trees in the upper right.",
         "environment": "A sunny summer noon. A wheeled robot waits in the center.",
         "size": 64.0, "seed": 3}
SPAWN = {"scout": dict(position=Point(x=-6.0, y=4.0))}


def bits(observation):
    return {name: numpy.asarray(value).tobytes() for name, value in observation.items()}


class LearningTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**WORLD)

    def setUp(self):
        self.assertTrue(self.world.unpause().success)

    def make(self, kind, *arguments, **fields):
        env = kind(*arguments, **fields)
        self.addCleanup(env.close)
        return env

    def test_gymnasium_finds_nothing_wrong(self):
        env = self.make(LatticeWorldEnv)
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            # It recommends actions within -1 .. 1; ours are metres and radians a second.
            warnings.filterwarnings("ignore", message=".*symmetric and normalized.*")
            warnings.filterwarnings("ignore", message=".*env.spec.*")
            gymnasium.utils.env_checker.check_env(env, skip_render_check=True)

    def test_pettingzoo_finds_nothing_wrong(self):
        env = self.make(LatticeWorldParallelEnv, ["robot", "scout"], spawn=SPAWN, max_actions=20)
        parallel_api_test(env, num_cycles=60)

    def rollout(self, env, seed, actions=25):
        observation, info = env.reset(seed=seed)
        seen = [(bits(observation), info["state_hash"])]
        env.action_space.seed(seed)
        for _ in range(actions):
            observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
            seen.append((bits(observation), reward, terminated, truncated, info["state_hash"]))
        return seen

    def test_the_same_seed_and_actions_are_observed_alike(self):
        env = self.make(LatticeWorldEnv, state_hash=True)
        first = self.rollout(env, 11)
        self.rollout(env, 12)
        self.assertEqual(first, self.rollout(env, 11))
        env.close()
        other = self.make(LatticeWorldEnv, state_hash=True)
        self.assertEqual(first, self.rollout(other, 11))
        self.assertNotEqual([seen[0] for seen in first],
                            [seen[0] for seen in self.rollout(other, 12)])

    def test_episodes_without_a_seed_differ(self):
        env = self.make(LatticeWorldEnv)
        env.reset(seed=1)
        goals = {tuple(env.reset()[0]["goal"]) for _ in range(4)}
        self.assertEqual(4, len(goals))

    def test_goals_are_free_places_off_the_outermost_cells(self):
        cells, half_m = 40, 20.0
        for seed in range(20):
            rng = numpy.random.default_rng(seed)
            blocked = rng.random((cells, cells)) < 0.15
            grid = OccupancyGrid(data=[100 if cell else 0 for cell in blocked.flat])
            grid.info.width = grid.info.height = cells
            grid.info.resolution = 1.0
            grid.info.origin.position = Point(x=-half_m, y=-half_m)
            for clearance_m in (0.0, 0.6):
                space = FreeSpace(grid, clearance_m)
                for _ in range(20):
                    begin = rng.uniform(-half_m, half_m, 2)
                    x, y = space.draw(*begin, 1.5, 10.0, rng)
                    own = tuple(numpy.floor(begin + half_m)) == (x + half_m - 0.5, y + half_m - 0.5)
                    if own:
                        continue  # nothing is free around it
                    self.assertFalse(blocked[int(y + half_m), int(x + half_m)], (seed, x, y))
                    self.assertLess(max(abs(x), abs(y)), half_m - 1.0 - clearance_m)

    def test_a_simple_controller_reaches_its_goals(self):
        env = self.make(LatticeWorldEnv)
        for seed in range(1, 4):
            total, info = drive(env, seed)
            self.assertTrue(info["is_success"], info)
            self.assertGreater(total, env.task.bonus)

    def test_two_robots_reach_their_goals_and_leave(self):
        env = self.make(LatticeWorldParallelEnv, ["robot", "scout"], spawn=SPAWN)
        arrived = drive_all(env, seed=2)
        self.assertEqual({"robot": True, "scout": True}, arrived)
        self.assertEqual([], env.agents)

    def test_goals_keep_the_footprint_of_the_robots_species_away(self):
        car = {"scout": dict(SPAWN["scout"], species="ackermann car")}
        env = self.make(LatticeWorldParallelEnv, ["robot", "scout"], spawn=car)
        with unittest.mock.patch.object(env._server, "free_space",
                                        wraps=env._server.free_space) as asked:
            env.reset(seed=1)
        self.assertEqual([0.4, 1.31], sorted(call.args[0] for call in asked.call_args_list))

    def test_rewards_are_what_the_formula_says(self):
        env = self.make(LatticeWorldEnv, task=GoalTask(goal=(20.0, 0.0), time_cost=0.5))
        observation, _ = env.reset(seed=1)
        for _ in range(3):
            before = math.hypot(*observation["goal"])
            observation, reward, *_ = env.step((1.0, 0.0))
            self.assertAlmostEqual(before - math.hypot(*observation["goal"]) - 0.5, reward, places=4)

    def test_the_scan_sees_what_stands_there(self):
        class Still(Task):
            def spaces(self, server):
                return {}

            def begin(self, view, rng, server):
                self.view = view

            def observe(self, view):
                return {}

            def judge(self, before, after):
                return 0.0, False, {}

        env = self.make(LatticeWorldEnv, task=Still(), max_actions=2)
        observation, info = env.reset(seed=1)
        self.assertEqual({"scan", "velocity"}, set(observation))
        x, y = info["position_m"]
        place = Point(x=x + 3.0 * math.cos(info["yaw_rad"]), y=y + 3.0 * math.sin(info["yaw_rad"]))
        # So tall that the scan meets it on a slope, too.
        self.assert_ok(self.world.spawn_element(kind="crate", name="box", position=place,
                                                heading=info["yaw_rad"],
                                                size=Vector3(x=1.0, y=1.0, z=2.0)))
        after, *_ , info = env.step((0.0, 0.0))
        ahead = len(after["scan"]) // 2
        self.assertLess(after["scan"][ahead], 3.0)
        self.assertGreater(after["scan"][ahead], 1.5)
        self.assertGreater(observation["scan"][ahead], after["scan"][ahead])
        *_, truncated, _ = env.step((0.0, 0.0))
        self.assertTrue(truncated)

    def test_close_lets_time_run_as_before(self):
        env = LatticeWorldEnv()
        env.reset(seed=1)
        self.assertTrue(self.world.get_world().paused)
        env.close()
        env.close()
        self.assertFalse(self.world.get_world().paused)
        self.assertTrue(self.world.pause().success)
        env = LatticeWorldEnv()
        env.close()
        self.assertTrue(self.world.get_world().paused)

    def test_two_environments_on_one_server_do_not_mix_their_episodes(self):
        first, second = self.make(LatticeWorldEnv), self.make(LatticeWorldEnv)
        first.reset(seed=1)
        first.step((0.5, 0.0))
        second.reset(seed=2)
        with self.assertRaisesRegex(ServerError, "episode .* is over.*server and a process each"):
            first.step((0.5, 0.0))
        second.step((0.5, 0.0))
        first.reset(seed=1)  # its own again
        first.step((0.5, 0.0))

    def test_goals_lie_on_the_dry_land_of_another_world_between_episodes(self):
        env = self.make(LatticeWorldEnv)
        env.reset(seed=1)
        self.addCleanup(self.world.generate, **WORLD)
        self.world.generate(layout="A lake fills the eastern half. Flat grassland in the west.",
                            environment="A wheeled robot waits in the center.", size=128.0, seed=5)
        goals = []
        for seed in range(30):
            _, info = env.reset(seed=seed)
            goals.append(Point(*env.task.goal, 0.0))
        self.assertEqual(128.0, env._server.size_m)
        # The shore is within reach, so that goals drawn on the old map lie in the lake.
        x, y = info["position_m"]
        around = [Point(x + 9.0 * math.cos(angle), y + 9.0 * math.sin(angle), 0.0)
                  for angle in numpy.linspace(0.0, 2.0 * math.pi, 24)]
        self.assertGreater(sum(depth_m > 0.0 for depth_m in self.water_depths(around)), 4)
        self.assertEqual([0.0] * 30, self.water_depths(goals))

    def water_depths(self, points):
        answer = self.assert_ok(self.world.query_terrain(points=points))
        return [sample.water_depth for sample in answer.samples]

    def test_what_is_closed_says_so(self):
        env = self.make(LatticeWorldEnv)
        env.reset(seed=1)
        env.close()
        with self.assertRaisesRegex(ServerError, "closed"):
            env.step((0.0, 0.0))
        env = self.make(LatticeWorldParallelEnv, ["robot", "scout"], spawn=SPAWN)
        env.reset(seed=1)
        env.close()
        with self.assertRaisesRegex(ServerError, "closed"):
            env.step({robot: (0.0, 0.0) for robot in env.agents})
        with self.assertRaisesRegex(ServerError, "closed"):
            env.reset(seed=1)

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(ServerError, '(?s)nobody.*|no agent "nobody"'):
            self.make(LatticeWorldEnv, "nobody").reset(seed=1)
        with self.assertRaisesRegex(ValueError, "steps_per_action is 0.*max_actions is -1"):
            LatticeWorldEnv(steps_per_action=0, max_actions=-1)
        with self.assertRaisesRegex(ValueError, "each once"):
            LatticeWorldParallelEnv(["robot", "robot"])
        env = self.make(LatticeWorldEnv)
        with self.assertRaisesRegex(RuntimeError, "reset"):
            env.step((0.0, 0.0))
        env.reset(seed=1)
        for action in ((math.nan, 0.0), (1.0,), (1.0, math.inf)):
            with self.assertRaisesRegex(ValueError, "two finite numbers"):
                env.step(action)

    def test_where_there_is_no_server_it_says_how_to_start_one(self):
        with unittest.mock.patch.dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:9"), \
                self.assertRaisesRegex(ServerError, "127.0.0.1:9.*roslaunch latticeworld"):
            LatticeWorldEnv()
        with unittest.mock.patch("rospy.wait_for_service", side_effect=rospy.ROSException("gone")), \
                self.assertRaisesRegex(ServerError, "lockstep.*roslaunch latticeworld"):
            LatticeWorldEnv()


if __name__ == "__main__":
    run("learning_test", LearningTest)
