"""Cut off: programs that are killed, or lose the power, at random moments, and start again."""

import collections
import importlib.util
import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import rosbag

import durable
from ground import DEADLINE_S, SMALL_WORLD, marked_processes, wait_until
from ledger import notes, promise, rounds_table, table

TITLE = "Cut off"
LIVES = 3  # that are cut off one after the other, on what the one before has left
CAMPAIGN = """name: tiny
worlds:
  - {name: lake, layout: A lake in the center., environment: Two sheep graze., seeds: [1, 2],
     size_m: 64, resolution_m: 1}
robots: [{stack: way}]
tasks: {count: 2, length_m: [10, 30]}
trials: [{name: calm, seeds: [1]}]
"""
PLACES = 110  # of a data set: two parts and a piece
TRAINING = pathlib.Path(__file__).resolve().parents[2] / "training"


def files_of(folder):
    """Path below folder -> content of every file."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


def hidden_in(folder):
    return sorted(path.name for path in folder.iterdir() if path.name.startswith("."))


def wait_at_random(random, most_s, program):
    """The moment of a cut, before a program's own end: the one place where time alone decides."""
    try:
        program.process.wait(random.uniform(0.0, most_s))
    except subprocess.TimeoutExpired:
        pass


class SavedWorlds:
    """world_server, which is generating and saving without a break."""

    name = "world_server"

    def run(self, ground, folder, random, environment, facts):
        worlds = folder / "worlds"
        worlds.mkdir(exist_ok=True)
        saved, life = list(facts.get("saved", ())), facts.get("life", 0) + 1
        with ground.world_server(environment, worlds_directory=worlds) as server:
            self.verify(ground, worlds, facts)
            ground.must("generate_world", seed=1, **SMALL_WORLD)
            before = len(saved)

            def work():
                for number in range(1000):
                    name = f"w{life}_{number}"
                    answer = ground.call("save_world", name=name)
                    if answer is None:
                        return
                    if answer.status.code == 0:
                        saved.append(name)
                    if number % 4 == 3:
                        ground.call("generate_world", seed=number, **SMALL_WORLD)

            worker = threading.Thread(target=work)
            worker.start()
            wait_until(lambda: len(saved) > before or not worker.is_alive(), "a world is saved")
            wait_at_random(random, 0.7, server)
            met = server.kill()
            worker.join(DEADLINE_S)
        return {"met": met, "saved": saved, "life": life}

    @staticmethod
    def verify(ground, worlds, facts):
        """What an earlier life has left."""
        listed = {world.name for world in ground.must("list_worlds").worlds}
        lost = sorted(set(facts.get("saved", ())) - listed)
        promise(not lost, f"worlds that were saved are gone: {lost}")
        for name in sorted(listed):
            ground.must("load_world", name=name)
        if facts:
            ground.must("generate_world", seed=1, **SMALL_WORLD)
            ground.must("save_world", name=f"after{facts['life']}")
            promise(not hidden_in(worlds), f"half worlds are left: {hidden_in(worlds)}")

    def check(self, ground, folder, facts):
        worlds = folder / "worlds"
        with ground.world_server(worlds_directory=worlds) as server:
            self.verify(ground, worlds, facts)
            promise(server.stop() == 0, f"world_server ended badly: {server.last_words()}")


class Episodes:
    """episode_recorder, with one episode that is finished and one that runs."""

    name = "episode_recorder"

    def run(self, ground, folder, random, environment, facts):
        life = facts.get("life", 0) + 1
        with ground.world_server(worlds_directory=folder / "worlds", real_time_factor=0), \
                ground.recorder(folder, environment) as recorder:
            self.verify(ground, folder, facts)
            ground.must("generate_world", seed=2, **SMALL_WORLD)
            ground.must("start_episode", name=f"first{life}")
            self.play(ground)
            finished = list(ground.must("stop_episode").paths)
            ground.must("start_episode", name=f"second{life}", split_mb=random.choice((0, 1)))
            began = time.monotonic()
            self.play(ground)
            wait_at_random(random, 3.0, recorder)
            met = recorder.kill()
            ran_s = time.monotonic() - began
        return {"met": met, "life": life, "ran_s": ran_s, "synced_only": bool(environment),
                "finished": [os.path.basename(path) for path in finished]}

    @staticmethod
    def play(ground):
        ground.must("spawn_agent", species="goblin", place="anywhere")
        ground.must("spawn_agent", species="sheep", place="anywhere")

    def verify(self, ground, folder, facts):
        """What an earlier life has left, while server and recorder run."""
        if not facts:
            return
        for name in facts["finished"]:
            promise((folder / name).exists(), f"the finished episode {name} is gone")
            self.read(folder / name)
            status, said = ground.tool("replay_episode", "--verify", folder / name)
            promise(status == 0 and "PROVEN" in said, f"{name} is not proven: {said[-300:]}")
        listed = {one.name: one.complete for one in ground.must("list_episodes").episodes}
        promise(listed.get(f"first{facts['life']}", False), f"first is not listed whole: {listed}")
        ground.must("generate_world", seed=2, **SMALL_WORLD)
        ground.must("start_episode", name=f"third{facts['life']}")
        ground.must("stop_episode")
        for active in sorted(folder.glob("*.bag.active")):
            self.repair(active, facts)

    def check(self, ground, folder, facts):
        with ground.world_server(worlds_directory=folder / "worlds"), ground.recorder(folder):
            self.verify(ground, folder, facts)

    def repair(self, active, facts):
        """As docs/episodes.md says: rename, rosbag reindex, and it is readable."""
        bag = active.with_suffix("")
        active.rename(bag)
        if facts["synced_only"] and bag.stat().st_size == 0:
            return
        done = subprocess.run(["rosbag", "reindex", "-q", bag], capture_output=True, text=True,
                              timeout=DEADLINE_S, check=False)
        if facts["synced_only"]:
            return
        promise(done.returncode == 0, f"rosbag reindex: {done.stderr[-300:]}")
        count = self.read(bag)
        promise(count > 0 or facts["ran_s"] < 3.0,
                f"nothing is in an episode that ran for {facts['ran_s']:.1f} s")

    @staticmethod
    def read(path):
        """Reads every message; how many there are."""
        try:
            with rosbag.Bag(str(path)) as bag:
                return sum(1 for _ in bag.read_messages())
        except (rosbag.ROSBagException, OSError) as error:
            promise(False, f"{path.name} cannot be read: {error}")


class Campaign:
    """A campaign with two workers: all of it is killed, or one worker."""

    name = "campaign"
    whole = None

    def run(self, ground, folder, random, environment, facts):
        out = folder / "out"
        with self.start(ground, folder, out, environment) as campaign:
            wait_until(lambda: out.exists() or not campaign.runs(), "the campaign has begun")
            wait_at_random(random, 1.5 if facts else 2.5, campaign)
            workers = [pid for pid in marked_processes(campaign.mark) if pid != campaign.pid]
            met = False
            if workers and not environment and random.random() < 0.4:
                try:
                    os.kill(random.choice(workers), signal.SIGKILL)
                    met = True
                except ProcessLookupError:
                    pass
                status = campaign.wait()
                promise(status == 0, f"it ended with {status} without a worker: "
                        f"{campaign.last_words()}")
            met = campaign.kill() or met
        return {"met": met}

    def start(self, ground, folder, out, environment=None):
        file = folder / "tiny.yaml"
        file.write_text(CAMPAIGN, encoding="utf-8")
        return ground.command("campaign", file, "--out", out, "--workers", 2, "--resume",
                              environment=environment)

    def finish(self, ground, folder):
        out = folder / "out"
        with self.start(ground, folder, out) as campaign:
            status = campaign.wait()
            promise(status == 0, f"--resume ended with {status}: {campaign.last_words()}")
        results = {name: content.replace(str(out).encode(), b"OUT")
                   for name, content in files_of(out).items()
                   if name.startswith("trials") or name in ("summary.json", "report.html")}
        left = [name for name in files_of(out) if name.endswith(".part")]
        promise(not left, f"half files are left: {left}")
        return results

    def check(self, ground, folder, _facts):
        if Campaign.whole is None:
            Campaign.whole = self.finish(ground, ground.new_folder("campaign-whole"))
        promise(self.finish(ground, folder) == Campaign.whole,
                "the results are not those of an unbroken campaign")


class Resumed:
    """A command line that goes on where it was: `program` starts it, `made` reads what it made."""

    most_s = 1.0

    def __init__(self):
        self.whole = None

    def run(self, ground, folder, random, environment, _facts):
        with self.program(ground, folder, environment) as program:
            wait_until(lambda: self.has_begun(folder) or not program.runs(), "it has begun")
            wait_at_random(random, self.most_s, program)
            return {"met": program.kill()}

    def has_begun(self, _folder):
        return True

    def finish(self, ground, folder):
        with self.program(ground, folder) as program:
            status = program.wait()
            promise(status == 0, f"it goes on and ends with {status}: {program.last_words()}")
        return self.made(folder)

    def check(self, ground, folder, _facts):
        if self.whole is None:
            self.whole = self.finish(ground, ground.new_folder(f"{self.name}-whole"))
        made = self.finish(ground, folder)
        differ = sorted(name for name in {*made, *self.whole}
                        if made.get(name) != self.whole.get(name))
        promise(not differ, f"not as after an unbroken run: {differ}")


class Dataset(Resumed):
    """A data set that is written by two threads."""

    name, most_s = "dataset", 4.0

    def program(self, ground, folder, environment=None):
        return ground.command("dataset", "--generate", PLACES, "--threads", 2, "--seed", 5,
                              "--out", folder / "set", "--resume", environment=environment)

    def made(self, folder):
        return files_of(folder / "set")


class Training(Resumed):
    """A language model that is trained; a checkpoint after every step."""

    name, most_s = "training of a model", 2.0
    PLACES = ("north", "south", "west", "east")

    @staticmethod
    def is_there():
        return importlib.util.find_spec("torch") is not None and TRAINING.is_dir()

    def program(self, ground, folder, environment=None):
        data = ground.folder / "talks.jsonl"
        if not data.exists():
            rows = {place: (letter * 32 + "\n") * 4 for place, letter in zip(self.PLACES, "WFAB")}
            data.write_text("".join(json.dumps({"messages": [
                {"role": "user", "content": f"A lake in the {place}."},
                {"role": "assistant", "content": rows[place]}]}) + "\n" for place in rows), "utf-8")
        return ground.program(
            sys.executable, "-B", "-m", "latticeworld_training.train_language_model",
            "--data", data, "--out", folder / "out", "--width", 32, "--layers", 1,
            "--heads", 2, "--kv-heads", 2,
            "--hidden", 32, "--batch-size", 2, "--epochs", 30, "--checkpoint-steps", 1,
            "--most-words", 20,
            environment={**(environment or {}), "OMP_NUM_THREADS": "1",
                         "PYTHONPATH": f"{TRAINING}:{os.environ['PYTHONPATH']}"})

    def has_begun(self, folder):
        """Until here a program loads PyTorch for seconds."""
        return any((folder / "out").glob("tokenizer.json*"))

    def made(self, folder):
        """All but the checkpoint and the picture: the one holds the time that it took."""
        left = sorted(path.name for path in (folder / "out").glob("*.unfinished"))
        promise(not left, f"half files are left: {left}")
        return {name: content for name, content in files_of(folder / "out").items()
                if name not in ("checkpoint.pt", "loss.png")}


class Bundle:
    """`latticeworld generate` and `export`, whose results are there whole or not at all."""

    name = "generate and export"
    whole = None

    def commands(self, folder):
        return (folder / "world", ("generate", "--layout", "A lake in the east.", "--size", 64,
                                   "--resolution", 1, "--seed", 3, "--out", folder / "world")), \
               (folder / "maps", ("export", folder / "world", "--to", "map", "--out",
                                  folder / "maps"))

    def run(self, ground, folder, random, environment, facts):
        ended, met = list(facts.get("ended", ())), False
        for target, command in self.commands(folder):
            if target.exists():
                continue
            with ground.command(*command, environment=environment) as program:
                wait_at_random(random, 0.6, program)
                if not program.runs():
                    promise(program.wait() == 0, f"{command[0]}: {program.last_words()}")
                    ended.append(target.name)
                met = program.kill()
            if target.name not in ended:
                break
        return {"met": met, "ended": ended}

    def check(self, ground, folder, facts):
        for name in facts["ended"]:
            promise((folder / name).exists(), f"{name} was written and is gone")
        for target, command in self.commands(folder):
            if not target.exists():
                ground.must_run(*command)
        promise(not hidden_in(folder), f"half folders are left: {hidden_in(folder)}")
        made = files_of(folder)
        made.pop("world/world.json")  # has the times that its making took, and a digest of all else
        if Bundle.whole is None:
            Bundle.whole = made
        differ = sorted(name for name in {*made, *Bundle.whole}
                        if made.get(name) != Bundle.whole.get(name))
        promise(not differ, f"not as after an unbroken run: {differ}")
        status, said = ground.tool("latticeworld", "show", folder / "world")
        promise(status == 0, f"latticeworld show: {said[-300:]}")


def kill_round(ground, victim, random, ledger):
    folder = ground.new_folder("kill")
    facts = {}
    for _ in range(LIVES):
        facts = victim.run(ground, folder, random, None, facts)
        ledger.note("cut", how="killed", victim=victim.name, met=facts["met"])
    victim.check(ground, folder, facts)
    ground.remove(folder)


def power_round(ground, victim, random, ledger):
    """A life with the synced state kept; both ends of what may be left are checked."""
    folder, kept = ground.new_folder("power"), ground.new_folder("kept")
    for name in ("worlds", "out", "set"):  # where the programs write: there before, and synced
        (folder / name).mkdir()
    durable.seal(folder, kept)
    facts = victim.run(ground, folder, random,
                       durable.environment(ground.libraries["power_loss"], folder, kept), {})
    ledger.note("cut", how="without power", victim=victim.name, met=facts["met"])
    for variant in durable.VARIANTS:
        left = ground.new_folder("left") / "root"
        durable.rebuild(folder, kept, left, variant)
        try:
            victim.check(ground, left, facts)
        except AssertionError as broken:
            raise type(broken)(f"with {variant}: {broken}") from broken
        ground.remove(left.parent)
    ground.remove(folder)
    ground.remove(kept)


def run(ground, end, random, ledger):
    """Rounds until `end` [s, monotonic], at least one of each."""
    victims = [Bundle(), SavedWorlds(), Episodes(), Campaign(), Dataset()]
    victims += [Training()] if Training.is_there() else []
    rounds = [(f"{victim.name}, {how}", victim, call) for victim in victims
              for how, call in (("killed", kill_round), ("without power", power_round))]
    rounds = [each for each in rounds if each[0].startswith(ground.wanted)]
    while True:
        random.shuffle(rounds)
        for name, victim, call in rounds:
            ledger.watch(name, lambda victim=victim, call=call:
                         call(ground, victim, random, ledger))
            if time.monotonic() > end:
                return


def tables(events):
    """Rounds, and how often a cut met a program that was at work."""
    cuts = notes(events, "cut")
    all_of = collections.Counter((cut["victim"], cut["how"]) for cut in cuts)
    met = collections.Counter((cut["victim"], cut["how"]) for cut in cuts if cut["met"])
    rows = [[f"{victim}, {how}", count, met[victim, how]]
            for (victim, how), count in sorted(all_of.items())]
    totals = [[f"all, {how}", sum(count for (_, of), count in all_of.items() if of == how),
               sum(count for (_, of), count in met.items() if of == how)]
              for how in ("killed", "without power")]
    return rounds_table(events) + table(
        ["cut off", "lives", "of these the program was at work"], rows + totals)
