"""A small level world with a robot, for environments."""

import subprocess

from peer import PROGRAM, WORLDS


def meadow():
    """The path of its bundle, made where it is not there yet."""
    path = WORLDS / "meadow"
    if not path.exists():
        subprocess.run([PROGRAM, "generate", "--layout", "Flat grassland, some trees.",
                        "--environment", "A wheeled robot waits in the center.", "--seed", "3",
                        "--size", "64", "--resolution", "0.5", "--out", path], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return path
