"""Filled up: what the programs say and leave where the system fails under them."""

import http.client
import time
import urllib.parse

import rospy
from std_msgs.msg import String

from cut_off import hidden_in
from faults import Fault, Place, all_faults
from ground import DEADLINE_S, SMALL_WORLD, told, wait_until
from ledger import BrokenPromise, notes, promise, rounds_table, table

TITLE = "Filled up"
PARTS = ("nodes", "commands")
MODEL_SERVER = "http://model.latticeworld.invalid:8080/v1"  # nobody answers by that name
ASKS_MODEL = ("looking up names hangs", "no more threads", "no more descriptors")
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
        self._count = 0
        for name in ("worlds", "episodes"):
            (place.folder / name).mkdir()
        self.start()

    def start(self):
        preload = {**self.place.environment, "LD_PRELOAD": str(self.ground.libraries["faults"])}
        self.server = self.ground.world_server(
            preload, worlds_directory=self.place.folder / "worlds", remote_url=MODEL_SERVER,
            generator="grounded", remote_connect_timeout=2, remote_max_retries=1)
        self.recorder = self.ground.recorder(self.place.folder / "episodes", preload)
        self.viewer = self.ground.node("world_viewer", preload, port=0)
        self.programs = [self.server, self.recorder, self.viewer]
        self.ground.must("generate_world", seed=1, **SMALL_WORLD)
        self.address = self._viewer_address()
        wait_until(lambda: self.view() == "done", "the page's world is there")

    def stop(self):
        for program in self.programs:
            program.__exit__()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

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

    def ask_model(self):
        """A model server is to read; there is none, so that this ends with an error at best."""
        answer = self.ground.call("generate_world", seed=1, reader="remote", **SMALL_WORLD)
        return "answered: " + told(answer) if answer else told(answer)

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

    def words(self, operations):
        """Operation -> what it says."""
        said = {}
        for name, (call, program) in operations.items():
            try:
                said[name] = call()
            except BrokenPromise as broken:
                said[name] = f"{broken}"
            if not program.runs():
                said[name] += f"; the node has ended: {program.last_words()}"
        return said

    def restart(self):
        """Nodes may have ended: all start again on what is left."""
        self.stop()
        self.start()

    def check_rest(self):
        """Nothing half is left: every world loads, every whole episode is listed."""
        worlds = self.place.folder / "worlds"
        for world in self.ground.must("list_worlds").worlds:
            self.ground.must("load_world", name=world.name)
        promise(not hidden_in(worlds), f"half worlds are left: {hidden_in(worlds)}")


def cell(ledger, place, fault, operation, words, left):
    """A cell of the table; the place's folder is left out of the words."""
    told_of = words.replace(str(place.folder), "...")
    ledger.note("cell", fault=fault, operation=operation, told=told_of, left=left)


def node_rows(fault, place, nodes, ledger):
    """Each service under the fault, and again without it."""
    operations = nodes.operations()
    if fault.name in ASKS_MODEL:
        operations["generate_world, reader remote"] = (nodes.ask_model, nodes.server)
    said = nodes.words(operations)
    fault.lift(place, nodes.programs)
    ended = not all(program.runs() for program in nodes.programs)
    if ended and fault.may_end_nodes:
        nodes.restart()
    if not ended or fault.may_end_nodes:
        works_again(nodes)
        nodes.check_rest()
    left = "nothing half; all works again" + (", after a new start" if ended else "")
    for name, text in said.items():
        cell(ledger, place, fault.name, name, text, left if not ended or fault.may_end_nodes else
             "a node has ended")
    promise(not ended or fault.may_end_nodes, f"under {fault.name} a node ended: {said}")


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
    results = folder / "results"
    return {"campaign": (results / "campaign", ("campaign", folder.parent / "tiny.yaml", "--out",
                                                results / "campaign", "--workers", 1, "--resume")),
            "dataset": (results / "set", ("dataset", "--generate", 6, "--threads", 1, "--out",
                                          results / "set", "--resume")),
            "export": (results / "maps", ("export", folder.parent / "world", "--to", "map",
                                          "--out", results / "maps"))}


def command_rows(ground, fault, place, ledger):
    """Each command under the fault, and again without it."""
    (place.folder / "results").mkdir()
    fault.put(place, [])
    preload = {**place.environment, "LD_PRELOAD": str(ground.libraries["faults"])}
    said = {}
    for name, (_, command) in commands(place.folder).items():
        with ground.command(*command, environment=preload, limits=fault.limits) as program:
            fault.upon(program)
            status = program.wait()
            said[name] = "done" if status == 0 else f"exit {status}: {program.last_words()}"
            promise(status >= 0 or fault.may_end_nodes,
                    f"{name} under {fault.name} was ended by signal {-status}: "
                    f"{program.last_words()}")
            promise(status <= 0 or program.last_words(), f"{name} under {fault.name} says nothing")
    fault.lift(place, [])
    for name, (target, command) in commands(place.folder).items():
        if not (name == "export" and target.exists()):
            ground.must_run(*command)
        promise(target.is_dir(), f"{name} is not there after {fault.name}")
        cell(ledger, place, fault.name, name, said[name], "nothing half; all works again")
    left = hidden_in(place.folder / "results")
    promise(not left, f"half folders are left: {left}")


def fault_round(ground, fault, ledger, part):
    folder = ground.new_folder("fault")
    (folder / "tiny.yaml").write_text(CAMPAIGN, encoding="utf-8")
    with Place(folder) as place:
        if fault.missing(place):
            cell(ledger, place, fault.name, part, f"not tried: {fault.missing(place)}", "")
            return
        if part == "nodes":
            with Nodes(ground, place) as nodes:
                fault.put(place, nodes.programs)
                node_rows(fault, place, nodes, ledger)
        else:
            ground.must_run("generate", "--layout", "A lake.", "--size", 64, "--resolution", 1,
                            "--seed", 3, "--out", folder / "world")
            command_rows(ground, fault, place, ledger)
    ground.remove(folder)


class Master:
    """The ROS master ends and comes back, as another process that knows nobody."""

    name = "master gone, and back"

    def __init__(self, ground):
        self.ground = ground

    def round(self, ledger, part):
        folder = self.ground.new_folder("master")
        (folder / "tiny.yaml").write_text(CAMPAIGN, encoding="utf-8")
        with Place(folder) as place:
            if part == "nodes":
                with Nodes(self.ground, place) as nodes:
                    self.nodes(nodes, ledger)
            else:
                self.commands(folder, place, ledger)
        self.ground.remove(folder)

    def nodes(self, nodes, ledger):
        """Services are found by the master: who has not asked before learns nothing of it."""
        self.ground.stop_master()
        said = nodes.words(nodes.operations())
        self.ground.start_master()
        works_again(nodes)
        nodes.check_rest()
        for name, words in said.items():
            cell(ledger, nodes.place, self.name, name, words,
                 "nodes are known again; all works again")

    def commands(self, folder, place, ledger):
        self.ground.must_run("generate", "--layout", "A lake.", "--size", 64, "--resolution", 1,
                             "--seed", 3, "--out", folder / "world")
        self.ground.stop_master()
        try:
            command_rows(self.ground, Fault(self.name), place, ledger)
        finally:
            self.ground.start_master()


def run(ground, end, random, ledger):
    """Faults in random order until `end` [s, monotonic], at least one, each once at most."""
    rounds = [(f"{fault.name}, {part}",
               lambda fault=fault, part=part: fault_round(ground, fault, ledger, part))
              for fault in all_faults() for part in PARTS]
    master = Master(ground)
    rounds += [(f"{master.name}, {part}", lambda part=part: master.round(ledger, part))
               for part in PARTS]
    rounds = [each for each in rounds if each[0].startswith(ground.wanted)]
    random.shuffle(rounds)
    for name, call in rounds:
        ledger.watch(name, call)
        if time.monotonic() > end:
            break


def tables(events):
    """A row a cell: what it said the last time, and how often it was tried."""
    cells = {}
    for note in notes(events, "cell"):
        cells.setdefault((note["fault"], note["operation"]), []).append(note)
    rows = [[fault, operation, len(some), some[-1]["told"][:160], some[-1]["left"]]
            for (fault, operation), some in sorted(cells.items())]
    return rounds_table(events) + table(
        ["fault", "operation", "times", "what is told", "what is left"], rows)
