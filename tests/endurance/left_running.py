"""Left running: one server through cycles of all that changes a world; does it stay as it is?"""

import os
import shutil
import statistics
import threading
import time

import rospy
from geometry_msgs.msg import Point
from std_msgs.msg import String

from ground import DEADLINE_S, SMALL_WORLD
from ledger import Ledger, promise
from web_client import WebSocket, address_of

MOST_GROWTH = 0.02  # of resident memory over the last half
LEAST_CYCLES = 40  # from here on growth is judged; before, the allocator still takes its share
MOST_GROWTH_COUNT = 4  # of descriptors and threads: connections that are just ending
KINDS = ("memory_mb", "descriptors", "threads")


def usage(pid):
    """Resident memory [MB], open descriptors, threads."""
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        resident = next(line for line in file if line.startswith("VmRSS"))
    return (int(resident.split()[1]) / 1000.0, len(os.listdir(f"/proc/{pid}/fd")),
            len(os.listdir(f"/proc/{pid}/task")))


class Cycles:
    """The cycles on one server, and what was measured after each."""

    def __init__(self, ground, folder, programs):
        self.ground, self.folder = ground, folder
        self.programs = programs  # name -> Program
        self.samples = {name: [] for name in programs}
        self.step_ms = []
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
        for name, program in self.programs.items():
            promise(program.runs(), f"{name} ended: {program.last_words()}")
            self.samples[name].append(usage(program.pid))

    def step(self, steps):
        began = time.monotonic()
        self.ground.must("step", steps=steps)
        self.step_ms.append(1000.0 * (time.monotonic() - began) / steps)

    def growth(self, name, kind):
        """Third and last quarter's median of what a program uses."""
        values = [sample[KINDS.index(kind)] for sample in self.samples[name]]
        quarter = max(1, len(values) // 4)
        return statistics.median(values[-2 * quarter:-quarter] or values), \
            statistics.median(values[-quarter:])

    def judge(self, ledger, phase):
        """A row a program; growth is a broken promise once there are cycles enough."""
        quarter = max(1, len(self.step_ms) // 4)
        steps = [statistics.median(self.step_ms[:quarter]),
                 statistics.median(self.step_ms[-quarter:])]
        for name in self.programs:
            cells = []
            for kind in KINDS:
                before, after = self.growth(name, kind)
                cells.append(f"{before:.0f} -> {after:.0f}" if kind != "memory_mb" else
                             f"{before:.1f} -> {after:.1f} ({100 * (after / before - 1):+.1f} %)")
            ledger.row(phase, self.count, name, *cells,
                       f"{steps[0]:.2f} -> {steps[1]:.2f}" if name == "world_server" else "")
        if self.count < LEAST_CYCLES:
            return
        for name in self.programs:
            before, after = self.growth(name, "memory_mb")
            promise(after < before * (1.0 + MOST_GROWTH),
                    f"{name} grew from {before:.1f} to {after:.1f} MB in {phase}")
            for kind in KINDS[1:]:
                before, after = self.growth(name, kind)
                promise(after <= before + MOST_GROWTH_COUNT,
                        f"{name} went from {before:.0f} to {after:.0f} {kind} in {phase}")


def alone(ground, end, ledger):
    folder = ground.new_folder("alone")
    with ground.world_server(worlds_directory=folder / "worlds") as server:
        cycles = Cycles(ground, folder, {"world_server": server})
        while cycles.count == 0 or time.monotonic() < end:
            ledger.watch("cycles, alone", cycles.cycle)
        ledger.watch("judgements", lambda: cycles.judge(ledger, "alone"))
        promise(server.stop() == 0, f"world_server ended badly: {server.last_words()}")
    ground.remove(folder)


def watched(ground, end, ledger):
    """With an episode of every cycle, and a client that looks."""
    folder = ground.new_folder("watched")
    with ground.world_server(worlds_directory=folder / "worlds") as server, \
            ground.recorder(folder / "episodes") as recorder, \
            ground.node("world_viewer", port=0) as viewer:
        host, port = address_of(rospy.wait_for_message("/viewer/address", String, DEADLINE_S).data)
        with WebSocket(host, port) as client:
            reader = threading.Thread(target=client.read_all, daemon=True)
            reader.start()
            cycles = Cycles(ground, folder, {"world_server": server, "episode_recorder": recorder,
                                             "world_viewer": viewer})
            while cycles.count == 0 or time.monotonic() < end:
                ledger.watch("cycles, recorded and looked at",
                             lambda: recorded(ground, folder, cycles))
            ledger.watch("judgements", lambda: cycles.judge(ledger, "recorded and looked at"))
    ground.remove(folder)


def recorded(ground, folder, cycles):
    """A cycle, and after it an episode, whose file is removed."""
    cycles.cycle()
    ground.must("start_episode", name="kept")
    ground.must("spawn_agent", species="goblin", position=Point(x=5.0))
    ground.must("stop_episode")
    shutil.rmtree(folder / "episodes")
    (folder / "episodes").mkdir()


def run(ground, end, _random):
    """Cycles until `end` [s, monotonic], at least one alone and one watched; the ledger."""
    ledger = Ledger("Left running")
    ledger.table("phase", "cycles", "program", "memory [MB], third -> last quarter",
                 "descriptors", "threads", "step [ms], first -> last quarter")
    middle = time.monotonic() + 0.6 * (end - time.monotonic())
    ledger.watch("servers", lambda: alone(ground, middle, ledger))
    ledger.watch("servers", lambda: watched(ground, end, ledger))
    return ledger
