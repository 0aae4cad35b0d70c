#!/usr/bin/env python3
"""Holds that a type has one definition: no two classes or enumerations of a namespace have one name.

Compiler and linker say nothing of two that do. Each source sees its own, and of the functions that
both have, such as a destructor, the linker keeps one for both.

Usage: names_test.py SOURCE_DIR
"""

import collections
import re
import sys
import tempfile
import unittest
from pathlib import Path

from cpp_outline import tokens_of
from floors import sources_below

UNNAMED = "(unnamed)"  # a namespace that each source has for itself
KEYS = {"class", "struct", "union", "enum"}
WORD = re.compile(r"[A-Za-z_]\w*$")


def without_brackets(head):
    """A declaration without attributes and what stands in angle brackets or parentheses."""
    depth, rest = 0, []
    for token in head:
        if token in ("<", "[", "("):
            depth += 1
        elif token in (">", "]", ")"):
            depth -= 1
        elif token == ">>":
            depth -= 2
        elif depth <= 0:
            rest.append(token)
    return rest


def namespace_of(head):
    """The name of the namespace that a declaration opens; None: it opens none."""
    if "namespace" not in head:
        return None
    return "".join(head[head.index("namespace") + 1:]) or UNNAMED


def type_of(head):
    """The name of the type that a declaration begins to define; None: it defines none, or is a
    specialization, which has its arguments to tell it."""
    specializes = [i for i in range(len(head) - 2) if head[i:i + 3] == ["template", "<", ">"]]
    named = without_brackets(head)
    if specializes or not KEYS & set(named) or "=" in named:
        return None
    name = None
    for token in named[max(i for i, each in enumerate(named) if each in KEYS) + 1:]:
        if token in (":", "final"):
            break
        if not WORD.match(token):
            return None
        name = token
    return name


def types_in(text):
    """Whole names of the types that a source defines in namespaces that others see too."""
    found, scopes, head = [], [], []
    for token, _ in tokens_of(text):
        if token == "{":
            namespace = namespace_of(head)
            name = None if namespace else type_of(head)
            seen = all(scope is not None and scope != UNNAMED for scope in scopes)
            if name and seen:
                found.append("::".join([*scopes, name]))
            scopes.append(namespace)
            head = []
        elif token == "}":
            if scopes:
                scopes.pop()
            head = []
        elif token == ";":
            head = []
        else:
            head.append(token)
    return found


def defined_twice(src):
    """A sentence on each type below `src` that has several definitions, and how many types there
    are."""
    places = collections.defaultdict(set)
    for path, text in sources_below(src):
        for name in types_in(text):
            places[name].add(str(path))
    return [f"{name} is defined in {' and in '.join(sorted(paths))}"
            for name, paths in sorted(places.items()) if len(paths) > 1], len(places)


class NamesTest(unittest.TestCase):
    def test_a_type_has_one_definition(self):
        found, count = defined_twice(Path(SOURCE_DIR) / "src")
        self.assertGreater(count, 1000)
        self.assertEqual(found, [], "\n".join(found))


class RuleTest(unittest.TestCase):
    def test_types_are_told_by_their_namespaces(self):
        text = """
namespace a::b {
struct One { enum class Inner { kA }; void F() { struct Local {}; } };
template <typename T> class [[nodiscard]] Two final : public One {};
template <> class Two<int> {};
enum class Three : int { kA };
struct Ahead;
Ahead Make() { return {}; }
const One one = {};
namespace {
struct Own {};
}  // namespace
}  // namespace a::b
struct Outside {};
"""
        self.assertEqual(types_in(text), ["a::b::One", "a::b::Two", "a::b::Three", "Outside"])

    def test_two_of_a_name_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            src = Path(folder)
            (src / "a.h").write_text("namespace n {\nstruct A { int a; };\n}\n", encoding="utf-8")
            (src / "b.cc").write_text("namespace n {\nclass A { char b; };\n}\n", encoding="utf-8")
            (src / "c.cc").write_text("namespace n {\nnamespace {\nstruct A {};\n}\n}\n",
                                      encoding="utf-8")
            self.assertEqual(defined_twice(src),
                             (["n::A is defined in a.h and in b.cc"], 1))


if __name__ == "__main__":
    SOURCE_DIR = sys.argv.pop(1)
    unittest.main()
