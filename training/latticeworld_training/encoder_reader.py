"""A reader of another make, for comparison: a sentence encoder with a small decoder over the words of the small language.

    python3 -m latticeworld_training.encoder_reader train --encoder DIR --data 'examples/*.jsonl' --out run --minutes 15 \\
        --left-out examples/left_out/*.jsonl
    python3 -m latticeworld_training.encoder_reader read --encoder DIR --run run --data examples/left_out/g01.jsonl > said.jsonl

DIR has a BERT of Hugging Face's layout (model.safetensors, config.json, tokenizer.json or vocab.txt), such as
all-MiniLM-L6-v2. All weights learn. The decoder (Vaswani et al. 2017, norms first) sees the encoder's last layer; its
symbols are the words, digits and marks of the sentences in the examples. `read` writes the examples with their texts
replaced by what was read: `latticeworld score --examples said.jsonl --reader controlled` then counts claims.
"""

import argparse
import json
import math
import os
import random
import re
import sys
import time

import torch
from safetensors.torch import load_file
from tokenizers import BertWordPieceTokenizer, Tokenizer
from torch import nn
from torch.nn import functional

from . import small_language
from .reader_examples import add_lesson_arguments, batches_of, chosen_examples, paths_of, read_examples
from .whole_files import whole_file

SYMBOLS = re.compile(r"\d|[A-Za-z]+(?:-[A-Za-z]+)*|\S")
PAD, BEGIN, END, GLUE = range(4)  # GLUE: the next symbol follows without a blank
PIECES_AT_ONCE = 6144
LONGEST_ANSWER = 400


def symbols_of(example):
    """The symbols of an example's sentences; where two stand side by side without a blank, GLUE is between them."""
    text, out, last = " ".join(f"{sentence}." for sentence in example["sentences"]) or "-", [], 0
    for match in SYMBOLS.finditer(text):
        if match.start() == last and last > 0:
            out.append(GLUE)
        out.append(match.group())
        last = match.end()
    return out


class EncoderLayer(nn.Module):
    """A layer of BERT (Devlin et al. 2019): norms after the sums."""

    def __init__(self, width, heads, hidden, epsilon):
        super().__init__()
        self.heads = heads
        self.query, self.key, self.value, self.out = (nn.Linear(width, width) for _ in range(4))
        self.attention_norm, self.norm = nn.LayerNorm(width, epsilon), nn.LayerNorm(width, epsilon)
        self.up, self.down = nn.Linear(width, hidden), nn.Linear(hidden, width)

    def forward(self, x, mask):
        x = self.attention_norm(x + self.out(attend(self.query(x), self.key(x), self.value(x), self.heads, mask)))
        return self.norm(x + self.down(functional.gelu(self.up(x))))


def attend(query, key, value, heads, mask):
    split = lambda x: x.view(*x.shape[:2], heads, -1).transpose(1, 2)
    query, key, value = split(query), split(key), split(value)
    scores = query @ key.transpose(2, 3) * query.shape[-1] ** -0.5 + mask
    return (scores.softmax(-1) @ value).transpose(1, 2).flatten(2)


class DecoderLayer(nn.Module):
    def __init__(self, width, heads, hidden):
        super().__init__()
        self.heads = heads
        self.norms = nn.ModuleList(nn.LayerNorm(width) for _ in range(3))
        self.own, self.out = nn.Linear(width, 3 * width), nn.Linear(width, width)
        self.asked, self.seen, self.told = nn.Linear(width, width), nn.Linear(width, 2 * width), nn.Linear(width, width)
        self.up, self.down = nn.Linear(width, hidden), nn.Linear(hidden, width)

    def forward(self, x, causal, memory, mask):
        x = x + self.out(attend(*self.own(self.norms[0](x)).chunk(3, -1), self.heads, causal))
        key, value = self.seen(memory).chunk(2, -1)
        x = x + self.told(attend(self.asked(self.norms[1](x)), key, value, self.heads, mask))
        return x + self.down(functional.gelu(self.up(self.norms[2](x))))


class EncoderReader(nn.Module):
    """pieces (batch, n), symbols (batch, m) -> logits (batch, m, symbols)."""

    def __init__(self, config, symbols, layers, drop):
        super().__init__()
        width, heads, hidden = config["hidden_size"], config["num_attention_heads"], config["intermediate_size"]
        self.words = nn.Embedding(config["vocab_size"], width)
        self.places = nn.Embedding(config["max_position_embeddings"], width)
        self.embedding_norm = nn.LayerNorm(width, config["layer_norm_eps"])
        self.encoder = nn.ModuleList(
            EncoderLayer(width, heads, hidden, config["layer_norm_eps"]) for _ in range(config["num_hidden_layers"]))
        self.symbols = nn.Embedding(symbols, width)
        self.steps = nn.Embedding(LONGEST_ANSWER, width)
        self.kind = nn.Embedding(2, width)
        nn.init.normal_(self.symbols.weight, std=0.05)
        nn.init.normal_(self.steps.weight, std=0.05)
        self.decoder = nn.ModuleList(DecoderLayer(width, heads, 3 * width) for _ in range(layers))
        self.norm = nn.LayerNorm(width)
        self.drop = nn.Dropout(drop)

    def encode(self, pieces, kinds):
        mask = torch.where(pieces == 0, -1e9, 0.0)[:, None, None, :]
        x = self.words(pieces) + self.places(torch.arange(pieces.shape[1])) + self.kind(kinds)[:, None]
        x = self.drop(self.embedding_norm(x))
        for layer in self.encoder:
            x = layer(x, mask)
        return x, mask

    def decode(self, symbols, memory, mask):
        length = symbols.shape[1]
        causal = torch.full((length, length), -1e9).triu(1)
        x = self.drop(self.symbols(symbols) + self.steps(torch.arange(length)))
        for layer in self.decoder:
            x = layer(x, causal, memory, mask)
        return functional.linear(self.norm(x), self.symbols.weight)

    def load_encoder(self, state):
        """Takes the weights of a file of Hugging Face's BERT."""
        state = {name.removeprefix("bert."): weights for name, weights in state.items()}
        take = lambda part, name: [getattr(part, kind).data.copy_(state[f"{name}.{kind}"])
                                   for kind in ("weight", "bias") if hasattr(part, kind)]
        take(self.words, "embeddings.word_embeddings")
        take(self.places, "embeddings.position_embeddings")
        take(self.embedding_norm, "embeddings.LayerNorm")
        self.kind.weight.data.copy_(state["embeddings.token_type_embeddings.weight"][:1].repeat(2, 1))
        for number, layer in enumerate(self.encoder):
            at = f"encoder.layer.{number}"
            for part, name in ((layer.query, "attention.self.query"), (layer.key, "attention.self.key"),
                               (layer.value, "attention.self.value"), (layer.out, "attention.output.dense"),
                               (layer.attention_norm, "attention.output.LayerNorm"), (layer.up, "intermediate.dense"),
                               (layer.down, "output.dense"), (layer.norm, "output.LayerNorm")):
                take(part, f"{at}.{name}")


def read_encoder(folder):
    """(config, weights, tokenizer) of a folder."""
    with open(os.path.join(folder, "config.json"), encoding="utf-8") as file:
        config = json.load(file)
    vocabulary = os.path.join(folder, "vocab.txt")
    tokenizer = (BertWordPieceTokenizer(vocabulary) if os.path.exists(vocabulary)
                 else Tokenizer.from_file(os.path.join(folder, "tokenizer.json")))
    tokenizer.no_padding()
    tokenizer.enable_truncation(500)
    return config, load_file(os.path.join(folder, "model.safetensors")), tokenizer


def padded(rows):
    out = torch.zeros(len(rows), max(map(len, rows)), dtype=torch.long)
    for row, ids in enumerate(rows):
        out[row, : len(ids)] = torch.tensor(ids)
    return out


def train(given):
    torch.set_num_threads(given.threads)
    torch.manual_seed(given.seed)
    config, weights, tokenizer = read_encoder(given.encoder)
    examples = chosen_examples(given)
    said = [symbols_of(example) for example in examples]
    names = ["", "", "", ""] + sorted({symbol for row in said for symbol in row if symbol != GLUE})
    place = {name: i for i, name in enumerate(names) if name} | {GLUE: GLUE}
    answers = [[BEGIN] + [place[symbol] for symbol in row][: LONGEST_ANSWER - 2] + [END] for row in said]
    pieces = [tokenizer.encode(example["text"]).ids for example in examples]
    kinds = torch.tensor([example["kind"] == "environment" for example in examples]).long()
    model = EncoderReader(config, len(names), given.layers, given.drop)
    if given.blank:
        model.apply(lambda part: nn.init.normal_(part.weight, std=0.05) if isinstance(part, nn.Embedding) else None)
    else:
        model.load_encoder(weights)
    old = list(model.words.parameters()) + list(model.places.parameters()) + list(model.encoder.parameters())
    known = set(map(id, old))
    new = [p for p in model.parameters() if id(p) not in known]
    optimizer = torch.optim.AdamW([{"params": old, "rate": given.rate * given.slower}, {"params": new, "rate": given.rate}],
                                  betas=(0.9, 0.98), weight_decay=0.01)
    print(f"{sum(p.numel() for p in model.parameters())} weights, {len(examples)} examples, {len(names)} symbols", flush=True)
    os.makedirs(given.out, exist_ok=True)
    worked = lambda: (time.process_time() - began) / given.threads / 60.0
    began, told, step, epoch, recent, counted = time.process_time(), time.monotonic(), 0, 0, 0.0, 0
    sizes = [max(len(a), len(b)) for a, b in zip(pieces, answers)]
    while worked() < given.minutes:
        for batch in batches_of(sizes, PIECES_AT_ONCE, random.Random(f"{given.seed} {epoch}")):
            done = worked() / given.minutes
            if done >= 1.0:
                break
            for group in optimizer.param_groups:
                group["lr"] = group["rate"] * min(1.0, (step + 1) / 200) * 0.5 * (1 + math.cos(math.pi * done))
            target = padded([answers[i] for i in batch])
            with torch.autocast("cpu", torch.bfloat16):
                memory, mask = model.encode(padded([pieces[i] for i in batch]), kinds[batch])
                logits = model.decode(target[:, :-1], memory, mask)
            loss = functional.cross_entropy(logits.float().flatten(0, 1), target[:, 1:].flatten(), ignore_index=PAD,
                                            label_smoothing=0.05)
            optimizer.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(model.parameters(), 1.0)
            optimizer.step()
            step, recent, counted = step + 1, recent + float(loss.detach()), counted + 1
            if time.monotonic() - told > 60:
                print(f"{worked():.1f} min, epoch {epoch}, step {step}: {recent / counted:.4f}", flush=True)
                recent, counted, told = 0.0, 0, time.monotonic()
        epoch += 1
    with whole_file(os.path.join(given.out, "reader.pt"), "wb") as file:
        torch.save({"weights": model.state_dict(), "names": names, "layers": given.layers}, file)
    print(f"{epoch} epochs, {step} steps", flush=True)
    if given.left_out:
        print(f"left-out authors {nats_a_text(model, tokenizer, place, read_examples(given.left_out)):.2f} nats a text", flush=True)


def nats_a_text(model, tokenizer, place, examples):
    """What the sentences of a text cost at the mean; texts with symbols that nobody taught are left out."""
    model.eval()
    total = count = 0
    for example in examples:
        symbols = symbols_of(example)
        if all(symbol in place for symbol in symbols):
            ids = torch.tensor([[BEGIN] + [place[symbol] for symbol in symbols] + [END]])
            with torch.no_grad():
                memory, mask = model.encode(torch.tensor([tokenizer.encode(example["text"]).ids]),
                                            torch.tensor([int(example["kind"] == "environment")]))
                logits = model.decode(ids[:, :-1], memory, mask)
            total += float(functional.cross_entropy(logits[0], ids[0, 1:], reduction="sum"))
            count += 1
    return total / count


def text_of(symbols):
    out, glued = "", True
    for symbol in symbols:
        if symbol == GLUE:
            glued = True
            continue
        out += ("" if glued else " ") + symbol
        glued = False
    return out


def read(given):
    torch.set_num_threads(given.threads)
    config, _, tokenizer = read_encoder(given.encoder)
    state = torch.load(os.path.join(given.run, "reader.pt"), weights_only=False)
    names = state["names"]
    model = EncoderReader(config, len(names), state["layers"], 0.0)
    model.load_state_dict(state["weights"])
    model.eval()
    illegal = count = exact = 0
    began = time.monotonic()
    for example in read_examples(paths_of(given))[: given.first]:
        with torch.no_grad():
            memory, mask = model.encode(torch.tensor([tokenizer.encode(example["text"]).ids]),
                                        torch.tensor([int(example["kind"] == "environment")]))
            ids = [BEGIN]
            while ids[-1] != END and len(ids) < LONGEST_ANSWER:
                ids.append(int(model.decode(torch.tensor([ids]), memory, mask)[0, -1].argmax()))
        text = text_of([GLUE if i == GLUE else names[i] for i in ids[1:] if i != END])
        sentences = [] if text == "-" else small_language.split(text)
        legal = [s for s in sentences if small_language.form_of(s, example["kind"])]
        illegal, count = illegal + len(sentences) - len(legal), count + len(sentences)
        exact += legal == example["sentences"]
        print(json.dumps({**example, "asked": example["text"], "text": " ".join(f"{s}." for s in legal) or "."}), flush=True)
    print(f"{illegal} of {count} sentences illegal, {exact} texts to the letter, {time.monotonic() - began:.1f} s", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("train", "read"))
    add_lesson_arguments(parser, rate=1e-3, minutes=15.0)
    parser.add_argument("--encoder", required=True, help="folder of the encoder")
    parser.add_argument("--out", help="train: folder of the run")
    parser.add_argument("--run", help="read: folder of the run")
    parser.add_argument("--left-out", nargs="*", help="train: JSON Lines that are measured in the end")
    parser.add_argument("--blank", type=int, default=0, help="1: the encoder begins from nothing too [0]")
    parser.add_argument("--first", type=int, default=None, help="read: so many examples at most")
    parser.add_argument("--layers", type=int, default=4, help="of the decoder [4]")
    parser.add_argument("--drop", type=float, default=0.1, help="share of embeddings' values that are dropped [0.1]")
    parser.add_argument("--slower", type=float, default=0.2, help="the encoder's rate over the decoder's [0.2]")
    given = parser.parse_args()
    (train if given.what == "train" else read)(given)


if __name__ == "__main__":
    main()
