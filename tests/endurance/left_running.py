"""Left running: do the programs stay as they are? Cycles of all that changes a world, worlds of
many sizes, and one with a hundred agents that is sensed, recorded, looked at and driven in."""

import contextlib
import itertools
import os
import shutil
import statistics
import threading
import time

import rospy
from geometry_msgs.msg import Point, PoseStamped
from sensor_msgs.msg import Imu, LaserScan, NavSatFix, PointCloud2
from std_msgs.msg import String

from ground import DEADLINE_S, SMALL_WORLD
from ledger import notes, promise, rounds_table, table
from web_client import WebSocket, address_of

TITLE = "Left running"
MOST_GROWTH = 0.02  # of resident memory over the last half
LEAST_SAMPLES = 40  # from here on growth is judged; before, the allocator still takes its share
MOST_GROWTH_COUNT = 4  # of descriptors and threads: connections that are just ending
KINDS = ("memory_mb", "descriptors", "threads")
SIZES_M = (32.0, 192.0, 64.0, 256.0, 48.0, 96.0, 128.0)
CROWD = 100  # agents
STEP_S = 0.05  # of the crowd's world
LEAST_STEPS = 500  # of it: what a round takes at least
RESET_AFTER = 20  # episodes: until then the server keeps every call, to be told where one begins


def usage(pid):
    """Resident memory [MB], open descriptors, threads."""
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        resident = next(line for line in file if line.startswith("VmRSS"))
    return (int(resident.split()[1]) / 1000.0, len(os.listdir(f"/proc/{pid}/fd")),
            len(os.listdir(f"/proc/{pid}/task")))


class Samples:
    """What programs use, again and again, and how long a step takes."""

    def __init__(self, programs):
        self.programs = programs  # name -> Program
        self.samples = {name: [] for name in programs}
        self.step_ms = []

    def take(self):
        for name, program in self.programs.items():
            promise(program.runs(), f"{name} ended: {program.last_words()}")
            self.samples[name].append(usage(program.pid))

    def note(self, ledger, phase, how_far):
        """The last sample, for who breaks the run off."""
        ledger.note("sample", phase=phase, how_far=how_far,
                    **{name: some[-1] for name, some in self.samples.items()})

    def growth(self, name, kind):
        """Third and last quarter's median of what a program uses."""
        values = [sample[KINDS.index(kind)] for sample in self.samples[name]]
        quarter = max(1, len(values) // 4)
        return statistics.median(values[-2 * quarter:-quarter] or values), \
            statistics.median(values[-quarter:])

    def judge(self, ledger, phase, how_long):
        """A note a program; growth is a broken promise once there are samples enough."""
        quarter = max(1, len(self.step_ms) // 4)
        steps = [statistics.median(self.step_ms[:quarter]),
                 statistics.median(self.step_ms[-quarter:])]
        for name in self.programs:
            ledger.note("phase", phase=phase, how_long=how_long, program=name, step_ms=steps,
                        **{kind: self.growth(name, kind) for kind in KINDS})
        if len(self.step_ms) < LEAST_SAMPLES:
            return
        for name in self.programs:
            before, after = self.growth(name, "memory_mb")
            promise(after < before * (1.0 + MOST_GROWTH),
                    f"{name} grew from {before:.1f} to {after:.1f} MB in {phase}")
            for kind in KINDS[1:]:
                before, after = self.growth(name, kind)
                promise(after <= before + MOST_GROWTH_COUNT,
                        f"{name} went from {before:.0f} to {after:.0f} {kind} in {phase}")


class Cycles(Samples):
    """Cycles of all that changes a world, on one server."""

    def __init__(self, ground, folder, programs):
        super().__init__(programs)
        self.ground, self.folder = ground, folder
        self.count = 0

    def cycle(self):
        must, number = self.ground.must, self.count
        must("generate_world", seed=number % 7 + 1, **SMALL_WORLD)
        must("pause")
        for place, species in (("upper left", "goblin"), ("center", "sheep"), ("lower", "horse")):
            must("spawn_agent", name=f"a_{species}", species=species, place=place)
        self.step(100)
        must("save_snapshot", name="here")
        must("remove_agent", name="a_sheep")
        self.step(20)
        must("restore_snapshot", name="here")
        must("reset_world", seed=number + 1)
        must("save_world", name="kept")
        must("load_world", name="kept")
        shutil.rmtree(self.folder / "worlds" / "kept")
        must("unpause")
        self.count += 1
        self.take()

    def step(self, steps):
        began = time.monotonic()
        self.ground.must("step", steps=steps)
        self.step_ms.append(1000.0 * (time.monotonic() - began) / steps)


def alone(ground, end, ledger):
    folder = ground.new_folder("alone")
    with ground.world_server(worlds_directory=folder / "worlds") as server:
        cycles = Cycles(ground, folder, {"world_server": server})
        while cycles.count == 0 or time.monotonic() < end:
            ledger.watch("cycles, alone", cycles.cycle)
        cycles.judge(ledger, "alone", f"{cycles.count} cycles")
        promise(server.stop() == 0, f"world_server ended badly: {server.last_words()}")
    ground.remove(folder)


def of_sizes(ground, end, ledger):
    """Worlds of different sizes, one after the other; measured after the last of each row."""
    with ground.world_server() as server:
        samples, count = Samples({"world_server": server}), 0
        while not samples.step_ms or time.monotonic() < end:
            for size_m in SIZES_M:
                ground.must("generate_world", seed=count % 28 + 1,
                            **{**SMALL_WORLD, "size": size_m})
                count += 1
            ground.must("pause")
            began = time.monotonic()
            ground.must("step", steps=50)
            samples.step_ms.append(20.0 * (time.monotonic() - began))
            ground.must("unpause")
            samples.take()
            samples.note(ledger, "worlds", count)
        samples.judge(ledger, "worlds of 32 to 256 m", f"{count} worlds")


@contextlib.contextmanager
def looked_at(viewer):
    """A client of the page that reads all that it is sent."""
    promise(viewer.runs(), f"world_viewer ended: {viewer.last_words()}")
    host, port = address_of(rospy.wait_for_message("/viewer/address", String, DEADLINE_S).data)
    with WebSocket(host, port) as client:
        threading.Thread(target=client.read_all, daemon=True).start()
        yield


def watched(ground, end, ledger):
    """Cycles with an episode of each, and a client that looks."""
    folder = ground.new_folder("watched")
    with ground.world_server(worlds_directory=folder / "worlds") as server, \
            ground.recorder(folder / "episodes") as recorder, \
            ground.node("world_viewer", port=0) as viewer, looked_at(viewer):
        cycles = Cycles(ground, folder, {"world_server": server, "episode_recorder": recorder,
                                         "world_viewer": viewer})
        while cycles.count == 0 or time.monotonic() < end:
            ledger.watch("cycles, recorded and looked at", lambda: recorded(ground, folder, cycles))
        cycles.judge(ledger, "recorded and looked at", f"{cycles.count} cycles")
    ground.remove(folder)


def recorded(ground, folder, cycles):
    """A cycle, and after it an episode, whose file is removed."""
    cycles.cycle()
    ground.must("start_episode", name="kept")
    ground.must("spawn_agent", species="goblin", position=Point(x=5.0))
    ground.must("stop_episode")
    shutil.rmtree(folder / "episodes")
    (folder / "episodes").mkdir()


class Crowd(Samples):
    """A world with a hundred agents as fast as it goes, and all that may look at it."""

    def __init__(self, ground, folder, programs):
        super().__init__(programs)
        self.ground, self.folder = ground, folder
        self.goals = rospy.Publisher("/robot/move_base_simple/goal", PoseStamped, queue_size=1)
        self.places = itertools.cycle([(30.0, 0.0), (0.0, 30.0), (-30.0, 0.0), (0.0, -30.0)])
        self.heard = {}
        self.listeners = [
            rospy.Subscriber(f"/robot/{topic}", kind, self.hear, callback_args=topic, queue_size=1)
            for topic, kind in (("scan", LaserScan), ("points", PointCloud2), ("imu", Imu),
                                ("fix", NavSatFix))]
        self.looks, self.lived = 0, 0  # lived: steps

    def close(self):
        for listener in (*self.listeners, self.goals):
            listener.unregister()

    def hear(self, _, topic):
        self.heard[topic] = self.heard.get(topic, 0) + 1

    def steps(self):
        return self.ground.must("get_world").step

    def hours(self):
        return self.lived * STEP_S / 3600.0

    def gather(self):
        """All agents but the world's own, which a reset has removed."""
        kinds = itertools.cycle(["sheep", "horse", "wheeled robot", "robotic dog", "goblin",
                                 "ancient warrior", "humanoid robot", "aerial robot", "eagle"])
        for number in range(CROWD):
            self.ground.must("spawn_agent", name=f"one_{number}", species=next(kinds),
                             place="anywhere", team=-1)

    def look(self, pause_s):
        """Some time of its life, with another goal and another episode; then a sample."""
        begins = self.looks % RESET_AFTER == 0
        self.looks += 1
        self.ground.must("start_episode", name="kept", keep_state=not begins)
        if begins:
            self.gather()
        before, began = self.steps(), time.monotonic()
        goal = PoseStamped()
        goal.header.frame_id = "map"
        goal.pose.position.x, goal.pose.position.y = next(self.places)
        goal.pose.orientation.w = 1.0
        self.goals.publish(goal)
        threading.Event().wait(pause_s)
        steps, now = self.steps(), time.monotonic()
        while steps - before < LEAST_STEPS:
            promise(now - began < DEADLINE_S, f"{steps - before} steps in {now - began:.0f} s")
            threading.Event().wait(1.0)
            steps, now = self.steps(), time.monotonic()
        self.ground.must("stop_episode")
        shutil.rmtree(self.folder / "episodes")
        (self.folder / "episodes").mkdir()
        self.step_ms.append(1000.0 * (now - began) / (steps - before))
        self.lived += steps - before
        self.take()


def crowd(ground, end, ledger):
    folder = ground.new_folder("crowd")
    with ground.world_server(worlds_directory=folder / "worlds", real_time_factor=0,
                             step=STEP_S, sensor_suite="survey") as server, \
            ground.recorder(folder / "episodes") as recorder, \
            ground.node("world_viewer", port=0) as viewer, \
            ground.node("navigator") as navigator, looked_at(viewer):
        ground.must("generate_world", seed=3, **{**SMALL_WORLD, "size": 128.0})
        crowd_of = Crowd(ground, folder, {"world_server": server, "episode_recorder": recorder,
                                          "world_viewer": viewer, "navigator": navigator})
        while not crowd_of.step_ms or time.monotonic() < end:
            if not ledger.watch("looks at a crowd", lambda: crowd_of.look(5.0)):
                break
            crowd_of.note(ledger, "crowd", crowd_of.hours())
        crowd_of.close()
        crowd_of.judge(ledger, f"{CROWD} agents at factor 0",
                       f"{crowd_of.hours():.2f} h of world time")
        promise(len(crowd_of.heard) == 4, f"not all sensors were heard: {crowd_of.heard}")
    ground.remove(folder)


def run(ground, end, _random, ledger):
    """Each phase for its share of the time until `end` [s, monotonic], at least a round of each."""
    phases = {"alone": (alone, 0.3), "sizes": (of_sizes, 0.2), "watched": (watched, 0.2),
              "crowd": (crowd, 0.3)}
    phases = {name: each for name, each in phases.items() if name.startswith(ground.wanted)}
    began, done, shares = time.monotonic(), 0.0, sum(share for _, share in phases.values())
    for name, (phase, share) in phases.items():
        done += share / shares
        until = began + done * (end - began)
        ledger.watch(f"phase {name}", lambda phase=phase, until=until: phase(ground, until, ledger))


def tables(events):
    rows = []
    for note in notes(events, "phase"):
        cells = [f"{before:.0f} -> {after:.0f}" if kind != "memory_mb" else
                 f"{before:.1f} -> {after:.1f} ({100 * (after / before - 1):+.1f} %)"
                 for kind in KINDS for before, after in [note[kind]]]
        steps = f"{note['step_ms'][0]:.2f} -> {note['step_ms'][1]:.2f}"
        rows.append([note["phase"], note["how_long"], note["program"], *cells,
                     steps if note["program"] == "world_server" else ""])
    return rounds_table(events) + table(
        ["phase", "how long", "program", "memory [MB], third -> last quarter", "descriptors",
         "threads", "step [ms], first -> last quarter"], rows)
