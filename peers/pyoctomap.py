"""pyoctomap reads an export --to octomap, casts rays into it and writes it again."""
# pypi: pyoctomap==1.2.2 numpy==2.4.6

import importlib.metadata

import numpy
import pyoctomap

from ground import Ground
from peer import FOLDER, Peer, export


def main():
    peer = Peer("pyoctomap", importlib.metadata.version("pyoctomap"), "`--to octomap`")
    path = export("octomap", "world.bt")
    ground = Ground(export("heights", "heights"))
    tree = pyoctomap.OcTree(0.1)
    peer.check("readBinary", tree.readBinary(str(path)) and tree.getResolution() == 0.5,
               f"{tree.getNumLeafNodes()} leaves of {tree.getResolution()} m and more")
    below, above = [], []
    for x, y in ground.places(1000, centers=True):
        end = numpy.zeros(3)
        if tree.castRay(numpy.array([x, y, 60.0]), numpy.array([0.0, 0.0, -1.0]), end, True):
            above.append(end[2] - ground.at(x, y))
            below.append(above[-1] < -0.5)
    on_ground = sum(abs(height) <= 0.5 for height in above)
    peer.check("rays from above", len(above) == 1000 and not any(below),
               f"{len(above)} of 1000 hit, {on_ground} the ground within a voxel, the rest what "
               "stands on it, none below")
    copy = FOLDER / "copy.bt"
    tree.writeBinary(str(copy))
    data = [file.read_bytes().split(b"data\n", 1)[1] for file in (path, copy)]
    peer.check("writeBinary", data[0] == data[1],
               "the same data" if data[0] == data[1] else "other data")
    peer.finish()


main()
