#!/usr/bin/python3
"""Drives the robot of a campaign's trial by nodes of a launch file: a navigation stack as it is.

In a campaign's file:
    stack: {command: [rosrun, latticeworld, launch_stack.py, my_robot.launch, "robot:=robot"], name: mine}

Usage: launch_stack.py [--robot NAME] [--pace X] LAUNCH_FILE [NAME:=VALUE ...]

Starts a ROS master of its own on a free port and roslaunches the file. The nodes get what they get
from world_server: /clock (use_sim_time is set), map, tf (map -> NAME/odom -> NAME/base_link and the
sensors' frames), NAME/odom, NAME/scan and NAME/points. The goal goes out as a goal of the action
NAME/move_base; what comes on NAME/cmd_vel drives. Nodes run freely on /clock, which goes X times as
fast as wall time (1): they are not in lockstep, and a trial is not the same twice. Simulated time
begins at 1 s.
"""

import argparse
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

# Installed, the modules lie beside this program; in the source tree the client lies elsewhere.
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "clients" / "latticeworld_stack")]
import latticeworld_stack  # noqa: E402

LAUNCH_S = 25.0  # for the stack to listen for goals
END_S = 1.2  # for the stack to end by itself


def descendants(pid):
    """Processes that this one started, and they; those that ended are not among them."""
    parents = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                stat = (entry / "stat").read_text()
            except OSError:
                continue
            parents.setdefault(int(stat.rpartition(")")[2].split()[1]), []).append(int(entry.name))
    found, left = [], [pid]
    while left:
        children = parents.get(left.pop(), [])
        found += children
        left += children
    return found


class Processes:
    """The master and the nodes; ended with all that they started."""

    def __init__(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1")
        os.environ.pop("ROS_HOSTNAME", None)
        self.master = self.start("rosmaster", "--core", "-p", str(port))
        self.launch = None

    def start(self, *command):
        # Standard output is the campaign's.
        return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=sys.stderr)

    def end(self):
        started = descendants(os.getpid())
        if self.launch is not None and self.launch.poll() is None:
            self.launch.send_signal(signal.SIGINT)
            try:
                self.launch.wait(END_S)
            except subprocess.TimeoutExpired:
                pass
        for pid in set(started) | set(descendants(os.getpid())):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass


class Refusal(latticeworld_stack.Stack):
    """Refuses every task."""

    def __init__(self, why):
        self.why = why

    def begin(self, task):
        raise latticeworld_stack.Failed(self.why)


def wait_for(what, condition, seconds):
    last = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > last:
            raise RuntimeError(f"waited {seconds:g} s for {what}")
        time.sleep(0.02)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--robot", default="robot", help="below whose name its topics lie [robot]")
    parser.add_argument("--pace", type=float, default=1.0,
                        help="simulated by wall time, above 0 to 100 [1]")
    parser.add_argument("launch_file")
    parser.add_argument("arguments", nargs="*", metavar="NAME:=VALUE")
    options = parser.parse_args()
    if not 0.0 < options.pace <= 100.0:
        parser.error(f"--pace is {options.pace}; above 0 to 100 is legal")
    if not os.path.isfile(options.launch_file):
        return latticeworld_stack.run(Refusal(f"there is no launch file {options.launch_file}"))
    for program in ("rosmaster", "roslaunch"):
        if shutil.which(program) is None:
            return latticeworld_stack.run(Refusal(f"there is no {program} in PATH"))
    processes = Processes()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    try:
        serve(options, processes)
    finally:
        processes.end()


def serve(options, processes):
    import rosgraph  # reads ROS_MASTER_URI
    master = rosgraph.Master("launch_stack")
    wait_for("the ROS master", lambda: is_online(master), LAUNCH_S)
    master.setParam("/use_sim_time", True)
    # These read the parameter when they are made.
    from stack_bridge import Bridge

    class LaunchedStack(latticeworld_stack.Stack):
        def begin(self, task):
            self.period_s = 1.0 / task.control_hz / options.pace
            self.bridge = Bridge(options.robot, task)
            processes.launch = processes.start("roslaunch", options.launch_file,
                                               *options.arguments)
            try:
                wait_for(f"a node that takes goals of {options.robot}/move_base",
                         lambda: self.bridge.is_heard() or processes.launch.poll() is not None,
                         LAUNCH_S)
            except RuntimeError as late:
                raise latticeworld_stack.Failed(str(late)) from late
            if processes.launch.poll() is not None:
                raise latticeworld_stack.Failed(
                    f"roslaunch {options.launch_file} ended with status {processes.launch.returncode}")
            self.due_s = time.monotonic()

        def update(self, now):
            self.due_s = max(self.due_s + self.period_s, time.monotonic() - self.period_s)
            self.bridge.tell(now)
            time.sleep(max(0.0, self.due_s - time.monotonic()))
            if processes.launch.poll() is not None:
                raise latticeworld_stack.Failed(
                    f"roslaunch ended with status {processes.launch.returncode} under way")
            ended, text = self.bridge.ended()
            if ended == "succeeded":
                return latticeworld_stack.ARRIVED
            if ended:
                raise latticeworld_stack.Failed(f"move_base: {ended}: {text}")
            return self.bridge.command()

    latticeworld_stack.run(LaunchedStack())


def is_online(master):
    try:
        master.getPid()
        return True
    except Exception:  # what the master's proxy raises is of several libraries
        return False


if __name__ == "__main__":
    main()
