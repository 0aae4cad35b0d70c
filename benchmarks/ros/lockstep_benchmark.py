#!/usr/bin/python3
"""Measures lockstep calls a second, as a learning loop makes them: one call a fixed step, one
persistent connection, a robot that drives.

Prints, for a meadow of 64 m with one robot and for the default world with 51 agents: calls a second
with the state and odometry alone, with the 2D scan of 1081 beams as well, and the processor time of
server and client for a call.

Usage: lockstep_benchmark.py   (with the build's devel/setup.bash sourced, and with a python that has
gymnasium and pettingzoo, as scripts/test.sh puts it into build/python)
"""

import os
import pathlib
import sys
import tempfile
import time

import world_server_benchmark as server

CALLS = 1500
CLIENT = pathlib.Path(__file__).resolve().parents[2] / "clients" / "latticeworld_gym"
WORLDS = {
    "meadow of 64 m, one robot": dict(layout_instruction="Flat grassland everywhere.",
                                      environment_instruction="A wheeled robot waits in the "
                                                              "center.", size=64.0),
    "default world, 51 agents": dict(layout_instruction=server.LAYOUT,
                                     environment_instruction=server.AGENTS),
}


def main():
    environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{server.free_port()}",
                       ROS_IP="127.0.0.1", ROS_HOME=tempfile.mkdtemp(prefix="latticeworld_bench_"))
    os.environ.update(environment)
    sys.path.insert(0, str(CLIENT))
    import rosgraph
    import rospy
    from geometry_msgs.msg import Twist, Vector3
    from std_srvs.srv import Trigger
    from latticeworld.msg import AgentCommand
    from latticeworld.srv import GenerateWorld, ResetWorld
    from latticeworld_gym.server import NumpyLockstep

    with server.launched(environment, "sensor_suite:=scanner") as launch:
        while not rosgraph.is_master_online():
            time.sleep(0.05)
        rospy.init_node("lockstep_benchmark", disable_signals=True)
        rospy.wait_for_service("/generate_world", timeout=30.0)
        generate = rospy.ServiceProxy("/generate_world", GenerateWorld)
        reset = rospy.ServiceProxy("/reset_world", ResetWorld)
        lockstep = rospy.ServiceProxy("/lockstep", NumpyLockstep, persistent=True)
        pid = server.server_pid(launch.pid)
        commands = [AgentCommand("robot", Twist(linear=Vector3(x=0.8), angular=Vector3(z=0.2)))]
        for name, world in WORLDS.items():
            answer = generate(seed=1, **world)
            assert answer.status.code == 0, answer.status.message
            rospy.ServiceProxy("/pause", Trigger)()
            for scan in (False, True):
                reset()
                for _ in range(100):  # makes what is made once
                    lockstep(commands=commands, steps=1, scan=scan)
                scans = set()
                begin, cpu = time.monotonic(), server.cpu_s(pid)
                own = time.process_time()
                for _ in range(CALLS):
                    answer = lockstep(commands=commands, steps=1, scan=scan)
                    scans.add(answer.observations[0].scan.header.stamp.to_nsec())
                wall = time.monotonic() - begin
                assert answer.status.code == 0, answer.status.message
                assert not scan or len(answer.observations[0].scan.ranges) == 1081
                assert not scan or abs(len(scans) - 0.4 * CALLS) <= 1, len(scans)  # 40 Hz
                print(f"{name}, {'state and scan' if scan else 'state'}: {CALLS / wall:.0f} calls a "
                      f"second; processor time a call: server "
                      f"{1e3 * (server.cpu_s(pid) - cpu) / CALLS:.2f} ms, client "
                      f"{1e3 * (time.process_time() - own) / CALLS:.2f} ms", flush=True)
        rospy.signal_shutdown("done")


if __name__ == "__main__":
    main()
