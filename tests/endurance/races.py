"""Races: eight clients call everything at once, in programs that ThreadSanitizer watches."""

import functools
import itertools
import pathlib
import re
import threading
import time

import rospy
from geometry_msgs.msg import Point, Twist, Vector3
from sensor_msgs.msg import Imu, LaserScan, PointCloud2
from std_msgs.msg import Empty, String
from visualization_msgs.msg import MarkerArray

from ground import DEADLINE_S, SMALL_WORLD
from latticeworld.msg import AgentCommand
from ledger import notes, promise, table
from web_client import WebSocket, address_of, get

TITLE = "Races"
CLIENTS = 8  # of which one looks at the page
# A world is made behind the simulation, which eight clients drive as fast as it goes, and all of it
# some ten times slower than it is without ThreadSanitizer.
ANSWER_S = 3.0 * DEADLINE_S
SUPPRESSIONS = pathlib.Path(__file__).resolve().parent / "tsan.supp"
REPORT = re.compile(r"^WARNING: ThreadSanitizer: .*?^SUMMARY: ThreadSanitizer: ([^\n]*)",
                    re.MULTILINE | re.DOTALL)
SPECIES = ("goblin", "sheep", "eagle", "wheeled robot", "robotic dog")
TOPICS = {"robot/scan": LaserScan, "robot/points": PointCloud2, "robot/imu": Imu,
          "agents/markers": MarkerArray, "world/markers": MarkerArray}


class Client:
    """Calls whatever there is, in random order. Statuses are not looked at, for others may be in
    the way; an answer has to come."""

    def __init__(self, ground, random, number):
        self.ground, self.random, self.number = ground, random, number
        self.commands = rospy.Publisher("/robot/cmd_vel", Twist, queue_size=1)
        self.strikes = rospy.Publisher("/robot/strike", Empty, queue_size=1)

    def name(self, kind):
        return f"{kind}_{self.random.randrange(4)}"

    def point(self):
        return Point(x=self.random.uniform(-30.0, 30.0), y=self.random.uniform(-30.0, 30.0))

    def listen(self):
        topic, kind = self.random.choice(sorted(TOPICS.items(), key=lambda each: each[0]))
        listener = rospy.Subscriber("/" + topic, kind, lambda _: None, queue_size=1)
        threading.Event().wait(self.random.uniform(0.0, 1.0))
        listener.unregister()

    def drive(self):
        command = Twist()
        command.linear.x, command.angular.z = self.random.uniform(-1, 1), self.random.uniform(-1, 1)
        self.commands.publish(command)
        self.strikes.publish(Empty())

    def requests(self):
        """What a client may do: weight, call."""
        call = functools.partial(self.ground.call, deadline_s=ANSWER_S)
        draw, world = self.random, {**SMALL_WORLD, "size": 48.0}
        factors = (0.0, 1.0, 20.0)
        return [
            (1, lambda: call("generate_world", seed=draw.randrange(1, 9), **world)),
            (2, lambda: call("save_world", name=self.name("w"))),
            (1, lambda: call("load_world", name=self.name("w"))),
            (2, lambda: call("list_worlds")), (4, lambda: call("get_world")),
            (1, lambda: call("get_world_bundle", files=True)),
            (6, lambda: call("spawn_agent", name=self.name("a"), place="anywhere",
                             species=draw.choice(SPECIES))),
            (4, lambda: call("remove_agent", name=self.name("a"))),
            (4, lambda: call("spawn_element", name=self.name("e"), position=self.point(),
                             kind=draw.choice(["crate", "gate", "bridge", "ball"]),
                             size=Vector3(1, 1, 1))),
            (3, lambda: call("remove_element", name=self.name("e"))),
            (2, lambda: call("open_gate", name=self.name("e"), opening=0.5)),
            (2, lambda: call("set_policy", team=2, policy="ambusher")),
            (2, lambda: call("set_weather", weather=draw.choice(["rain", "snow", "sunny"]))),
            (2, lambda: call("save_snapshot", name=self.name("s"))),
            (2, lambda: call("restore_snapshot", name=self.name("s"))),
            (1, lambda: call("reset_world", seed=draw.randrange(1, 9))),
            (3, lambda: call("set_real_time_factor", factor=draw.choice(factors))),
            (2, lambda: call("pause")), (3, lambda: call("unpause")),
            (3, lambda: call("step", steps=20, hash=True)),
            (2, lambda: call("lockstep", steps=10, scan=True,
                             commands=[AgentCommand(agent="robot")])),
            (3, lambda: call("query_terrain", points=[self.point()])),
            (2, lambda: call("query_things", names=[])),
            (2, lambda: call("start_episode", name=self.name("e"), keep_state=True)),
            (2, lambda: call("stop_episode")), (2, lambda: call("list_episodes")),
            (5, self.drive), (4, self.listen)]

    def work(self, end, counts):
        weights, calls = zip(*self.requests())
        while time.monotonic() < end:
            self.random.choices(calls, weights)[0]()
            counts[self.number] += 1


class Looker:
    """A client that looks at the page: its files, and a WebSocket that asks and strikes."""

    def __init__(self, ground, address):
        self.ground, self.address = ground, address

    def work(self, end, counts):
        for number in itertools.count():
            if time.monotonic() > end:
                return
            with WebSocket(*self.address) as socket:
                socket.ask(type="list_worlds")
                socket.send(type="strike", robot="robot")
                get(*self.address, "/api/world.json")
            counts[CLIENTS - 1] = 4 * (number + 1)


def reports(folder):
    """Where each data race was, by what ThreadSanitizer wrote: summary -> one report."""
    found = {}
    for path in sorted(folder.glob("tsan.*")):
        for match in REPORT.finditer(path.read_text(errors="replace")):
            found.setdefault(match.group(1).strip(), match.group(0))
    return found


def calls_of(ground, end, random, address):
    """All clients until `end`; how many calls they made, and why clients ended before."""
    counts, failures = [0] * CLIENTS, []
    clients = [Client(ground, type(random)(random.random()), number)
               for number in range(CLIENTS - 1)] + [Looker(ground, address)]

    def work(client):
        try:
            client.work(end, counts)
        except Exception as error:  # pylint: disable=broad-except
            failures.append(f"{type(client).__name__}: {error}")

    threads = [threading.Thread(target=work, args=[client]) for client in clients]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sum(counts), failures


def round_of(ground, end, random, ledger):
    folder = ground.new_folder("races")
    watched = {"TSAN_OPTIONS": f"suppressions={SUPPRESSIONS} log_path={folder}/tsan exitcode=0 "
                               "second_deadlock_stack=1 history_size=4 "
                               "ignore_noninstrumented_modules=1"}
    began = time.monotonic()
    with ground.world_server(watched, worlds_directory=folder / "worlds") as server, \
            ground.recorder(folder / "episodes", watched) as recorder, \
            ground.node("world_viewer", watched, port=0) as viewer:
        address = address_of(rospy.wait_for_message("/viewer/address", String, DEADLINE_S).data)
        ground.must("generate_world", seed=1, **SMALL_WORLD)
        count, failures = calls_of(ground, end, random, address)
        ended = {name: (program.stop(), program.last_words())
                 for name, program in (("viewer", viewer), ("recorder", recorder),
                                       ("server", server))}
    found = reports(folder)
    ledger.note("calls", count=count, minutes=round((time.monotonic() - began) / 60.0, 1),
                reports=sorted(found))
    for report in found.values():
        print(report, flush=True)
    promise(not failures, f"clients ended: {failures}")
    promise(not any(status for status, _ in ended.values()), f"nodes ended so: {ended}")
    promise(not found, f"{len(found)} data races: {sorted(found)}")
    ground.remove(folder)


def run(ground, end, random, ledger):
    ledger.watch("mixed calls of eight clients", lambda: round_of(ground, end, random, ledger))


def tables(events):
    return table(["minutes", "calls of eight clients", "data races"],
                 [[note["minutes"], note["count"], "; ".join(note["reports"]) or "none"]
                  for note in notes(events, "calls")])
