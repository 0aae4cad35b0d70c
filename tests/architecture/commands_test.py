#!/usr/bin/python3
"""Holds the commands that pages show against what is there: commands and options of latticeworld (by
docs/command_line.md, which tests/tools holds against the program), scripts and modules with their
options, launch files with their arguments, programs of rosrun, services with their fields.

Usage: commands_test.py SOURCE_DIR
"""

import pathlib
import re
import subprocess
import sys
import unittest

import yaml

SOURCE = pathlib.Path(sys.argv.pop())
QUOTED = re.compile(r"'[^']*'|\"[^\"]*\"")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]\b(?!-)")


def pages():
    """Every page of the repository, with its name."""
    names = subprocess.run(["git", "-C", SOURCE, "ls-files", "*.md"], text=True, check=True,
                           stdout=subprocess.PIPE).stdout.split()
    return {name: (SOURCE / name).read_text(encoding="utf-8") for name in names
            if name != "CHANGELOG.md"}  # tells of what was


def commands_of(text):
    """The commands of a page: lines of its blocks, without what stands behind a #, and what stands in
    back quotes within its prose. A command of several lines is one."""
    blocks, prose, fenced = [], [], False
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
        else:
            (blocks if fenced or line.startswith("    ") else prose).append(line.strip())
    joined = "\n".join(blocks).replace("\\\n", " ")
    found = [re.sub(r"^\$ ", "", line) for line in joined.splitlines()]
    for paragraph in "\n".join(prose).split("\n\n"):
        found += re.findall(r"`([^`]+)`", paragraph.replace("\n", " "))
    return [re.split(r"\s#\s", command)[0] for command in found]


def options_in(words):
    return set(OPTION.findall(QUOTED.sub("''", words)))


def program_options():
    """{command of latticeworld: its options}."""
    text = (SOURCE / "docs/command_line.md").read_text(encoding="utf-8")
    sections = re.split(r"^## ", text, flags=re.MULTILINE)[1:]
    return {section.split("\n")[0]: {"--help", *re.findall(r"^- `(--[a-z-]+)", section, re.MULTILINE)}
            for section in sections}


def camel(name):
    return "".join(word.capitalize() for word in name.split("_"))


def sources_of_ros():
    return "".join(path.read_text(encoding="utf-8")
                   for path in (SOURCE / "src/latticeworld_ros").rglob("*.cc"))


class Reader:
    """Says of a command what of it is not there."""

    def __init__(self):
        self.options = program_options()
        self.ros = sources_of_ros()
        self.nodes = set(re.findall(r"latticeworld_(?:node|example)\((\w+)", "".join(
            (SOURCE / folder / "CMakeLists.txt").read_text(encoding="utf-8")
            for folder in ("src/nodes", "examples"))))
        self.counted = 0

    def missing_in(self, command):
        """What a command names and nobody has; None where it is none of ours."""
        for pattern, look in ((r"^latticeworld (\S+)(.*)", self.of_program),
                              (r"^(?:\w+=\S+ )*(scripts/[\w/]+\.\w+)(.*)", self.of_file),
                              (r"^python3 -m (latticeworld_training\.\w+)(.*)", self.of_module),
                              (r"^roslaunch latticeworld (\S+\.launch)(.*)", self.of_launch),
                              (r"^rosrun latticeworld (\S+)(.*)", self.of_node),
                              (r"^rosservice call /?(\w+)(.*)", self.of_service)):
            match = re.search(pattern, command)
            if match:
                self.counted += 1
                return look(match[1], match[2])
        return None

    def of_program(self, name, words):
        if name.startswith(("-", "COMMAND", "...")) or not re.fullmatch(r"[a-z-]+", name):
            return None
        if name not in self.options:
            return f"no command {name}"
        return self.named(options_in(words) - self.options[name])

    def of_file(self, name, words):
        if not (SOURCE / name).is_file():
            return f"no {name}"
        text = (SOURCE / name).read_text(encoding="utf-8")
        return self.named({option for option in options_in(words) if option not in text})

    def of_module(self, name, words):
        package = SOURCE / "training" / name.split(".")[0]
        if not (package / (name.split(".")[1] + ".py")).is_file():
            return f"no {name}"
        text = "".join(path.read_text(encoding="utf-8") for path in package.glob("*.py"))
        # Some options are the fields of a dataclass.
        return self.named({option for option in options_in(words) if option not in text and
                           f"    {option[2:].replace('-', '_')}: " not in text})

    def of_launch(self, name, words):
        files = list((SOURCE / "launch_cfg").rglob(name))
        if not files:
            return f"no {name}"
        arguments = set(re.findall(r'<arg name="(\w+)"', files[0].read_text(encoding="utf-8")))
        return self.named(set(re.findall(r"(\w+):=", QUOTED.sub("''", words))) - arguments)

    def of_node(self, name, _):
        there = name in self.nodes or (SOURCE / "scripts" / name).is_file()
        return None if there else f"no {name}"

    def of_service(self, name, words):
        file = SOURCE / f"srv/{camel(name)}.srv"
        if not file.is_file():
            return None if f'"{name}"' in self.ros else f"no service {name}"
        request = file.read_text(encoding="utf-8").split("\n---")[0]
        fields = set(re.findall(r"^\S+ (\w+)", request, re.MULTILINE))
        given = re.search(r"""(['"])(\{.*\})\1""", words)
        return self.named(set(yaml.safe_load(given[2]) if given else ()) - fields)

    @staticmethod
    def named(names):
        return ", ".join(sorted(names)) or None


class CommandsTest(unittest.TestCase):
    maxDiff = None

    def test_every_command_that_a_page_shows_is_there_with_its_options(self):
        reader, wrong = Reader(), {}
        for name, text in pages().items():
            for command in commands_of(text):
                missing = reader.missing_in(command)
                if missing:
                    wrong[f"{name}: {command}"] = missing
        self.assertGreater(reader.counted, 250, "hardly any command was read")
        self.assertEqual({}, wrong)

    def test_what_is_not_there_is_seen(self):
        reader = Reader()
        for command, missing in (
                ("latticeworld genrate", "no command genrate"),
                ("latticeworld generate --layout 'a --b' --sead 3", "--sead"),
                ("scripts/run_all.sh", "no scripts/run_all.sh"),
                ("scripts/test.sh --with training --jobs 2", "--jobs"),
                ("python3 -m latticeworld_training.train", "no latticeworld_training.train"),
                ("roslaunch latticeworld world.launch generat:=\"a:=b\"", "generat"),
                ("roslaunch latticeworld words.launch", "no words.launch"),
                ("rosrun latticeworld world_srever", "no world_srever"),
                ("rosservice call /generate_word '{}'", "no service generate_word"),
                ("rosservice call /step '{step: 3}'", "step"),
                ("rosservice call /pause", None), ("latticeworld show DIR", None),
                ("rosservice call /step '{steps: 3}'", None)):
            self.assertEqual(missing, reader.missing_in(command), command)

    def test_commands_are_read_of_blocks_and_of_lines(self):
        text = "a `b\n--c` d\n```console\n$ e \\\n  f # g\n```\n\n    h\n"
        self.assertEqual(["e  f", "h", "b --c"], commands_of(text))


if __name__ == "__main__":
    unittest.main()
