#!/usr/bin/env python3
"""Holds folders, functions and the greatest classes of src/ to what one can take in at a glance,
and what is frozen to the lines that it has.

Usage: sizes_test.py SRC
"""

import collections
import pathlib
import sys
import tempfile
import unittest

from cpp_outline import outline
from floors import sources_below

MOST_FILES = 40  # .h and .cc, in a folder itself
MOST_LINES = 80  # of a function, from its opening brace to its closing brace
# Classes that once had grown too great: the most member functions and data members that they may
# declare; None: any number.
GREAT_CLASSES = {
    "SimulatorImpl": (25, 14),
    "OdeBody": (40, None),
    "OdeWorld": (40, None),
}
# Rules that read instructions get no new rule, pass or word (docs/language.md): the most lines of
# the files below a folder, CMakeLists.txt aside.
FROZEN = {
    "latticeworld/language/grounded/reading": 31251,
    "latticeworld/language/grounded/environment": 14709,
}


def crowded_folders(src):
    """A sentence on each folder below `src` that holds too many files."""
    files = collections.Counter(str(pathlib.PurePosixPath(path).parent)
                                for path, _ in sources_below(src))
    return [f"src/{folder} holds {count} .h and .cc files of its own, {MOST_FILES} at most: put "
            "what belongs together on a shelf, a folder in it"
            for folder, count in sorted(files.items()) if count > MOST_FILES]


def grown_folders(src, limits):
    """A sentence on each folder of `limits` that has more lines, or is not there."""
    found = []
    for folder, most in sorted(limits.items()):
        lines = sum(len(file.read_text(encoding="utf-8").splitlines())
                    for file in (src / folder).rglob("*")
                    if file.is_file() and file.name != "CMakeLists.txt")
        if lines > most:
            found.append(f"src/{folder} has {lines} lines, {most} at most: it is frozen; what is "
                         "misread is taught to the reader by examples (training/examples)")
        elif lines == 0:
            found.append(f"src/{folder} has no lines: FROZEN is to name what it has become")
    return found


def outlines_below(src):
    """(path relative to src, outline) of every header and source."""
    return [(path, outline(text)) for path, text in sources_below(src)]


def long_functions(outlines):
    """A sentence on each function that is too long, the longest first."""
    found = [(function.lines, path, function)
             for path, source in outlines for function in source.functions
             if function.lines > MOST_LINES]
    return [f"src/{path}:{function.line}: {function.name} has {lines} lines, {MOST_LINES} at most: "
            "split it by what it does"
            for lines, path, function in sorted(found, key=lambda one: (-one[0], one[1]))]


def great_classes(outlines, limits):
    """A sentence on each class of `limits` that declares too much or is not there."""
    found, unseen = [], set(limits)
    for path, source in outlines:
        for declared in source.classes:
            if declared.name not in limits:
                continue
            unseen.discard(declared.name)
            for kind, names, most in zip(("member functions", "data members"),
                                         (declared.functions, declared.data),
                                         limits[declared.name]):
                if most is not None and len(names) > most:
                    found.append(f"src/{path}:{declared.line}: {declared.name} declares "
                                 f"{len(names)} {kind}, {most} at most: give what belongs together "
                                 f"a class of its own ({', '.join(names)})")
    return found + [f"there is no class {name}: GREAT_CLASSES is to name what it has become"
                    for name in sorted(unseen)]


class SizesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.outlines = outlines_below(SRC)

    def expect_none(self, sentences):
        if sentences:
            self.fail("\n" + "\n".join(sentences))

    def test_functions_are_read_at_all(self):
        self.assertGreater(sum(len(source.functions) for _, source in self.outlines), 5000,
                           "is this the source tree?")

    def test_no_folder_holds_more_than_40_sources(self):
        self.expect_none(crowded_folders(SRC))

    def test_no_function_has_more_than_80_lines(self):
        self.expect_none(long_functions(self.outlines))

    def test_the_great_classes_stay_small(self):
        self.expect_none(great_classes(self.outlines, GREAT_CLASSES))

    def test_the_rules_that_read_are_frozen(self):
        self.expect_none(grown_folders(SRC, FROZEN))


class RulesTest(unittest.TestCase):
    """The rules themselves, on trees that are made up."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.src = pathlib.Path(folder.name)

    def write(self, path, text=""):
        file = self.src / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def long_functions(self):
        return long_functions(outlines_below(self.src))

    def write_functions(self, inner):
        """Three files, each with a function that has those lines between its braces."""
        self.write("a/free.cc", "namespace n {\nint F(int a,\n      int b) {\n" + inner + "}\n}\n")
        self.write("a/inside.h", "class C {\n  void F() {\n" + inner + "  }\n};\n")
        self.write("a/start.cc", "C::C(int a)\n    : a_{a}, b_(a) {\n" + inner + "}\n")

    def test_the_41st_source_is_seen_and_neither_data_nor_shelves_count(self):
        for i in range(20):
            self.write(f"latticeworld/scene/a{i}.h")
            self.write(f"latticeworld/scene/a{i}.cc")
        self.write("latticeworld/scene/CMakeLists.txt")
        self.write("latticeworld/scene/weather/wind.h")
        self.assertEqual([], crowded_folders(self.src))
        self.write("latticeworld/scene/one_more.h")
        sentence, = crowded_folders(self.src)
        self.assertIn("src/latticeworld/scene holds 41 ", sentence)

    def test_the_81st_line_is_seen_wherever_the_function_stands(self):
        inner = "  a = {1};\n" * 78  # with the lines of both braces: 80
        self.write_functions(inner)
        self.assertEqual([], self.long_functions())
        self.write_functions(inner + "\n")
        self.assertEqual(["src/a/free.cc:3: F has 81 lines", "src/a/inside.h:2: C::F has 81 lines",
                          "src/a/start.cc:2: C::C has 81 lines"],
                         [sentence.partition(",")[0] for sentence in self.long_functions()])

    def test_what_is_no_function_may_be_long(self):
        rows = '  {"}", 1},\n' * 100
        self.write("a/a.cc", "namespace n {\nclass C {\n" + "  int F();\n" * 100 + "};\n"
                   "enum class E {\n" + "  kA,\n" * 100 + "};\n"
                   "const Row kRows[] = {\n" + rows + "};\n"
                   "const std::vector<Row> kMore{\n" + rows + "};\n"
                   'constexpr char kText[] = R"(\n' + "void F() {\n" * 100 + ')";\n}\n')
        self.assertEqual([], self.long_functions())

    def test_a_lambda_counts_with_its_function_or_alone_where_it_has_none(self):
        inner = "  [] {\n" + "    a();\n" * 80 + "  };\n"
        self.write("a/a.cc", "void F() {\n" + inner + "}\nconst auto kF =\n" + inner)
        self.assertEqual(["src/a/a.cc:1: F has 84 lines",
                          "src/a/a.cc:86: lambda of kF has 82 lines"],
                         [sentence.partition(",")[0] for sentence in self.long_functions()])

    def test_a_line_more_in_what_is_frozen_is_seen(self):
        limits = {"a/rules": 3}
        self.write("a/rules/one.cc", "int a;\nint b;\n")
        self.write("a/rules/data/words.txt", "lake\n")
        self.write("a/rules/CMakeLists.txt", "more\n")
        self.assertEqual([], grown_folders(self.src, limits))
        self.write("a/rules/data/words.txt", "lake\nmere\n")
        sentence, = grown_folders(self.src, limits)
        self.assertIn("src/a/rules has 4 lines, 3 at most: it is frozen", sentence)
        self.write("a/rules/data/words.txt", "")
        self.assertEqual([], grown_folders(self.src, limits))
        gone, = grown_folders(self.src, {"a/gone": 3})
        self.assertIn("src/a/gone has no lines", gone)

    def test_a_great_class_is_counted_without_what_is_nested_in_it(self):
        limits = {"Engine": (2, 1), "Gone": (1, None)}
        nested = "  struct Row {\n    int a, b, c;\n    void F();\n    void G();\n  };\n"
        self.write("a/a.h", "class Engine {\n  Engine();\n  void Run() {}\n" + nested
                   + "  Row row_;\n};\nclass Gone {\n};\n")
        self.assertEqual([], great_classes(outlines_below(self.src), limits))
        self.write("a/a.h", "class Engine {\n  Engine();\n  void Run() {}\n  void Stop();\n"
                   + nested + "  Row row_, last_;\n};\n")
        functions, data, gone = great_classes(outlines_below(self.src), limits)
        self.assertIn("Engine declares 3 member functions, 2 at most", functions)
        self.assertIn("(Engine, Run, Stop)", functions)
        self.assertIn("Engine declares 2 data members, 1 at most", data)
        self.assertIn("no class Gone", gone)


if __name__ == "__main__":
    SRC = pathlib.Path(sys.argv.pop(1))
    unittest.main()
