#!/usr/bin/python3
"""Runs the programs of a build until time is up: cut off, filled up, left running, attacked, raced.

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
import races
from ground import Ground, own_mounts
from ledger import BrokenPromise, Ledger, broken_promises, read_events, section

# name -> module, share of the time; 0: it is run where it is named alone
PARTS = {"cut_off": (cut_off, 0.4), "filled_up": (filled_up, 0.25),
         "left_running": (left_running, 0.2), "let_nobody_in": (let_nobody_in, 0.15),
         "races": (races, 0.0)}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True,
                        help="folder of world_server and the other programs")
    parser.add_argument("--libraries", type=pathlib.Path, required=True,
                        help="folder of the preloaded libraries")
    parser.add_argument("--minutes", type=float, required=True, help="for all parts together")
    parser.add_argument("--only", choices=PARTS, action="append",
                        help="a part [all but races, for which programs have to be built]")
    parser.add_argument("--round", action="append",
                        help="only rounds and phases whose name begins so [all]; not of races")
    parser.add_argument("--seed", type=int, default=1, help="of the moments and of the order [1]")
    parser.add_argument("--ledger", type=pathlib.Path,
                        help="file that every round is appended to; the tables are of all in it")
    parser.add_argument("--report", type=pathlib.Path, help="Markdown file for the tables")
    return parser.parse_args()


def run(ground, given, file):
    """The events of all parts that were asked for."""
    parts = given.only or [name for name, (_, share) in PARTS.items() if share]
    shares = {name: PARTS[name][1] or 1.0 for name in parts}
    ground.wanted = tuple(given.round or [""])
    events = []
    for name in parts:
        end = time.monotonic() + 60.0 * given.minutes * shares[name] / sum(shares.values())
        print(f"{name} ...", flush=True)
        ledger = Ledger(name, file)
        try:
            PARTS[name][0].run(ground, end, random.Random(f"{given.seed} {name}"), ledger)
        except BrokenPromise as broken:  # outside of a round
            ledger.note("broken", what=str(broken))
            print(f"BROKEN  {name}: {broken}", flush=True)
        events += ledger.events
    return events


def report(events):
    parts = {name: [event for event in events if event["part"] == name] for name in PARTS}
    return "\n".join(section(PARTS[name][0].TITLE, some, PARTS[name][0].tables)
                     for name, some in parts.items() if some)


def main():
    given = arguments()
    own_mounts()
    libraries = {path.stem.removeprefix("lib"): path for path in given.libraries.glob("*.so")}
    file = open(given.ledger, "a", encoding="utf-8") if given.ledger else None
    with tempfile.TemporaryDirectory(prefix="latticeworld_endurance_") as folder, \
            Ground(pathlib.Path(folder), given.programs, libraries) as ground:
        events = run(ground, given, file)
    if file:
        file.close()
    said = report(read_events(given.ledger) if given.ledger else events)
    print(said)
    if given.report:
        head = f"Run of {time.strftime('%Y-%m-%d', time.gmtime())}, {platform.machine()}.\n\n"
        given.report.write_text(head + said, encoding="utf-8")
    return 1 if broken_promises(events) else 0


if __name__ == "__main__":
    sys.exit(main())
