#!/usr/bin/python3
"""The wheels of clients/ that scripts/build_wheel.sh makes have every module, and no other.

Usage: client_wheels_test.py SOURCE_DIR
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCE = pathlib.Path(sys.argv.pop())
CLIENTS = SOURCE / "clients"


class ClientWheelsTest(unittest.TestCase):
    def test_each_wheel_has_the_modules_of_its_client_to_the_byte(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([SOURCE / "scripts/build_wheel.sh", "--clients", folder], check=True)
            wheels = {wheel.name.split("-")[0]: wheel for wheel in pathlib.Path(folder).iterdir()}
            self.assertEqual({"latticeworld_gym", "latticeworld_stack"}, set(wheels))
            for name, wheel in wheels.items():
                self.assertTrue(wheel.name.endswith("-py3-none-any.whl"), wheel.name)
                modules = {str(path.relative_to(CLIENTS / name)): path.read_bytes()
                           for path in (CLIENTS / name).rglob("*.py") if "build" not in path.parts}
                self.assertTrue(modules, name)
                with zipfile.ZipFile(wheel) as packed:
                    self.assertEqual(modules, {file: packed.read(file) for file in packed.namelist()
                                               if file.endswith(".py")})


if __name__ == "__main__":
    unittest.main()
