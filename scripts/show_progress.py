#!/usr/bin/env python3
"""Builds with Ninja and says in words how far it is; where a step fails, shows that one alone.

All that the build says goes to BUILD_DIR/build.log.

Usage: show_progress.py BUILD_DIR [further arguments for cmake --build, as --target world_server]
"""

import os
import pathlib
import re
import subprocess
import sys
import time

STATUS = re.compile(r"^@(\d+)/(\d+)@ ")  # what NINJA_STATUS below puts before every step
TOLD_PARTS = 10  # where no terminal looks on, a line each tenth


def in_words(seconds):
    """A span of time as people say it."""
    if seconds < 90:
        return f"{max(1, round(seconds))} s"
    return f"{round(seconds / 60)} min"


def line_of(done, all_steps, gone_s):
    """How far a build is; what is left is guessed once a twentieth is done."""
    line = f"built {done} of {all_steps} ({100 * done // all_steps} %), {in_words(gone_s)} gone"
    if done == all_steps or done < all_steps / 20:
        return line
    return line + f", about {in_words(gone_s * (all_steps - done) / done)} left"


class Teller:
    """Says a line where it is worth it: always on a terminal, which forgets the one before."""

    def __init__(self, out):
        self.out = out
        self.on_terminal = out.isatty()
        self.told_parts = 0

    def tell(self, done, all_steps, gone_s):
        if self.on_terminal:
            self.out.write(f"\r\033[K{line_of(done, all_steps, gone_s)}")
        elif TOLD_PARTS * done // all_steps > self.told_parts:
            self.told_parts = TOLD_PARTS * done // all_steps
            self.out.write(line_of(done, all_steps, gone_s) + "\n")
        self.out.flush()

    def end(self):
        if self.on_terminal:
            self.out.write("\n")


def first_failure(log_lines):
    """The lines of the first step that failed: its name, its command and what it said."""
    begin = next((i for i, line in enumerate(log_lines) if line.startswith("FAILED: ")), None)
    if begin is None:  # not a step: CMake, Ninja itself, or somebody who stopped it
        return log_lines[-5:]
    end = next((i for i in range(begin + 1, len(log_lines))
                if STATUS.match(log_lines[i]) or log_lines[i].startswith(("FAILED: ", "ninja: "))),
               len(log_lines))
    return log_lines[begin:end]


def main():
    build = pathlib.Path(sys.argv[1])
    command = ["cmake", "--build", str(build), "--parallel", str(len(os.sched_getaffinity(0))),
               *sys.argv[2:]]
    teller = Teller(sys.stdout)
    lines = []
    begin = time.monotonic()
    with open(build / "build.log", "w", encoding="utf-8") as log, \
            subprocess.Popen(command, env={**os.environ, "NINJA_STATUS": "@%f/%t@ "}, text=True,
                             errors="replace", stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT) as ninja:
        for line in ninja.stdout:
            log.write(line)
            lines.append(line.rstrip("\n"))
            step = STATUS.match(line)
            if step:
                teller.tell(int(step[1]), int(step[2]), time.monotonic() - begin)
    teller.end()
    if ninja.returncode != 0:
        print("\n".join(first_failure(lines)), file=sys.stderr)
        print(f"the build stopped there; all that it said is in {build / 'build.log'}",
              file=sys.stderr)
    return ninja.returncode


if __name__ == "__main__":
    sys.exit(main())
