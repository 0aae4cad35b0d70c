"""Writes small ONNX networks for the tests of SketchModel, and what numpy says they give.

usage: make_sketch_models.py DIRECTORY

unet.onnx is a real encoder and decoder with a skip connection: its first convolution tells ridges,
valleys and paper apart, the ones below carry them into the land around. Its weights are made, not
trained: ridges come out higher than valleys. The others are networks that SketchModel has to refuse.
"""
import pathlib
import sys

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

SIDE = 64
# Of the version that readers as old as OpenCV 4.6 take.
OPSET = 11
IR_VERSION = 6


def gaussian(size, sigma):
    x = np.arange(size) - size // 2
    line = np.exp(-0.5 * (x / sigma) ** 2)
    kernel = np.outer(line, line)
    return kernel / kernel.sum()


def make_weights():
    """Convolutions as (output, input, rows, columns), and their biases."""
    random = np.random.default_rng(20260101)

    def noise(*shape):
        return random.normal(0.0, 0.01, shape)

    # Channels 0 and 1 after the first one: a ridge is there, a valley is there.
    first = noise(8, 3, 3, 3)
    first[0, 0, 1, 1] = -1.0  # black takes away red and blue,
    first[0, 2, 1, 1] = -1.0
    first[1, 0, 1, 1] = -1.0  # blue takes away red alone
    first[1, 2, 1, 1] = 1.0
    first_bias = noise(8)
    first_bias[0] = 1.0
    # On half the grid: each spreads.
    deep = noise(8, 8, 5, 5)
    for channel in (0, 1):
        deep[channel, channel] += 2.0 * gaussian(5, 2.0)
    deep_bias = noise(8)
    # The strokes themselves and their surroundings, together.
    last = noise(1, 16, 3, 3)
    last[0, 0] += 1.5 * gaussian(3, 1.0)
    last[0, 1] -= 1.5 * gaussian(3, 1.0)
    last[0, 8] += 2.0 * gaussian(3, 1.0)
    last[0, 9] -= 2.0 * gaussian(3, 1.0)
    last_bias = noise(1)
    return {
        name: array.astype(np.float32)
        for name, array in (("first", first), ("first_bias", first_bias), ("deep", deep),
                            ("deep_bias", deep_bias), ("last", last), ("last_bias", last_bias))
    }


def convolve(x, weights, bias):
    """x: (channels, rows, columns), zeros around it."""
    reach = weights.shape[2] // 2
    padded = np.pad(x, ((0, 0), (reach, reach), (reach, reach)))
    rows, cols = x.shape[1:]
    result = np.zeros((weights.shape[0], rows, cols)) + bias[:, None, None]
    for dy in range(weights.shape[2]):
        for dx in range(weights.shape[3]):
            window = padded[:, dy:dy + rows, dx:dx + cols]
            result += np.einsum("oi,ihw->ohw", weights[:, :, dy, dx], window)
    return result


def run_in_numpy(weights, x):
    w = {name: array.astype(np.float64) for name, array in weights.items()}
    skip = np.maximum(convolve(x, w["first"], w["first_bias"]), 0.0)
    half = skip.reshape(8, SIDE // 2, 2, SIDE // 2, 2).mean(axis=(2, 4))
    deep = np.maximum(convolve(half, w["deep"], w["deep_bias"]), 0.0)
    up = deep.repeat(2, axis=1).repeat(2, axis=2)
    out = convolve(np.concatenate([skip, up]), w["last"], w["last_bias"])
    return 1.0 / (1.0 + np.exp(-out[0]))


def conv(name, source, target, size):
    return helper.make_node("Conv", [source, name, name + "_bias"], [target], kernel_shape=[size, size],
                            pads=[size // 2] * 4)


def tensor(name, channels, side):
    return helper.make_tensor_value_info(name, TensorProto.FLOAT, [1, channels, side, side])


def save(path, nodes, input_channels, output_channels, constants):
    graph = helper.make_graph(
        nodes, "sketch", [tensor("sketch", input_channels, SIDE)],
        [tensor("height", output_channels, SIDE)],
        [numpy_helper.from_array(array, name) for name, array in constants.items()])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)])
    model.ir_version = IR_VERSION
    onnx.checker.check_model(model)
    onnx.save(model, str(path))


def make_unet(path, weights):
    nodes = [
        conv("first", "sketch", "a", 3),
        helper.make_node("Relu", ["a"], ["skip"]),
        helper.make_node("AveragePool", ["skip"], ["half"], kernel_shape=[2, 2], strides=[2, 2]),
        conv("deep", "half", "b", 5),
        helper.make_node("Relu", ["b"], ["deep_out"]),
        helper.make_node("Upsample", ["deep_out"], ["up"], mode="nearest") if OPSET < 10 else
        helper.make_node("Resize", ["deep_out", "roi", "scales"], ["up"], mode="nearest",
                         coordinate_transformation_mode="asymmetric", nearest_mode="floor"),
        helper.make_node("Concat", ["skip", "up"], ["both"], axis=1),
        conv("last", "both", "c", 3),
        helper.make_node("Sigmoid", ["c"], ["height"]),
    ]
    constants = dict(weights)
    constants["roi"] = np.zeros(0, np.float32)
    constants["scales"] = np.array([1, 1, 2, 2], np.float32)
    save(path, nodes, 3, 1, constants)


def make_pointwise(path, input_channels, output_channels, factor, bias, then=None):
    """One 1 x 1 convolution, and `then`."""
    nodes = [conv("only", "sketch", "height" if then is None else "a", 1)]
    if then is not None:
        nodes.append(helper.make_node(then, ["a"], ["height"]))
    save(path, nodes, input_channels, output_channels, {
        "only": np.full((output_channels, input_channels, 1, 1), factor, np.float32),
        "only_bias": np.full(output_channels, bias, np.float32),
    })


def make_slopes(path):
    """Land that is the same under all strokes: a valley down the middle, twice as steep to the east of it."""
    offset = np.arange(SIDE) - (SIDE - 1) / 2
    land = np.where(offset > 0, 2 * offset, -offset) / SIDE
    save(path, [conv("only", "sketch", "a", 1), helper.make_node("Add", ["a", "land"], ["height"])], 3, 1, {
        "only": np.zeros((1, 3, 1, 1), np.float32),
        "only_bias": np.zeros(1, np.float32),
        "land": np.broadcast_to(land, (1, 1, SIDE, SIDE)).astype(np.float32),
    })


def make_sketch():
    """Strokes, (SIDE x SIDE): 0 none, 1 valley, 2 ridge."""
    sketch = np.zeros((SIDE, SIDE), np.uint8)
    for row in range(SIDE):
        sketch[row, 16 + row // 8] = 1
        sketch[row, 44 - row // 8] = 2
    return sketch


def main():
    directory = pathlib.Path(sys.argv[1])
    directory.mkdir(parents=True, exist_ok=True)
    weights = make_weights()
    make_unet(directory / "unet.onnx", weights)
    make_slopes(directory / "slopes.onnx")
    sketch = make_sketch()
    colours = np.array([[1, 1, 1], [0, 0, 1], [0, 0, 0]], np.float64)
    height = run_in_numpy(weights, colours[sketch].transpose(2, 0, 1))
    sketch.tofile(directory / "sketch.u8")
    height.astype(np.float32).tofile(directory / "height.f32")

    make_pointwise(directory / "one_channel.onnx", 1, 1, 1.0, 0.25)
    make_pointwise(directory / "two_channels_in.onnx", 2, 1, 1.0, 0.0)
    make_pointwise(directory / "two_channels_out.onnx", 3, 2, 1.0, 0.0)
    make_pointwise(directory / "level.onnx", 1, 1, 0.0, 0.5)
    # Logarithms of nothing, on ridges alone: blank paper gives a number.
    make_pointwise(directory / "not_finite.onnx", 1, 1, -1.0, 1.0, then="Log")


if __name__ == "__main__":
    main()
