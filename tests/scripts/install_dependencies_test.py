"""scripts/install_dependencies.sh: says what is missing, and installs nothing without rights."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])
MISSING = "latticeworld-of-nobody"  # no such package is in Debian
NOBODY = 65534


class InstallDependenciesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.folder.chmod(0o755)
        shutil.copy(ROOT / "scripts/install_dependencies.sh", self.folder)
        (self.folder / "packages").mkdir()
        self.group("there", "# what every Debian has\nbash coreutils  # two\n")
        self.group("missing", f"bash {MISSING}\n")

    def group(self, name, text):
        (self.folder / f"packages/{name}.txt").write_text(text)

    def run_script(self, *words, user=None):
        return subprocess.run([self.folder / "install_dependencies.sh", *words], text=True, user=user,
                              stdin=subprocess.DEVNULL, capture_output=True, check=False)

    def test_where_all_is_there_nothing_is_said_or_done(self):
        for words in (["there"], ["--say", "there"]):
            done = self.run_script(*words)
            self.assertEqual((0, "", ""), (done.returncode, done.stdout, done.stderr))

    def test_say_names_what_is_missing_of_the_groups_and_that_alone(self):
        done = self.run_script("--say", "there", "missing")
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertEqual(f"missing of there missing: {MISSING}", done.stdout.splitlines()[0])

    def test_an_unknown_group_is_refused_with_the_names_of_those_there_are(self):
        done = self.run_script("missing", "tset")
        self.assertEqual(2, done.returncode)
        self.assertIn("there is no group 'tset': it is one of missing there", done.stderr)

    def test_without_rights_it_fails_and_names_what_would_have_to_be_installed(self):
        user = NOBODY if os.getuid() == 0 else None
        done = self.run_script("missing", user=user)
        self.assertNotEqual(0, done.returncode)
        self.assertIn(MISSING, done.stdout + done.stderr)

    def test_every_group_that_ships_has_packages(self):
        groups = list((ROOT / "scripts/packages").glob("*.txt"))
        self.assertGreater(len(groups), 6)
        for group in groups:
            names = " ".join(line.split("#")[0] for line in group.read_text().splitlines()).split()
            self.assertTrue(names, group)
            for name in names:
                self.assertRegex(name, r"^[a-z0-9][a-z0-9+.-]+$", group)


if __name__ == "__main__":
    unittest.main()
