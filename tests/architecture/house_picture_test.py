#!/usr/bin/env python3
"""Holds that docs/images/house.svg is what scripts/draw_house.py makes of the sources.

Usage: house_picture_test.py SOURCE_DIR
"""

import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree

SVG = "{http://www.w3.org/2000/svg}"


def texts_of(picture):
    """The texts of an SVG."""
    return [text.text for text in xml.etree.ElementTree.fromstring(picture).iter(SVG + "text")]


class HousePictureTest(unittest.TestCase):
    def test_the_committed_picture_is_that_of_the_sources(self):
        committed = (SOURCE / "docs/images/house.svg").read_text(encoding="utf-8")
        if draw_house.draw(SOURCE / "src") != committed:
            self.fail("the house has changed: scripts/draw_house.py draws docs/images/house.svg "
                      "anew, and docs/architecture.md may have to follow")

    def test_rooms_shelves_sizes_and_includes_are_those_of_the_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            src = pathlib.Path(folder)
            bare = draw_house.draw(src)
            ways = src / "latticeworld/terrain/ways"
            ways.mkdir(parents=True)
            include = '#include "latticeworld/geometry/grid.h"\n'
            (ways / "road.cc").write_text(include * 10 + "\n" * 1990)
            (ways.parent / "ground.h").write_text("")
            (ways / "words.txt").write_text("")
            built = draw_house.draw(src)
            self.assertEqual(built, draw_house.draw(src))
        self.assertIn("0 files, under 1k lines", texts_of(bare))
        for text in ("terrain", "2 files, 2k lines", "ways\u00a01"):
            self.assertIn(text, texts_of(built))
        self.assertNotIn("ways\u00a01", texts_of(bare))
        dots = [sum(1 for _ in xml.etree.ElementTree.fromstring(picture).iter(SVG + "circle"))
                for picture in (bare, built)]
        self.assertEqual(1, dots[1] - dots[0])


if __name__ == "__main__":
    SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
    sys.path.insert(0, str(SOURCE / "scripts"))
    import draw_house
    unittest.main()
