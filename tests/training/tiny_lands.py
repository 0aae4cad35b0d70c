"""Small height maps for the tests, each rising to a side of the world, with what is said of them."""

import json
import os

import numpy
from PIL import Image

SIDES = {"north": (-1, 0), "south": (1, 0), "west": (0, -1), "east": (0, 1)}


def land(side, seed, samples=24):
    """(samples x samples) uint16, rising to a side of the world."""
    random = numpy.random.RandomState(seed)
    down, right = SIDES[side]
    line = numpy.linspace(-1, 1, samples)
    height = down * line[:, None] + right * line[None] + 0.3 * random.randn(samples, samples)
    return (32768 + 9000 * height).astype(numpy.uint16)


def caption_of(side):
    return "Where is it high?", f"It is highest in the {side}."


def layout_of(side):
    """Four lines of four letters: a forest on the high side of the grass."""
    down, right = SIDES[side]
    rows = ["".join("F" if down * (row - 1.5) + right * (column - 1.5) > 1 else "G" for column in range(4))
            for row in range(4)]
    return "Forest where it is high.", "\n".join(rows)


def write_split(folder, task, split, count=16, seed=0, said_of=caption_of):
    """A file of records as `latticeworld dataset` writes one, the first of them without a picture. said_of(side): what
    is asked and what is answered. Returns the file's path."""
    for part in (task, "images"):
        os.makedirs(os.path.join(folder, part), exist_ok=True)
    records = [{"messages": [{"role": "user", "content": "?"}, {"role": "assistant", "content": "!"}], "images": []}]
    for i in range(count):
        side = list(SIDES)[i % 4]
        name = f"images/{seed + i}.png"
        Image.fromarray(land(side, seed + i)).save(os.path.join(folder, name))
        asked, said = said_of(side)
        records.append({"messages": [{"role": "user", "content": asked}, {"role": "assistant", "content": said}],
                        "images": [name]})
    path = os.path.join(folder, task, split + ".jsonl")
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(json.dumps(record) + "\n" for record in records)
    return path
