"""What the parts of the endurance run count and find, and the tables that are made of it."""

import collections


class BrokenPromise(AssertionError):
    """Something that docs and interfaces promise was not so."""


def promise(kept, what):
    """Fails with what was promised and what was there instead."""
    if not kept:
        raise BrokenPromise(what)


class Ledger:
    """Rounds, counts, cells of tables and broken promises of one part."""

    def __init__(self, title):
        self.title = title
        self.counts = collections.Counter()  # name -> how often
        self.broken = []  # texts
        self.facts = []  # sentences
        self.columns, self.rows = [], []

    def count(self, name, times=1):
        self.counts[name] += times

    def fact(self, text):
        self.facts.append(text)

    def table(self, *columns):
        self.columns = columns

    def row(self, *cells):
        self.rows.append([" ".join(str(cell).replace("|", "/").split()) for cell in cells])

    def watch(self, name, call):
        """Counts one round of `name`; a promise that it breaks is kept, and the run goes on."""
        self.count(name)
        try:
            call()
            print(f"kept    {self.title}: {name}", flush=True)
            return True
        except BrokenPromise as broken:
            self.broken.append(f"{name}: {broken}")
            print(f"BROKEN  {self.title}: {name}: {broken}", flush=True)
            return False

    def markdown(self):
        lines = [f"## {self.title}", ""]
        if self.counts:
            lines += ["| rounds of | count |", "|---|---|"]
            lines += [f"| {name} | {count} |" for name, count in sorted(self.counts.items())]
            lines.append("")
        if self.rows:
            lines += ["| " + " | ".join(self.columns) + " |", "|" + "---|" * len(self.columns)]
            lines += ["| " + " | ".join(row) + " |" for row in self.rows]
            lines.append("")
        lines += [*self.facts, ""] if self.facts else []
        lines += [f"Broken promises: {len(self.broken)}.", ""]
        lines += [f"- {text}" for text in self.broken] + ([""] if self.broken else [])
        return "\n".join(lines)
