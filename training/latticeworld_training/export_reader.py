"""Makes the adapter file of a run of train_reader: what the repository ships, in q8_0.

    python3 -m latticeworld_training.export_reader --run run --base SmolLM2-135M-Instruct.Q4_1.gguf --out models/reader.gguf
"""

import argparse

from . import gguf
from .adapters import SCALE, read_adapters
from .join_reader import KEY, sha256_of


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("run", "base", "out"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--mean-with", help="a run or file of the same shape, halfway to which the weights are taken")
    given = parser.parse_args(arguments)
    state = read_adapters(given.run)
    if given.mean_with:
        other = read_adapters(given.mean_with)
        state = {name: 0.5 * (weights.float() + other[name].float()) for name, weights in state.items()}
    writer = gguf.GgufWriter()
    writer.add("general.architecture", gguf.STRING, "latticeworld-reader-adapter")
    writer.add("general.name", gguf.STRING, "latticeworld reader")
    writer.add(KEY, gguf.STRING, sha256_of(given.base))
    parts = {ours: theirs for theirs, ours in gguf.LLAMA_PARTS.items()}
    for name, weights in state.items():
        _, number, part, which = name.split(".")
        values = weights.float() * (SCALE if which == "b" else 1.0)
        # Rows of B are as long as the rank: a multiple of the blocks of q8_0.
        writer.add_tensor(f"blk.{number}.{parts[part]}.weight.{which}", values.numpy(), gguf.Q8_0)
    writer.write(given.out)


if __name__ == "__main__":
    main()
