"""Reads an episode with the PyPI package rosbags alone, types and all from the bag itself, and
prints what it found as JSON. Usage: python read_with_rosbags.py BAG"""

import json
import pathlib
import sys

from rosbags.highlevel import AnyReader


def main():
    found = {"counts": {}, "agents": [], "calls": [], "files": []}
    with AnyReader([pathlib.Path(sys.argv[1])]) as reader:
        for connection, _, raw in reader.messages():
            message = reader.deserialize(raw, connection.msgtype)
            topic = connection.topic
            found["counts"][topic] = found["counts"].get(topic, 0) + 1
            if topic == "/agents":
                found["agents"].append(len(message.agents))
            elif topic == "/world/journal":
                found["calls"].append(json.loads(message.call)["call"])
            elif topic == "/episode/world":
                found["files"] = [file.path for file in message.files]
            elif topic == "/episode/start":
                found["name"] = message.name
                found["parameters"] = sorted(json.loads(message.parameters))
    print(json.dumps(found))


if __name__ == "__main__":
    main()
