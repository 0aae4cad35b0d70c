"""pysheds reads an export --to geotiff and routes water over it."""
# pypi: pysheds==0.5 numpy==2.2.6

import importlib.metadata

import numpy
from pysheds.grid import Grid

from ground import Ground
from peer import Peer, export


def main():
    peer = Peer("pysheds", importlib.metadata.version("pysheds"), "`--to geotiff`",
                "`numpy<2.4`, which dropped `in1d`")
    path = str(export("geotiff", "geotiff") / "elevation.tif")
    ground = Ground(export("heights", "heights"))
    grid = Grid.from_raster(path)
    dem = grid.read_raster(path)
    places = ground.places(1000, centers=True)
    found = []
    for x, y in places:
        col, row = ~dem.affine * (x, y)
        found.append(float(dem[int(row), int(col)]))
    ground.check(peer, found, places)
    filled = grid.resolve_flats(grid.fill_depressions(grid.fill_pits(dem)))
    accumulation = grid.accumulation(grid.flowdir(filled))
    peer.check("water over the filled ground", accumulation.max() > 1000,
               f"{int(accumulation.max())} of {dem.size} cells pass the largest outlet; "
               f"{float((filled - dem > 0.01).mean()):.3f} of the land was filled")
    peer.finish()


main()
