"""Cut off: programs that are killed, or lose the power, at random moments, and start again."""

import os
import signal
import subprocess
import threading
import time

import rosbag

import durable
from ground import DEADLINE_S, SMALL_WORLD, marked_processes, wait_until
from ledger import Ledger, promise

CAMPAIGN = """name: tiny
worlds:
  - {name: lake, layout: A lake in the center., environment: Two sheep graze., seeds: [1, 2],
     size_m: 64, resolution_m: 1}
robots: [{stack: way}]
tasks: {count: 2, length_m: [10, 30]}
trials: [{name: calm, seeds: [1]}]
"""
PLACES = 110  # of a data set: two parts and a piece


def files_of(folder):
    """Path below folder -> content of every file."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


def hidden_in(folder):
    return sorted(path.name for path in folder.iterdir() if path.name.startswith("."))


def wait_at_random(random, most_s):
    """The moment of a cut: the one place where time alone decides."""
    threading.Event().wait(random.uniform(0.0, most_s))


class SavedWorlds:
    """world_server, which is generating and saving without a break."""

    name = "world_server"

    def run(self, ground, folder, random, environment):
        worlds = folder / "worlds"
        worlds.mkdir(exist_ok=True)
        saved = []
        with ground.world_server(environment, worlds_directory=worlds) as server:
            ground.must("generate_world", seed=1, **SMALL_WORLD)

            def work():
                for number in range(1000):
                    answer = ground.call("save_world", name=f"w{number}")
                    if answer is None:
                        return
                    if answer.status.code == 0:
                        saved.append(f"w{number}")
                    if number % 4 == 3:
                        ground.call("generate_world", seed=number, **SMALL_WORLD)

            worker = threading.Thread(target=work)
            worker.start()
            wait_until(lambda: saved or not worker.is_alive(), "a world is saved")
            wait_at_random(random, 1.5)
            server.kill()
            worker.join(DEADLINE_S)
        return {"saved": saved}

    def check(self, ground, folder, facts):
        worlds = folder / "worlds"
        with ground.world_server(worlds_directory=worlds) as server:
            listed = {world.name for world in ground.must("list_worlds").worlds}
            lost = sorted(set(facts["saved"]) - listed)
            promise(not lost, f"worlds that were saved are gone: {lost}")
            ground.must("generate_world", seed=1, **SMALL_WORLD)
            for name in sorted(listed):
                ground.must("load_world", name=name)
            ground.must("save_world", name="after")
            promise(not hidden_in(worlds), f"half worlds are left: {hidden_in(worlds)}")
            promise(server.stop() == 0, f"world_server ended badly: {server.last_words()}")


class Episodes:
    """episode_recorder, with one episode that is finished and one that runs."""

    name = "episode_recorder"

    def run(self, ground, folder, random, environment):
        with ground.world_server(worlds_directory=folder / "worlds", real_time_factor=0), \
                ground.recorder(folder, environment) as recorder:
            ground.must("generate_world", seed=2, **SMALL_WORLD)
            ground.must("start_episode", name="first")
            self.play(ground)
            finished = list(ground.must("stop_episode").paths)
            ground.must("start_episode", name="second", split_mb=random.choice((0, 1)))
            began = time.monotonic()
            self.play(ground)
            wait_at_random(random, 4.0)
            recorder.kill()
            ran_s = time.monotonic() - began
        return {"finished": [os.path.basename(path) for path in finished], "ran_s": ran_s,
                "synced_only": bool(environment)}

    @staticmethod
    def play(ground):
        ground.must("spawn_agent", species="goblin", place="anywhere")
        ground.must("spawn_agent", species="sheep", place="anywhere")

    def check(self, ground, folder, facts):
        for name in facts["finished"]:
            promise((folder / name).exists(), f"the finished episode {name} is gone")
            self.read(folder / name)
            status, said = ground.tool("replay_episode", "--verify", folder / name)
            promise(status == 0 and "PROVEN" in said, f"{name} is not proven: {said[-300:]}")
        with ground.world_server(worlds_directory=folder / "worlds"), ground.recorder(folder):
            listed = {one.name: one.complete for one in ground.must("list_episodes").episodes}
            promise(listed.get("first", False), f"first is not listed as whole: {listed}")
            ground.must("generate_world", seed=2, **SMALL_WORLD)
            ground.must("start_episode", name="third")
            ground.must("stop_episode")
        for active in sorted(folder.glob("*.bag.active")):
            self.repair(active, facts)

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

    def run(self, ground, folder, random, environment):
        out = folder / "out"
        with self.start(ground, folder, out, environment) as campaign:
            wait_until(lambda: out.exists() or not campaign.runs(), "the campaign has begun")
            wait_at_random(random, 4.0)
            workers = [pid for pid in marked_processes(campaign.mark) if pid != campaign.pid]
            if workers and not environment and random.random() < 0.4:
                try:
                    os.kill(random.choice(workers), signal.SIGKILL)
                except ProcessLookupError:
                    pass
                status = campaign.wait()
                promise(status == 0, f"it ended with {status} without a worker: "
                        f"{campaign.last_words()}")
            campaign.kill()
        return {}

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


class Dataset:
    """A data set that is written by two threads."""

    name = "dataset"
    whole = None

    def start(self, ground, folder, environment=None):
        return ground.command("dataset", "--generate", PLACES, "--threads", 2, "--seed", 5,
                              "--out", folder / "set", "--resume", environment=environment)

    def run(self, ground, folder, random, environment):
        with self.start(ground, folder, environment) as writer:
            wait_at_random(random, 14.0)
            writer.kill()
        return {}

    def finish(self, ground, folder):
        with self.start(ground, folder) as writer:
            status = writer.wait()
            promise(status == 0, f"--resume ended with {status}: {writer.last_words()}")
        return files_of(folder / "set")

    def check(self, ground, folder, _facts):
        if Dataset.whole is None:
            Dataset.whole = self.finish(ground, ground.new_folder("dataset-whole"))
        promise(self.finish(ground, folder) == Dataset.whole,
                "the bytes are not those of an unbroken run")


class Bundle:
    """`latticeworld generate` and `export`, whose results are there whole or not at all."""

    name = "generate and export"
    whole = None

    def commands(self, folder):
        return (folder / "world", ("generate", "--layout", "A lake in the east.", "--size", 64,
                                   "--resolution", 1, "--seed", 3, "--out", folder / "world")), \
               (folder / "maps", ("export", folder / "world", "--to", "map", "--out",
                                  folder / "maps"))

    def run(self, ground, folder, random, environment):
        ended = []
        for target, command in self.commands(folder):
            if target.exists():
                continue
            with ground.command(*command, environment=environment) as program:
                wait_at_random(random, 2.5)
                if not program.runs():
                    promise(program.wait() == 0, f"{command[0]}: {program.last_words()}")
                    ended.append(target.name)
                program.kill()
            if target.name not in ended:
                break
        return {"ended": ended}

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


def kill_round(ground, victim, random):
    folder = ground.new_folder("kill")
    facts = victim.run(ground, folder, random, None)
    victim.check(ground, folder, facts)
    ground.remove(folder)


def power_round(ground, victim, random):
    """The same with the synced state kept; both ends of what may be left are checked."""
    folder, kept = ground.new_folder("power"), ground.new_folder("kept")
    for name in ("worlds", "out", "set"):  # where the programs write: there before, and synced
        (folder / name).mkdir()
    durable.seal(folder, kept)
    facts = victim.run(ground, folder, random,
                       durable.environment(ground.libraries["power_loss"], folder, kept))
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


def run(ground, end, random):
    """Rounds until `end` [s, monotonic], at least one; the ledger."""
    ledger = Ledger("Cut off")
    rounds = [(kind, victim) for victim in (Bundle(), SavedWorlds(), Episodes(), Campaign(),
                                            Dataset())
              for kind in (kill_round, power_round)]
    while True:
        random.shuffle(rounds)
        for kind, victim in rounds:
            what = "killed" if kind is kill_round else "without power"
            ledger.watch(f"{victim.name}, {what}", lambda: kind(ground, victim, random))
            if time.monotonic() > end:
                return ledger
