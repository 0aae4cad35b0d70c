"""Let nobody in: hostile clients of the page and of ROS ports, and worlds that strangers have made;
do honest clients go on being served?"""

import hashlib
import json
import os
import pathlib
import resource
import shutil
import struct
import threading
import time
import urllib.parse
import xmlrpc.client
import zlib

import rosgraph
import rospy
from std_msgs.msg import String

from ground import DEADLINE_S, SMALL_WORLD, wait_until
from ledger import notes, promise, table
from web_client import WebSocket, address_of, connect, get, status_of

TITLE = "Let nobody in"
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
                "garbage": self.garbage, "slow senders": self.slow,
                "wrong origin": self.wrong_origin,
                "wrong token": self.wrong_token, "paths that leave": self.paths,
                "WebSocket frames out of order": self.frames, "floods": self.flood,
                "1,000 connections": self.crowd}


def change_manifest(change):
    """Of a bundle, with the digest that it then has to carry."""
    def apply(bundle):
        manifest = json.loads((bundle / "world.json").read_text(encoding="utf-8"))
        change(manifest)
        manifest["manifest_sha256"] = "0" * 64
        text = json.dumps(manifest)
        manifest["manifest_sha256"] = hashlib.sha256(text.encode()).hexdigest()
        (bundle / "world.json").write_text(json.dumps(manifest), encoding="utf-8")
    return apply


def forge(bundle, name, content):
    """Gives a bundle's file other content, and the manifest what it says of it."""
    (bundle / name).write_bytes(content)
    told_of = {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()}
    change_manifest(lambda manifest: [file.update(told_of) for file in manifest["files"]
                                      if file["name"] == name])(bundle)


def _instead_of(name, make):
    """Another kind of file in a bundle's file's place."""
    def apply(bundle):
        (bundle / name).unlink()
        make(bundle / name)
    return apply


def _grown_terrain(bundle):
    """What begins as packed terrain goes on as 200 MB of nothing, packed into less than 1 MB."""
    packer = zlib.compressobj(1)
    grown = b"".join(packer.compress(bytes(1 << 20)) for _ in range(200)) + packer.flush()
    forge(bundle, "terrain.bin", (bundle / "terrain.bin").read_bytes()[:64] + grown)


# What may be wrong with a bundle that a stranger has made.
HOSTILE_BUNDLES = {
    "a name that leaves": change_manifest(
        lambda manifest: manifest["files"][0].update(name="../good/layout.txt")),
    "an absolute name": change_manifest(
        lambda manifest: manifest["files"][0].update(name="/etc/passwd")),
    "huge sizes": change_manifest(
        lambda manifest: [file.update(bytes=(1 << 64) - 1) for file in manifest["files"]]),
    "a size without bounds": change_manifest(
        lambda manifest: manifest["request"].update(size_m=1e300)),
    "30,000 files": change_manifest(
        lambda manifest: manifest.update(files=manifest["files"] * 2000)),
    "a link to what has no end": _instead_of(
        "layout.txt", lambda path: path.symlink_to("/dev/zero")),
    "a link to itself": _instead_of("layout.txt", lambda path: path.symlink_to(path)),
    "a link that leaves": _instead_of("layout.txt", lambda path: path.symlink_to("/etc/passwd")),
    "a pipe": _instead_of("terrain.bin", os.mkfifo),
    "a folder": _instead_of("world.json", os.mkdir),
    "terrain that grows": _grown_terrain,
    "lists in lists": lambda bundle: forge(bundle, "agents.json", b"[" * (1 << 20)),
}
MOST_GROWTH_MB = 250.0  # of the server at its most under hostile bundles; 150 are the 30,000 files


def resident_mb(pid):
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        return int(next(line for line in file if line.startswith("VmHWM")).split()[1]) / 1000.0


class RosAttacks:
    """What is done to the ROS ports of world_server, and to the folder of its worlds."""

    def __init__(self, ground, server, folder, random):
        self.ground, self.server, self.random = ground, server, random
        self.visuals, self.worlds = folder / "visuals", folder / "worlds"
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

    def bundles(self):
        """Each is refused by load_world with words; list_worlds goes on listing the others."""
        if not (self.worlds / "good").exists():
            self.ground.must("save_world", name="good")
        before_mb = resident_mb(self.server.pid)
        for number, (what, spoil) in enumerate(HOSTILE_BUNDLES.items()):
            bundle = self.worlds / f"bad{number}"
            shutil.copytree(self.worlds / "good", bundle)
            spoil(bundle)
            answer = self.ground.call("load_world", name=bundle.name)
            promise(answer is not None and answer.status.code != 0,
                    f"a bundle with {what} got {answer and answer.status}")
            listed = [world.name for world in self.ground.must("list_worlds").worlds]
            promise("good" in listed, f"beside a bundle with {what} only {listed} are listed")
            shutil.rmtree(bundle)
        grown_mb = resident_mb(self.server.pid) - before_mb
        promise(grown_mb < MOST_GROWTH_MB, f"hostile bundles took {grown_mb:.0f} MB")
        self.ground.must("load_world", name="good")
        return f"{len(HOSTILE_BUNDLES)} kinds, each refused"

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
                "hostile bundles": self.bundles,
                "visual_path that leaves": self.visual_paths}


def attack_round(attack, honest_at, programs, before, name, ledger):
    """One attack while an honest client looks; afterwards all is as before."""
    with Honest(*honest_at) as honest:
        outcome = attack()
    for program in programs:
        promise(program.runs(), f"a node ended under {name}: {program.last_words()}")
    wait_until(lambda: all(_descriptors(program) <= before[program.pid] + 8
                           for program in programs), f"the connections of {name} are let go")
    ledger.note("attack", attack=name, outcome=outcome,
                waits_ms=[round(wait, 1) for wait in honest.waits_ms])


def _descriptors(program):
    return len(os.listdir(f"/proc/{program.pid}/fd"))


def run(ground, end, random, ledger):
    """Attacks in random order until `end` [s, monotonic], at least one of each."""
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
                        **RosAttacks(ground, server, folder, random).all()}.items())
        attacks = [each for each in attacks if each[0].startswith(ground.wanted)]
        before = {}
        while True:
            random.shuffle(attacks)
            for name, attack in attacks:
                for program in (server, viewer):
                    before.setdefault(program.pid, _descriptors(program))
                ledger.watch(name, lambda name=name, attack=attack: attack_round(
                    attack, at, (server, viewer), before, name, ledger))
                if time.monotonic() > end:
                    return


def tables(events):
    """What came of each attack, and how long the honest client waited meanwhile."""
    rounds = {}
    for event in notes(events, "attack"):
        rounds.setdefault(event["attack"], []).append(event)
    rows = []
    for name, some in sorted(rounds.items()):
        waits_ms = sorted(wait for event in some for wait in event["waits_ms"])
        rows.append([name, len(some), some[-1]["outcome"], len(waits_ms),
                     *(f"{waits_ms[min(len(waits_ms) - 1, int(share * len(waits_ms)))]:.0f}"
                       for share in (0.5, 0.95, 1.0))])
    return table(["attack", "rounds", "what comes of it", "answers to an honest client",
                  "its median wait [ms]", "95 of 100 [ms]", "longest [ms]"], rows)
