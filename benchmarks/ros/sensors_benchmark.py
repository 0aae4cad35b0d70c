#!/usr/bin/python3
"""Measures what sensors cost world_server, messages and their publication to a subscriber included.

One robot drives through the default world in lockstep, as fast as the machine can. Prints, for each
set of topics that is listened to: processor time of the server for a second of simulated time beyond
that without listeners, and the bytes that came.

Usage: sensors_benchmark.py   (with the build's devel/setup.bash sourced)
"""

import os
import tempfile
import time

import world_server_benchmark as server

STEPS = 500
STEP_S = 0.01
# What is listened to, by name; the suite is "survey": 64 x 1024 beams and 640 x 480 pixels at 10 Hz.
SETS = {
    "lidar 64 x 1024": ["points"],
    "depth 640 x 480": ["camera/depth/image_raw"],
    "lidar and depth": ["points", "camera/depth/image_raw"],
    "colour 640 x 480": ["camera/color/image_raw"],
    "scanner 1080 at 40 Hz": ["scan"],
    "imu, odometry, fix, magnetometer, bumper": ["imu", "wheel_odom", "fix", "magnetic_field",
                                                 "bumper"],
}


def main():
    environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{server.free_port()}",
                       ROS_IP="127.0.0.1", ROS_HOME=tempfile.mkdtemp(prefix="latticeworld_bench_"))
    os.environ.update(environment)
    import rosgraph
    import rospy
    from geometry_msgs.msg import Twist
    from std_srvs.srv import Trigger
    from latticeworld.srv import GenerateWorld, ResetWorld, Step

    with server.launched(environment, "sensor_suite:=survey") as launch:
        while not rosgraph.is_master_online():
            time.sleep(0.05)
        rospy.init_node("sensors_benchmark", disable_signals=True)
        rospy.wait_for_service("/generate_world", timeout=30.0)
        answer = rospy.ServiceProxy("/generate_world", GenerateWorld)(
            layout_instruction=server.LAYOUT, environment_instruction=server.AGENTS, seed=1)
        assert answer.status.code == 0, answer.status.message
        rospy.ServiceProxy("/pause", Trigger)()
        step, reset = rospy.ServiceProxy("/step", Step), rospy.ServiceProxy("/reset_world", ResetWorld)
        command = rospy.Publisher("/robot/cmd_vel", Twist, queue_size=1)
        drive = Twist()
        drive.linear.x, drive.angular.z = 0.8, 0.1
        pid = server.server_pid(launch.pid)

        def processor_share():
            """Processor time for a second of simulated time."""
            reset()
            step(steps=20)
            begin, wall = server.cpu_s(pid), time.monotonic()
            for _ in range(STEPS // 25):
                command.publish(drive)
                step(steps=25)
            simulated_s = STEPS * STEP_S
            return (server.cpu_s(pid) - begin) / simulated_s, (time.monotonic() - wall) / simulated_s

        processor_share()  # warm
        alone, alone_wall = processor_share()
        print(f"nobody listens: {100 * alone:.1f} % of a core for real time, "
              f"{1.0 / alone_wall:.0f} times real time")
        for name, topics in SETS.items():
            received = {"bytes": 0}

            def add(message, received=received):
                received["bytes"] += len(message._buff)

            listeners = [rospy.Subscriber(f"/robot/{topic}", rospy.AnyMsg, add, queue_size=100)
                         for topic in topics]
            while any(listener.get_num_connections() == 0 for listener in listeners):
                time.sleep(0.01)
            processor_share()  # makes what is made once
            received["bytes"] = 0
            share, wall = processor_share()
            print(f"{name}: {100 * (share - alone):.1f} % of a core for real time, "
                  f"{1.0 / wall:.1f} times real time, {received['bytes'] / 1e6 / (STEPS * STEP_S):.2f} "
                  "MB a second")
            for listener in listeners:
                listener.unregister()
        rospy.signal_shutdown("done")


if __name__ == "__main__":
    main()
