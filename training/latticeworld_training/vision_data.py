"""Height maps with what is said of them, from the JSON Lines that `latticeworld dataset` writes."""

import json
import os
from dataclasses import dataclass

import numpy
import torch
from PIL import Image

from .chat_data import batch_tensors, encode_conversation


@dataclass
class Picture:
    height: numpy.ndarray  # (side, side) float32, normalized
    messages: list  # of (role, content)

    def answer(self):
        return next(content for role, content in self.messages if role == "assistant")


def read_height(path, side):
    """(side, side) float32, mean 0 and standard deviation 1: means over cells of the picture, a sample in two cells
    counting in each by its share."""
    image = numpy.asarray(Image.open(path)).astype(numpy.float64)
    if image.ndim != 2:
        raise ValueError(f"{path} has {image.shape} samples; a height map is grey")
    image = _shares(image.shape[0], side) @ image @ _shares(image.shape[1], side).T
    return ((image - image.mean()) / max(float(image.std()), 1e-6)).astype(numpy.float32)


def _shares(samples, side):
    """(side, samples): how much of each of `side` cells each sample makes up."""
    cells, edges = numpy.arange(side)[:, None] * (samples / side), numpy.arange(samples)[None]
    overlaps = numpy.minimum(cells + samples / side, edges + 1) - numpy.maximum(cells, edges)
    return overlaps.clip(0) * (side / samples)


# What LatticeWorld says of a height map that it shows, after what it says of it in words.
RELIEF_WORDS = "Heights of the land: "
PICTURE_WORDS = "The picture shows the same heights: north is up, black is the lowest ground, white the highest."


def told_of_picture(content):
    """A message as LatticeWorld writes it for a model that sees; one that says nothing of the relief stays."""
    lines = content.split("\n")
    for number, line in enumerate(lines):
        if line.startswith(RELIEF_WORDS):
            return "\n".join(lines[: number + 1] + [PICTURE_WORDS] + lines[number + 1 :])
    return content


def read_pictures(path, side, images=None):
    """Records that have a height map; its file is the first of their images, relative to `images`: the data set's
    folder, by default the one above the file's. Raises ValueError naming file and line."""
    images = images or os.path.dirname(os.path.dirname(os.path.abspath(path)))
    pictures, known = [], {}
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            try:
                record = json.loads(line)
                if not record.get("images"):
                    continue
                name = record["images"][0]
                if name not in known:
                    known[name] = read_height(os.path.join(images, name), side)
                messages = [(message["role"], told_of_picture(message["content"])) for message in record["messages"]]
                pictures.append(Picture(known[name], messages))
            except (ValueError, KeyError, TypeError, OSError) as error:
                raise ValueError(f"{path}, line {number}: no height map with words: {error}") from error
    return pictures


def height_tensor(pictures, device=None):
    return torch.from_numpy(numpy.stack([picture.height for picture in pictures])[:, None]).to(device)


def caption_tensors(tokenizer, captions, length, device=None):
    """(count, most) tokens and (count) lengths of captions, each cut at `length`."""
    encoded = [tokenizer.encode(caption)[:length] or [0] for caption in captions]
    tokens = torch.zeros(len(encoded), max(map(len, encoded)), dtype=torch.long)
    for row, some in enumerate(encoded):
        tokens[row, : len(some)] = torch.tensor(some)
    return tokens.to(device), torch.tensor([len(some) for some in encoded], device=device)


def conversation_tensors(tokenizer, pictures, device=None):
    """As chat_data.batch_tensors."""
    return batch_tensors([encode_conversation(tokenizer, picture.messages) for picture in pictures], device)
