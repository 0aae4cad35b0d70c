"""Makes the beginning of a run of a model file, as wide and deep as one likes, for `--begin-with`.

    python3 -m latticeworld_training.grow_gguf layout.gguf --width 192 --hidden 512 --layers 6 --out grown
    python3 -m latticeworld_training.train_language_model --begin-with grown --data ... --out run

The larger model says what the file says until it is trained (Chen et al. 2016, Net2Net): what is new is read with small
random weights, and what is written to it and by it begins as nothing. Heads keep their width, so that a wider model has
more of them; new layers stand evenly between the old ones.
"""

import argparse
import dataclasses
import json
import math
import os

import torch

from .checkpoint import save_checkpoint
from .export_gguf import tensor_name
from .gguf import read_gguf
from .llama import Llama, LlamaSizes
from .tokenizer import Tokenizer
from .whole_files import whole_file

NEW_WEIGHT = 0.02  # standard deviation


def sizes_of(metadata):
    """LlamaSizes of a file's metadata."""
    return LlamaSizes(
        tokens=metadata["llama.vocab_size"],
        width=metadata["llama.embedding_length"],
        layers=metadata["llama.block_count"],
        heads=metadata["llama.attention.head_count"],
        kv_heads=metadata["llama.attention.head_count_kv"],
        hidden=metadata["llama.feed_forward_length"],
        context=metadata["llama.context_length"],
        norm_epsilon=metadata["llama.attention.layer_norm_rms_epsilon"],
        rope_base=metadata["llama.rope.freq_base"],
    )


def grown_sizes(sizes, width, layers, hidden):
    """The same sizes but for those given. Raises ValueError where one is smaller, or heads do not fit."""
    larger = dataclasses.replace(sizes, width=width or sizes.width, layers=layers or sizes.layers,
                                 hidden=hidden or sizes.hidden)
    for name in ("width", "layers", "hidden"):
        if getattr(larger, name) < getattr(sizes, name):
            raise ValueError(f"{name} {getattr(larger, name)} is less than the file's {getattr(sizes, name)}")
    head_width, share = sizes.width // sizes.heads, sizes.heads // sizes.kv_heads
    if larger.width % (head_width * share):
        raise ValueError(f"width {larger.width} is no multiple of the {head_width * share} of heads that share keys")
    heads = larger.width // head_width
    # A stream with nothing beside it has a smaller mean square, and what is added to that is smaller by as much.
    epsilon = sizes.norm_epsilon * sizes.width / larger.width
    return dataclasses.replace(larger, heads=heads, kv_heads=heads // share, norm_epsilon=epsilon)


def widened(key, old, shape, stretch):
    """A matrix or norm of `shape` that does with the old part of what it reads what `old` does. stretch: by how much the
    zeros beside the old values of a stream make its root mean square smaller."""
    if old.dim() == 1:
        new = torch.ones(shape)
        new[: len(old)] = old * stretch
        return new
    # Rows write. What is written into the stream, or kept there from the first, is nothing at first where it is new;
    # what is read of the stream's new part may be anything, since that part is nothing.
    rows, columns = old.shape
    into_stream = key.endswith(("attention_output.weight", "down.weight", "embeddings.weight"))
    new = torch.zeros(shape) if into_stream else NEW_WEIGHT * torch.randn(shape)
    new[:rows, :columns] = old
    return new


def grown(metadata, tensors, width=None, layers=None, hidden=None):
    """A Llama that computes what a file's does, to rounding."""
    small = sizes_of(metadata)
    sizes = grown_sizes(small, width, layers, hidden)
    model = Llama(sizes)
    stretch = math.sqrt(small.width / sizes.width)
    state = model.state_dict()
    for key, values in state.items():
        parts, silent = key.split("."), False
        if parts[0] == "layers":
            here = int(parts[1])
            old = here * small.layers // sizes.layers
            repeated = here > 0 and (here - 1) * small.layers // sizes.layers == old
            silent = repeated and key.endswith(("attention_output.weight", "down.weight"))
            parts[1] = str(old)
        file_values = torch.from_numpy(tensors[tensor_name(".".join(parts))].copy())
        state[key] = torch.zeros_like(values) if silent else widened(key, file_values, values.shape, stretch)
    model.load_state_dict(state)
    return model


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="that export_gguf wrote")
    parser.add_argument("--width", type=int, help="of the new model's embeddings [the file's]")
    parser.add_argument("--layers", type=int, help="of the new model [the file's]")
    parser.add_argument("--hidden", type=int, help="of its feed-forward networks [the file's]")
    parser.add_argument("--out", required=True, help="folder: tokenizer.json, model.json, checkpoint.pt")
    given = parser.parse_args(arguments)
    torch.manual_seed(1)
    try:
        metadata, tensors = read_gguf(given.file)
        model = grown(metadata, tensors, given.width, given.layers, given.hidden)
    except ValueError as error:
        parser.error(str(error))
    os.makedirs(given.out, exist_ok=True)
    tokens = Tokenizer(metadata["tokenizer.ggml.tokens"], metadata["tokenizer.ggml.scores"])
    tokens.save(os.path.join(given.out, "tokenizer.json"))
    with whole_file(os.path.join(given.out, "model.json")) as file:
        json.dump(dataclasses.asdict(model.sizes), file, indent=2)
    save_checkpoint(os.path.join(given.out, "checkpoint.pt"), model, torch.optim.AdamW(model.parameters()))
    print(f"{given.out}: {sum(weight.numel() for weight in model.parameters())} weights in {model.sizes.layers} layers")


if __name__ == "__main__":
    main()
