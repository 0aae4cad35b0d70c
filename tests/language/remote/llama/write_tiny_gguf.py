#!/usr/bin/env python3
"""Writes a tiny language model of the LLaMA architecture with random weights, as a GGUF file.

Its tokens are the 256 bytes, the printable ASCII characters and the newline, so that it can spell
anything; what it spells is noise, the same for the same seed. Usage: write_tiny_gguf.py OUT [SEED]

Format: GGUF version 3 (https://github.com/ggml-org/ggml/blob/master/docs/gguf.md).
"""

import struct
import sys

import numpy as np

LAYERS, WIDTH, HEADS, KV_HEADS, HIDDEN, CONTEXT = 1, 32, 1, 1, 64, 32768
ALIGNMENT = 32
UINT32, FLOAT32, BOOL, STRING, ARRAY = 4, 6, 7, 8, 9  # GGUF's numbers of its value types
INT32 = 5
NORMAL, UNKNOWN, CONTROL, BYTE = 1, 2, 3, 6  # llama.cpp's numbers of its token types


def string(text):
    data = text.encode()
    return struct.pack("<Q", len(data)) + data


def entry(key, kind, value):
    if kind == UINT32:
        packed = struct.pack("<I", value)
    elif kind == FLOAT32:
        packed = struct.pack("<f", value)
    elif kind == BOOL:
        packed = struct.pack("<?", value)
    else:
        packed = string(value)
    return string(key) + struct.pack("<I", kind) + packed


def array(key, kind, values):
    packed = b"".join({STRING: string,
                       FLOAT32: lambda v: struct.pack("<f", v),
                       INT32: lambda v: struct.pack("<i", v)}[kind](value) for value in values)
    return string(key) + struct.pack("<IIQ", ARRAY, kind, len(values)) + packed


def vocabulary():
    """(text, type) of every token; a space is spelled U+2581, as SentencePiece does."""
    tokens = [("<unk>", UNKNOWN), ("<s>", CONTROL), ("</s>", CONTROL)]
    tokens += [(f"<0x{byte:02X}>", BYTE) for byte in range(256)]
    tokens += [("\u2581", NORMAL), ("\n", NORMAL)]
    return tokens + [(chr(code), NORMAL) for code in range(0x21, 0x7F)]


def tensors(tokens, seed):
    """(name, matrix) of every weight, (rows x columns) = (outputs x inputs)."""
    random = np.random.default_rng(seed)
    kv_width = WIDTH // HEADS * KV_HEADS

    def noise(rows, columns):
        return random.normal(0.0, columns ** -0.5, (rows, columns)).astype(np.float32)

    yield "token_embd.weight", noise(tokens, WIDTH)
    for layer in range(LAYERS):
        block = f"blk.{layer}."
        yield block + "attn_norm.weight", np.ones(WIDTH, np.float32)
        yield block + "attn_q.weight", noise(WIDTH, WIDTH)
        yield block + "attn_k.weight", noise(kv_width, WIDTH)
        yield block + "attn_v.weight", noise(kv_width, WIDTH)
        yield block + "attn_output.weight", noise(WIDTH, WIDTH)
        yield block + "ffn_norm.weight", np.ones(WIDTH, np.float32)
        yield block + "ffn_gate.weight", noise(HIDDEN, WIDTH)
        yield block + "ffn_up.weight", noise(HIDDEN, WIDTH)
        yield block + "ffn_down.weight", noise(WIDTH, HIDDEN)
    yield "output_norm.weight", np.ones(WIDTH, np.float32)
    yield "output.weight", noise(tokens, WIDTH)


def main():
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    tokens = vocabulary()
    metadata = [
        entry("general.architecture", STRING, "llama"),
        entry("general.name", STRING, "tiny-noise"),
        entry("general.alignment", UINT32, ALIGNMENT),
        entry("llama.context_length", UINT32, CONTEXT),
        entry("llama.embedding_length", UINT32, WIDTH),
        entry("llama.block_count", UINT32, LAYERS),
        entry("llama.feed_forward_length", UINT32, HIDDEN),
        entry("llama.attention.head_count", UINT32, HEADS),
        entry("llama.attention.head_count_kv", UINT32, KV_HEADS),
        entry("llama.attention.layer_norm_rms_epsilon", FLOAT32, 1e-5),
        entry("llama.rope.dimension_count", UINT32, WIDTH // HEADS),
        entry("tokenizer.ggml.model", STRING, "llama"),
        array("tokenizer.ggml.tokens", STRING, [text for text, _ in tokens]),
        array("tokenizer.ggml.scores", FLOAT32, [0.0] * len(tokens)),
        array("tokenizer.ggml.token_type", INT32, [kind for _, kind in tokens]),
        entry("tokenizer.ggml.unknown_token_id", UINT32, 0),
        entry("tokenizer.ggml.bos_token_id", UINT32, 1),
        entry("tokenizer.ggml.eos_token_id", UINT32, 2),
        entry("tokenizer.ggml.add_space_prefix", BOOL, False),
    ]
    infos, data = b"", b""
    weights = list(tensors(len(tokens), seed))
    for name, matrix in weights:
        data += b"\0" * (-len(data) % ALIGNMENT)
        # The format counts dimensions from the fastest one; type 0 is float32.
        infos += string(name) + struct.pack("<I", matrix.ndim)
        infos += b"".join(struct.pack("<Q", size) for size in reversed(matrix.shape))
        infos += struct.pack("<IQ", 0, len(data))
        data += matrix.tobytes()
    head = b"GGUF" + struct.pack("<IQQ", 3, len(weights), len(metadata))
    head += b"".join(metadata) + infos
    with open(sys.argv[1], "wb") as out:
        out.write(head + b"\0" * (-len(head) % ALIGNMENT) + data)


if __name__ == "__main__":
    main()
