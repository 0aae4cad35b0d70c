"""Conversations of a small data set, as models of their kind are trained on."""

import json
import pathlib
import subprocess

from peer import PROGRAM, WORLDS

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
MODELS = REPOSITORY / "models"


def data_set(kind):
    """The folder of a data set of one kind, "layout" or "environment", without pictures."""
    folder = WORLDS / f"data-{kind}"
    if not folder.exists():
        subprocess.run([PROGRAM, "dataset", "--generate", "8", "--seed", "3", f"--{kind}",
                        "--no-images", "--prompts", "short", "--relief-share", "0", "--split",
                        "1,0", "--out", folder], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
    return folder


def conversations(kind):
    """Its lists of messages."""
    with open(data_set(kind) / kind / "train.jsonl", encoding="utf-8") as file:
        return [json.loads(line)["messages"] for line in file]
