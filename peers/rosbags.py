"""rosbags reads a recorded episode and writes it again; replay_episode then proves every state."""
# debian: python3-rosbag
# pypi: rosbags==0.11.9

import importlib.metadata
import re

from rosbags.rosbag1 import Reader, Writer

from episode import episode
from peer import FOLDER, Peer, run
from ros import ros_says


def main():
    peer = Peer("rosbags", importlib.metadata.version("rosbags"), "an episode's bag (LZ4)",
                "write bags without LZ4, which ROS 1 does not read from rosbags (findings)")
    bag = episode()
    written = FOLDER / "written.bag"
    count, times = 0, []
    with Reader(bag) as reader, Writer(written) as writer:
        connections = {c.id: writer.add_connection(
            c.topic, c.msgtype, msgdef=c.msgdef.data, md5sum=c.digest, callerid=c.ext.callerid,
            latching=c.ext.latching) for c in reader.connections}
        for connection, stamp, data in reader.messages():
            writer.write(connections[connection.id], stamp, data)
            times.append(stamp)
            count += 1
        topics = len(reader.topics)
    said = run("/usr/bin/python3", "-c",
               f"import rosbag; print(rosbag.Bag({str(bag)!r}).get_message_count())").stdout.split()
    peer.check("messages", said and int(said[-1]) == count and times == sorted(times),
               f"{count} of {said[-1] if said else '?'} of {topics} topics, in order of time")
    for name, path in (("replay of the bag", bag), ("replay of what it wrote", written)):
        said = ros_says(f"rosrun latticeworld replay_episode {path}")
        proof = re.search(r"(PROVEN|NO PROOF|DIFFERS).*", said)
        peer.check(name, proof and proof.group(1) == "PROVEN", proof.group(0) if proof else said)
    peer.finish()


main()
