"""Let nobody in: hostile clients of the page and of ROS ports; do honest ones go on being served?"""

import os
import pathlib
import resource
import statistics
import struct
import threading
import time
import urllib.parse
import xmlrpc.client

import rosgraph
import rospy
from std_msgs.msg import String

from ground import DEADLINE_S, SMALL_WORLD, wait_until
from ledger import Ledger, promise
from web_client import WebSocket, address_of, connect, get, status_of

TOKEN = "a-token-that-nobody-guesses"
MOST_CONNECTIONS = 1000
PATHS_OUT = ("/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/./",
             "/api/worlds/../../etc/passwd", "/api/worlds/x/../../../etc/passwd", "/\\..\\..\\x",
             "/..%2f..%2fetc%2fpasswd", "/index.html%00.png", "*", "/" + "a" * 7000)


class Honest:
    """A client that looks from before an attack to after it, and how long it waits. A context."""

    def __init__(self, host, port):
        self.socket = WebSocket(host, port)
        promise(self.socket.status == 101, f"an honest client got {self.socket.status}")
        self.waits_ms, self.failure = [], None
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._ask, daemon=True)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, kind, *_):
        self._over.set()
        self._thread.join(DEADLINE_S)
        self.socket.__exit__()
        promise(kind is not None or (self.failure is None and self.waits_ms),
                f"an honest client was left alone: {self.failure}")

    def _ask(self):
        """As a page does that is looked at: one question after another, none in haste."""
        try:
            while not self.waits_ms or not self._over.wait(0.2):
                began = time.monotonic()
                answer = self.socket.ask(type="list_worlds")
                promise(answer.get("ok"), f"list_worlds: {answer}")
                self.waits_ms.append(1000.0 * (time.monotonic() - began))
        except (OSError, AssertionError) as error:
            self.failure = error


class Attacks:
    """What is done to a viewer. Each returns what came of it, in words."""

    def __init__(self, host, port, random):
        self.host, self.port, self.random = host, port, random

    def _connect(self):
        return connect(self.host, self.port)

    def _status_of(self, data):
        with self._connect() as connection:
            try:
                connection.sendall(data)
            except OSError:
                pass  # it was left before it had said all
            return status_of(connection)

    def _head(self, line="GET / HTTP/1.1"):
        return f"{line}\r\nHost: {self.host}:{self.port}\r\n".encode()

    def oversized(self):
        for data in (self._head() + b"X: " + b"a" * 100000 + b"\r\n\r\n",
                     self._head("GET /" + "a" * 100000 + " HTTP/1.1") + b"\r\n",
                     self._head("POST / HTTP/1.1") + b"Content-Length: 99999999999\r\n\r\nxx",
                     self._head() + b"X: y\r\n" * 5000 + b"\r\n"):
            status = self._status_of(data)
            promise(status is None or 400 <= status < 500, f"an oversized request got {status}")
        return "4xx, or left"

    def half(self):
        for _ in range(50):
            whole = self._head() + b"\r\n"
            with self._connect() as connection:
                connection.sendall(whole[:self.random.randrange(1, len(whole))])
        return "left"

    def garbage(self):
        for _ in range(50):
            data = bytearray(self._head() + b"\r\n") if self.random.random() < 0.5 else \
                bytearray(self.random.randbytes(200))
            for _ in range(5):
                data[self.random.randrange(len(data))] = self.random.randrange(256)
            status = self._status_of(bytes(data) + b"\r\n\r\n")
            promise(status is None or status == 200 or 400 <= status < 500,
                    f"garbage got {status}")
        return "4xx, or left"

    def slow(self):
        """Fifty that send a letter each now and then; they are left after 15 s."""
        crowd = [self._connect() for _ in range(50)]
        for letter in b"GET / HTTP/1.1\r\nHost":
            for connection in crowd:
                try:
                    connection.sendall(bytes([letter]))
                except OSError:
                    pass
        with crowd[0] as first:
            promise(status_of(first) is None, "half a request was answered")
        for connection in crowd:
            connection.close()
        return "left after 15 s"

    def wrong_origin(self):
        for origin, name in (("http://evil.example", None), ("null", None),
                             ("http://127.0.0.1:1", None), ("http://evil.example", "evil.example")):
            with WebSocket(self.host, self.port, origin, name) as client:
                promise(client.status == 403, f"origin {origin}, host {name} got {client.status}")
        return "403"

    def wrong_token(self):
        with WebSocket(self.host, self.port) as client:
            tried = 0
            for number in range(12):
                answer = client.ask(type="authenticate", token=f"{TOKEN[:-1]}{number}")
                promise(not answer["ok"], "a wrong token was taken")
                tried += answer["code"] == "UNAUTHENTICATED"
            promise(tried < 12, "tokens can be tried as fast as one likes")
            answer = client.ask(type="pause")
            promise(answer["code"] == "PERMISSION_DENIED", f"pause got {answer}")
        return f"UNAUTHENTICATED {tried} times of 12, then RESOURCE_EXHAUSTED"

    def paths(self):
        for path in PATHS_OUT:
            status = get(self.host, self.port, path)
            promise(status in (400, 404, 431, 416), f"{path[:60]} got {status}")
        return "4xx"

    def frames(self):
        """Each of these ends its connection (RFC 6455, 5)."""
        bad = (lambda c: c.send_frame(0, b"a continuation of nothing"),
               lambda c: (c.send_frame(1, b"{", final=False), c.send_frame(1, b"}")),
               lambda c: c.send_frame(3, b"no such opcode"),
               lambda c: c.send_frame(11, b"no such control"),
               lambda c: c.send_frame(1, b"{}", masked=False),
               lambda c: c.send_frame(1, b"{}", reserved=0x40),
               lambda c: c.send_frame(9, b"p" * 126), lambda c: c.send_frame(9, final=False),
               lambda c: c.send_frame(8, b"x"), lambda c: c.send_frame(1, b"\xff\xfe"),
               lambda c: c.send_frame(1, b"x" * 5000),
               lambda c: c.send_bytes(b"\x81\xff" + b"\x7f" + b"\xff" * 7 + b"\0" * 4))
        for number, send in enumerate(bad):
            with WebSocket(self.host, self.port) as client:
                promise(client.status == 101, f"a client got {client.status}")
                send(client)
                promise(client.ends(), f"bad frame {number} did not end its connection")
        return f"{len(bad)} kinds, each ends its connection"

    def flood(self):
        with WebSocket(self.host, self.port) as client:
            try:
                for _ in range(3000):
                    client.send(type="strike", robot="robot")
            except OSError:
                pass
            promise(client.ends(), "a flood goes on for ever")
        with self._connect() as connection:
            try:
                connection.sendall((self._head() + b"\r\n") * 2000)
            except OSError:
                pass
        return "the WebSocket is ended"

    def crowd(self):
        crowd = []
        try:
            for _ in range(MOST_CONNECTIONS):
                crowd.append(self._connect())
        except OSError:
            pass
        for connection in crowd:
            connection.close()
        return f"{len(crowd)} connections, 256 held"

    def all(self):
        return {"oversized requests": self.oversized, "half requests": self.half,
                "garbage": self.garbage, "slow senders": self.slow, "wrong origin": self.wrong_origin,
                "wrong token": self.wrong_token, "paths that leave": self.paths,
                "WebSocket frames out of order": self.frames, "floods": self.flood,
                "1,000 connections": self.crowd}


class RosAttacks:
    """What is done to the ROS ports of world_server."""

    def __init__(self, ground, visuals, random):
        self.ground, self.visuals, self.random = ground, visuals, random
        master = rosgraph.Master(rospy.get_name())
        service = urllib.parse.urlparse(master.lookupService("/get_world"))
        node = urllib.parse.urlparse(master.lookupNode("/world_server"))
        self.service, self.node = (service.hostname, service.port), (node.hostname, node.port)

    def garbage(self):
        for address in (self.service, self.node):
            for _ in range(20):
                with connect(*address) as connection:
                    connection.sendall(self.random.randbytes(300))
        return "left"

    def lengths(self):
        """Headers and requests that say they are larger than they may be, and half ones."""
        header = b"".join(struct.pack("<I", len(field)) + field for field in
                          (b"callerid=/evil", b"service=/get_world", b"md5sum=*"))
        for data in (struct.pack("<I", 0xffffffff), struct.pack("<I", 0x7fffffff) + b"x" * 100,
                     struct.pack("<I", len(header)) + header[:10],
                     struct.pack("<I", len(header)) + header + struct.pack("<I", 0xffffffff)):
            with connect(*self.service) as connection:
                connection.sendall(data)
        return "left"

    def calls(self):
        proxy = xmlrpc.client.ServerProxy(f"http://{self.node[0]}:{self.node[1]}")
        for call in (lambda: proxy.requestTopic("/evil", "/clock", [["TCPROS"] * 200]),
                     lambda: proxy.publisherUpdate("/evil", "/x" * 2000, ["http://127.0.0.1:1"]),
                     lambda: proxy.paramUpdate("/evil", "/k", "v" * 100000),
                     lambda: proxy.noSuchCall(1, 2, 3)):
            try:
                call()
            except (xmlrpc.client.Error, OSError):
                pass
        return "answered with an error"

    def crowd(self):
        crowd = [connect(*address) for address in (self.service, self.node) for _ in range(200)]
        for connection in crowd:
            connection.close()
        return "400 connections"

    def visual_paths(self):
        """Files outside by every name, also while a folder is swapped for a link."""
        secret = self.visuals.parent / "secret"
        secret.mkdir(exist_ok=True)
        (secret / "a.pgm").write_bytes(b"P5 2 2 255 SECR")
        inner, link = self.visuals / "inner", self.visuals.parent / "link"
        inner.mkdir(exist_ok=True)
        for path in (link, self.visuals / "out"):
            if not path.is_symlink():
                path.symlink_to(secret)
        for path in ("../secret/a.pgm", str(secret / "a.pgm"), "out/a.pgm", "/proc/self/environ",
                     "/dev/zero", "inner/../../secret/a.pgm"):
            self._refused(path)
        over = threading.Event()
        swapper = threading.Thread(target=self._swap, args=(inner, link, over), daemon=True)
        swapper.start()
        for _ in range(20):
            self._refused("inner/a.pgm")
        over.set()
        swapper.join()
        return "PERMISSION_DENIED or NOT_FOUND"

    def _refused(self, path):
        answer = self.ground.call("generate_world", seed=1, visual_kind=1, visual_path=path,
                                  **SMALL_WORLD)
        promise(answer is not None and answer.status.code in (5, 7),
                f"visual_path {path} got {answer and answer.status.message}")

    @staticmethod
    def _swap(inner, link, over):
        spare = inner.with_name("spare")
        while not over.is_set():
            os.rename(inner, spare)
            os.symlink(link, inner)
            os.unlink(inner)
            os.rename(spare, inner)

    def all(self):
        return {"garbage at ROS ports": self.garbage, "lengths at ROS ports": self.lengths,
                "calls of the node's own interface": self.calls,
                "400 connections to ROS ports": self.crowd,
                "visual_path that leaves": self.visual_paths}


class Waits:
    """What came of each kind of attack, and how long honest clients waited meanwhile."""

    def __init__(self):
        self.of = {}  # attack -> [outcome, rounds, waits in ms]

    def add(self, name, outcome, waits_ms):
        entry = self.of.setdefault(name, [outcome, 0, []])
        entry[1] += 1
        entry[2] += waits_ms

    def tell(self, ledger):
        ledger.table("attack", "rounds", "what comes of it", "answers to an honest client",
                     "its median wait [ms]", "longest [ms]")
        for name, (outcome, rounds, waits_ms) in sorted(self.of.items()):
            ledger.row(name, rounds, outcome, len(waits_ms), f"{statistics.median(waits_ms):.0f}",
                       f"{max(waits_ms):.0f}")


def attack_round(attack, honest_at, programs, before, name, waits):
    """One attack while an honest client looks; afterwards all is as before."""
    with Honest(*honest_at) as honest:
        outcome = attack()
    for program in programs:
        promise(program.runs(), f"a node ended under {name}: {program.last_words()}")
    wait_until(lambda: all(_descriptors(program) <= before[program.pid] + 8
                           for program in programs), f"the connections of {name} are let go")
    waits.add(name, outcome, honest.waits_ms)


def _descriptors(program):
    return len(os.listdir(f"/proc/{program.pid}/fd"))


def run(ground, end, random):
    """Attacks in random order until `end` [s, monotonic], at least one; the ledger."""
    ledger = Ledger("Let nobody in")
    waits = Waits()
    resource.setrlimit(resource.RLIMIT_NOFILE, (resource.getrlimit(resource.RLIMIT_NOFILE)[1],) * 2)
    folder = pathlib.Path(ground.new_folder("attacks"))
    visuals = folder / "visuals"
    visuals.mkdir()
    with ground.world_server(worlds_directory=folder / "worlds",
                             visual_directories=[str(visuals)]) as server, \
            ground.node("world_viewer", {"LATTICEWORLD_VIEWER_TOKEN": TOKEN}, port=0,
                        require_token=True) as viewer:
        at = address_of(rospy.wait_for_message("/viewer/address", String, DEADLINE_S).data)
        ground.must("generate_world", seed=1, **SMALL_WORLD)
        attacks = list({**Attacks(*at, random).all(),
                        **RosAttacks(ground, visuals, random).all()}.items())
        before = {}
        while True:
            random.shuffle(attacks)
            for name, attack in attacks:
                for program in (server, viewer):
                    before.setdefault(program.pid, _descriptors(program))
                ledger.watch(name, lambda: attack_round(attack, at, (server, viewer), before, name,
                                                        waits))
                if time.monotonic() > end:
                    waits.tell(ledger)
                    return ledger
