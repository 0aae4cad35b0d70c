#!/usr/bin/env python3
"""A path of this clone stands, as a definition, on the compile lines of the sources that need it and
of no others of their program: ccache has then what another clone compiled of the rest.

Usage: compile_lines_test.py SOURCE_DIR BUILD_DIR
"""

import collections
import json
import pathlib
import re
import sys
import unittest

SOURCE, BUILD = map(pathlib.Path, sys.argv[1:])
del sys.argv[1:]
MOST_SOURCES = 2  # of one program that need one path


def widespread(commands, source):
    """{(program, definition): sources} of the definitions with a path below `source` that more
    sources of a program have than may."""
    having = collections.defaultdict(set)
    for entry in commands:
        program = re.search(r"CMakeFiles/(\w+)\.dir", entry["command"])
        for name, path in re.findall(r'-D(\w+)=\S*?"(/[^"\\]*)', entry["command"]):
            if program and path.startswith(f"{source}/"):
                having[program[1], name].add(entry["file"])
    return {key: files for key, files in having.items() if len(files) > MOST_SOURCES}


class CompileLinesTest(unittest.TestCase):
    def test_no_path_of_this_clone_is_on_sources_that_do_not_need_it(self):
        commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
        self.assertGreater(len(commands), 500)
        self.assertEqual({}, widespread(commands, SOURCE))

    def test_a_path_on_every_source_is_seen(self):
        line = 'c++ -DDOCS=\\"/clone/docs\\" -DTOOL=\\"/usr/bin/x\\" -o CMakeFiles/a_test.dir/{0}.o {0}'
        commands = [{"command": line.format(name), "file": name} for name in ("a", "b", "c")]
        self.assertEqual({("a_test", "DOCS"): {"a", "b", "c"}},
                         widespread(commands, pathlib.Path("/clone")))
        self.assertEqual({}, widespread(commands[:2], pathlib.Path("/clone")))


if __name__ == "__main__":
    unittest.main()
