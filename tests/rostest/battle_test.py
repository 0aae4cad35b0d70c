#!/usr/bin/python3
"""A battle of two teams and a robot: recorded, played back, and fought again from its bag alone, to
the same states."""

import collections
import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import xmlrpc.client

import rosbag
import rosgraph
import rospy
from geometry_msgs.msg import Point, Twist
from std_msgs.msg import Empty

from latticeworld.msg import AgentEvent, AgentStates, JournalEntry, Status
from world_client import TIMEOUT_S, Collector, ServerTest, run, wait_until

FIELD = {"layout": "Flat grassland everywhere.", "environment": "A sunny summer noon.",
         "size": 96.0, "seed": 9}
RECORDED = ("/clock", "/tf", "/agents", "/agent_events", "/world/info", "/elements",
            "/world/journal", "/world/state_hash")
SEED = 4

# What a bag of a battle says.
Battle = collections.namedtuple("Battle", "info states events journal hashes")


def twist(call):
    message = Twist()
    message.linear.x, message.linear.y, message.linear.z = call["linear_mps"]
    message.angular.z = call["yaw_rate_radps"]
    return message


class BattleTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**FIELD)

    def setUp(self):
        self.assertTrue(self.world.pause().success)
        self.publishers = {}

    def line_up(self, seed=SEED):
        """Two teams before each other and a robot beside them, from the start state on, paused."""
        self.assert_ok(self.world.reset_world(seed=seed))
        for team, species, row in ((3, "goblin", -5.0), (4, "ancient_warrior", 5.0)):
            for i in range(5):
                answer = self.world.spawn_agent(species=species, team=team, state="attacking",
                                                position=Point(x=3.0 * i - 6.0, y=row))
                self.assertIn(answer.status.code, (Status.OK, Status.FAILED_PRECONDITION))
        self.assert_ok(self.world.spawn_agent(name="champion", place="center", controllable=True))
        self.assert_ok(self.world.set_policy(team=4, policy="pursuer"))

    def test_a_recorded_battle_replays(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "battle.bag")
            self.record(path)
            battle = self.read(path)
            self.play(path, battle.states)
        # Events and states tell one story: who is dead has died, and who was hurt was hit.
        died = {event.agent for event in battle.events if event.kind == "died"}
        struck = {event.agent for event in battle.events if event.kind == "hit"}
        for agent in battle.states[-1].agents:
            self.assertEqual(agent.health == 0.0, agent.name in died, agent.name)
            if agent.health < 1.0:
                self.assertIn(agent.name, struck)
        self.assertTrue(struck)
        self.assertTrue(any(event.kind == "attacked" for event in battle.events))
        self.fight_again(battle)
        # With another seed it goes another way.
        with Collector("agents", AgentStates) as states:
            states.wait_until_connected()
            self.line_up(seed=SEED + 1)
            last = battle.states[-1]
            after = self.assert_ok(self.world.step(steps=last.episode_step))
            other = states.wait_for(lambda m: m.step == after.step)
        self.assertNotEqual([str(agent.pose) for agent in last.agents],
                            [str(agent.pose) for agent in other.agents])

    def record(self, path):
        """From the line-up on, until somebody has been hit and some time more; the robot is driven
        and strikes meanwhile."""
        with Collector("agent_events", AgentEvent) as events, \
                Collector("agents", AgentStates) as states:
            recorder = subprocess.Popen(["rosbag", "record", "-O", str(path), *RECORDED],
                                        start_new_session=True)
            try:
                wait_until(lambda: self.listens("/record", RECORDED), "the recorder listens")
                for collector in (events, states):
                    collector.wait_until_connected()
                self.line_up()
                drive = rospy.Publisher("champion/cmd_vel", Twist, queue_size=1)
                strike = rospy.Publisher("champion/strike", Empty, queue_size=1)
                wait_until(lambda: drive.get_num_connections() and strike.get_num_connections(),
                           "the robot listens")
                self.assertTrue(self.world.unpause().success)
                self.fight(events, states, drive, strike)
                self.assertTrue(self.world.pause().success)
            finally:
                os.killpg(recorder.pid, signal.SIGINT)
                recorder.wait(TIMEOUT_S)
            wait_until(path.exists, "the bag is closed")

    @staticmethod
    def fight(events, states, drive, strike):
        """Whatever moment a command comes at: the journal tells."""
        turns, last_step, beyond = 0, None, None
        while last_step is None or last_step < beyond:
            command = Twist()
            command.linear.x, command.angular.z = 0.7, math.sin(0.3 * turns)
            drive.publish(command)
            if turns % 4 == 0:
                strike.publish(Empty())
            turns += 1
            for _ in range(5):
                state = states.wait_for_next()
            hit = next((event for event in events.messages() if event.kind == "hit"), None)
            if hit is not None:
                last_step, beyond = state.step, hit.step + 300
        # What the recorder may miss at its end shall be no command.
        states.wait_for(lambda m: m.step >= last_step + 100)

    def fight_again(self, battle):
        """From the bag alone: the world, its seed, and every call at its step. The states are those
        of the battle, bit for bit: whenever the bag has a hash, and what everybody is at the end."""
        info = battle.info
        world = self.world.generate(layout=info.layout_instruction,
                                    environment=info.environment_instruction, seed=info.seed,
                                    size=info.size, resolution=info.resolution)
        self.assertEqual(info.world_id, world.world_id)
        resets = [entry for entry in battle.journal if json.loads(entry.call)["call"] == "reset"]
        begin = resets[-1]
        moments = [((entry.step, entry.number, 0), entry) for entry in battle.journal
                   if entry.number >= begin.number]
        last = battle.states[-1]
        moments += [((state.step, state.calls, 1), state) for state in battle.hashes
                    if state.calls >= begin.number and state.episode_step <= last.episode_step]
        kinds = collections.Counter()
        at = 0
        with Collector("world/journal", JournalEntry) as journal, \
                Collector("agents", AgentStates) as states:
            journal.wait_until_connected()
            states.wait_until_connected()
            for (step, _, is_hash), moment in sorted(moments, key=lambda pair: pair[0]):
                if step - begin.step > at:
                    self.assert_ok(self.world.step(steps=step - begin.step - at))
                    at = step - begin.step
                if is_hash:
                    now = self.assert_ok(self.world.get_world())
                    self.assertEqual((at, moment.state_hash), (now.episode_step, now.state_hash))
                    kinds["hash"] += 1
                else:
                    kinds[self.call_again(moment.call)] += 1
            if at < last.episode_step:
                self.assert_ok(self.world.step(steps=last.episode_step - at))
            end = states.wait_for(lambda m: m.episode_step == last.episode_step)
            self.assertEqual([str(agent) for agent in last.agents],
                             [str(agent) for agent in end.agents])
            # The calls are those of the battle, word for word.
            battle_calls = [entry.call for entry in battle.journal if entry.number >= begin.number]
            journal.wait_for(lambda _: len(journal.messages()) == len(battle_calls))
            self.assertEqual(battle_calls, [entry.call for entry in journal.messages()])
        self.assertGreater(kinds["hash"], 3)
        self.assertGreater(kinds["command"], 10)
        self.assertGreater(kinds["strike"], 2)
        self.assertEqual((1, 1), (kinds["reset"], kinds["set_policy"]))
        self.assertGreater(kinds["spawn"], 5)

    def call_again(self, text):
        """Answers the kind of call, once the simulation has got it."""
        call = json.loads(text)
        if call["call"] == "reset":
            self.assert_ok(self.world.reset_world(seed=call["seed"]))
        elif call["call"] == "spawn":
            x, y = call["position_m"] or (0.0, 0.0)
            team = {None: 0, 0: -1}.get(call["team"], call["team"])
            answer = self.assert_ok(self.world.spawn_agent(
                name=call["name"], species=call["species"], state=call["state"] or "",
                place="" if call["position_m"] else call["region"], position=Point(x=x, y=y),
                heading=call["heading_rad"], controllable=call["controllable"], team=team,
                policy=call["policy"]))
            self.assertEqual(call["answer"], answer.name)
        elif call["call"] == "set_policy":
            self.assert_ok(self.world.set_policy(agent=call["agent"], team=call["team"] or 0,
                                                 policy=call["policy"]))
        elif call["call"] == "command":
            self.command(call["agent"] + "/cmd_vel", twist(call))
        elif call["call"] == "strike":
            self.command(call["agent"] + "/strike", Empty())
        else:
            self.fail("the battle has no such call: " + text)
        return call["call"]

    def command(self, name, message):
        """Publishes it, and waits until the future depends on it."""
        if name not in self.publishers:
            self.publishers[name] = rospy.Publisher(name, type(message), queue_size=1)
        topic = self.publishers[name]
        wait_until(lambda: topic.get_num_connections() > 0, f"somebody listens to {name}")
        before = self.world.get_world().state_hash
        topic.publish(message)
        wait_until(lambda: self.world.get_world().state_hash != before, f"{name} is heard")

    @staticmethod
    def listens(prefix, topics):
        """Whether world_server sends all of them to a node of that name: the master only knows who
        wants to hear."""
        server = xmlrpc.client.ServerProxy(rosgraph.Master("/battle_test").lookupNode("/world_server"))
        _, _, connections = server.getBusInfo("/battle_test")
        heard = {topic for _, node, direction, _, topic, *_ in connections
                 if direction == "o" and node.startswith(prefix)}
        return set(topics) <= heard

    def read(self, path):
        """What the bag says; the frames must be where the states say."""
        states, events, frames, clock, infos, journal, hashes = [], [], {}, [], [], [], []
        kept = {"/agents": states, "/agent_events": events, "/world/info": infos,
                "/world/journal": journal, "/world/state_hash": hashes}
        with rosbag.Bag(str(path)) as bag:
            for topic, message, _ in bag.read_messages():
                if topic in kept:
                    kept[topic].append(message)
                elif topic == "/clock":
                    clock.append(message.clock)
                elif topic == "/tf":
                    for transform in message.transforms:
                        key = (transform.header.stamp, transform.child_frame_id)
                        frames[key] = transform
        self.assertEqual(sorted(clock), clock)
        self.assertGreater(len(states), 100)
        # A pause tells its step once more, under a stamp of its own.
        steps = [state.step for state in states]
        self.assertEqual(sorted(steps), steps)
        stamps = [state.header.stamp for state in states]
        self.assertEqual(sorted(set(stamps)), stamps)
        compared = 0
        for state in states:
            for agent in state.agents:
                frame = frames.get((state.header.stamp, agent.name + "/base_link"))
                if frame is None or frame.header.frame_id != "map":
                    continue
                compared += 1
                for axis in "xyz":
                    self.assertAlmostEqual(getattr(agent.pose.position, axis),
                                           getattr(frame.transform.translation, axis), places=6)
        self.assertGreater(compared, 1000)
        told = [event.step for event in events]
        self.assertEqual(sorted(told), told)
        self.assertLessEqual(told[-1], steps[-1])
        # No call is missing.
        numbers = [entry.number for entry in journal]
        self.assertEqual(list(range(numbers[0], numbers[0] + len(numbers))), numbers)
        return Battle(infos[-1], states, events, journal, hashes)

    def play(self, path, states):
        """rosbag play tells the same states, under another name."""
        with Collector("/replayed/agents", AgentStates) as replayed:
            player = subprocess.Popen(["rosbag", "play", "--quiet", "--delay", "1", "--rate", "4",
                                       str(path), "--topics", "/agents",
                                       "/agents:=/replayed/agents"], start_new_session=True)
            try:
                replayed.wait_for(lambda m: m.header.stamp == states[-1].header.stamp)
            finally:
                os.killpg(player.pid, signal.SIGINT)
                player.wait(TIMEOUT_S)
            heard = replayed.messages()
            # A subscriber that comes late may miss the first ones, and no other.
            self.assertGreater(len(heard), len(states) // 2)
            # The bag makes message types of its own: their words are the same.
            for recorded, told in zip(states[-len(heard):], heard):
                self.assertEqual(str(recorded), str(told))

    def test_a_snapshot_brings_the_battle_back(self):
        self.line_up()
        self.assert_ok(self.world.step(steps=200))
        saved = self.assert_ok(self.world.save_snapshot(name="middle"))
        self.assertEqual(["middle"], saved.snapshots)
        first = self.assert_ok(self.world.step(steps=300, hash=True))
        for _ in range(2):
            restored = self.assert_ok(self.world.restore_snapshot(name="middle"))
            self.assertEqual((saved.state_hash, 200, SEED),
                             (restored.state_hash, restored.episode_step, restored.seed))
            again = self.assert_ok(self.world.step(steps=300, hash=True))
            self.assertEqual(first.state_hash, again.state_hash)
        # ROS time and the count of steps went on.
        self.assertEqual(first.step + 600, again.step)
        self.assertGreater(again.stamp, first.stamp)
        self.refuse_snapshots()

    def refuse_snapshots(self):
        self.assert_refused(self.world.restore_snapshot(name="absent"), Status.NOT_FOUND, "absent",
                            "middle")
        self.assert_refused(self.world.save_snapshot(name="a" * 65), Status.INVALID_ARGUMENT, "64")
        for i in range(7):
            self.assert_ok(self.world.save_snapshot(name=f"more_{i}"))
        self.assert_refused(self.world.save_snapshot(), Status.RESOURCE_EXHAUSTED, "8", "middle")
        self.assert_ok(self.world.save_snapshot(name="middle"))


if __name__ == "__main__":
    run("battle_test", BattleTest)
