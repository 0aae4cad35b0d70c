"""What the programs of this folder have in common: exports of the shared world, and what is found
with them. peers/run.py reads the result."""

import csv
import json
import os
import pathlib
import subprocess
import sys

PROGRAM = os.environ["PEER_PROGRAM"]
WORLDS = pathlib.Path(os.environ["PEER_WORLDS"])
FOLDER = pathlib.Path(os.environ["PEER_FOLDER"])  # of this peer alone


class Peer:
    """name, version: of the program; fed: what it was given; must: what a user has to do for it."""

    def __init__(self, name, version, fed, must=""):
        self.result = {"name": name, "version": version, "fed": fed, "must": must, "checks": []}
        print(f"{name} {version}: {fed}")

    def check(self, name, ok, figures):
        """ok: as this project says that it is, good or bad."""
        self.result["checks"].append([name, bool(ok), str(figures)])
        print(f"{'ok' if ok else 'OFF':4} {name}: {figures}", flush=True)

    def finish(self):
        pathlib.Path(os.environ["PEER_RESULT"]).write_text(json.dumps(self.result))
        sys.stdout.flush()
        # At once: some libraries wait for threads of theirs when a program ends.
        os._exit(0 if all(ok for _, ok, _ in self.result["checks"]) else 1)


def export(form, name, *options):
    """The path of an export of the shared world, made where it is not there yet."""
    path = WORLDS / name
    if not path.exists():
        done = subprocess.run([PROGRAM, "export", WORLDS / "world", "--to", form, "--out", path,
                               *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)
        if done.returncode != 0:
            sys.exit(done.stdout)
    return path


def assets():
    """The rows of assets.csv."""
    with open(WORLDS / "world" / "assets.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def run(*command, **options):
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False, **options)
