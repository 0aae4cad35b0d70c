"""rasterio reads an export --to geotiff."""
# pypi: rasterio==1.4.4 pyproj==3.7.2 numpy==2.4.6

import numpy
import pyproj
import rasterio

from ground import Ground
from peer import Peer, export


def main():
    peer = Peer("rasterio", f"{rasterio.__version__} (GDAL {rasterio.__gdal_version__})",
                "`--to geotiff`")
    folder = export("geotiff", "geotiff")
    truth = Ground(export("heights", "heights"))
    places = truth.places(1000, centers=True)
    with rasterio.open(folder / "elevation.tif") as grid:
        truth.check(peer, [value[0] for value in grid.sample(places)], places)
        where = pyproj.Transformer.from_crs(grid.crs, "EPSG:4326").transform(0.0, 0.0)
        earth = truth.about["earth"]
        off = max(abs(where[0] - earth["latitude_deg"]), abs(where[1] - earth["longitude_deg"]))
        peer.check("place on the earth", off < 1e-8,
                   f"{where[0]:.6f}, {where[1]:.6f}; unit {grid.crs.linear_units}")
        peer.check("altitude of z = 0", "ZERO_ALTITUDE_M" in grid.tags(),
                   grid.tags().get("ZERO_ALTITUDE_M"))
    with rasterio.open(folder / "water.tif") as grid:
        dry = ~(grid.dataset_mask() > 0)
        peer.check("dry cells", dry.any() and not dry.all(),
                   f"no data {grid.nodata}, {dry.mean():.3f} masked")
    with rasterio.open(folder / "classes.tif") as grid:
        names = {key: value for key, value in grid.tags().items() if key.startswith("CLASS_")}
        used = numpy.unique(grid.read(1))
        peer.check("names of classes", all(f"CLASS_{value}" in names for value in used),
                   ", ".join(names[f"CLASS_{value}"] for value in used))
    peer.finish()


main()
