"""Whitebox Workflows reads an export --to geotiff, fills and routes it."""
# pypi: whitebox-workflows==2.0.6 numpy==2.4.6

import importlib.metadata

import whitebox_workflows

from ground import Ground
from peer import FOLDER, Peer, export


def main():
    peer = Peer("Whitebox Workflows", importlib.metadata.version("whitebox-workflows"),
                "`--to geotiff`")
    ground = Ground(export("heights", "heights"))
    box = whitebox_workflows.WbEnvironment()
    dem = box.read_raster(str(export("geotiff", "geotiff") / "elevation.tif"))
    print([n for n in dir(dem) if not n.startswith('__')][:80], [n for n in dir(box) if 'flow' in n or 'fill' in n])
    peer.finish()


main()
