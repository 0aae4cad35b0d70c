#!/usr/bin/env python3
"""Where the time of a build goes, from Ninja's own log: the table of docs/building.md.

Times are a step's from begin to end, so they are comparable only within one build, and nothing else
should have run beside it.

Usage: build_times.py BUILD_DIR [TARGET]   (TARGET: what is built by default in scripts/run.sh)
"""

import collections
import pathlib
import re
import subprocess
import sys

# Parts of the tree by what the path of a step's output begins with; the first that fits counts.
PARTS = (("the core", r"src/latticeworld/"), ("ROS: libraries", r"src/latticeworld_ros/"),
         ("ROS: programs", r"src/nodes/"), ("command line", r"src/tools/"), ("the page", r"web/"),
         ("tests and examples", r"tests/|examples/"), ("benchmarks", r"benchmarks/"),
         ("messages, linking", r""))


def steps_of(build):
    """The steps of the newest build of each output: {outputs: seconds}."""
    newest = {}
    for line in (build / ".ninja_log").read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            continue
        begin_ms, end_ms, _, output, command = line.split("\t")
        newest[output] = (int(begin_ms), int(end_ms), command)
    outputs = collections.defaultdict(list)
    for output, step in newest.items():
        outputs[step].append(output)  # one step may have many outputs
    return {tuple(names): (end - begin) / 1000 for (begin, end, _), names in outputs.items()}


def needed_by(build, target):
    """Every file that a target is made of."""
    said = subprocess.run(["ninja", "-C", str(build), "-t", "inputs", target], text=True,
                          check=True, stdout=subprocess.PIPE).stdout
    return {target, *said.splitlines()}


def part_of(output):
    return next(name for name, pattern in PARTS if re.match(pattern, output))


def main():
    build = pathlib.Path(sys.argv[1])
    needed = needed_by(build, sys.argv[2] if len(sys.argv) > 2 else "world_server")
    seconds, count, server = (collections.Counter() for _ in range(3))
    for outputs, span in steps_of(build).items():
        part = part_of(outputs[0])
        seconds[part] += span
        count[part] += 1
        server[part] += span if needed.intersection(outputs) else 0
    everything = sum(seconds.values())
    print("| part | steps | seconds | share | for the server alone |\n|---|---|---|---|---|")
    for part, _ in PARTS:
        if count[part]:
            print(f"| {part} | {count[part]} | {seconds[part]:.0f} | "
                  f"{seconds[part] / everything:.2f} | {server[part] / everything:.2f} |")
    print(f"| all | {sum(count.values())} | {everything:.0f} | 1.00 | "
          f"{sum(server.values()) / everything:.2f} |")


if __name__ == "__main__":
    main()
