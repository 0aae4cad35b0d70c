#!/usr/bin/env python3
"""Compares who turns words into layouts and environments, and writes docs/models.md.

    scripts/compare_models.py --reader-model build/models/reader.gguf
    scripts/compare_models.py --local-model layout.gguf --local-environment-model grounded
    scripts/compare_models.py --remote-url http://127.0.0.1:8080/v1 --remote-dialect llama.cpp

Each reads and answers the instructions of a part of benchmarks/fidelity (`latticeworld score`); options that begin with
--local- or --remote- are that program's. The reader `controlled` reads no free text: it gets what people said by hand of
instructions of the development part (training/examples/development_*.jsonl), and the claims are those of the benchmark's
authors. Time is the median of one answer, memory the most that the process held.

What stands in the page below its line on hands stays as it is.
"""

import argparse
import datetime
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SAID = "controlled"  # a column of other texts than the rest
HAND = "<!-- What follows is written by hand; scripts/compare_models.py keeps it. -->\n"
ROW = re.compile(r"^  (\S.*?) +(\d+) of +(\d+) ")
TIME = re.compile(r"^  median time +([\d.]+) ms")


def read_tables(text):
    """What `latticeworld score` prints: {"layout" | "environment": {row's name: (satisfied, total), "time": ms}}."""
    tables, table = {}, None
    for line in text.splitlines():
        row, time = ROW.match(line), TIME.match(line)
        if row and table is not None:
            table[row[1]] = (int(row[2]), int(row[3]))
        elif time and table is not None:
            table["time"] = float(time[1])
        elif line and not line.startswith(" "):
            table = tables.setdefault(line.split(" ")[0], {})
    return tables


def score(program, benchmark, part, options):
    """The tables of one column; "memory" [MB] beside them. Ends this program where the score cannot be had."""
    command = [program, "score", "--benchmark", benchmark, "--part", part] + options
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    said, errors = process.stdout.read(), process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with {process.returncode}:\n{errors.strip()}")
    return {**read_tables(said), "memory": used.ru_maxrss / 1024}


def write_said(benchmark, examples, folder):
    """A benchmark of what was said by hand: the development part's instructions that examples have, in their sentences.
    Whether there are any."""
    said = {}
    for path in examples:
        with open(path, encoding="utf-8") as file:
            for example in map(json.loads, file):
                said[example["kind"], example["text"]] = "".join(f"{one}. " for one in example["sentences"]).strip()
    os.symlink(os.path.abspath(os.path.join(benchmark, "layouts")), os.path.join(folder, "layouts"))
    found = 0
    for kind in ("layout", "environment"):
        with open(os.path.join(benchmark, f"{kind}_development.json"), encoding="utf-8") as file:
            items = [{**item, "instruction": said[kind, item["instruction"]]}
                     for item in json.load(file) if (kind, item["instruction"]) in said]
        with open(os.path.join(folder, f"{kind}_development.json"), "w", encoding="utf-8") as file:
            json.dump(items, file)
        found += len(items)
    return found > 0


def score_said(given):
    """The tables of the reader `controlled`; None where nothing was said by hand."""
    with tempfile.TemporaryDirectory() as folder:
        if not write_said(given.benchmark, given.said, folder):
            return None
        return score(given.program, folder, "development", ["--reader", "controlled", "--generator", "grounded"])


def share(count):
    if count is None or count[1] == 0:
        return "-"
    return f"{count[0]} of {count[1]} ({count[0] / count[1]:.3f})"


def table_of(kind, scores):
    """Markdown: a column for each who reads or answers."""
    tables = {name: found[kind] for name, found in scores.items()}
    lines = ["| | " + " | ".join(tables) + " |", "|---|" + "---|" * len(tables)]

    def add(title, cell):
        lines.append(f"| {title} | " + " | ".join(cell(table) for table in tables.values()) + " |")

    add("valid answers", lambda table: share(table.get("valid answers")))
    add("**claims satisfied**", lambda table: f"**{share(table.get('all claims'))}**")
    add("median time of an answer", lambda table: f"{table['time']:.{0 if table['time'] >= 10 else 1}f} ms")
    kinds = sorted({row for table in tables.values() for row in table} - {"all claims", "valid answers", "time"})
    for row in kinds:
        add(row, lambda table, row=row: share(table.get(row)))
    return "\n".join(lines)


def best_of(scores):
    """The column with most claims of those that have the same texts and whose layouts are all valid."""
    whole = [name for name, found in scores.items()
             if name != SAID and len(set(found["layout"]["valid answers"])) == 1]
    sums = {name: sum(scores[name][kind]["all claims"][0] for kind in ("layout", "environment")) for name in whole}
    return max(sums, key=sums.get) if sums else None


def page(scores, given, more_of, version):
    memory = "\n".join(f"| {name} | {found['memory']:.0f} MB |" for name, found in scores.items())
    best = best_of(scores)
    local = ""
    if "local" in scores:
        file = given.local_model
        local = f"\n`local`: `{os.path.basename(file)}`, {os.path.getsize(file) / 1e6:.1f} MB"
        if given.local_environment_model:
            local += f"; environments by `{os.path.basename(given.local_environment_model)}`"
        if more_of["local"]:
            local += f"; `{' '.join(more_of['local'])}`"
        local += ". How it came about: [training](training.md).\n"
    who = "`rules`, `model` and `checked` read" if "model" in scores else "`rules` read"
    who += ", and `grounded` answers"
    others = [f"`{name}`" for name in ("local", "remote") if name in scores]
    if others:
        who += f"; {' and '.join(others)} {'read and answer' if len(others) > 1 else 'reads and answers'} by itself"
    said = ""
    if SAID in scores:
        said = f"""

`{SAID}` reads no free text. Its column has other texts: {scores[SAID]["layout"]["valid answers"][1]} layouts and
{scores[SAID]["environment"]["valid answers"][1]} environments of the development part, said in the [small
language](small_language.md) by hand; the claims are those that the benchmark's authors wrote down for the
texts as people wrote them."""
    return f"""# Readers and generators compared

Written by `scripts/compare_models.py` on {datetime.date.today().isoformat()}, {version}: the
{given.part} part of `benchmarks/fidelity`. What the kinds of claims mean is in
[language](language.md), how time is measured in [benchmarks](benchmarks.md). {who}.{said}
{local}
## Layouts

{table_of("layout", scores)}

## Environments

{table_of("environment", scores)}

## Memory

| | most that the process held |
|---|---|
{memory}

Of the columns of these texts whose layouts are all valid, **{best}** has the most claims.
"""


def kept_of(path):
    """What hands wrote below the tables of the page that there is, with the line above it; "" where there is none."""
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        _, line, kept = file.read().partition(HAND)
    return "\n" + line + kept if line else ""


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False
    )
    program = os.path.join(ROOT, "devel/lib/latticeworld/latticeworld")
    parser.add_argument("--program", default=program, help="latticeworld [that of devel/]")
    parser.add_argument("--benchmark", default=os.path.join(ROOT, "benchmarks/fidelity"))
    parser.add_argument("--part", choices=["development", "test", "first_sight"], default="test", help="[test]")
    parser.add_argument("--out", default=os.path.join(ROOT, "docs/models.md"))
    parser.add_argument("--reader-model", metavar="FILE", help="GGUF file; without it `model` and `checked` are left out")
    parser.add_argument("--local-model", metavar="FILE", help="GGUF file; without it `local` is left out")
    parser.add_argument("--local-environment-model", metavar="FILE", help="the same for environments, or grounded")
    parser.add_argument("--said", nargs="*", metavar="FILE", help="examples that say instructions of the development part "
                        "by hand, for `controlled` [training/examples/development_*.jsonl]",
                        default=sorted(glob.glob(os.path.join(ROOT, "training/examples/development_*.jsonl"))))
    given, more = parser.parse_known_args()

    more_of = {"local": [], "remote": []}
    name = None
    for word in more:
        if word.startswith("--"):
            name = word[2:].split("-")[0]
            if name not in more_of:
                parser.error(f"{word}: unknown; legal beside those of --help are --local-... and --remote-...")
        if name is None:
            parser.error(f"{word}: unknown")
        more_of[name].append(word)
    if more_of["local"] and not given.local_model:
        parser.error("options of a local model without --local-model")

    # A column each: who reads, and who answers where it is not grounded.
    options = {"rules": ["--reader", "rules"]}
    if given.reader_model:
        for reader in ("model", "checked"):
            options[reader] = ["--reader", reader, "--reader-model", given.reader_model]
    if given.local_model:
        options["local"] = ["--reader", "rules", "--local-model", given.local_model] + more_of["local"]
        if given.local_environment_model:
            options["local"] += ["--local-environment-model", given.local_environment_model]
    if more_of["remote"]:
        options["remote"] = ["--generator", "remote"] + more_of["remote"]
        options["remote reads"] = ["--reader", "remote", "--generator", "grounded"] + more_of["remote"]

    scores = {}
    for name, some in options.items():
        scores[name] = score(given.program, given.benchmark, given.part, some)
        if name == "rules" and (said := score_said(given)) is not None:
            scores[SAID] = said
    version = subprocess.run([given.program, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    kept = kept_of(given.out)
    with open(given.out, "w", encoding="utf-8") as file:
        file.write(page(scores, given, more_of, version) + kept)
    subprocess.run([sys.executable, os.path.join(ROOT, "scripts/wrap_pages.py"), given.out], check=True)
    print(given.out)


if __name__ == "__main__":
    main()
