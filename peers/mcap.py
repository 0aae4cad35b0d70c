"""mcap takes the messages of a recorded episode and gives them back by its ROS 1 decoder."""
# pypi: mcap==1.6.0 mcap-ros1-support==0.9.0 rosbags==0.11.9

import hashlib
import importlib.metadata

from mcap.reader import make_reader
from mcap_ros1.decoder import DecoderFactory
from rosbags.rosbag1 import Reader

from episode import bag_as_mcap, episode
from peer import FOLDER, Peer


def main():
    peer = Peer("mcap", importlib.metadata.version("mcap"),
                "an episode's bag, by rosbags, with the profile `ros1`")
    bag = episode()
    path, count = bag_as_mcap(bag, FOLDER / "episode.mcap")
    given = hashlib.sha256()
    with Reader(bag) as reader:
        for _, stamp, data in reader.messages():
            given.update(stamp.to_bytes(8, "little") + data)
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
