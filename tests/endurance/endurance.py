#!/usr/bin/python3
"""Runs the programs of a build until time is up: cut off, filled up, left running, attacked.

scripts/endurance.sh calls it. Exit status 1 where a promise was broken.
"""

import argparse
import pathlib
import platform
import random
import sys
import tempfile
import time

import cut_off
import filled_up
import left_running
import let_nobody_in
from ground import Ground, own_mounts
from ledger import BrokenPromise, Ledger

PARTS = {"cut_off": (cut_off.run, 0.4), "filled_up": (filled_up.run, 0.25),
         "left_running": (left_running.run, 0.2), "let_nobody_in": (let_nobody_in.run, 0.15)}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True,
                        help="folder of world_server and the other programs")
    parser.add_argument("--libraries", type=pathlib.Path, required=True,
                        help="folder of the preloaded libraries")
    parser.add_argument("--minutes", type=float, required=True, help="for all parts together")
    parser.add_argument("--only", choices=PARTS, action="append", help="a part [all]")
    parser.add_argument("--seed", type=int, default=1, help="of the moments and of the order [1]")
    parser.add_argument("--report", type=pathlib.Path, help="Markdown file for the tables")
    return parser.parse_args()


def run(ground, given):
    parts = given.only or list(PARTS)
    shares = sum(PARTS[name][1] for name in parts)
    ledgers = []
    for name in parts:
        call, share = PARTS[name]
        end = time.monotonic() + 60.0 * given.minutes * share / shares
        print(f"{name} ...", flush=True)
        try:
            ledgers.append(call(ground, end, random.Random(f"{given.seed} {name}")))
        except BrokenPromise as broken:  # before a round began
            ledgers.append(Ledger(name))
            ledgers[-1].broken.append(str(broken))
        print(ledgers[-1].markdown(), flush=True)
    return ledgers


def report(given, ledgers, seconds):
    date = time.strftime("%Y-%m-%d", time.gmtime())
    lines = [f"Run of {date}: {seconds / 60:.1f} minutes, seed {given.seed}, "
             f"{platform.system()} {platform.machine()}.", ""]
    return "\n".join(lines + [ledger.markdown() for ledger in ledgers])


def main():
    given = arguments()
    own_mounts()
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="latticeworld_endurance_") as folder:
        libraries = {path.stem.removeprefix("lib"): path for path in given.libraries.glob("*.so")}
        with Ground(pathlib.Path(folder), given.programs, libraries) as ground:
            ledgers = run(ground, given)
    if given.report:
        given.report.write_text(report(given, ledgers, time.monotonic() - began), encoding="utf-8")
    return 1 if any(ledger.broken for ledger in ledgers) else 0


if __name__ == "__main__":
    sys.exit(main())
