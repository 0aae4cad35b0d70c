#!/usr/bin/env python3
"""Holds tests/fuzz together: each target has a corpus and is built, each corpus is of a target, and
corpora stay small.

Usage: fuzz_corpora_test.py SOURCE_DIR
"""

import pathlib
import re
import sys
import tempfile
import unittest

END = "_fuzz.cc"
MOST_BYTES = 32_768  # of one input
MOST_BYTES_IN_ALL = 600_000


def faults(fuzz):
    """A sentence on each thing that is wrong in the folder `fuzz`."""
    targets = {path.name[:-len(END)] for path in fuzz.glob("*" + END)}
    corpora = {path.name for path in (fuzz / "corpus").iterdir()}
    built = set(re.findall(r"latticeworld_fuzz\((\w+)", (fuzz / "CMakeLists.txt").read_text()))
    built.discard("name")  # of the function itself
    found = [f"{name}{END} has no corpus: tests/fuzz/corpus/{name}"
             for name in sorted(targets - corpora)]
    found += [f"corpus/{name} is of no target" for name in sorted(corpora - targets)]
    found += [f"{name}{END} is not in CMakeLists.txt" for name in sorted(targets - built)]
    total = 0
    for path in sorted((fuzz / "corpus").glob("*/*")):
        size = path.stat().st_size
        total += size
        if size > MOST_BYTES:
            found.append(f"{path.relative_to(fuzz)} has {size} bytes, {MOST_BYTES} at most")
    if total > MOST_BYTES_IN_ALL:
        found.append(f"the corpora have {total} bytes together, {MOST_BYTES_IN_ALL} at most")
    return found


class FuzzCorporaTest(unittest.TestCase):
    def test_targets_and_corpora_belong_together(self):
        fuzz = SOURCE / "tests" / "fuzz"
        self.assertGreater(len(list(fuzz.glob("*" + END))), 25, "is this the source tree?")
        found = faults(fuzz)
        if found:
            self.fail("\n" + "\n".join(found))


class RuleTest(unittest.TestCase):
    """The rule itself, on a folder that is made up."""

    def test_what_does_not_belong_together_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            fuzz = pathlib.Path(folder)
            for path, size in (("a_fuzz.cc", 1), ("b_fuzz.cc", 1), ("corpus/a/seed", 32_769),
                               ("corpus/c/seed", 2)):
                (fuzz / path).parent.mkdir(parents=True, exist_ok=True)
                (fuzz / path).write_bytes(b"x" * size)
            (fuzz / "CMakeLists.txt").write_text("function(latticeworld_fuzz name)\n"
                                                 "latticeworld_fuzz(a LIBRARIES x)\n")
            self.assertEqual(["b_fuzz.cc has no corpus: tests/fuzz/corpus/b",
                              "corpus/c is of no target",
                              "b_fuzz.cc is not in CMakeLists.txt",
                              "corpus/a/seed has 32769 bytes, 32768 at most"], faults(fuzz))


if __name__ == "__main__":
    SOURCE = pathlib.Path(sys.argv.pop(1))
    unittest.main()
