"""Examples for readers: texts and the sentences of the small language that they mean.

A file is JSON Lines, an object a line:
  {"kind": "layout", "author": "a01", "voice": "a hiker", "vocabulary": "suburb", "text": "...", "sentences": ["...", ...]}
kind: "layout" or "environment". vocabulary: "suburb" or "wild", of layouts alone. An author is a hand that wrote; whoever
is left out of training is left out by author.

Writes such files from the texts of authors, "V:", "T:" or "W:" and "S:" lines:
    python3 -m latticeworld_training.reader_examples --kind layout --author a01 text-1.txt text-2.txt >> layouts.jsonl
"""

import argparse
import glob
import json
import random
import sys

from . import small_language

PROMPT = "<|im_start|>system\n{kind}<|im_end|>\n<|im_start|>user\n{text}<|im_end|>\n<|im_start|>assistant\n"
END = "<|im_end|>"


def read_examples(paths, without=(), only=None):
    """The examples of files; `without` leaves authors out, `only` keeps no others."""
    examples = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for line in file:
                example = json.loads(line)
                if example["author"] not in without and (only is None or example["author"] in only):
                    examples.append(example)
    return examples


def add_lesson_arguments(parser, rate, minutes):
    """What every program that teaches a reader is told: examples, rate, time, threads, seed."""
    parser.add_argument("--data", nargs="+", required=True, help="JSON Lines")
    parser.add_argument("--share", type=float, default=1.0, help="of the examples, for a learning curve [1]")
    parser.add_argument("--rate", type=float, default=rate, help=f"of learning [{rate:g}]")
    parser.add_argument("--minutes", type=float, default=minutes,
                        help=f"of the processors' time, over which the rate falls to nothing [{minutes:g}]")
    parser.add_argument("--threads", type=int, default=2, help="of the processor [2]")
    parser.add_argument("--seed", type=int, default=1, help="[1]")


def paths_of(given):
    return [path for pattern in given.data for path in sorted(glob.glob(pattern))]


def chosen_examples(given, without=()):
    """The share of the examples that is asked for, in an order drawn from the seed."""
    examples = read_examples(paths_of(given), without=without)
    random.Random(given.seed).shuffle(examples)
    return examples[: max(1, round(given.share * len(examples)))]


def batches_of(lengths, most, draws):
    """Indices of what is of like length, at most so much together, in a drawn order."""
    order = sorted(range(len(lengths)), key=lambda i: lengths[i] + draws.random() * 16)
    batches, batch = [], []
    for i in order:
        if batch and (len(batch) + 1) * lengths[i] > most:
            batches.append(batch)
            batch = []
        batch.append(i)
    batches.append(batch)
    draws.shuffle(batches)
    return batches


def answer_of(example):
    """What a model answers: the sentences with their stops, or a dash."""
    return " ".join(f"{sentence}." for sentence in example["sentences"]) or "-"


def faults_of(example):
    """What is wrong with an example, a text each; none where nothing is."""
    if not example["text"].strip():
        return ["the text is empty"]
    return [f"no sentence of the small language: {sentence}" for sentence in example["sentences"]
            if small_language.form_of(sentence, example["kind"]) is None]


def parse_lines(lines, kind, author):
    """The examples of an author's lines; a line that is none of the format raises ValueError."""
    examples, voice, text = [], "", None
    for number, line in enumerate(lines, 1):
        line = line.strip()
        mark, rest = line[:2], line[2:].strip()
        if not line:
            continue
        if mark == "V:":
            voice = rest
        elif mark in ("T:", "W:"):
            text = (rest.replace("\\n", "\n"), "wild" if mark == "W:" else "suburb")
        elif mark == "S:" and text is not None:
            example = {"kind": kind, "author": author, "voice": voice}
            if kind == "layout":
                example["vocabulary"] = text[1]
            example["text"] = text[0]
            example["sentences"] = [] if rest == "-" else small_language.split(rest)
            examples.append(example)
            text = None
        else:
            raise ValueError(f"line {number}: neither V:, T:, W: nor S: after a text: {line[:60]}")
    return examples


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kind", choices=("layout", "environment"), required=True)
    parser.add_argument("--author", required=True)
    parser.add_argument("files", nargs="+")
    given = parser.parse_args()
    for path in given.files:
        with open(path, encoding="utf-8") as file:
            for example in parse_lines(file, given.kind, given.author):
                faults = faults_of(example)
                if faults:
                    print(f"{path}: left out: {example['text'][:60]}: {faults[0]}", file=sys.stderr)
                else:
                    print(json.dumps(example, ensure_ascii=False))


if __name__ == "__main__":
    main()
