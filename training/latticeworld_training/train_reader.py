"""Teaches a small language model to read: adapters on a base model, from examples (reader_examples.py).

    python3 -m latticeworld_training.train_reader --base SmolLM2-135M-Instruct.Q4_1.gguf --data examples/*.jsonl \\
        --leave-out AUTHOR ... --out run --minutes 40

The folder `run` gets adapter.pt, settings.json and loss.csv; the same command again goes on where it was interrupted.
The loss runs over the tokens that some answer has, as the grammar lets a reader choose among those alone.
"""

import argparse
import json
import math
import os
import random
import time

import torch
from torch.nn import functional

from . import adapters, llama
from .base_model import read_base
from .reader_examples import (END, PROMPT, add_lesson_arguments, answer_of, batches_of, chosen_examples, paths_of,
                              read_examples)
from .whole_files import whole_file

TOKENS_AT_ONCE = 3072
SAVED_EVERY_S = 300.0  # of the processors' time; what is interrupted begins its epoch anew


class FastLayer:
    """The same layer as llama.LlamaLayer with its norm and attention written for the processor's bfloat16 units."""

    @staticmethod
    def norm(self, x):
        return functional.rms_norm(x, (x.shape[-1],), self.weight.to(x.dtype), self.epsilon)

    @staticmethod
    def turn(x, cosines, sines):
        even, odd = x[..., 0::2], x[..., 1::2]
        cosines, sines = cosines[:, None].to(x.dtype), sines[:, None].to(x.dtype)
        return torch.stack((even * cosines - odd * sines, even * sines + odd * cosines), -1).flatten(-2)

    @staticmethod
    def attend(self, x, angles, mask):
        batch, length, _ = x.shape
        heads, share = self.sizes.heads, self.sizes.heads // self.sizes.kv_heads
        width = self.sizes.width // heads
        queries = FastLayer.turn(self.query(x).view(batch, length, -1, width), *angles).transpose(1, 2)
        keys = FastLayer.turn(self.key(x).view(batch, length, -1, width), *angles).transpose(1, 2)
        values = self.value(x).view(batch, length, -1, width).transpose(1, 2)
        keys = keys[:, :, None].expand(-1, -1, share, -1, -1).reshape(batch, heads, length, width)
        values = values[:, :, None].expand(-1, -1, share, -1, -1).reshape(batch, heads, length, width)
        scores = (queries * width**-0.5) @ keys.transpose(2, 3) + mask.to(queries.dtype)
        return self.attention_output((scores.softmax(-1) @ values).transpose(1, 2).reshape(batch, length, -1))


def make_fast(model, compiled):
    """Fixed weights in bfloat16, layers compiled."""
    llama.RootMeanSquareNorm.forward = FastLayer.norm
    llama.LlamaLayer.attend = FastLayer.attend
    model.embeddings.weight = torch.nn.Parameter(model.embeddings.weight.detach().bfloat16(), requires_grad=False)
    for layer in model.layers:
        for name in adapters.ADAPTED:
            part = getattr(layer, name)
            part.weight = torch.nn.Parameter(part.weight.detach().bfloat16(), requires_grad=False)
        if compiled:
            layer.compile(dynamic=True)


def encode(tokenizer, example):
    """(tokens, number of those that ask)."""
    asked = tokenizer.encode(PROMPT.format(kind=example["kind"], text=example["text"])).ids
    return asked + tokenizer.encode(answer_of(example) + END).ids, len(asked)


def tensors_of(encoded, indices, place_of):
    """Tokens (batch, length) and the answers' targets among the answers' tokens, -100 elsewhere."""
    length = max(len(encoded[i][0]) for i in indices)
    length = -(-length // 32) * 32
    tokens = torch.zeros(len(indices), length, dtype=torch.long)
    targets = torch.full((len(indices), length), -100)
    for row, i in enumerate(indices):
        ids, asked = encoded[i]
        tokens[row, : len(ids)] = torch.tensor(ids)
        targets[row, asked - 1 : len(ids) - 1] = torch.tensor([place_of[token] for token in ids[asked:]])
    return tokens, targets


def loss_of(model, encoded, indices, place_of, answers):
    tokens, targets = tensors_of(encoded, indices, place_of)
    features = model.features(model.embeddings(tokens))
    counted = targets != -100
    logits = features[counted] @ model.embeddings.weight[answers].T
    return functional.cross_entropy(logits.float(), targets[counted]), int(counted.sum())


class Lesson:
    """What is learned: examples in tokens, and the tokens that answers have."""

    def __init__(self, tokenizer, examples, left_out):
        self.encoded = [encode(tokenizer, example) for example in examples]
        tokens = sorted({token for ids, asked in self.encoded for token in ids[asked:]})
        self.place_of = {token: place for place, token in enumerate(tokens)}
        self.answers = torch.tensor(tokens)
        checked = [encode(tokenizer, example) for example in left_out]
        self.checked = [(ids, asked) for ids, asked in checked if all(token in self.place_of for token in ids[asked:])]

    def __str__(self):
        length = sum(len(ids) for ids, _ in self.encoded) / len(self.encoded)
        return f"{len(self.encoded)} examples of {length:.0f} tokens, {len(self.answers)} tokens of answers"


def unseen_loss(model, lesson):
    """(nats a token, nats a text) of the authors that are left out."""
    with torch.no_grad():
        sums = [loss_of(model, lesson.checked, [i], lesson.place_of, lesson.answers) for i in range(len(lesson.checked))]
    nats = sum(float(loss) * count for loss, count in sums)
    return nats / sum(count for _, count in sums), nats / len(sums)


def read_lesson(tokenizer, given):
    left_out = read_examples(paths_of(given), only=given.leave_out) if given.leave_out else []
    return Lesson(tokenizer, chosen_examples(given, without=given.leave_out), left_out)


def save(path, model, optimizer, **rest):
    state = {"adapters": {n: w for n, w in model.state_dict().items() if n.endswith((".a", ".b"))},
             "optimizer": optimizer.state_dict(), **rest}
    with whole_file(path, "wb") as file:
        torch.save(state, file)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_lesson_arguments(parser, rate=2e-3, minutes=40.0)
    parser.add_argument("--base", required=True, help="GGUF file")
    parser.add_argument("--leave-out", nargs="*", default=[], help="authors that are not trained on")
    parser.add_argument("--out", required=True, help="folder of the run")
    parser.add_argument("--begin-with", help="run's folder, or file of export_reader, whose adapters this one begins with")
    parser.add_argument("--rank", type=int, default=32, help="of the adapters [32]")
    parser.add_argument("--layers", type=int, default=0, help="of the base that are kept, from below; 0: all [0]")
    parser.add_argument("--compile", type=int, default=1, help="1: compile the layers [1]")
    given = parser.parse_args(arguments)

    torch.set_num_threads(given.threads)
    torch.manual_seed(given.seed)
    os.makedirs(given.out, exist_ok=True)
    model, tokenizer = read_base(given.base)
    if given.layers:
        model.layers = model.layers[: given.layers]
    adapters.adapt(model, given.rank)
    make_fast(model, bool(given.compile))
    trained = [weights for weights in model.parameters() if weights.requires_grad]
    optimizer = torch.optim.AdamW(trained, lr=given.rate, betas=(0.9, 0.99), weight_decay=0.0)

    lesson = read_lesson(tokenizer, given)
    print(f"{sum(w.numel() for w in trained)} weights, {lesson}", flush=True)
    with whole_file(os.path.join(given.out, "settings.json")) as file:
        json.dump({**vars(given), "examples": len(lesson.encoded)}, file, indent=2)

    path = os.path.join(given.out, "adapter.pt")
    step, spent, epoch = 0, 0.0, 0
    if os.path.exists(path):
        state = torch.load(path, weights_only=False)
        model.load_state_dict(state["adapters"], strict=False)
        optimizer.load_state_dict(state["optimizer"])
        step, spent, epoch = state["step"], state["spent"], state["epoch"]
    elif given.begin_with:
        model.load_state_dict(adapters.read_adapters(given.begin_with), strict=False)
    # A processor that others use as well does not shorten the lesson.
    worked = lambda: spent + (time.process_time() - began) / given.threads
    began = time.process_time()
    limit = given.minutes * 60.0
    recent, counted, tokens = 0.0, 0, 0
    told, saved = time.monotonic(), worked()
    while worked() < limit:
        if epoch > 0:
            lesson = read_lesson(tokenizer, given)  # files may have grown
        encoded, place_of, answers = lesson.encoded, lesson.place_of, lesson.answers
        for indices in batches_of([len(ids) for ids, _ in encoded], TOKENS_AT_ONCE, random.Random(f"{given.seed} {epoch}")):
            done = worked() / limit
            if done >= 1.0:
                break
            for group in optimizer.param_groups:
                group["lr"] = given.rate * min(1.0, (step + 1) / 30) * 0.5 * (1 + math.cos(math.pi * done))
            loss, count = loss_of(model, encoded, indices, place_of, answers)
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(trained, 1.0)
            optimizer.step()
            step += 1
            recent, counted = recent + float(loss.detach()) * count, counted + count
            tokens += sum(len(encoded[i][0]) for i in indices)
            if time.monotonic() - told > 60:
                print(f"{worked() / 60:.1f} min, epoch {epoch}, step {step}: {recent / counted:.4f} nats a token, "
                      f"{tokens / (time.monotonic() - told):.0f} tokens/s", flush=True)
                recent, counted, tokens, told = 0.0, 0, 0, time.monotonic()
            if worked() - saved > SAVED_EVERY_S:
                saved = worked()
                save(path, model, optimizer, step=step, spent=saved, epoch=epoch)
        epoch += 1
        save(path, model, optimizer, step=step, spent=worked(), epoch=epoch)
        if lesson.checked:
            unseen, a_text = unseen_loss(model, lesson)
            print(f"epoch {epoch} of {lesson} ends: left-out authors {unseen:.4f} nats a token, {a_text:.2f} a text", flush=True)
            with open(os.path.join(given.out, "loss.csv"), "a", encoding="utf-8") as file:
                file.write(f"{step},{worked() / 60:.2f},{unseen:.4f}\n")
    save(path, model, optimizer, step=step, spent=worked(), epoch=epoch)


if __name__ == "__main__":
    main()
