"""Programs in Debian's ROS, on a port of their own."""

import os
import pathlib
import subprocess
import sys
import time

from peer import PROGRAM, WORLDS

PORT = "11377"
SETUP = os.path.join(os.path.dirname(PROGRAM), "..", "..", "setup.bash")
CLIENTS = pathlib.Path(__file__).resolve().parents[2] / "clients"


def ros(command, **options):
    """A command with the environment of ROS, started."""
    text = f"source {SETUP} && export ROS_MASTER_URI=http://127.0.0.1:{PORT} && exec {command}"
    return subprocess.Popen(["bash", "-c", text], **{"stdout": subprocess.DEVNULL,
                            "stderr": subprocess.DEVNULL, **options})


def call(command, tries=60):
    for _ in range(tries):
        if ros(command).wait() == 0:
            return
        time.sleep(1)
    raise SystemExit(f"no answer: {command}")


def ros_says(command):
    """What a program of ROS prints."""
    return ros(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
               text=True).communicate()[0]


class Launch:
    """A launch file of latticeworld, for as long as the block lasts."""

    def __init__(self, file, **arguments):
        home = WORLDS / "ros"
        words = " ".join(f"{name}:='{value}'" for name, value in arguments.items())
        self.launch = ros(f"roslaunch -p {PORT} latticeworld {file} {words}",
                          env={**os.environ, "HOME": str(home), "ROS_HOME": str(home)})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.launch.terminate()
        self.launch.wait()

    def python(self, program):
        """What a Python program says that uses clients/latticeworld_gym."""
        call("rosservice call /static_map")  # refused until a world runs
        path = f"PYTHONPATH={CLIENTS / 'latticeworld_gym'}:$PYTHONPATH"
        return ros_says(f"env {path} {sys.executable} -P {program}")
