#!/usr/bin/python3
"""Measures the running world_server as its user meets it, with a master of its own on a free port.

Prints: seconds that /generate_world takes for the default world; the longest wall-clock gap of
/clock while another world is generated; the real-time factor with 50 agents and one robot, held to
real time and as fast as possible; peak memory of the server; the cost of publishing transforms; the
real-time factor with 100 driving four-wheel robots, of which nothing, states and frames, or odometry
as well is recorded.

Usage: world_server_benchmark.py DEVEL_DIRECTORY   (with DEVEL_DIRECTORY/setup.bash sourced)
"""

import contextlib
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

LAYOUT = ("A river winds from the north to the south between dense forest in the upper left and "
          "farmland on the right. A road runs from the west to the east, with a small village in "
          "the center.")
AGENTS = ("A sunny summer day. 25 sheep graze. 10 horses graze. 10 goblins patrol. 5 eagles circle "
          "above. A wheeled robot waits in the center.")


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class ClockWatch:
    """Keeps the longest wall-clock gap between two /clock messages, and the simulated time."""

    def __init__(self):
        self._lock = threading.Lock()
        self._last = None
        self.longest_gap_s = 0.0
        self.simulated_s = 0.0

    def __call__(self, message):
        now = time.monotonic()
        with self._lock:
            if self._last is not None:
                self.longest_gap_s = max(self.longest_gap_s, now - self._last)
            self._last = now
            self.simulated_s = message.clock.to_sec()

    def restart(self):
        with self._lock:
            self._last = time.monotonic()
            self.longest_gap_s = 0.0


def server_pid(launch_pid):
    """The world_server among the children of roslaunch."""
    children = pathlib.Path(f"/proc/{launch_pid}/task/{launch_pid}/children").read_text()
    for pid in children.split():
        command = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")[0]
        if command.endswith(b"/world_server"):
            return int(pid)
    raise RuntimeError("no world_server below roslaunch")


def peak_memory_mib(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) / 1024.0
    raise RuntimeError("no VmHWM")


def cpu_s(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@contextlib.contextmanager
def launched(environment, *arguments):
    process = subprocess.Popen(["roslaunch", "latticeworld", "world.launch", *arguments],
                               env=environment, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()


def factor_over(watch, wall_s):
    begin, begin_simulated = time.monotonic(), watch.simulated_s
    time.sleep(wall_s)
    return (watch.simulated_s - begin_simulated) / (time.monotonic() - begin)


def main():
    devel = pathlib.Path(sys.argv[1])
    environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}",
                       ROS_IP="127.0.0.1", ROS_HOME=tempfile.mkdtemp(prefix="latticeworld_bench_"))
    os.environ.update(environment)
    import rosgraph
    import rospy
    from rosgraph_msgs.msg import Clock
    from latticeworld.srv import GenerateWorld

    def generate(seed):
        call = rospy.ServiceProxy("/generate_world", GenerateWorld)
        begin = time.monotonic()
        answer = call(layout_instruction=LAYOUT, environment_instruction=AGENTS, seed=seed)
        assert answer.status.code == 0, answer.status.message
        return time.monotonic() - begin

    with launched(environment, "real_time_factor:=1.0") as launch:
        while not rosgraph.is_master_online():
            time.sleep(0.05)
        rospy.init_node("world_server_benchmark", disable_signals=True)
        rospy.wait_for_service("/generate_world", timeout=30.0)
        watch = ClockWatch()
        rospy.Subscriber("/clock", Clock, watch, queue_size=1000, tcp_nodelay=True)
        answers = [generate(1)]
        factor_over(watch, 2.0)
        gaps = []
        for seed in range(2, 7):
            watch.restart()
            answers.append(generate(seed))
            gaps.append(watch.longest_gap_s)
        pid = server_pid(launch.pid)
        cpu_begin, wall_begin = cpu_s(pid), time.monotonic()
        factor = factor_over(watch, 5.0)
        share = (cpu_s(pid) - cpu_begin) / (time.monotonic() - wall_begin)
        print(f"service answer, default world: first {answers[0]:.2f} s, then "
              f"{min(answers[1:]):.2f} to {max(answers[1:]):.2f} s")
        print(f"longest gap of /clock while generating: {1e3 * max(gaps):.0f} ms (worlds: "
              + ", ".join(f"{1e3 * gap:.0f}" for gap in gaps) + ")")
        print(f"50 agents and a robot, held to real time: factor {factor:.3f}, "
              f"{100 * share:.0f} % of a core with publishing")
        print(f"peak memory of world_server: {peak_memory_mib(pid):.0f} MiB")
        rospy.Subscriber("/tf", rospy.AnyMsg, lambda message: None, queue_size=100)
        tf = subprocess.run([devel / "lib/latticeworld/tf_benchmark"], env=environment,
                            check=True, capture_output=True, text=True)
        print(tf.stdout.strip())
        rospy.signal_shutdown("done")

    for part in ("--fast", "--robots"):
        child = subprocess.run([sys.executable, __file__, part, str(devel)], check=True,
                               capture_output=True, text=True)
        print(child.stdout.strip())


@contextlib.contextmanager
def fast_server(*arguments):
    """As fast as possible, with a master of its own, and this process a node beside it."""
    os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}", ROS_IP="127.0.0.1")
    import rosgraph
    import rospy
    with launched(dict(os.environ), "real_time_factor:=0", *arguments):
        while not rosgraph.is_master_online():
            time.sleep(0.05)
        rospy.init_node("world_server_benchmark", disable_signals=True)
        rospy.wait_for_service("/generate_world", timeout=30.0)
        yield


def fast():
    """In a process of its own: a rospy node lives once."""
    import rospy
    from rosgraph_msgs.msg import Clock
    from latticeworld.srv import GenerateWorld
    with fast_server():
        watch = ClockWatch()
        rospy.Subscriber("/clock", Clock, watch, queue_size=10000, tcp_nodelay=True)
        answer = rospy.ServiceProxy("/generate_world", GenerateWorld)(
            layout_instruction=LAYOUT, environment_instruction=AGENTS, seed=1)
        assert answer.status.code == 0, answer.status.message
        factor_over(watch, 2.0)
        print(f"50 agents and a robot, as fast as possible: factor {factor_over(watch, 5.0):.1f}, "
              "with publishing")
        rospy.signal_shutdown("done")


class StepTimes:
    """Mean wall time of Simulator::Step [s], as the last diagnostics tell it."""

    def __init__(self):
        self.mean_s = float("nan")

    def __call__(self, message):
        for value in message.status[0].values:
            if value.key == "mean step time [s]":
                self.mean_s = float(value.value)


@contextlib.contextmanager
def recorded(folder, *topics):
    """Meanwhile rosbag records these topics; none: nobody does. Afterwards: how many messages it
    got, by topic."""
    counts = {}
    if not topics:
        yield counts
        return
    import rosbag
    import roslib.packages
    record = roslib.packages.find_node("rosbag", "record")[0]  # itself: "rosbag" would end before it
    bag = pathlib.Path(folder, "robots.bag")
    recorder = subprocess.Popen([record, "--quiet", "-O", bag, "-e", "|".join(topics)],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        time.sleep(6.0)  # for it to hear all of them
        yield counts
    finally:
        recorder.send_signal(signal.SIGINT)
        recorder.wait()
    with rosbag.Bag(str(bag)) as file:
        counts.update({topic: info.message_count
                       for topic, info in file.get_type_and_topic_info()[1].items()})


def spawn_robots(count_a_side, spacing_m):
    """Their names, on a square grid."""
    import rospy
    from geometry_msgs.msg import Point
    from latticeworld.srv import SpawnAgent
    rospy.wait_for_service("/spawn_agent", timeout=30.0)
    spawn = rospy.ServiceProxy("/spawn_agent", SpawnAgent, persistent=True)
    names = []
    for i in range(count_a_side ** 2):
        for shift_m in range(8):  # to where no stone lies
            place = Point(x=spacing_m * (i % count_a_side - count_a_side / 2) + 0.5 * shift_m,
                          y=spacing_m * (i // count_a_side - count_a_side / 2) + 20.0)
            answer = spawn(name=f"robot_{i + 2}", species="wheeled_robot", position=place,
                           controllable=True)
            if answer.status.code == 0:
                names.append(answer.name)
                break
        else:
            raise RuntimeError(answer.status.message)
    return names


def robots():
    """100 robots on a meadow that are commanded and drive in circles. Each has odometry, ground
    truth, joints and frames; what is recorded of them grows."""
    import rospy
    from diagnostic_msgs.msg import DiagnosticArray
    from geometry_msgs.msg import Twist
    from latticeworld.srv import GenerateWorld, GetWorld
    with tempfile.TemporaryDirectory(prefix="latticeworld_bench_") as folder:
        config = pathlib.Path(folder, "config.yaml")
        config.write_text("command_timeout: 60.0\n")  # simulated, so that commands may come slowly
        with fast_server(f"config:={config}"):
            answer = rospy.ServiceProxy("/generate_world", GenerateWorld)(
                layout_instruction="Flat grassland everywhere.",
                environment_instruction="A sunny summer noon.", seed=1)
            assert answer.status.code == 0, answer.status.message
            names = spawn_robots(10, 8.0)
            topics = [rospy.Publisher(f"/{name}/cmd_vel", Twist, queue_size=1) for name in names]
            command = Twist()
            command.linear.x, command.angular.z = 1.0, 0.5
            stop = threading.Event()

            def drive():
                while not stop.wait(2.0):
                    for topic in topics:
                        topic.publish(command)

            driver = threading.Thread(target=drive)
            driver.start()
            get_world = rospy.ServiceProxy("/get_world", GetWorld)
            times = StepTimes()
            rospy.Subscriber("/diagnostics", DiagnosticArray, times)
            time.sleep(4.0)
            for what, record in (("nobody listens", ()),
                                 ("states and frames recorded", ("/tf", "/agents")),
                                 ("odometry of each as well", ("/tf", "/agents", "/.*/odom"))):
                with recorded(folder, *record) as counts:
                    begin, begin_step = time.monotonic(), get_world().step
                    time.sleep(10.0)
                    wall_s, steps = time.monotonic() - begin, get_world().step - begin_step
                heard = sum(topic.endswith("/odom") for topic in counts)
                assert heard == 0 or heard >= len(names), f"odometry of {heard} robots"
                print(f"{len(names)} driving four-wheel robots, as fast as possible, {what}: factor "
                      f"{steps * 0.01 / wall_s:.2f} (a step {1e3 * times.mean_s:.2f} ms of "
                      f"{1e3 * wall_s / steps:.2f} ms)")
            stop.set()
            driver.join()
            rospy.signal_shutdown("done")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--fast":
        fast()
    elif len(sys.argv) == 3 and sys.argv[1] == "--robots":
        robots()
    elif len(sys.argv) == 2:
        main()
    else:
        sys.exit(__doc__)
