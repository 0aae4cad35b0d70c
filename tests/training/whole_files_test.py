"""What a run writes is there whole, or as it was before, whatever ends the run."""

import os
import tempfile
import unittest
from unittest import mock

from latticeworld_training import curves, whole_files


class WholeFileTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "model.json")

    def test_is_the_one_before_where_writing_fails(self):
        with whole_files.whole_file(self.path) as file:
            file.write("before")
        with self.assertRaises(ZeroDivisionError):
            with whole_files.whole_file(self.path) as file:
                file.write("half of what was to c")
                file.write(str(1 / 0))
        with open(self.path, encoding="utf-8") as file:
            self.assertEqual(file.read(), "before")
        self.assertEqual(os.listdir(os.path.dirname(self.path)), ["model.json"])

    def test_content_is_on_the_disk_before_its_name_and_the_name_before_all_that_follows(self):
        did = []
        sync, replace = os.fsync, os.replace
        with mock.patch("os.fsync", lambda file: (did.append(os.readlink(f"/proc/self/fd/{file}")), sync(file))), \
                mock.patch("os.replace", lambda old, new: (did.append("replace"), replace(old, new))):
            with whole_files.whole_file(self.path, "wb") as file:
                file.write(b"content")
        self.assertEqual(did, [self.path + ".unfinished", "replace", os.path.dirname(self.path)])


class CurveTest(unittest.TestCase):
    def test_a_half_line_is_forgotten(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "loss.csv")
            curve = curves.LossCurve(path, ["training"])
            curve.keep_until(0)
            for step in (1, 2, 12):
                curve.add(step, training=1.0 / step)
            with open(path, "r+b") as file:
                file.truncate(os.path.getsize(path) - len("2,0.0833333\r\n"))  # step 12 reads 1
            curve.keep_until(5)
            self.assertEqual([row["step"] for row in curve.rows], [1, 2])


if __name__ == "__main__":
    unittest.main()
