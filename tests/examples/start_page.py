"""What docs/start.md shows: its blocks by language, and the commands in them.

Blocks of `bash` are run by tests, each command in a shell of its own: those of ROS by
tests/rostest/examples_test.py, the others by start_page_test.py. Blocks of `console` set things up
(install, build, start): what they name of the sources has to be there.
"""

import re

ROS_PROGRAMS = ("rosservice", "rosrun", "rostopic", "roslaunch")
FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks_of(text, language):
    return [body for name, body in FENCE.findall(text) if name == language]


def commands_of(text):
    """The commands of the page's bash blocks, in order: a line each."""
    lines = "".join(blocks_of(text, "bash")).splitlines()
    return [line for line in lines if line.strip() and not line.startswith("#")]


def needs_ros(command):
    return command.split()[0] in ROS_PROGRAMS
