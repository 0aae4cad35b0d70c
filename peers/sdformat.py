"""libsdformat, with which Gazebo reads worlds, loads an export --to sdf."""
# debian: libsdformat-dev
# pypi: numpy==2.4.6 pillow==13.0.0

import pathlib
import re
import subprocess
import xml.etree.ElementTree

import numpy
import PIL.Image

from ground import Ground
from peer import FOLDER, Peer, export, run

SOURCE = pathlib.Path(__file__).resolve().parents[1] / "tests/exporting/check_sdf.cc"


def check_height_map(peer, folder, ground):
    """The picture over the size and at the place that world.sdf gives it."""
    shape = xml.etree.ElementTree.parse(folder / "world.sdf").getroot().find(
        ".//collision/geometry/heightmap")
    name = shape.find("uri").text.split("model://latticeworld_media/")[-1]
    picture = numpy.asarray(PIL.Image.open(folder / "latticeworld_media" / name)).astype(float)
    width, depth, height = (float(value) for value in shape.find("size").text.split())
    x0, y0, z0 = (float(value) for value in shape.find("pos").text.split())
    inside = (ground.width / 2, ground.depth / 2)
    places, found = [], []
    random = numpy.random.default_rng(2)
    while len(places) < 1000:
        row, col = (int(random.integers(0, n)) for n in picture.shape)
        x = x0 + width * (col / (picture.shape[1] - 1) - 0.5)
        y = y0 + depth * (0.5 - row / (picture.shape[0] - 1))
        if abs(x) < inside[0] and abs(y) < inside[1]:
            places.append((x, y))
            found.append(z0 + height * picture[row, col] / 65535)
    ground.check(peer, found, places, limit_m=2 * height / 65535 + 1e-3)


def main():
    version = run("pkg-config", "--modversion", "sdformat12").stdout.strip()
    peer = Peer("libsdformat", version, "`--to sdf`",
                "`GZ_SIM_RESOURCE_PATH` has to name the folder")
    flags = run("pkg-config", "--cflags", "--libs", "sdformat12").stdout.split()
    subprocess.run(["g++", "-std=c++17", "-o", FOLDER / "check_sdf", SOURCE, *flags], check=True)
    folder = export("sdf", "sdf")
    said = run(FOLDER / "check_sdf", folder / "world.sdf", folder / "latticeworld_media/model.sdf")
    found = re.search(r"world\.sdf: (.*)", said.stdout)
    peer.check("world.sdf", said.returncode == 0 and " 0 errors" in said.stdout,
               found.group(1) if found else said.stdout[-200:])
    check_height_map(peer, folder, Ground(export("heights", "heights")))
    peer.finish()


main()
