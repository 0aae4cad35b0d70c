#!/usr/bin/python3
"""Holds together what the project's manifests say: one version, and keys that rosdep knows.

Usage: manifests_test.py SOURCE_DIR
"""

import json
import pathlib
import re
import sys
import tomllib
import unittest
import xml.etree.ElementTree

SOURCE = pathlib.Path(sys.argv.pop())
HERE = pathlib.Path(__file__).resolve().parent


def text_of(name):
    return (SOURCE / name).read_text(encoding="utf-8")


def found(pattern, name):
    """The first version of a file that stands where the pattern has its group."""
    return re.search(pattern, text_of(name), re.MULTILINE)[1]


def versions():
    """What each manifest says of the version: {file: version}."""
    said = {
        "CHANGELOG.md": found(r"^## (\d\S*)$", "CHANGELOG.md"),
        "CMakeLists.txt": found(r"^project\(latticeworld VERSION (\S+)", "CMakeLists.txt"),
        "cmake/debian/changelog": found(r"^latticeworld \(([^)]+)\)", "cmake/debian/changelog"),
        "package.xml": xml.etree.ElementTree.fromstring(text_of("package.xml")).findtext("version"),
        "web/package.json": json.loads(text_of("web/package.json"))["version"],
        "web/package-lock.json": json.loads(text_of("web/package-lock.json"))["version"],
    }
    for path in sorted([*SOURCE.glob("clients/*/pyproject.toml"), SOURCE / "python/pyproject.toml"]):
        with open(path, "rb") as file:
            said[str(path.relative_to(SOURCE))] = tomllib.load(file)["project"]["version"]
    return said


def rosdep_keys():
    """Every key that package.xml asks rosdep for."""
    package = xml.etree.ElementTree.fromstring(text_of("package.xml"))
    return {element.text for element in package if element.tag.endswith("depend")}


class ManifestsTest(unittest.TestCase):
    def test_every_manifest_has_the_version_that_the_changes_tell_of_last(self):
        said = versions()
        self.assertGreaterEqual(len(said), 9)
        newest = said["CHANGELOG.md"]
        self.assertRegex(newest, r"^\d+\.\d+\.\d+$")
        self.assertEqual({}, {name: version for name, version in said.items() if version != newest})

    def test_rosdep_knows_every_key(self):
        known = re.sub(r"#.*", "", (HERE / "rosdep_keys.txt").read_text(encoding="utf-8")).split()
        self.assertGreater(len(rosdep_keys()), 40)
        self.assertEqual(set(), rosdep_keys() - set(known))
        self.assertEqual(set(), set(known) - rosdep_keys(), "keys that nobody asks for")


if __name__ == "__main__":
    unittest.main()
