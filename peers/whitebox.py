"""Whitebox Workflows reads an export --to geotiff, fills it and routes water over it."""
# pypi: whitebox-workflows==2.0.6 numpy==2.4.6

import importlib.metadata

import numpy
import whitebox_workflows

from ground import Ground
from peer import Peer, export


def main():
    peer = Peer("Whitebox Workflows", importlib.metadata.version("whitebox-workflows"),
                "`--to geotiff`", "tools of 1.x as in `env.fill_depressions(dem)` are now in "
                "`env.hydrology`, by keyword alone; give the raster an EPSG code (`gdal_translate -a_srs`), or "
                "its metres are taken for degrees")
    ground = Ground(export("heights", "heights"))
    box = whitebox_workflows.WbEnvironment()
    dem = box.read_raster(str(export("geotiff", "geotiff") / "elevation.tif"))
    places = ground.places(1000, centers=True)
    ground.check(peer, [dem.get_value(dem.get_row_from_y(y), dem.get_column_from_x(x))
                        for x, y in places], places)
    filled = box.hydrology.fill_depressions(dem=dem)
    accumulation = box.hydrology.d8_flow_accum(dem=filled, out_type="cells").to_numpy()
    raised = filled.to_numpy() - dem.to_numpy() > 0.01
    peer.check("water over the filled ground", numpy.nanmax(accumulation) > 1000,
               f"{int(numpy.nanmax(accumulation))} of {accumulation.size} cells pass the largest "
               f"outlet; {float(raised.mean()):.3f} of the land was filled")
    peer.finish()


main()
