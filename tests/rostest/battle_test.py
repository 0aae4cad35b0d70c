#!/usr/bin/python3
"""A battle of two teams: recorded, replayed from its bag, and fought again to the same end."""

import os
import pathlib
import signal
import subprocess
import tempfile

import rosbag
import rosgraph
from geometry_msgs.msg import Point

from latticeworld.msg import AgentEvent, AgentStates, Status
from world_client import TIMEOUT_S, Collector, ServerTest, run, wait_until

FIELD = {"layout": "Flat grassland everywhere.", "environment": "A sunny summer noon.",
         "size": 96.0, "seed": 9}
RECORDED = ("/clock", "/tf", "/agents", "/agent_events", "/world/info", "/elements")
SEED = 4


class BattleTest(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.world.generate(**FIELD)

    def setUp(self):
        self.assertTrue(self.world.pause().success)

    def line_up(self, seed=SEED):
        """Two teams before each other, from the start state on, paused."""
        self.assert_ok(self.world.reset_world(seed=seed))
        for team, species, row in ((3, "goblin", -5.0), (4, "ancient_warrior", 5.0)):
            for i in range(5):
                answer = self.world.spawn_agent(species=species, team=team, state="attacking",
                                                position=Point(x=3.0 * i - 6.0, y=row))
                self.assertIn(answer.status.code, (Status.OK, Status.FAILED_PRECONDITION))
        self.assert_ok(self.world.set_policy(team=4, policy="pursuer"))

    def test_a_recorded_battle_replays(self):
        self.line_up()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "battle.bag")
            self.record(path)
            end = self.assert_ok(self.world.get_world())
            states, events = self.read(path)
            self.play(path, states)
        # Events and states tell one story: who is dead has died, and who was hurt was hit.
        died = {event.agent for event in events if event.kind == "died"}
        struck = {event.agent for event in events if event.kind == "hit"}
        for agent in states[-1].agents:
            self.assertEqual(agent.health == 0.0, agent.name in died, agent.name)
            if agent.health < 1.0:
                self.assertIn(agent.name, struck)
        self.assertTrue(struck)
        self.assertTrue(any(event.kind == "attacked" for event in events))
        # Fought again with the same seed, it ends in the same state.
        self.line_up()
        again = self.assert_ok(self.world.step(steps=end.episode_step, hash=True))
        self.assertEqual(end.state_hash, again.state_hash)
        # And with another seed it does not.
        self.line_up(seed=SEED + 1)
        other = self.assert_ok(self.world.step(steps=end.episode_step, hash=True))
        self.assertNotEqual(end.state_hash, other.state_hash)

    def record(self, path):
        """Until somebody has been hit and some time more."""
        with Collector("agent_events", AgentEvent) as events, \
                Collector("agents", AgentStates) as states:
            recorder = subprocess.Popen(["rosbag", "record", "-O", str(path), *RECORDED],
                                        start_new_session=True)
            try:
                wait_until(lambda: self.listens("/record", RECORDED), "the recorder listens")
                for collector in (events, states):
                    collector.wait_until_connected()
                self.assertTrue(self.world.unpause().success)
                hit = events.wait_for(lambda m: m.kind == "hit")
                states.wait_for(lambda m: m.step >= hit.step + 300)
                self.assertTrue(self.world.pause().success)
            finally:
                os.killpg(recorder.pid, signal.SIGINT)
                recorder.wait(TIMEOUT_S)
            wait_until(path.exists, "the bag is closed")

    @staticmethod
    def listens(prefix, topics):
        _, subscribers, _ = rosgraph.Master("/battle_test").getSystemState()
        heard = {topic for topic, nodes in subscribers
                 if any(node.startswith(prefix) for node in nodes)}
        return set(topics) <= heard

    def read(self, path):
        """States and events of the bag; the frames must be where the states say."""
        states, events, frames, clock = [], [], {}, []
        with rosbag.Bag(str(path)) as bag:
            for topic, message, _ in bag.read_messages():
                if topic == "/agents":
                    states.append(message)
                elif topic == "/agent_events":
                    events.append(message)
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
        return states, events

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
