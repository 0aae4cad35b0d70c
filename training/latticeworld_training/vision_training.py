"""Trains what sees, stage by stage, on a data set of `latticeworld dataset`.

  python3 -m latticeworld_training.vision_training --data set --language-model runs/layout --out runs/vision

`runs/vision` gets contrast/, align/ and together/, each with checkpoint.pt, loss.csv and loss.png; a call that finds
them goes on where they end. --language-model is the folder of a run of train_language_model; models of Hugging Face
are not taken.
"""

import argparse
import json
import os

import torch

from .checkpoint import read_checkpoint
from .llama import Llama, LlamaSizes
from .tokenizer import Tokenizer
from .vision_data import read_pictures
from .vision_network import VisionOptions
from .vision_stages import align, align_options, contrast, contrast_options, together, together_options


def read_language_model(directory):
    with open(os.path.join(directory, "model.json"), encoding="utf-8") as file:
        model = Llama(LlamaSizes(**json.load(file)))
    model.load_state_dict(read_checkpoint(os.path.join(directory, "checkpoint.pt"))["model"])
    return model


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", required=True, help="folder of the data set, with relief/ and the task's folder")
    parser.add_argument("--task", default="layout", help="what stage 3 learns: layout, environment or relief [layout]")
    parser.add_argument("--language-model", required=True, help="folder of its run")
    parser.add_argument("--out", required=True)
    parser.add_argument("--side", type=int, default=64, help="samples a side that the encoder sees [64]")
    parser.add_argument("--contrast-epochs", type=int, default=contrast_options().epochs)
    parser.add_argument("--align-epochs", type=int, default=align_options().epochs)
    parser.add_argument("--together-epochs", type=int, default=together_options().epochs)
    parser.add_argument("--batch-size", type=int, default=32)
    parser.add_argument("--checkpoint-steps", type=int, default=50, help="between two checkpoints [50]")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--device", default="cpu", help="cpu or cuda [cpu]")
    given = parser.parse_args(arguments)
    torch.set_num_threads(given.threads)
    if not os.path.exists(os.path.join(given.language_model, "model.json")):
        parser.error(f"--language-model: {given.language_model} is no run of train_language_model: no model.json "
                     "there; models of Hugging Face cannot be given eyes")

    def path_of(task, split):
        return os.path.join(given.data, task, split + ".jsonl")

    def pictures(task, split):
        path = path_of(task, split)
        return read_pictures(path, given.side) if os.path.exists(path) else []

    def to_learn_from(task):
        found = pictures(task, "train")
        if not found:
            parser.error(f"{path_of(task, 'train')}: no record with a height map")
        return found

    def options(stage, epochs):
        return stage(epochs=epochs, batch_size=given.batch_size, checkpoint_steps=given.checkpoint_steps)

    tokenizer = Tokenizer.load(os.path.join(given.language_model, "tokenizer.json"))
    language_model = read_language_model(given.language_model)
    captions, unseen = to_learn_from("relief"), pictures("relief", "validation")[:256]
    answers, unseen_answers = to_learn_from(given.task), pictures(given.task, "validation")[:256]
    common = {"device": given.device}
    network = VisionOptions(side=given.side, tokens=len(tokenizer))
    model, _ = contrast(captions, tokenizer, os.path.join(given.out, "contrast"), network,
                        options(contrast_options, given.contrast_epochs), unseen, **common)
    encoder = model.heights.eval()
    projection, _ = align(encoder, language_model, tokenizer, captions, os.path.join(given.out, "align"),
                          options(align_options, given.align_epochs), unseen, **common)
    together(encoder, projection, language_model, tokenizer, answers,
             os.path.join(given.out, "together"), options(together_options, given.together_epochs), unseen_answers,
             **common)


if __name__ == "__main__":
    main()
