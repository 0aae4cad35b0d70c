"""A recorded episode of a robot that is driven for some seconds."""

import time

from peer import WORLDS
from ros import Launch, call, ros


def episode():
    """The bag, recorded where it is not there yet."""
    bag = WORLDS / "patrol.bag"
    if bag.exists():
        return bag
    with Launch("episode.launch", size=64, seed=4, generate="Flat grassland, a wood in the north.",
                environment="A wheeled robot waits in the center, two sheep graze."):
        call("rosservice call /start_episode '{name: patrol, seed: 4}'")
        drive = ros("rostopic pub -r 10 /robot/cmd_vel geometry_msgs/Twist "
                    "'{linear: {x: 1.0}, angular: {z: 0.3}}'")
        call("rostopic echo -n 1 /robot/cmd_vel")  # the first command is there
        time.sleep(6)
        drive.terminate()
        call("rosservice call /stop_episode", tries=3)
    found = next((WORLDS / "ros").rglob("patrol.bag"))
    found.rename(bag)
    return bag


def bag_as_mcap(bag, path):
    """(path, messages): a bag's messages in an MCAP file of the profile ros1, as they are."""
    from mcap.writer import Writer
    from rosbags.rosbag1 import Reader
    count = 0
    with Reader(bag) as reader, open(path, "wb") as file:
        writer = Writer(file)
        writer.start(profile="ros1", library="peers")
        channels = {}
        for c in reader.connections:
            schema = writer.register_schema(c.msgtype.replace("/msg/", "/"), "ros1msg",
                                            c.msgdef.data.encode())
            channels[c.id] = writer.register_channel(c.topic, "ros1", schema)
        for connection, stamp, data in reader.messages():
            writer.add_message(channels[connection.id], stamp, data, stamp)
            count += 1
        writer.finish()
    return path, count


if __name__ == "__main__":
    print(episode())
