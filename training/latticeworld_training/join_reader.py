"""Joins a base model with a reader's adapter into the file that is run: W + B A of every matrix, in q8_0.

    python3 -m latticeworld_training.join_reader --base SmolLM2-135M-Instruct.Q4_1.gguf --adapter models/reader.gguf \\
        --out reader.gguf

The adapter names the base that it belongs to by its SHA-256; another one is refused.
"""

import argparse
import hashlib
import sys

from . import gguf

KEY = "latticeworld.reader.base_sha256"
KINDS = {bool: gguf.BOOL, int: gguf.UINT32, float: gguf.FLOAT32, str: gguf.STRING}


def sha256_of(path):
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


def copy_metadata(metadata, writer):
    """Writes what a base says of itself; numbers of arrays are 32-bit."""
    for key, value in metadata.items():
        if key in ("general.name", "general.file_type", "general.quantization_version"):
            continue
        if isinstance(value, list):
            writer.add_array(key, gguf.INT32 if isinstance(value[0], int) else KINDS[type(value[0])], value)
        else:
            writer.add(key, KINDS[type(value)], value)


def join(base_path, adapter_path, out_path):
    """Raises ValueError where the two do not belong together."""
    about, adapters = gguf.read_gguf(adapter_path)
    given = sha256_of(base_path)
    if about[KEY] != given:
        raise ValueError(f"{adapter_path} belongs to the base of SHA-256 {about[KEY]}; {base_path} has {given}")
    metadata, tensors = gguf.read_gguf(base_path)
    # A reader may have learned on the base's first layers alone.
    layers = 1 + max(int(name.split(".")[1]) for name in adapters)
    metadata[f"{metadata['general.architecture']}.block_count"] = layers
    tensors = {name: values for name, values in tensors.items() if not name.startswith("blk.") or int(name.split(".")[1]) < layers}
    writer = gguf.GgufWriter()
    writer.add("general.name", gguf.STRING, about["general.name"])
    copy_metadata(metadata, writer)
    for name, values in tensors.items():
        if f"{name}.a" in adapters:
            values = values + adapters[f"{name}.b"] @ adapters[f"{name}.a"]
        writer.add_tensor(name, values, gguf.Q8_0 if values.ndim == 2 else gguf.F32)
    writer.write(out_path)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("base", "adapter", "out"):
        parser.add_argument(f"--{name}", required=True)
    given = parser.parse_args(arguments)
    try:
        join(given.base, given.adapter, given.out)
    except (OSError, ValueError) as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
