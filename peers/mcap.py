"""mcap takes the messages of a recorded episode and gives them back by its ROS 1 decoder."""
# pypi: mcap==1.6.0 mcap-ros1-support==0.9.0 rosbags==0.11.9

import hashlib
import importlib.metadata

from mcap.reader import make_reader
from mcap.writer import Writer
from mcap_ros1.decoder import DecoderFactory
from rosbags.rosbag1 import Reader

from episode import episode
from peer import FOLDER, Peer


def main():
    peer = Peer("mcap", importlib.metadata.version("mcap"),
                "an episode's bag, by rosbags, with the profile `ros1`")
    path = FOLDER / "episode.mcap"
    given, count = hashlib.sha256(), 0
    with Reader(episode()) as reader, open(path, "wb") as file:
        writer = Writer(file)
        writer.start(profile="ros1", library="peers")
        channels = {}
        for c in reader.connections:
            schema = writer.register_schema(c.msgtype.replace("/msg/", "/"), "ros1msg",
                                            c.msgdef.data.encode())
            channels[c.id] = writer.register_channel(c.topic, "ros1", schema)
        for connection, stamp, data in reader.messages():
            writer.add_message(channels[connection.id], stamp, data, stamp)
            given.update(stamp.to_bytes(8, "little") + data)
            count += 1
        writer.finish()
    kept, decoded, topics = hashlib.sha256(), 0, set()
    with open(path, "rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for schema, channel, message, value in reader.iter_decoded_messages():
            kept.update(message.log_time.to_bytes(8, "little") + message.data)
            decoded += value is not None
            topics.add(channel.topic)
    peer.check("messages", kept.digest() == given.digest() and decoded == count,
               f"{decoded} of {count} of {len(topics)} topics decoded, bytes and times the same")
    peer.finish()


main()
