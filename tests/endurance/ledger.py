"""What the parts of an endurance run do and find, event by event, and tables of it."""

import collections
import json
import time


class BrokenPromise(AssertionError):
    """Something that docs and interfaces promise was not so."""


def promise(kept, what):
    """Fails with what was promised and what was there instead."""
    if not kept:
        raise BrokenPromise(what)


class Ledger:
    """Events of one part: dicts of a round's name, what it broke (None: nothing) and its time, or
    of a note's kind and fields. file: each event is appended to it as a line of JSON."""

    def __init__(self, part, file=None):
        self.part, self.file = part, file
        self.events = []

    def _add(self, **event):
        self.events.append({"part": self.part, **event})
        if self.file:
            self.file.write(json.dumps(self.events[-1]) + "\n")
            self.file.flush()

    def note(self, kind, **fields):
        self._add(note=kind, **fields)

    def watch(self, name, call):
        """One round of `name`; a promise that it breaks is written down, and the run goes on."""
        began, broken = time.monotonic(), None
        try:
            call()
        except BrokenPromise as error:
            broken = str(error)
        seconds = round(time.monotonic() - began, 1)
        self._add(round=name, broken=broken, seconds=seconds)
        print(f"{'kept   ' if broken is None else 'BROKEN '} {self.part}: {name} ({seconds} s)"
              f"{': ' + broken if broken else ''}", flush=True)
        return broken is None


def read_events(path):
    """Those of all runs that were appended to a file."""
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def notes(events, kind):
    return [event for event in events if event.get("note") == kind]


def broken_promises(events):
    """(round, what) -> how often."""
    return collections.Counter(
        [(event["round"], event["broken"]) for event in events if event.get("broken")] +
        [("outside of a round", event["what"]) for event in notes(events, "broken")])


def table(columns, rows):
    """Lines of a table in Markdown; none where there are no rows."""
    cells = [[" ".join(str(cell).replace("|", "/").split()) for cell in row] for row in rows]
    lines = ["| " + " | ".join(row) + " |" for row in [columns, *cells]]
    return [lines[0], "|" + "---|" * len(columns), *lines[1:], ""] if rows else []


def rounds_table(events):
    """How often each round ran, and how often it broke something."""
    rounds = collections.Counter(event["round"] for event in events if "round" in event)
    broken = collections.Counter(event["round"] for event in events if event.get("broken"))
    return table(["rounds of", "count", "broken"],
                 [[name, count, broken[name]] for name, count in sorted(rounds.items())])


def section(title, events, tables):
    """A part in Markdown; tables: function of events that gives lines."""
    broken = broken_promises(events)
    lines = [f"## {title}", "", *tables(events), f"Broken promises: {sum(broken.values())}.", ""]
    lines += [f"- {name}: {what} ({count})" for (name, what), count in sorted(broken.items())]
    return "\n".join(lines + ([""] if broken else []))
