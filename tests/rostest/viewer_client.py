"""A client of world_viewer over bare sockets, and a world_viewer process that a test starts itself."""

import http.client
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import roslib.packages
import rospy
from std_msgs.msg import String

from world_client import TIMEOUT_S

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "endurance"))
from web_client import WebSocket, address_of  # noqa: E402

WORLD_VIEWER = roslib.packages.find_node("latticeworld", "world_viewer")[0]


class Viewer:
    """A world_viewer process of our own on a free port with these private parameters."""

    def __init__(self, environment=None, **parameters):
        rospy.set_param("/world_viewer", {"port": 0, **parameters})
        self.output = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen([WORLD_VIEWER], stdout=self.output,
                                        stderr=subprocess.STDOUT,
                                        env={**os.environ, **(environment or {})})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
        rospy.delete_param("/world_viewer")

    def address(self):
        """Host and port, once it listens."""
        url = rospy.wait_for_message("/viewer/address", String, timeout=TIMEOUT_S).data
        return address_of(url)

    def get(self, path):
        """Status and body of a GET."""
        connection = http.client.HTTPConnection(*self.address(), timeout=TIMEOUT_S)
        connection.request("GET", path)
        response = connection.getresponse()
        body = response.read()
        connection.close()
        return response.status, body

    def world(self):
        status, body = self.get("/api/world.json")
        return json.loads(body) if status == 200 else None

    def stop(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        return self.process.wait(TIMEOUT_S)

    def text(self):
        self.output.seek(0)
        return self.output.read()


class Socket(WebSocket):
    """A WebSocket to a viewer, which takes it."""

    def __init__(self, viewer):
        super().__init__(*viewer.address())
        assert self.status == 101, self.status

    def wait_for(self, wanted, what):
        """The next message for which wanted is true."""
        deadline = time.monotonic() + TIMEOUT_S
        while time.monotonic() < deadline:
            message = self.receive()
            if wanted(message):
                return message
        raise AssertionError(f"not within {TIMEOUT_S} s: {what}")

    def wait_for_type(self, kind, **fields):
        return self.wait_for(
            lambda message: isinstance(message, dict) and message.get("type") == kind and
            all(message.get(key) == value for key, value in fields.items()),
            f"{kind} {fields}")

    def wait_for_bytes(self, kind):
        """The next binary message that begins with that byte."""
        return self.wait_for(lambda message: isinstance(message, bytes) and message[0] == kind,
                             f"binary message {kind}")

    def ask(self, **request):
        """Sends a request and gives its reply."""
        self.send(id=request["type"], **request)
        return self.wait_for_type("reply", id=request["type"])
