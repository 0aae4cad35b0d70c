#!/usr/bin/python3
"""Over ROS, for learning_peers.py: learning_lockstep.py LAND SEED SECONDS WORLD_SERVER.

The same land, robot and scan in a world_server of its own: a decision is one call of the service
lockstep, over one connection that stays open. Processor time is of the server and of the client.
With the build's devel/setup.bash sourced.
"""

import math
import os
import pathlib
import sys
import tempfile
import time

import numpy as np
import world_server_benchmark as node
from robots_benchmark import running

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from learning_world import EPISODE, RANGE_M, RAYS, STEP_S, STEPS, actions, report


def main():
    land, seed = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])
    seconds, program = float(sys.argv[3]), sys.argv[4]
    os.environ["ROS_HOME"] = tempfile.mkdtemp(prefix="latticeworld_bench_")
    with running(program, start_paused=True, step=STEP_S, worlds_directory=str(land),
                 sensors=str(land / "sensors.json"), sensor_suite="scanner of its own") as server:
        import rospy
        from geometry_msgs.msg import Twist, Vector3
        from latticeworld.msg import AgentCommand
        from latticeworld.srv import LoadWorld, Lockstep, ResetWorld

        answer = rospy.ServiceProxy("/load_world", LoadWorld)(name="world")
        assert answer.status.code == 0, answer.status.message
        reset = rospy.ServiceProxy("/reset_world", ResetWorld, persistent=True)
        lockstep = rospy.ServiceProxy("/lockstep", Lockstep, persistent=True)
        wanted = actions(seed)

        def episode():
            reset()
            speed_mps, seen = 0.0, 0.0
            for _ in range(EPISODE):
                forward_mps, yaw_rate_radps = next(wanted)
                drive = Twist(linear=Vector3(x=forward_mps), angular=Vector3(z=yaw_rate_radps))
                answer = lockstep(commands=[AgentCommand("robot", drive)], steps=STEPS, scan=True)
                assert answer.status.code == 0, answer.status.message
                (view,) = answer.observations
                assert len(view.scan.ranges) == RAYS
                seen += float((np.asarray(view.scan.ranges) < RANGE_M).mean()) / EPISODE
                velocity = view.state.twist.linear
                speed_mps += math.hypot(velocity.x, velocity.y) / EPISODE
            return speed_mps, seen

        episode()
        episodes, begin = [], time.perf_counter()
        cpu_s = node.cpu_s(server.pid) + time.process_time()
        while time.perf_counter() - begin < seconds:
            episodes.append(episode())
        report(EPISODE * len(episodes), time.perf_counter() - begin,
               node.cpu_s(server.pid) + time.process_time() - cpu_s,
               *np.mean(episodes, axis=0).tolist())


if __name__ == "__main__":
    main()
