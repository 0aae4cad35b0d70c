#!/usr/bin/python3
"""A world in process and one on a server: the same request, seeds and actions give the same bits."""

import json
import os
import pathlib
import subprocess
import sys

CLIENTS = pathlib.Path(__file__).resolve().parents[2] / "clients"
sys.path.insert(0, str(CLIENTS / "latticeworld_gym"))

from latticeworld_gym import LatticeWorldEnv  # noqa: E402
from rollouts import WORLD, rollouts  # noqa: E402
from world_client import ServerTest, run  # noqa: E402


class InProcessTest(ServerTest):
    def test_a_world_in_process_gives_the_same_trajectories(self):
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("PYTHON", "ROS_"))}
        environment.update(PYTHONPATH=os.environ["LATTICEWORLD_MODULE"],
                           PYTHONDONTWRITEBYTECODE="1")
        script = pathlib.Path(__file__).resolve().parent / "rollouts.py"
        in_process = json.loads(subprocess.run(
            [os.environ["LATTICEWORLD_MODULE_PYTHON"], script], env=environment, check=True,
            stdout=subprocess.PIPE).stdout)

        self.world.generate(**WORLD)
        env = LatticeWorldEnv(state_hash=True)
        self.addCleanup(env.close)
        seen = json.loads(json.dumps(rollouts(env)))
        self.assertEqual(in_process["world"], env._server.world_id)
        self.assertEqual(in_process["seen"], seen)


if __name__ == "__main__":
    run("in_process_test", InProcessTest)
