#!/usr/bin/python3
"""rosbag record -a of a running world reads back whole."""

import os
import pathlib
import signal
import subprocess
import tempfile

import rosbag
import rosgraph
from diagnostic_msgs.msg import DiagnosticArray

from world_client import TIMEOUT_S, Collector, WorldTest, run, wait_until

LATCHED = {"/world/info": "latticeworld/WorldInfo", "/world/layout": "latticeworld/Layout",
           "/world/environment": "latticeworld/Environment", "/map": "nav_msgs/OccupancyGrid",
           "/world/height_map": "grid_map_msgs/GridMap", "/world/height_image": "sensor_msgs/Image",
           "/octomap_full": "octomap_msgs/Octomap", "/octomap_binary": "octomap_msgs/Octomap",
           "/world/markers": "visualization_msgs/MarkerArray",
           "/world/changes": "latticeworld/SceneChanges",
           "/elements": "latticeworld/ElementStates"}
FLOWING = {"/clock": "rosgraph_msgs/Clock", "/tf": "tf2_msgs/TFMessage",
           "/agents": "latticeworld/AgentStates",
           "/agents/markers": "visualization_msgs/MarkerArray",
           "/diagnostics": "diagnostic_msgs/DiagnosticArray"}


class BagTest(WorldTest):
    def test_a_record_of_all_topics_reads_back_whole(self):
        with tempfile.TemporaryDirectory() as folder:
            bag_path = pathlib.Path(folder, "world.bag")
            recorder = subprocess.Popen(["rosbag", "record", "-a", "-O", str(bag_path)],
                                        start_new_session=True)
            try:
                wait_until(lambda: self.subscribed(set(LATCHED) | set(FLOWING)),
                           "the recorder listens to every topic")
                # The recorder is known to the master before it is connected: the rarest topic
                # tells by its count that some time went by.
                diagnostics = Collector("/diagnostics", DiagnosticArray)
                diagnostics.wait_for(lambda m: len(diagnostics.messages()) >= 5)
            finally:
                # rosbag is a script that runs the recorder: both get the signal, as by Ctrl-C.
                os.killpg(recorder.pid, signal.SIGINT)
                recorder.wait(TIMEOUT_S)
            # The script may end before the recorder, which renames the file when it is whole.
            wait_until(bag_path.exists, "the bag is closed")
            self.read(bag_path)

    @staticmethod
    def subscribed(topics):
        _, subscribers, _ = rosgraph.Master("/bag_test").getSystemState()
        recorded = {topic for topic, nodes in subscribers
                    if any(node.startswith("/record") for node in nodes)}
        return topics <= recorded

    def read(self, bag_path):
        counts, clock, stamps = {}, [], []
        with rosbag.Bag(str(bag_path)) as bag:
            topics = bag.get_type_and_topic_info()[1]
            types = {topic: info.msg_type for topic, info in topics.items()}
            for topic, message, _ in bag.read_messages():
                counts[topic] = counts.get(topic, 0) + 1
                if topic == "/clock":
                    clock.append(message.clock)
                elif topic == "/agents":
                    stamps.append(message.header.stamp)
                elif topic == "/world/info":
                    self.assertEqual(self.world.get_world().info.world_id, message.world_id)
        for topic, message_type in {**LATCHED, **FLOWING}.items():
            self.assertEqual(message_type, types.get(topic), topic)
            self.assertGreaterEqual(counts[topic], 1 if topic in LATCHED else 2, topic)
        self.assertEqual(sorted(clock), clock)
        self.assertGreater(counts["/agents"], 50)
        # Every state bears a time that the clock has told.
        told = set(clock)
        untold = [stamp for stamp in stamps if clock[0] <= stamp <= clock[-1] and stamp not in told]
        self.assertEqual([], untold)


if __name__ == "__main__":
    run("bag_test", BagTest)
