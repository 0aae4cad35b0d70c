#!/usr/bin/env python3
"""Compares who turns words into layouts and environments, and writes docs/models.md.

    scripts/compare_models.py --reader-model build/models/reader.gguf
    scripts/compare_models.py --local-model layout.gguf --local-environment-model grounded
    scripts/compare_models.py --remote-url http://127.0.0.1:8080/v1 --remote-dialect llama.cpp

Each reads and answers the instructions of a part of benchmarks/fidelity (`latticeworld score`); options that begin with
--local- or --remote- are that program's. Time is the median of one answer, memory the most that the process held.
"""

import argparse
import datetime
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
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
    """The column with most claims of those whose layouts are all valid."""
    whole = [name for name, found in scores.items() if len(set(found["layout"]["valid answers"])) == 1]
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
    return f"""# Readers and generators compared

Written by `scripts/compare_models.py` on {datetime.date.today().isoformat()}, {version}: the
{given.part} part of `benchmarks/fidelity`. What the kinds of claims mean is in
[language](language.md), how time is measured in [benchmarks](benchmarks.md). `rules`, `model` and
`checked` read, and `grounded` answers; `local` and `remote` read and answer themselves.
{local}
## Layouts

{table_of("layout", scores)}

## Environments

{table_of("environment", scores)}

## Memory

| | most that the process held |
|---|---|
{memory}

Of the columns whose layouts are all valid, **{best}** has the most claims.
"""


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

    scores = {name: score(given.program, given.benchmark, given.part, some) for name, some in options.items()}
    version = subprocess.run([given.program, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    with open(given.out, "w", encoding="utf-8") as file:
        file.write(page(scores, given, more_of, version))
    print(given.out)


if __name__ == "__main__":
    main()
