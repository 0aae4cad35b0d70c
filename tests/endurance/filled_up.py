"""Filled up: what the programs say and leave where the system fails under them."""

import http.client
import time
import urllib.parse

import rospy
from std_msgs.msg import String

from cut_off import hidden_in
from faults import Place, all_faults
from ground import DEADLINE_S, SMALL_WORLD, told, wait_until
from ledger import BrokenPromise, Ledger, promise

CAMPAIGN = """name: tiny
worlds:
  - {name: lake, layout: A lake in the center., environment: Two sheep graze., seeds: [1],
     size_m: 64, resolution_m: 1}
robots: [{stack: way}]
tasks: {count: 1, length_m: [10, 30]}
trials: [{name: calm, seeds: [1]}]
"""


class Nodes:
    """world_server, episode_recorder and world_viewer that write to a place. A context."""

    def __init__(self, ground, place):
        self.ground, self.place = ground, place
        preload = {**place.environment, "LD_PRELOAD": str(ground.libraries["faults"])}
        for name in ("worlds", "episodes"):
            (place.folder / name).mkdir()
        self.server = ground.world_server(preload, worlds_directory=place.folder / "worlds")
        self.recorder = ground.recorder(place.folder / "episodes", preload)
        self.viewer = ground.node("world_viewer", preload, port=0)
        self.programs = [self.server, self.recorder, self.viewer]
        self._count = 0
        ground.must("generate_world", seed=1, **SMALL_WORLD)
        self.address = self._viewer_address()
        wait_until(lambda: self.view() == "done", "the page's world is there")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for program in self.programs:
            program.__exit__()

    @staticmethod
    def _viewer_address():
        url = rospy.wait_for_message("/viewer/address", String, timeout=DEADLINE_S).data
        parts = urllib.parse.urlparse(url)
        return parts.hostname, parts.port

    def save_world(self):
        self._count += 1
        return told(self.ground.call("save_world", name=f"w{self._count}"))

    def generate_world(self):
        self._count += 1
        return told(self.ground.call("generate_world", seed=self._count, **SMALL_WORLD))

    def start_episode(self):
        self._count += 1
        answer = told(self.ground.call("start_episode", name=f"e{self._count}"))
        if answer != "done":
            return answer
        ended = self.ground.call("stop_episode")
        return told(ended) if told(ended) == "done" else f"started; at its end {told(ended)}"

    def view(self):
        """Loads what a page loads first."""
        def get():
            connection = http.client.HTTPConnection(*self.address, timeout=10)
            try:
                connection.request("GET", "/api/world.json")
                return connection.getresponse().status
            except OSError as error:
                return type(error).__name__
            finally:
                connection.close()

        end = time.monotonic() + 20
        status = get()
        while status == 404 and time.monotonic() < end:  # it is preparing another world
            status = get()
        return "done" if status == 200 else f"{status}"

    def operations(self):
        return {"save_world": (self.save_world, self.server),
                "generate_world": (self.generate_world, self.server),
                "start_episode": (self.start_episode, self.recorder),
                "viewer": (self.view, self.viewer)}

    def check_rest(self):
        """Nothing half is left: every world loads, every whole episode is listed."""
        worlds = self.place.folder / "worlds"
        for world in self.ground.must("list_worlds").worlds:
            self.ground.must("load_world", name=world.name)
        promise(not hidden_in(worlds), f"half worlds are left: {hidden_in(worlds)}")


def node_rows(ground, fault, place, nodes, ledger):
    """Each service under the fault, and again without it."""
    said = {}
    for name, (call, program) in nodes.operations().items():
        try:
            said[name] = call()
        except BrokenPromise as broken:
            said[name] = f"{broken}"
        if not program.runs():
            said[name] += f"; the node has ended: {program.last_words()}"
    fault.lift(place, nodes.programs)
    if all(program.runs() for program in nodes.programs):
        works_again(nodes)
        nodes.check_rest()
        left = "nothing half; all works again"
    else:
        left = "a node has ended"
    for name, text in said.items():
        ledger.row(fault.name, name, text[:160], left)
    promise(left != "a node has ended" or fault.may_end_nodes,
            f"under {fault.name} a node ended: {said}")


def works_again(nodes):
    """Every operation does what it is asked, within the time that there is for it."""
    for name, (call, program) in nodes.operations().items():
        end = time.monotonic() + DEADLINE_S
        said = call()
        while said != "done":
            promise(time.monotonic() < end and program.runs(),
                    f"{name} does not work again: {said} {program.last_words()}")
            said = call()


def commands(folder):
    """The command line's operations: what they make, and how."""
    return {"campaign": (folder / "campaign", ("campaign", folder.parent / "tiny.yaml", "--out",
                                               folder / "campaign", "--workers", 1, "--resume")),
            "dataset": (folder / "set", ("dataset", "--generate", 6, "--threads", 1, "--out",
                                         folder / "set", "--resume")),
            "export": (folder / "maps", ("export", folder.parent / "world", "--to", "map",
                                         "--out", folder / "maps"))}


def command_rows(ground, fault, place, ledger):
    """Each command under the fault, and again without it."""
    fault.put(place, [])
    preload = {**place.environment, "LD_PRELOAD": str(ground.libraries["faults"])}
    said = {}
    for name, (_, command) in commands(place.folder).items():
        with ground.command(*command, environment=preload, limits=fault.limits) as program:
            status = program.wait()
            said[name] = "done" if status == 0 else f"exit {status}: {program.last_words()}"
            promise(status >= 0 or fault.may_end_nodes,
                    f"{name} under {fault.name} was ended by signal {-status}: "
                    f"{program.last_words()}")
            promise(status == 0 or program.last_words(), f"{name} under {fault.name} says nothing")
    fault.lift(place, [])
    for name, (target, command) in commands(place.folder).items():
        if not (name == "export" and target.exists()):
            ground.must_run(*command)
        promise(target.is_dir(), f"{name} is not there after {fault.name}")
        ledger.row(fault.name, name, said[name][:160], "nothing half; all works again")
    promise(not hidden_in(place.folder), f"half folders are left: {hidden_in(place.folder)}")


def fault_round(ground, fault, ledger, part):
    folder = ground.new_folder("fault")
    (folder / "tiny.yaml").write_text(CAMPAIGN, encoding="utf-8")
    with Place(folder) as place:
        if fault.needs_mount and not place.is_mounted:
            ledger.row(fault.name, "all", "not tried: nothing may be mounted here", "")
            return
        if part == "nodes":
            with Nodes(ground, place) as nodes:
                fault.put(place, nodes.programs)
                node_rows(ground, fault, place, nodes, ledger)
        else:
            ground.must_run("generate", "--layout", "A lake.", "--size", 64, "--resolution", 1,
                            "--seed", 3, "--out", folder / "world")
            command_rows(ground, fault, place, ledger)
    ground.remove(folder)


def master_round(ground, ledger):
    """The master ends and comes back, as another process that knows nobody."""
    folder = ground.new_folder("master")
    with Place(folder) as place, Nodes(ground, place) as nodes:
        ground.stop_master()
        said = {name: call() for name, (call, _) in nodes.operations().items() if name == "viewer"}
        ground.start_master()
        works_again(nodes)
        nodes.check_rest()
        ledger.row("master gone", "viewer", said["viewer"], "")
        ledger.row("master back", "all", "nodes are known to it again", "all works again")
    ground.remove(folder)


def run(ground, end, random):
    """Faults in random order until `end` [s, monotonic], at least one; the ledger."""
    ledger = Ledger("Filled up")
    ledger.table("fault", "operation", "what is told", "what is left")
    rounds = [(f"{fault.name}, {part}",
               lambda fault=fault, part=part: fault_round(ground, fault, ledger, part))
              for fault in all_faults() for part in ("nodes", "commands")
              if part == "nodes" or fault.for_commands]
    rounds.append(("master gone and back", lambda: master_round(ground, ledger)))
    random.shuffle(rounds)
    for name, call in rounds:
        ledger.watch(name, call)
        if time.monotonic() > end:
            break
    return ledger
