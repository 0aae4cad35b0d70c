"""Trains a language model from scratch on a data set of conversations (`latticeworld dataset`).

    python3 -m latticeworld_training.train_language_model --data set/layout/train.jsonl \\
        --validation set/layout/validation.jsonl --out run --rate 2e-3 --decay cosine --warmup-steps 100

The folder `run` gets tokenizer.json, model.json, checkpoint.pt, loss.csv and loss.png. The same command again goes on
where it was interrupted. `export_gguf` makes a model file of it.
"""

import argparse
import dataclasses
import json
import os
import random
import shutil

import torch

from .chat_data import brief, encode_all, read_conversations
from .checkpoint import read_checkpoint
from .fitting import FitOptions, fit
from .llama import Llama, LlamaSizes
from .optimizers import OPTIMIZERS
from .tokenizer import Tokenizer, train_tokenizer
from .whole_files import whole_file


def add_fields(parser, options):
    """An option a field of a dataclass with defaults of plain types."""
    for field in dataclasses.fields(options):
        value = getattr(options, field.name)
        if isinstance(value, (int, float, str)):
            flag = "--" + field.name.replace("_", "-")
            parser.add_argument(flag, type=type(value), default=value, help=f"[{value}]")


def filled(options, arguments):
    """The dataclass with what the arguments say."""
    given = {f.name: getattr(arguments, f.name) for f in dataclasses.fields(options) if hasattr(arguments, f.name)}
    return dataclasses.replace(options, **given)


def read_or_train_tokenizer(directory, conversations, most_fours, most_words):
    path = os.path.join(directory, "tokenizer.json")
    if not os.path.exists(path):
        texts = [content for messages in conversations for role, content in messages if role != "system"]
        train_tokenizer(texts, most_fours, most_words).save(path)
    return Tokenizer.load(path)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", nargs="+", required=True, help="JSON Lines")
    parser.add_argument("--validation", nargs="*", default=[], help="JSON Lines that are not trained on")
    parser.add_argument("--out", required=True, help="folder of the run")
    parser.add_argument("--begin-with", help="folder of a run whose tokenizer, sizes and weights this one begins with")
    parser.add_argument("--brief-share", type=float, default=0.0, help="of environments that come without map and fine attributes [0]")
    parser.add_argument("--most-fours", type=int, default=1000, help="pieces of maps in the vocabulary [1000]")
    parser.add_argument("--most-words", type=int, default=1000, help="pieces of words in the vocabulary [1000]")
    parser.add_argument("--threads", type=int, default=1, help="of the processor [1]")
    parser.add_argument("--device", default="cpu", help="cpu or cuda [cpu]")
    sizes, options = LlamaSizes(), FitOptions()
    add_fields(parser, sizes)
    add_fields(parser, options)
    parser.set_defaults(tokens=0)
    given = parser.parse_args(arguments)
    if given.optimizer not in OPTIMIZERS:
        parser.error(f"--optimizer: '{given.optimizer}'; legal are {', '.join(OPTIMIZERS)}")

    torch.set_num_threads(given.threads)
    torch.manual_seed(given.seed)
    os.makedirs(given.out, exist_ok=True)
    if given.begin_with:
        shutil.copy(os.path.join(given.begin_with, "tokenizer.json"), given.out)
    conversations = read_conversations(given.data)
    tokenizer = read_or_train_tokenizer(given.out, conversations, given.most_fours, given.most_words)
    if given.begin_with:
        with open(os.path.join(given.begin_with, "model.json"), encoding="utf-8") as file:
            sizes = LlamaSizes(**json.load(file))
    else:
        sizes = dataclasses.replace(filled(sizes, given), tokens=len(tokenizer))
    model = Llama(sizes)
    if given.begin_with:
        model.load_state_dict(read_checkpoint(os.path.join(given.begin_with, "checkpoint.pt"))["model"])
    with whole_file(os.path.join(given.out, "model.json")) as file:
        json.dump(dataclasses.asdict(sizes), file, indent=2)
    unseen = read_conversations(given.validation)
    draws = random.Random(given.seed)
    conversations = [brief(messages) if draws.random() < given.brief_share else messages for messages in conversations]
    examples, longer = encode_all(tokenizer, conversations, sizes.context)
    validation, _ = encode_all(tokenizer, unseen, sizes.context)
    weights = sum(weight.numel() for weight in model.parameters())
    length = sum(len(example.tokens) for example in examples) / max(len(examples), 1)
    print(f"{weights} weights, a vocabulary of {len(tokenizer)}, {len(examples)} examples of {length:.0f} tokens")
    if longer:
        print(f"{longer} conversations are longer than the context of {sizes.context} tokens and left out")
    fit(model, examples, validation, given.out, filled(options, given), given.device)


if __name__ == "__main__":
    main()
