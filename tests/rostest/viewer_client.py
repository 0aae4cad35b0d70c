"""A client of world_viewer over bare sockets, and a world_viewer process that a test starts itself."""

import base64
import http.client
import json
import os
import signal
import socket
import struct
import subprocess
import tempfile
import time
import urllib.parse

import roslib.packages
import rospy
from std_msgs.msg import String

from world_client import TIMEOUT_S

WORLD_VIEWER = roslib.packages.find_node("latticeworld", "world_viewer")[0]
TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


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
        parts = urllib.parse.urlparse(url)
        return parts.hostname, parts.port

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


class Socket:
    """A WebSocket (RFC 6455) to a viewer."""

    def __init__(self, viewer):
        host, port = viewer.address()
        self._socket = socket.create_connection((host, port), timeout=TIMEOUT_S)
        key = base64.b64encode(os.urandom(16)).decode()
        self._socket.sendall((
            f"GET /ws HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\n"
            f"Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n"
            f"Origin: http://{host}:{port}\r\n\r\n").encode())
        self._buffer = b""
        while b"\r\n\r\n" not in self._buffer:
            self._fill()
        head, self._buffer = self._buffer.split(b"\r\n\r\n", 1)
        assert b" 101 " in head.split(b"\r\n")[0], head

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._socket.close()

    def _fill(self):
        data = self._socket.recv(1 << 16)
        if not data:
            raise ConnectionError("the viewer ended the connection")
        self._buffer += data

    def _take(self, count):
        while len(self._buffer) < count:
            self._fill()
        data, self._buffer = self._buffer[:count], self._buffer[count:]
        return data

    def _send_frame(self, opcode, payload):
        length = (bytes([0x80 | len(payload)]) if len(payload) < 126 else
                  bytes([0x80 | 126]) + struct.pack(">H", len(payload)))
        self._socket.sendall(bytes([0x80 | opcode]) + length + b"\0\0\0\0" + payload)

    def send(self, **request):
        self._send_frame(TEXT, json.dumps(request).encode())

    def receive(self):
        """The next message: a dict, or bytes."""
        while True:
            opcode, length = self._take(2)
            if length == 126:
                length, = struct.unpack(">H", self._take(2))
            elif length == 127:
                length, = struct.unpack(">Q", self._take(8))
            payload = self._take(length)
            if opcode & 15 == PING:
                self._send_frame(PONG, payload)
            elif opcode & 15 == TEXT:
                return json.loads(payload)
            elif opcode & 15 == BINARY:
                return payload
            elif opcode & 15 == CLOSE:
                raise ConnectionError("the viewer said good-bye")

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
