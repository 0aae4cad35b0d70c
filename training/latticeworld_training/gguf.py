"""Writes GGUF files, version 3, and reads those in f32, f16, q4_1 and q8_0 (https://github.com/ggml-org/ggml/blob/master/docs/gguf.md)."""

import struct

import numpy

from .whole_files import whole_file

ALIGNMENT = 32
# The format's numbers of the kinds of values and of tensors.
UINT32, INT32, FLOAT32, BOOL, STRING, ARRAY = 4, 5, 6, 7, 8, 9
# Of each plain kind, how struct reads it.
FORMS = {0: "B", 1: "b", 2: "H", 3: "h", UINT32: "I", INT32: "i", FLOAT32: "f", BOOL: "?", 10: "Q", 11: "q", 12: "d"}
F32, F16, Q4_1, Q8_0 = 0, 1, 3, 8
TENSOR_TYPES = {"f32": F32, "f16": F16, "q8_0": Q8_0}
Q8_BLOCK = 32
# What the format calls the parts of a layer of a LLaMA, and llama.py does.
LLAMA_PARTS = {
    "attn_norm": "attention_norm", "attn_q": "query", "attn_k": "key", "attn_v": "value",
    "attn_output": "attention_output", "ffn_norm": "feed_forward_norm", "ffn_gate": "gate", "ffn_up": "up",
    "ffn_down": "down",
}


def _string(text):
    raw = text.encode("utf-8")
    return struct.pack("<Q", len(raw)) + raw


def _scalar(kind, value):
    if kind == STRING:
        return _string(value)
    return struct.pack("<" + FORMS[kind], value)


def quantized(values):
    """Bytes in q8_0: blocks of 32 along the last axis, each a float16 scale and 32 int8."""
    if values.shape[-1] % Q8_BLOCK:
        raise ValueError(f"rows of {values.shape[-1]} values do not divide into blocks of {Q8_BLOCK}")
    blocks = values.astype(numpy.float32).reshape(-1, Q8_BLOCK)
    scale = numpy.abs(blocks).max(1) / 127.0
    inverse = numpy.divide(1.0, scale, out=numpy.zeros_like(scale), where=scale > 0)
    scaled = blocks * inverse[:, None]
    rounded = numpy.trunc(scaled + numpy.copysign(0.5, scaled)).astype(numpy.int8)
    packed = numpy.zeros(len(blocks), dtype=[("scale", "<f2"), ("values", "i1", Q8_BLOCK)])
    packed["scale"], packed["values"] = scale, rounded
    return packed.tobytes()


class GgufWriter:
    """Collects metadata and tensors; `write` makes the file."""

    def __init__(self):
        self._entries = []
        self._infos = []
        self._data = bytearray()

    def add(self, key, kind, value):
        self._entries.append(_string(key) + struct.pack("<I", kind) + _scalar(kind, value))

    def add_array(self, key, kind, values):
        head = struct.pack("<IIQ", ARRAY, kind, len(values))
        self._entries.append(_string(key) + head + b"".join(_scalar(kind, value) for value in values))

    def add_tensor(self, name, values, kind):
        """values: a numpy array of one or two dimensions, the last of which runs fastest."""
        self._data += b"\0" * (-len(self._data) % ALIGNMENT)
        shape = struct.pack(f"<I{values.ndim}Q", values.ndim, *reversed(values.shape))
        self._infos.append(_string(name) + shape + struct.pack("<IQ", kind, len(self._data)))
        if kind == Q8_0:
            self._data += quantized(values)
        else:
            self._data += numpy.ascontiguousarray(values, "<f2" if kind == F16 else "<f4").tobytes()

    def write(self, path):
        """The file is whole or is the one before."""
        head = b"GGUF" + struct.pack("<IQQ", 3, len(self._infos), len(self._entries))
        head += b"".join(self._entries) + b"".join(self._infos)
        head += b"\0" * (-len(head) % ALIGNMENT)
        with whole_file(path, "wb") as file:
            file.write(head)
            file.write(self._data)


def _values(raw, kind, count):
    """`count` float32 of a tensor's bytes."""
    if kind == F32:
        return numpy.frombuffer(raw, "<f4", count)
    if kind == F16:
        return numpy.frombuffer(raw, "<f2", count).astype(numpy.float32)
    if kind == Q4_1:
        halves = [("step", "<f2"), ("least", "<f2"), ("values", "u1", Q8_BLOCK // 2)]
        blocks = numpy.frombuffer(raw, dtype=halves, count=count // Q8_BLOCK)
        both = numpy.concatenate([blocks["values"] & 15, blocks["values"] >> 4], axis=1).astype(numpy.float32)
        return (blocks["step"].astype(numpy.float32)[:, None] * both + blocks["least"].astype(numpy.float32)[:, None]).reshape(-1)
    if kind != Q8_0:
        raise ValueError(f"a tensor of type {kind}; read here are f32, f16, q4_1 and q8_0")
    blocks = numpy.frombuffer(raw, dtype=[("scale", "<f2"), ("values", "i1", Q8_BLOCK)], count=count // Q8_BLOCK)
    return (blocks["scale"].astype(numpy.float32)[:, None] * blocks["values"]).reshape(-1)


class _Head:
    """Reads a file's head from its beginning."""

    def __init__(self, raw):
        self.raw, self.at = raw, 0

    def take(self, form):
        values = struct.unpack_from("<" + form, self.raw, self.at)
        self.at += struct.calcsize("<" + form)
        return values if len(values) > 1 else values[0]

    def text(self):
        size = self.take("Q")
        self.at += size
        return self.raw[self.at - size : self.at].decode("utf-8")

    def value(self, kind):
        if kind == STRING:
            return self.text()
        if kind == ARRAY:
            of, count = self.take("IQ")
            return [self.value(of) for _ in range(count)]
        return self.take(FORMS[kind])


def read_gguf(path):
    """Metadata (a dict) and tensors (float32 arrays by name) of a file. Raises ValueError for one that is not read here."""
    with open(path, "rb") as file:
        head = _Head(file.read())
    try:
        if head.take("4sI") != (b"GGUF", 3):
            raise ValueError("no GGUF of version 3")
        tensors, entries = head.take("QQ")
        metadata = {head.text(): head.value(head.take("I")) for _ in range(entries)}
        infos = []
        for _ in range(tensors):
            name, dimensions = head.text(), head.take("I")
            shape = [head.take("Q") for _ in range(dimensions)]
            infos.append((name, shape[::-1], *head.take("IQ")))
        begin = head.at + -head.at % ALIGNMENT
        return metadata, {
            name: _values(memoryview(head.raw)[begin + offset :], kind, int(numpy.prod(shape))).reshape(shape)
            for name, shape, kind, offset in infos
        }
    except (ValueError, KeyError, struct.error) as error:
        raise ValueError(f"{path} cannot be read: {error!r}") from error
