"""What the tests of episodes share: a recorder's services, a second recorder, and the tools."""

import os
import pathlib
import resource
import signal
import socket
import subprocess

import rosgraph

from latticeworld import srv
from world_client import TIMEOUT_S, service, wait_until

FIELD = {"layout": "Flat grassland everywhere.",
         "environment": "A sunny summer noon. A wheeled robot waits in the center.",
         "size": 96.0, "seed": 9}


class Recorder:
    """The services of an episode_recorder; prefix: of their names."""

    def __init__(self, prefix=""):
        self.start_episode = service(prefix + "start_episode", srv.StartEpisode)
        self.stop_episode = service(prefix + "stop_episode", srv.StopEpisode)
        self.list_episodes = service(prefix + "list_episodes", srv.ListEpisodes)


class OtherRecorder:
    """Another episode_recorder beside the first, in a process of its own. A context."""

    def __init__(self, name, directory, max_file_bytes=None):
        names = ("start_episode", "stop_episode", "list_episodes", "episode/status")
        limit = None
        if max_file_bytes is not None:
            limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                               (max_file_bytes, max_file_bytes))
        self.process = subprocess.Popen(
            [program("episode_recorder"), f"__name:={name}", f"_directory:={directory}",
             *(f"{one}:=/{name}/{one}" for one in names)], preexec_fn=limit)
        self.recorder = Recorder(f"/{name}/")

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait(TIMEOUT_S)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(TIMEOUT_S)


class OtherMaster:
    """A ROS master of its own. A context that gives the environment of who uses it."""

    def __enter__(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
        self.process = subprocess.Popen(["rosmaster", "--core", "-p", str(port)],
                                        stdout=subprocess.DEVNULL)
        uri = f"http://127.0.0.1:{port}/"
        master = rosgraph.Master("/episode_test", master_uri=uri)
        wait_until(master.is_online, "the other master is there")
        return dict(os.environ, ROS_MASTER_URI=uri)

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(TIMEOUT_S)


def program(name):
    """Where a node of the package lies."""
    found = subprocess.run(["catkin_find", "--first-only", "--libexec", "latticeworld", name],
                           stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    assert found, f"{name} is not built"
    return found


def run_tool(*arguments, env=None):
    """Exit code and all that it says."""
    done = subprocess.run([program(arguments[0]), *map(str, arguments[1:])], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT_S,
                          env=env, check=False)
    return done.returncode, done.stdout


def verify(*bags):
    """As whoever has no ROS master does it."""
    env = {name: value for name, value in os.environ.items() if name != "ROS_MASTER_URI"}
    return run_tool("replay_episode", "--verify", *bags, env=env)
