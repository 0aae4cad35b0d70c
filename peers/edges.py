"""ODE, Embree and OpenCV's networks at the edges of what the simulation asks of them."""
# debian: libode-dev libembree-dev libopencv-dnn-dev g++
# pypi: onnx==1.23.2 numpy==2.4.6

import pathlib
import re

import numpy
import onnx
from onnx import TensorProto, helper, numpy_helper

from peer import FOLDER, Peer, run

SOURCE = pathlib.Path(__file__).parent / "common" / "edges.cc"


def network(name, kind, relu):
    """A convolution of 16 channels and one back to one; kind: of numbers."""
    random = numpy.random.default_rng(1)
    into = random.normal(0, 0.3, (16, 1, 3, 3)).astype(kind)
    back = random.normal(0, 0.3, (1, 16, 3, 3)).astype(kind)
    dtype = TensorProto.FLOAT16 if kind == "f2" else TensorProto.FLOAT
    shape = [1, 1, 16, 16]
    nodes = [helper.make_node("Conv", ["x", "into"], ["a"], pads=[1] * 4, kernel_shape=[3, 3])]
    nodes += [helper.make_node("Relu", ["a"], ["b"])] if relu else []
    nodes += [helper.make_node("Conv", ["b" if relu else "a", "back"], ["y"], pads=[1] * 4,
                               kernel_shape=[3, 3])]
    graph = helper.make_graph(nodes, "net", [helper.make_tensor_value_info("x", dtype, shape)],
                              [helper.make_tensor_value_info("y", dtype, shape)],
                              [numpy_helper.from_array(into, "into"),
                               numpy_helper.from_array(back, "back")])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 11)], ir_version=7)
    onnx.save(model, FOLDER / f"{name}.onnx")


# What each line is expected to say, as a regular expression.
EXPECTED = {
    "ode ball on level ground": "1 contacts, normals' z at least 1.000, depth 0.050",
    "ode ball over a NaN": "1 contacts, normals' z at least 1.000, depth 0.050",
    "ode ball at borders of cells": "1 contacts, normals' z at least 1.000, depth 0.050",
    "ode ray from exactly the ground": "1 contacts.*depth 0.000",
    "ode ray from 0.1 m above": "1 contacts.*depth 0.100",
    "ode ball with its centre 0.1 m below": "1 contacts.*depth 0.400",
    "ode ball with its centre 0.5 m below": "1 contacts.*depth 0.200",
    "embree from exactly the surface": "down -1, up -1, from 1e-7 above down 1e-07",
    "embree beside a triangle with a NaN": "met triangle 2 at 3",
    "embree along an edge": "0 of 19999 slip through, 0 with the flag robust",
    "opencv half floats": "refused: Unsupported data type: FLOAT16",
    "opencv one NaN in": "25 NaN out of a convolution, 25 out of one with a ReLU",
    "opencv two threads with a network each": "the same",
}


def main():
    versions = [run("dpkg-query", "-W", "-f", "${Version}", name).stdout.split(":")[-1].split("+")[0]
                for name in ("libode-dev", "libembree-dev", "libopencv-dnn-dev")]
    peer = Peer("ODE, Embree, OpenCV's networks", ", ".join(versions),
                "height fields, rays, networks at their edges (`peers/edges.py`)",
                "nothing: LatticeWorld asks none of them with NaN, and begins rays off surfaces")
    network("float", "f4", False)
    network("half", "f2", False)
    network("relu", "f4", True)
    made = run("g++", "-O1", "-std=c++17", "-I/usr/include/opencv4", SOURCE, "-o", FOLDER / "edges",
               "-lode", "-lembree3", "-lopencv_dnn", "-lopencv_core", "-lpthread")
    said = dict(line.split(": ", 1) for line in run(FOLDER / "edges", FOLDER).stdout.splitlines()
                if ": " in line)
    for name, wanted in EXPECTED.items():
        found = said.get(name, made.stdout[-300:])
        peer.check(name, re.fullmatch(wanted, found), found)
    peer.finish()


main()
