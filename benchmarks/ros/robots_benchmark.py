#!/usr/bin/python3
"""Measures what 100 robots cost world_server whose odometry, frames and scans are listened to.

100 four-wheel robots of the suite "scanner" (scans of 1081 beams at 40 Hz, states at 50 Hz) drive in
circles on a meadow, stepped as fast as the machine can by the service lockstep. Prints, by who
listens: the real-time factor; processor time of the server and of the listener for a second of
simulated time, which other programs on the machine change little; messages, and those that are
missing. Several servers, as before and after a change, run beside each other and take turns of two
simulated seconds; medians over the turns come last, with their ratios to the first server's.

Usage: robots_benchmark.py [--turns N] WORLD_SERVER...
       (the programs to compare; with the build's devel/setup.bash sourced)
"""

import argparse
import contextlib
import json
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import time

import world_server_benchmark as node

STEP_S = 0.01
STEPS_A_TURN = 200
SETTLED_S = 0.3  # nothing has come for so long: all has
TIMEOUT_S = 300.0
AUDIENCES = ("nobody", "one robot", "odometry and frames of all",
             "odometry, frames and scans of all")


def topics_of(names):
    """What is listened to, by who listens."""
    odometry = [f"/{name}/odom" for name in names]
    scans = [f"/{name}/scan" for name in names]
    return dict(zip(AUDIENCES, ([], ["/tf", odometry[0], scans[0]], ["/tf"] + odometry,
                                ["/tf"] + odometry + scans)))


class Listener:
    """A process that hears topics and counts; without topics there is none."""

    def __init__(self, topics):
        import roslib.packages
        self._process = None
        if topics:
            program = roslib.packages.find_node("latticeworld", "topic_listener")[0]
            self._process = subprocess.Popen([program, *topics], stdin=subprocess.PIPE,
                                             stdout=subprocess.PIPE, text=True)
            while not self._take()["connected"]:
                time.sleep(0.1)

    def _take(self):
        if self._process is None:
            return {"messages": 0, "bytes": 0, "missing": 0, "cpu_s": 0.0}
        self._process.stdin.write("\n")
        self._process.stdin.flush()
        return json.loads(self._process.stdout.readline())

    def take_all(self):
        """What came since the last call, once nothing comes any more."""
        total = self._take()
        while self._process is not None:
            time.sleep(SETTLED_S)
            more = self._take()
            total = {key: total[key] + more[key] for key in total}
            if more["messages"] == 0:
                break
        return total

    def close(self):
        if self._process is not None:
            self._process.stdin.close()
            self._process.wait()


@contextlib.contextmanager
def running(program, **parameters):
    """A master of its own, this process a node beside it, and meanwhile the server: its process."""
    environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{node.free_port()}",
                       ROS_IP="127.0.0.1")
    os.environ.update(environment)
    import rosgraph
    import rospy
    with contextlib.ExitStack() as processes:
        def start(*command):
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            processes.callback(process.wait)
            processes.callback(process.send_signal, signal.SIGINT)
            return process

        start("rosmaster", "--core", "-p", environment["ROS_MASTER_URI"].rsplit(":", 1)[1])
        while not rosgraph.is_master_online():
            time.sleep(0.05)
        rospy.set_param("/use_sim_time", True)
        rospy.set_param("/world_server", parameters)
        server = start(program)
        rospy.init_node("robots_benchmark", disable_signals=True, disable_rosout=True)
        rospy.wait_for_service("/generate_world", timeout=TIMEOUT_S)
        yield server
        rospy.signal_shutdown("done")


def take_turn(pid, lockstep, commands, listener):
    """The figures of a turn."""
    begin, begin_s = time.monotonic(), node.cpu_s(pid)
    answer = lockstep(commands=commands, steps=STEPS_A_TURN, hash=True)
    wall_s = time.monotonic() - begin
    assert answer.status.code == 0, answer.status.message
    heard = listener.take_all()
    simulated_s = STEP_S * STEPS_A_TURN
    return {"factor": simulated_s / wall_s,
            "server_s": (node.cpu_s(pid) - begin_s) / simulated_s,
            "listener_s": heard["cpu_s"] / simulated_s, "messages": heard["messages"] / simulated_s,
            "megabytes": 1e-6 * heard["bytes"] / simulated_s, "missing": heard["missing"],
            "state_hash": answer.state_hash}


def serve(program):
    """Runs a server and answers on standard output what standard input asks for: another audience by
    its name, or "turn". In a process of its own: a rospy node lives once."""
    import rospy
    from geometry_msgs.msg import Twist, Vector3
    from latticeworld.msg import AgentCommand
    from latticeworld.srv import GenerateWorld, Lockstep
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="latticeworld_bench_"))
        os.environ["ROS_HOME"] = folder
        server = stack.enter_context(running(program, start_paused=True, command_timeout=60.0,
                                             sensor_suite="scanner", worlds_directory=folder))
        answer = rospy.ServiceProxy("/generate_world", GenerateWorld)(
            layout_instruction="Flat grassland everywhere.",
            environment_instruction="A sunny summer noon.", seed=1, size=256.0)
        assert answer.status.code == 0, answer.status.message
        names = node.spawn_robots(10, 8.0)
        drive = Twist(linear=Vector3(x=1.0), angular=Vector3(z=0.5))
        commands = [AgentCommand(name, drive) for name in names]
        lockstep = rospy.ServiceProxy("/lockstep", Lockstep, persistent=True)
        listener = Listener([])
        print("ready", flush=True)
        for line in sys.stdin:
            if line.strip() == "turn":
                figures = take_turn(server.pid, lockstep, commands, listener)
                print(json.dumps(figures), flush=True)
            else:
                listener.close()
                listener = Listener(topics_of(names)[line.strip()])
                take_turn(server.pid, lockstep, commands, listener)  # makes what is made once
                print("ready", flush=True)
        listener.close()


class Server:
    """A process that serves."""

    def __init__(self, program):
        self.program = program
        self.turns = {audience: [] for audience in AUDIENCES}
        self._process = subprocess.Popen([sys.executable, __file__, "--serve", program],
                                         stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, what):
        self._process.stdin.write(what + "\n")
        self._process.stdin.flush()

    def answer(self):
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"{self.program} has ended")
        return line

    def close(self):
        self._process.stdin.close()
        self._process.wait()

    def median(self, audience, figure):
        return statistics.median(turn[figure] for turn in self.turns[audience])


def report(servers):
    for audience in AUDIENCES:
        for server in servers:
            factor, server_s, listener_s, messages, megabytes = (
                server.median(audience, figure)
                for figure in ("factor", "server_s", "listener_s", "messages", "megabytes"))
            missing = sum(turn["missing"] for turn in server.turns[audience])
            print(f"{audience}, {server.program}: factor {factor:.2f} "
                  f"({factor / servers[0].median(audience, 'factor'):.2f} of the first); a simulated "
                  f"second takes {server_s:.3f} s of the server "
                  f"({server_s / servers[0].median(audience, 'server_s'):.2f}), {listener_s:.3f} s of "
                  f"the listener; {messages:.0f} messages, {megabytes:.1f} MB; {missing} missing "
                  "in all", flush=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--serve", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("programs", nargs="+")
    options = parser.parse_args()
    if options.serve:
        serve(options.programs[0])
        return
    servers = [Server(program) for program in options.programs]
    for server in servers:
        server.answer()
    for audience in AUDIENCES:
        for server in servers:
            server.ask(audience)
            server.answer()
        for _ in range(options.turns):
            for server in servers:
                server.ask("turn")
                server.turns[audience].append(json.loads(server.answer()))
            hashes = {server.turns[audience][-1]["state_hash"] for server in servers}
            if len(hashes) > 1:
                print(f"{audience}: the servers' states differ", flush=True)
    report(servers)
    for server in servers:
        server.close()


if __name__ == "__main__":
    main()
