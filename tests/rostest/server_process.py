"""A world_server process that a rostest starts and ends itself."""

import os
import signal
import subprocess
import tempfile

import roslib.packages
import rospy
import rosservice

from world_client import TIMEOUT_S, wait_until

WORLD_SERVER = roslib.packages.find_node("latticeworld", "world_server")[0]


class Server:
    """A world_server process of our own with these private parameters.

    before: what the process does before it becomes the server. environment: variables that it has
    besides this process's own.
    """

    def __init__(self, *, before=None, environment=None, **parameters):
        rospy.set_param("/world_server", parameters)
        self.output = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen([WORLD_SERVER], stdout=self.output,
                                        stderr=subprocess.STDOUT, preexec_fn=before,
                                        env={**os.environ, **(environment or {})})

    def __enter__(self):
        wait_until(lambda: rosservice.get_service_node("/generate_world") or
                   self.process.poll() is not None, "world_server is ready")
        return self

    def __exit__(self, *_):
        self.stop()
        rospy.delete_param("/world_server")

    def stop(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        return self.process.wait(TIMEOUT_S)

    def text(self):
        self.output.seek(0)
        return self.output.read()
