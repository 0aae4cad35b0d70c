#!/usr/bin/env python3
"""Makes docs/command_line.md of what the program itself says: every command and every option.

Usage: command_line_page.py PROGRAM > docs/command_line.md
"""

import re
import subprocess
import sys

import wrap_pages

HEAD = """# Command line

Every command of `latticeworld` and every option, in the program's own words;
`scripts/command_line_page.py` makes this page of `--help`. What the commands are for stands in [the
interfaces](interfaces.md#command-line), and what to do with them on [the tour](tour.md).

`latticeworld --version` tells the version. Exit status: 0 success, 1 failure, 2 unusable arguments,
texts or pictures.
"""
COLUMN = 30  # where the help tells what a name means; longer names have a line of their own


def help_of(program, *words):
    return subprocess.run([program, *words, "--help"], text=True, check=True,
                          stdout=subprocess.PIPE).stdout


def entries_of(text, section):
    """(name, what is said of it) of each line of a section of a help, as 'Options'."""
    found, before = [], ""
    for line in text.split(f"\n{section}:\n")[1].split("\n\n")[0].splitlines():
        if line[:COLUMN].strip():
            found.append((line[:COLUMN].strip(), line[COLUMN:]))
        else:
            found[-1] = (before.strip(), line.strip())
        before = line
    return found


def commands_of(program):
    return entries_of(help_of(program), "Subcommands")


def item_of(name, words):
    """An item of a list: an option or a file, and what is said of it."""
    needed = name.endswith(" REQUIRED")
    name = name.removesuffix(" REQUIRED")
    name = re.sub(r"^(\w+) \1\b", r"\1", name)  # of a file, which has no name but what it takes
    return f"- `{name}`{' (needed)' if needed else ''}: {words}"


def section_of(program, command):
    """A command's part of the page."""
    text = help_of(program, command)
    what, usage = text.split("\nUsage: ")
    lines = [f"## {command}", "", what.strip(), "", f"    {usage.splitlines()[0]}", ""]
    for section in ("Positionals", "Options"):
        if f"\n{section}:\n" in text:
            lines += [item_of(*entry) for entry in entries_of(text, section)
                      if entry[0] != "--help"]
    return "\n".join(lines).rstrip()


def page_of(program):
    sections = [section_of(program, command) for command, _ in commands_of(program)]
    return wrap_pages.wrap(HEAD + "\n" + "\n\n".join(sections))


if __name__ == "__main__":
    sys.stdout.write(page_of(sys.argv[1]))
