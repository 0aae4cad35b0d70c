#!/usr/bin/env python3
"""Lays what examples for readers say: the sentences of each text are read as they stand (the reader `controlled`),
answered by `grounded`, and their own claims are measured on the answer. So much the small language and the synthesis
leave room for, and a pair that asks for what cannot be is found.

    scripts/score_sentences.py [--list] [FILE ...]      (files: JSON Lines as in training/examples, which are the default)

Relief and single things are no part of a layout: sentences on them are read, and measured on whole worlds alone.
"""

import argparse
import collections
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
KINDS = ("layout", "environment")
MISS = re.compile(r'^  pairs (\d+) (\w+): (".*")$')
WARNING = re.compile(r"^  pairs (\d+) warning: (.*)$")
ALL = re.compile(r"^  all claims +(\d+) of +(\d+) ")
# Warnings that say of a claim what its measure says already.
OF_CLAIMS = re.compile(r"^not satisfied: |: not met: ")


def read_pairs(paths):
    """[(file, line, example)] of files of JSON Lines."""
    pairs = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            pairs += [(path, number, json.loads(line)) for number, line in enumerate(file, 1) if line.strip()]
    return pairs


def text_of(sentences):
    return " ".join(f"{sentence}." for sentence in sentences)


def lay(program, examples):
    """What `latticeworld score` says of examples whose texts are their sentences: (claims, claims that hold, {index of an
    example: [what of it does not hold, or is warned of]})."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "pairs.jsonl")
        with open(path, "w", encoding="utf-8") as file:
            for example in examples:
                file.write(json.dumps({**example, "text": text_of(example["sentences"])}) + "\n")
        command = [program, "score", "--examples", path, "--reader", "controlled", "--generator", "grounded", "--misses",
                   "--warnings"]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stderr.strip()}")
    claims = held = 0
    missed, warned = collections.defaultdict(list), collections.defaultdict(list)
    for line in done.stdout.splitlines():
        if found := ALL.match(line):
            held, claims = held + int(found[1]), claims + int(found[2])
        elif found := WARNING.match(line):
            if not OF_CLAIMS.search(found[2]):
                warned[int(found[1]) - 1].append(found[2])
        elif found := MISS.match(line):
            missed[int(found[1]) - 1].append(f"{found[2]}: {found[3]}")
    return claims, held, missed, warned


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="FILE",
                        default=sorted(glob.glob(os.path.join(ROOT, "training/examples/**/*.jsonl"), recursive=True)))
    parser.add_argument("--program", default=os.path.join(ROOT, "devel/lib/latticeworld/latticeworld"),
                        help="latticeworld [that of devel/]")
    parser.add_argument("--list", action="store_true", help="also lists every pair of which something does not hold, or is "
                        "warned of")
    given = parser.parse_args()
    pairs = read_pairs(given.files)
    print(f"{'':<12}{'pairs':>8}{'that hold':>11}{'share':>8}{'claims':>8}{'that hold':>11}{'share':>8}{'warned of':>11}")
    for kind in KINDS:
        some = [pair for pair in pairs if pair[2]["kind"] == kind]
        if not some:
            continue
        claims, held, missed, warned = lay(given.program, [example for _, _, example in some])
        whole = len(some) - len(missed)
        print(f"{kind + 's':<12}{len(some):>8}{whole:>11}{whole / len(some):>8.3f}"
              f"{claims:>8}{held:>11}{held / max(1, claims):>8.3f}{len(warned):>11}", flush=True)
        if given.list:
            for index in sorted({*missed, *warned}):
                path, number, example = some[index]
                print(f"  {os.path.basename(path)}:{number} {text_of(example['sentences'])}")
                for word, what in (("missed", missed), ("warned", warned)):
                    print("".join(f"      {word}: {one}\n" for one in what.get(index, ())), end="")


if __name__ == "__main__":
    main()
