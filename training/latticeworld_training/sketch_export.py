"""Writes a trained sketch network as ONNX, for `latticeworld generate --sketch-model`.

  python3 -m latticeworld_training.sketch_export --run runs/sketch --side 512 --out sketch.onnx
"""

import argparse
import copy

import onnx
import torch
from torch import nn
from torch.nn import functional

from .sketch_training import read_generator

OPSET = 11  # what readers as old as OpenCV 4.6 take


class _Folded(nn.Module):
    """A residual block whose gain is part of its second convolution."""

    def __init__(self, block):
        super().__init__()
        self.first, self.second = block.first, block.second

    def forward(self, x):
        y = functional.leaky_relu(self.first(functional.leaky_relu(x, 0.2)), 0.2)
        return x + self.second(y)


def _fold(generator):
    generator = copy.deepcopy(generator).cpu().eval()
    for i, block in enumerate(generator.blocks):
        with torch.no_grad():
            block.second.weight *= block.gain
            block.second.bias *= block.gain
        generator.blocks[i] = _Folded(block)
    return generator


def _name_equal_weights_twice(path):
    """Weights that are equal are written once, under a second name by an Identity, which OpenCV does not read."""
    model = onnx.load(path)
    weights = {weight.name: weight for weight in model.graph.initializer}
    for node in [node for node in model.graph.node if node.op_type == "Identity" and node.input[0] in weights]:
        weight = onnx.TensorProto()
        weight.CopyFrom(weights[node.input[0]])
        weight.name = node.output[0]
        model.graph.initializer.append(weight)
        model.graph.node.remove(node)
    onnx.checker.check_model(model)
    onnx.save(model, path)


def export(generator, side, path):
    """side: N of the network's only input, 1 x 3 x N x N."""
    generator = _fold(generator)
    with torch.no_grad():
        torch.onnx.export(generator, torch.ones(1, 3, side, side), path, opset_version=OPSET,
                          input_names=["sketch"], output_names=["height"], do_constant_folding=True)
    _name_equal_weights_twice(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--run", required=True, help="directory of a training run")
    parser.add_argument("--side", type=int, default=512, help="samples a side, a multiple of 16 [512]")
    parser.add_argument("--out", required=True, help="the file to write")
    given = parser.parse_args()
    export(read_generator(given.run), given.side, given.out)


if __name__ == "__main__":
    main()
