"""pyoctomap reads, prunes and expands an export --to octomap."""
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
    tree = pyoctomap.OcTree(0.5)
    print([n for n in dir(tree) if not n.startswith('_')])
    print(tree.readBinary(str(path).encode()) if hasattr(tree,'readBinary') else '')
    peer.finish()


main()
