"""Pairs of sketch and land, as `latticeworld sketch-pairs` writes them: NAME_sketch.png beside NAME_height.png."""

import pathlib

import numpy
import torch
from PIL import Image
from torch.nn import functional

# A standard deviation of heights, in what the network gives: nearly all of them then lie in [0, 1].
SPREAD = 0.2
INK = 128  # a channel below it has no light: red where there is a stroke, blue where that is a ridge


class SketchPairs:
    """All pairs of a directory, in memory: 256 x 256 take 0.2 MB."""

    def __init__(self, directory=None):
        self.names, self.strokes, self.heights = [], [], []
        if directory is None:
            return
        for height_file in sorted(pathlib.Path(directory).glob("*_height.png")):
            sketch_file = height_file.with_name(height_file.name.replace("_height", "_sketch"))
            if sketch_file.exists():
                self._add(height_file, sketch_file)
        if not self.names:
            raise ValueError(f"{directory} holds no NAME_height.png beside NAME_sketch.png")

    def _add(self, height_file, sketch_file):
        strokes, height = read_strokes(sketch_file), read_height(height_file)
        if strokes.shape != height.shape or height.shape[0] != height.shape[1]:
            raise ValueError(f"{sketch_file} has {strokes.shape} pixels and {height_file} has {height.shape}; "
                             "both must be squares of one size")
        if self.heights and height.shape != self.heights[0].shape:
            raise ValueError(f"{height_file} has {height.shape} pixels, the pairs before {self.heights[0].shape}")
        self.names.append(height_file.name[: -len("_height.png")])
        self.strokes.append(strokes)
        self.heights.append(height.astype(numpy.float16))

    def side(self):
        return len(self.heights[0])

    def halved(self):
        """The same on half the grid; strokes stay strokes. Sides must be even."""
        half, side = SketchPairs(), self.side() // 2
        half.names = list(self.names)
        for strokes, height in zip(self.strokes, self.heights):
            # A ridge outlasts a valley, and both the paper.
            half.strokes.append(strokes.reshape(side, 2, side, 2).max(axis=(1, 3)))
            mean = height.astype(numpy.float32).reshape(side, 2, side, 2).mean(axis=(1, 3))
            half.heights.append(mean.astype(numpy.float16))
        return half

    def __len__(self):
        return len(self.names)

    def batch(self, indices, random=None):
        """(count, 3, N, N) strokes and (count, 1, N, N) heights. random: a numpy RandomState that turns, mirrors,
        enlarges and draws as hands do; None: as they are."""
        inputs, targets = [], []
        for i in indices:
            strokes, height = self.strokes[i], self.heights[i].astype(numpy.float32)
            if random is not None:
                strokes, height = _vary(strokes, height, random)
            inputs.append(colors_of(strokes))
            targets.append(normalize(height)[None])
        return torch.from_numpy(numpy.stack(inputs)), torch.from_numpy(numpy.stack(targets))


def read_strokes(path):
    """(rows x cols), 0 paper, 1 valley (blue), 2 ridge (black)."""
    rgb = numpy.asarray(Image.open(path).convert("RGB"))
    strokes = numpy.zeros(rgb.shape[:2], numpy.uint8)
    red_paper, blue_paper = rgb[..., 0] >= INK, rgb[..., 2] >= INK
    strokes[~red_paper & blue_paper] = 1
    strokes[~red_paper & ~blue_paper] = 2
    return strokes


def read_height(path):
    """(rows x cols), [0, 1]."""
    return numpy.asarray(Image.open(path)).astype(numpy.float32) / 65535


def colors_of(strokes):
    """(3, rows, cols): red, green, blue of the strokes, as SketchModel feeds them."""
    paper = (strokes == 0).astype(numpy.float32)
    return numpy.stack([paper, paper, (strokes != 2).astype(numpy.float32)])


def normalize(height):
    """A sketch tells neither how high the land is nor how steep: mean 0.5 and one spread for all."""
    return (0.5 + SPREAD * (height - height.mean()) / max(float(height.std()), 1e-6)).astype(numpy.float32)


def _vary(strokes, height, random):
    side = len(height)
    if random.rand() < 0.3:  # a part of it, enlarged: the same forms at another scale
        part = random.randint(side // 2, side)
        r, c = random.randint(0, side - part, 2)
        strokes = strokes[r : r + part, c : c + part]
        index = numpy.arange(side) * part // side
        strokes = strokes[index][:, index]
        piece = torch.from_numpy(height[r : r + part, c : c + part])[None, None]
        height = functional.interpolate(piece, (side, side), mode="bilinear", align_corners=False)[0, 0].numpy()
    if random.rand() < 0.4:  # a thicker pen
        inks = torch.from_numpy(numpy.stack([strokes == 1, strokes == 2]).astype(numpy.float32))[None]
        inks = functional.max_pool2d(inks, 3, 1, 1)[0].numpy()
        strokes = numpy.where(inks[1] > 0, 2, inks[0]).astype(numpy.uint8)
    if random.rand() < 0.5:  # what nobody drew
        strokes = strokes.copy()
        for _ in range(random.randint(1, 5)):
            size = random.randint(side // 16, side // 4)
            r, c = random.randint(0, side - size, 2)
            strokes[r : r + size, c : c + size] = 0
    turns = random.randint(4)
    strokes, height = numpy.rot90(strokes, turns), numpy.rot90(height, turns)
    if random.rand() < 0.5:
        strokes, height = strokes[:, ::-1], height[:, ::-1]
    return numpy.ascontiguousarray(strokes), numpy.ascontiguousarray(height)
