#!/usr/bin/python3
"""Episodes: recorded, proven, altered, killed, cut off by a full disk, read by other programs."""

import json
import os
import pathlib
import re
import subprocess
import tempfile

import rosbag
import rospy
from geometry_msgs.msg import Point, Twist
from std_msgs.msg import String

from episode_world import FIELD, OtherMaster, OtherRecorder, Recorder, run_tool, verify
from latticeworld import srv
from latticeworld.msg import EpisodeStatus, Status
from world_client import TIMEOUT_S, Collector, ServerTest, run, service, wait_until

FILLER_BYTES = 1 << 20


def listeners(publisher):
    """The names of the nodes that are connected with a publisher."""
    return {connection.endpoint_id for connection in publisher.impl.connections}


class EpisodeTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.recorder = Recorder()
        cls.set_weather = service("set_weather", srv.SetWeather)
        # One publisher for all episodes: a recorder takes part in a topic that is there when it begins
        # before start_episode answers, and in a later one some time after its first message.
        cls.command = rospy.Publisher("/robot/cmd_vel", Twist, queue_size=10)
        cls.world.generate(**FIELD)

    def setUp(self):
        self.assertTrue(self.world.pause().success)

    def begin_anew(self):
        """Without snapshots: calls of before a reset are kept for as long as one may need them."""
        self.world.generate(**FIELD)
        self.assertTrue(self.world.pause().success)

    def record(self, act, recorder=None, **request):
        """An episode of what `act` does; its files."""
        recorder = recorder or self.recorder
        started = self.assert_ok(recorder.start_episode(**request))
        self.assertTrue(started.path.endswith(".bag.active"), started.path)
        act()
        return self.assert_ok(recorder.stop_episode())

    def drive(self, steps, forward=0.8):
        """The robot, by its topic."""
        wait_until(lambda: "/world_server" in listeners(self.command), "the robot listens")
        for _ in range(steps // 20):
            command = Twist()
            command.linear.x = forward
            command.angular.z = 0.3
            self.command.publish(command)
            self.assert_ok(self.world.step(steps=20))

    def go_on(self, steps):
        """By calls short enough that the recorder hears every message on a busy machine."""
        for _ in range(steps // 20):
            self.assert_ok(self.world.step(steps=20))

    def battle(self):
        """Commands, spawns, policies, elements, a gate, weather, a snapshot and a reset."""
        for team, species, row in ((3, "goblin", -5.0), (4, "ancient_warrior", 5.0)):
            for i in range(3):
                self.assert_ok(self.world.spawn_agent(
                    species=species, team=team, state="attacking",
                    position=Point(x=4.0 * i - 6.0, y=row)))
        self.assert_ok(self.world.set_policy(team=4, policy="pursuer"))
        self.assert_ok(self.world.spawn_element(kind="gate", name="north_gate",
                                                position=Point(y=20.0)))
        self.assert_ok(self.world.open_gate(name="north_gate"))
        self.assert_ok(self.set_weather(weather="rain"))
        wait_until(lambda: "/episode_recorder" in listeners(self.command),
                   "the recorder hears commands")
        self.drive(200)
        self.assert_ok(self.world.save_snapshot(name="middle"))
        self.go_on(100)
        self.assert_ok(self.world.restore_snapshot(name="middle"))
        self.go_on(100)
        self.assert_ok(self.world.reset_world(seed=23))
        self.assert_ok(self.world.spawn_agent(species="goblin"))
        self.drive(100)
        self.assert_ok(self.world.step(steps=50))

    def test_a_battle_is_proven_and_an_altered_one_is_not(self):
        done = self.record(self.battle, name="battle", seed=4)
        self.assertEqual((0, 0), (done.dropped, done.missing_calls))
        (bag,) = done.paths
        code, said = verify(bag)
        self.assertEqual(0, code, said)
        self.assertRegex(said, r"PROVEN: (\d+) of \1 recorded states .* after (\d+) of \2 recorded")
        self.other_readers(bag)
        self.foreign_reader(bag)
        self.foreign_writer(bag)
        self.tools(bag)
        with tempfile.TemporaryDirectory() as folder:
            altered = pathlib.Path(folder, "altered.bag")
            self.alter(bag, altered)
            code, said = verify(altered)
            self.assertEqual(1, code, said)
            self.assertIn("DIFFERS at step", said)
            self.assertIn("the states agreed until step", said)
            self.without_hashes(bag, pathlib.Path(folder, "stripped.bag"))
            self.damage(bag, pathlib.Path(folder))

    def without_hashes(self, bag, stripped):
        """The hash of the beginning is left: it proves nothing of what came after it."""
        with rosbag.Bag(bag) as source, rosbag.Bag(str(stripped), "w") as target:
            for topic, message, time in source.read_messages():
                if topic != "/world/state_hash":
                    target.write(topic, message, time)
        code, said = verify(stripped)
        self.assertEqual(1, code, said)
        self.assertIn("NO PROOF", said)
        self.assertNotIn("PROVEN", said)

    @staticmethod
    def alter(bag, altered):
        """The same bag with one digit of one command changed."""
        done = False
        with rosbag.Bag(bag) as source, rosbag.Bag(str(altered), "w") as target:
            for topic, message, time in source.read_messages():
                if topic == "/world/journal" and '"command"' in message.call and not done:
                    message.call = message.call.replace("0.8", "0.9", 1)
                    done = True
                target.write(topic, message, time)
        assert done, "no command was recorded"

    def damage(self, bag, folder):
        """What is no whole episode is refused with the reason."""
        def refused(path, *words):
            code, said = verify(path)
            self.assertEqual(1, code, said)
            for word in words:
                self.assertIn(word, said)

        data = pathlib.Path(bag).read_bytes()
        pathlib.Path(folder, "cut.bag").write_bytes(data[:len(data) // 2])
        refused(folder / "cut.bag", "DATA_LOSS", "cut.bag")
        pathlib.Path(folder, "text.bag").write_text("no bag", encoding="utf-8")
        refused(folder / "text.bag", "no rosbag")
        pathlib.Path(folder, "empty.bag").write_bytes(b"")
        refused(folder / "empty.bag", "DATA_LOSS")
        refused(folder / "absent.bag", "NOT_FOUND", "absent.bag")
        with rosbag.Bag(str(folder / "other.bag"), "w") as other:
            other.write("/chatter", String("hello"), rospy.Time(1))
        refused(folder / "other.bag", "no episode", "latticeworld/EpisodeStart")
        with rosbag.Bag(bag) as source, rosbag.Bag(str(folder / "worldless.bag"), "w") as target:
            for topic, message, time in source.read_messages():
                if topic != "/episode/world":
                    target.write(topic, message, time)
        refused(folder / "worldless.bag", "latticeworld/WorldFiles")
        with rosbag.Bag(bag) as source, rosbag.Bag(str(folder / "later.bag"), "w") as target:
            for topic, message, time in source.read_messages():
                if topic == "/episode/start":
                    message.format = 99
                target.write(topic, message, time)
        refused(folder / "later.bag", "format 99")
        self.assertEqual(2, run_tool("replay_episode")[0])
        self.assertEqual(2, run_tool("episode", "fly", bag)[0])
        self.assertEqual(2, run_tool("replay_episode", "--play", "--rate", "-1", bag)[0])

    def other_readers(self, bag):
        """The standard tools read it."""
        said = subprocess.run(["rosbag", "info", bag], stdout=subprocess.PIPE, text=True,
                              check=True, timeout=TIMEOUT_S).stdout
        for word in ("lz4", "latticeworld/EpisodeStart", "/world/journal", "/agents", "/clock"):
            self.assertIn(word, said)
        with tempfile.TemporaryDirectory() as folder:
            filtered = pathlib.Path(folder, "filtered.bag")
            subprocess.run(["rosbag", "filter", bag, str(filtered), "topic == '/agents'"],
                           check=True, stdout=subprocess.DEVNULL, timeout=TIMEOUT_S)
            with rosbag.Bag(str(filtered)) as agents:
                self.assertGreater(agents.get_message_count(), 10)
        with rosbag.Bag(bag) as read:
            types = {topic: info.msg_type for topic, info in
                     read.get_type_and_topic_info()[1].items()}
            start = next(m for _, m, _ in read.read_messages("/episode/start"))
            end = next(m for _, m, _ in read.read_messages("/episode/end"))
        for topic in ("/tf", "/agent_events", "/elements", "/world/weather", "/world/info",
                      "/robot/odom", "/robot/ground_truth", "/robot/cmd_vel", "/episode/world"):
            self.assertIn(topic, types)
        self.assertEqual(("battle", 4, 1), (start.name, start.seed, start.format))
        self.assertIn("world_server", start.parameters)
        self.assertEqual("stopped", end.reason)

    def foreign_reader(self, bag):
        """A reader that shares no code with ROS finds the same as rosbag."""
        python = os.environ.get("LATTICEWORLD_PYTHON")
        if not python:
            return
        script = pathlib.Path(__file__).with_name("read_with_rosbags.py")
        said = subprocess.run([python, str(script), bag], stdout=subprocess.PIPE, text=True,
                              check=True, timeout=TIMEOUT_S).stdout
        found = json.loads(said)
        with rosbag.Bag(bag) as read:
            self.assertEqual({topic: info.message_count for topic, info in
                              read.get_type_and_topic_info()[1].items()}, found["counts"])
            self.assertEqual([len(m.agents) for _, m, _ in read.read_messages("/agents")],
                             found["agents"])
        self.assertEqual("battle", found["name"])
        for call in ("command", "spawn", "set_policy", "spawn_element", "open_gate", "set_weather",
                     "save", "restore", "reset"):
            self.assertIn(call, found["calls"])
        for file in ("world.json", "terrain.bin", "assets.csv"):
            self.assertIn(file, found["files"])

    def foreign_writer(self, bag):
        """What rosbags writes with lz4 is whole, no rosbag of ROS reads it, and the command that is
        told then makes a proven episode of it."""
        python = os.environ.get("LATTICEWORLD_PYTHON")
        if not python:
            return
        convert = str(pathlib.Path(python).with_name("rosbags-convert"))
        with tempfile.TemporaryDirectory() as folder:
            foreign = pathlib.Path(folder, "foreign.bag")
            subprocess.run([convert, "--src", bag, "--dst", foreign, "--compress", "lz4"],
                           check=True, timeout=TIMEOUT_S)
            code, said = verify(foreign)
            self.assertEqual(1, code, said)
            self.assertNotIn("damaged", said)
            told = re.search(r"rosbags-convert --src \S+ --dst \S+\.bag", said)
            self.assertIsNotNone(told, said)
            subprocess.run([convert, *told.group().split()[1:]], check=True, cwd=folder,
                           timeout=TIMEOUT_S)
            self.assertTrue(pathlib.Path(folder, "OTHER.bag").exists(), told.group())
            code, said = verify(pathlib.Path(folder, "OTHER.bag"))
            self.assertEqual(0, code, said)
            self.assertIn("PROVEN", said)

    def tools(self, bag):
        """Summary, tables and a picture."""
        code, said = run_tool("episode", "summary", bag)
        self.assertEqual(0, code, said)
        for word in ("battle", "robot", "goblin_1", "spawned"):
            self.assertIn(word, said)
        code, said = run_tool("episode", "metrics", bag)
        self.assertEqual(0, code, said)
        rows = {line.split(",")[0]: line.split(",") for line in said.splitlines()}
        self.assertGreater(float(rows["robot"][rows["agent"].index("distance_m")]), 0.5)
        self.assertGreater(float(rows["robot"][rows["agent"].index("joint_work_j")]), 0.0)
        with tempfile.TemporaryDirectory() as folder:
            code, said = run_tool("episode", "csv", bag, "--out", folder)
            self.assertEqual(0, code, said)
            self.assertEqual({"tracks.csv", "events.csv", "metrics.csv"},
                             {path.name for path in pathlib.Path(folder).iterdir()})
            picture = pathlib.Path(folder, "tracks.png")
            code, said = run_tool("episode", "picture", bag, "--out", picture, "--width", 300)
            self.assertEqual(0, code, said)
            self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

    def test_an_episode_from_the_middle_of_a_run_is_proven(self):
        self.begin_anew()
        self.assert_ok(self.world.reset_world(seed=8))
        self.drive(60)
        (bag,) = self.record(lambda: self.drive(60), name="middle", keep_state=True,
                             compression="bz2").paths
        code, said = verify(bag)
        self.assertEqual(0, code, said)
        # What came before is in it too: the calls since the reset.
        self.assertIn("simulated 120 steps", said)

    def test_what_cannot_be_recorded_is_refused(self):
        refusals = (
            ({"name": "../evil"}, "name"), ({"name": "a" * 65}, "64"),
            ({"compression": "zip"}, "lz4"), ({"topics": ["(("]}, "(("),
            ({"topics": ["x" * 300]}, "256"), ({"max_duration": -1.0}, "max_duration"),
            ({"max_duration": float("nan")}, "max_duration"),
            ({"keep_state": True, "seed": 7}, "keep_state"))
        for request, word in refusals:
            self.assert_refused(self.recorder.start_episode(**request), Status.INVALID_ARGUMENT,
                                word)
        self.assert_refused(self.recorder.stop_episode(), Status.FAILED_PRECONDITION)
        done = self.record(lambda: self.refuse_a_second(), name="first", topics=["/agents"])
        self.assertEqual("first", done.name)
        self.assert_refused(self.recorder.start_episode(name="first"), Status.ALREADY_EXISTS,
                            "first")
        listed = {one.name: one for one in self.recorder.list_episodes().episodes}
        self.assertTrue(listed["first"].complete)
        self.assertEqual(done.paths, listed["first"].paths)
        with rosbag.Bag(done.paths[0]) as bag:
            topics = set(bag.get_type_and_topic_info()[1])
        self.assertEqual({"/agents"}, topics - {"/clock", "/episode/start", "/episode/world",
                                                "/episode/end", "/world/journal",
                                                "/world/state_hash"})

    def refuse_a_second(self):
        self.assert_refused(self.recorder.start_episode(name="second"),
                            Status.FAILED_PRECONDITION, "first")
        listed = {one.name: one for one in self.recorder.list_episodes().episodes}
        self.assertFalse(listed["first"].complete)

    def test_limits_end_an_episode(self):
        with Collector("episode/status", EpisodeStatus) as status:
            self.assert_ok(self.recorder.start_episode(name="short", max_duration=0.5))
            self.assert_ok(self.world.step(steps=100))
            ended = status.wait_for(lambda m: m.name == "short" and m.state == "complete")
        self.assertIn("max_duration", ended.reason)
        self.assert_refused(self.recorder.stop_episode(), Status.FAILED_PRECONDITION, "short",
                            "max_duration")
        self.assertEqual(0, verify(*ended.paths)[0])

    def test_what_a_call_of_thousands_of_steps_loses_is_counted(self):
        topics = {"/agents": lambda m: m.header.seq, "/tf": lambda m: m.transforms[0].header.seq}
        with Collector("episode/status", EpisodeStatus) as status:
            self.assert_ok(self.recorder.start_episode(name="burst", topics=list(topics)))
            last = self.assert_ok(self.world.step(steps=5000)).stamp
            # What is on its way comes within a few rounds of the recorder's.
            count = len(status.messages())
            wait_until(lambda: len(status.messages()) > count + 8, "the recorder goes on")
            done = self.assert_ok(self.recorder.stop_episode())
        missing = 0
        with rosbag.Bag(done.paths[0]) as bag:
            for topic, number_of in topics.items():
                heard = [(number_of(m), time) for _, m, time in bag.read_messages(topic)]
                published = heard[-1][0] - heard[0][0] + 1
                self.assertGreaterEqual(published, 2500, topic)  # 50 a second
                self.assertLessEqual(last, heard[-1][1], "queues keep the newest")
                missing += published - len(heard)
        self.assertEqual(missing, done.dropped)

    def test_another_world_ends_an_episode(self):
        with Collector("episode/status", EpisodeStatus) as status:
            self.assert_ok(self.recorder.start_episode(name="swapped"))
            self.drive(20)
            self.world.generate(**FIELD)
            ended = status.wait_for(lambda m: m.name == "swapped" and m.state == "complete")
        self.assertIn("another world", ended.reason)
        code, said = verify(*ended.paths)
        self.assertEqual(0, code, said)

    def test_a_killed_recorder_leaves_what_it_wrote(self):
        with tempfile.TemporaryDirectory() as folder:
            with OtherRecorder("killed", folder) as other, \
                    Collector("/killed/episode/status", EpisodeStatus) as status:
                started = self.assert_ok(other.recorder.start_episode(name="killed"))
                self.drive(100)
                # What is told after the steps was on the disk a second later.
                count = len(status.messages())
                wait_until(lambda: len(status.messages()) > count + 8, "the recorder goes on")
                self.drive(20)
                other.kill()
            active = pathlib.Path(started.path)
            self.assertTrue(active.exists())
            code, said = verify(active)
            self.assertEqual(1, code, said)
            self.assertIn("rosbag reindex", said)
            killed = active.rename(active.with_name("killed.bag"))
            subprocess.run(["rosbag", "reindex", str(killed)], check=True,
                           stdout=subprocess.DEVNULL, timeout=TIMEOUT_S)
            code, said = verify(killed)
            self.assertEqual(0, code, said)
            with rosbag.Bag(str(killed)) as bag:
                last = max(m.step for _, m, _ in bag.read_messages("/world/state_hash"))
                first = next(m for _, m, _ in bag.read_messages("/episode/start"))
            self.assertGreaterEqual(last - first.step, 100)

    def fill(self, megabytes):
        publisher = rospy.Publisher("/filler", String, queue_size=megabytes)
        wait_until(lambda: publisher.get_num_connections() > 0, "the recorder listens")
        for _ in range(megabytes):
            publisher.publish(String("x" * FILLER_BYTES))
        self.filler = publisher

    def test_a_full_disk_ends_the_episode_with_a_whole_bag(self):
        limit = 24 << 20
        with tempfile.TemporaryDirectory() as folder:
            with OtherRecorder("full", folder, max_file_bytes=limit) as other, \
                    Collector("/full/episode/status", EpisodeStatus) as status:
                self.assert_ok(other.recorder.start_episode(
                    name="full", compression="none", topics=["/agents", "/filler"]))
                self.drive(40)
                self.fill(40)
                ended = status.wait_for(lambda m: m.state == "failed")
                self.assertIn("RESOURCE_EXHAUSTED", ended.reason)
                self.assert_refused(other.recorder.stop_episode(), Status.FAILED_PRECONDITION,
                                    "RESOURCE_EXHAUSTED")
            (bag,) = ended.paths
            self.assertLessEqual(pathlib.Path(bag).stat().st_size, limit)
            with rosbag.Bag(bag) as read:
                self.assertGreater(read.get_message_count("/filler"), 5)
            code, said = verify(bag)
            self.assertEqual(0, code, said)
            self.assertIn("RESOURCE_EXHAUSTED", run_tool("episode", "summary", bag)[1])

    def test_each_part_of_a_split_episode_stands_alone(self):
        def act():
            self.drive(40)
            self.fill(12)
            self.drive(40)
            self.fill(12)
            self.drive(40)

        self.begin_anew()
        done = self.record(act, name="split", compression="none", split_mb=8,
                           topics=["/agents", "/filler"])
        self.assertGreaterEqual(len(done.paths), 3)
        code, said = verify(*done.paths)
        self.assertEqual(0, code, said)
        self.assertIn("simulated 120 steps", said)
        for path in done.paths:
            code, said = verify(path)
            self.assertEqual(0, code, said)
        code, said = run_tool("episode", "summary", *done.paths)
        self.assertIn("stopped", said)

    def test_an_episode_is_not_played_beside_a_running_world(self):
        (bag,) = self.record(lambda: self.drive(20), name="beside").paths
        code, said = run_tool("replay_episode", "--play", bag)
        self.assertEqual(1, code, said)
        self.assertIn("/clock", said)

    def test_what_was_recorded_is_played(self):
        (bag,) = self.record(lambda: self.drive(200), name="played").paths
        with rosbag.Bag(bag) as read:
            recorded = [str(m) for _, m, _ in read.read_messages("/agents")]
        with OtherMaster() as env:
            script = pathlib.Path(__file__).with_name("hear_episode.py")
            hearer = subprocess.Popen(["/usr/bin/python3", str(script), str(len(recorded))],
                                      env=env, text=True, stdout=subprocess.PIPE)
            try:
                self.assertEqual("ready\n", hearer.stdout.readline())
                code, said = run_tool("replay_episode", "--play", "--rate", 4, bag, env=env)
                self.assertEqual(0, code, said)
                heard = json.loads(hearer.communicate(timeout=TIMEOUT_S)[0])
            finally:
                hearer.kill()
                hearer.wait(TIMEOUT_S)
        self.assertTrue(heard["ended"])
        # Who listens from the start on misses nothing.
        self.assertEqual(recorded, heard["states"])
        self.assertEqual(sorted(heard["clock"]), heard["clock"])


if __name__ == "__main__":
    run("episode_test", EpisodeTest)
