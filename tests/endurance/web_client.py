"""A client of world_viewer over bare sockets, which may say whatever it likes."""

import base64
import json
import os
import socket
import struct
import urllib.parse

TEXT, CLOSE, PING, PONG = 1, 8, 9, 10
PATIENCE_S = 60.0


def address_of(url):
    parts = urllib.parse.urlparse(url)
    return parts.hostname, parts.port


def connect(host, port, patience_s=PATIENCE_S):
    return socket.create_connection((host, port), timeout=patience_s)


def read_head(connection):
    """Status line and headers of an answer; empty where the connection ends without."""
    data = b""
    try:
        while b"\r\n\r\n" not in data:
            more = connection.recv(1 << 12)
            if not more:
                break
            data += more
    except OSError:
        pass
    return data


def status_of(connection):
    """Of an answer; None: the connection ended without one."""
    head = read_head(connection)
    return int(head.split(b" ", 2)[1]) if head.startswith(b"HTTP/1.1 ") else None


def get(host, port, path, headers=""):
    """The status of a GET; None where none came."""
    with connect(host, port) as connection:
        connection.sendall(f"GET {path} HTTP/1.1\r\nHost: {host}:{port}\r\nConnection: close\r\n"
                           f"{headers}\r\n".encode())
        return status_of(connection)


class WebSocket:
    """A WebSocket (RFC 6455). A context. status: of the answer to its request."""

    def __init__(self, host, port, origin=None, host_name=None):
        name = host_name or f"{host}:{port}"
        key = base64.b64encode(os.urandom(16)).decode()
        self._socket = connect(host, port)
        self._socket.sendall((
            f"GET /ws HTTP/1.1\r\nHost: {name}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n"
            f"Origin: {origin or 'http://' + name}\r\n\r\n").encode())
        head = read_head(self._socket)
        self.status = int(head.split(b" ", 2)[1]) if head.startswith(b"HTTP/1.1 ") else None
        self._buffer = head.split(b"\r\n\r\n", 1)[1] if b"\r\n\r\n" in head else b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._socket.close()

    def send_bytes(self, data):
        self._socket.sendall(data)

    def send_frame(self, opcode, payload=b"", final=True, reserved=0, masked=True):
        """Any frame, legal or not."""
        first = (0x80 if final else 0) | reserved | opcode
        mask = 0x80 if masked else 0
        size = len(payload)
        length = (bytes([mask | size]) if size < 126 else
                  bytes([mask | 126]) + struct.pack(">H", size))
        self.send_bytes(bytes([first]) + length + (b"\0\0\0\0" if masked else b"") + payload)

    def send(self, **request):
        self.send_frame(TEXT, json.dumps(request).encode())

    def _take(self, count):
        while len(self._buffer) < count:
            data = self._socket.recv(1 << 16)
            if not data:
                raise ConnectionError("the viewer ended the connection")
            self._buffer += data
        data, self._buffer = self._buffer[:count], self._buffer[count:]
        return data

    def receive(self):
        """The next message: a dict, or bytes. Errors: ConnectionError once it is over."""
        while True:
            opcode, length = self._take(2)
            if length == 126:
                length, = struct.unpack(">H", self._take(2))
            elif length == 127:
                length, = struct.unpack(">Q", self._take(8))
            payload = self._take(length)
            if opcode & 15 == PING:
                self.send_frame(PONG, payload)
            elif opcode & 15 == TEXT:
                return json.loads(payload)
            elif opcode & 15 == CLOSE:
                raise ConnectionError("the viewer said good-bye")
            elif opcode & 15 != PONG:
                return payload

    def read_all(self):
        """Reads until the connection ends."""
        try:
            while True:
                self.receive()
        except (OSError, ValueError):
            pass

    def ask(self, **request):
        """Sends a request and gives its reply."""
        self.send(id=request["type"], **request)
        while True:
            message = self.receive()
            if isinstance(message, dict) and message.get("id") == request["type"]:
                return message

    def ends(self):
        """Whether the server ends the connection; False where it stays silent for a minute."""
        try:
            while True:
                self.receive()
        except TimeoutError:
            return False
        except (OSError, ValueError):
            return True
