#!/usr/bin/env bash
# Whitebox Workflows takes metres for degrees if a GeoTIFF's projection has no EPSG code.
#
# Versions: whitebox-workflows 2.0.6, rasterio 1.4.4 (GDAL 3.10.3) and numpy 2.4.6 from PyPI.
# Expected: A projection is told by its parameters as well as by a code. A survey's local transverse Mercator or an
# azimuthal projection around a site has no code, and its unit, the metre, stands in the file.
# Observed: The raster is said to be in EPSG:4326, the geographic system that the projection is based on. Its cells of
# 2 x 2 m are then 2 x 2 degrees: the smallest catchment is one of 10^10 square metres instead of 4. Nothing is said.
# The same raster with an EPSG code, or with no system at all, has 4 square metres; so has one whose underlying
# geographic system has no code either.
# Since: 2.0.6 is the only version that was tried.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check whitebox-workflows==2.0.6 rasterio==1.4.4 numpy==2.4.6

venv/bin/python -W ignore - <<'PY' | tee seen.txt
import numpy
import rasterio
import whitebox_workflows

rows, cols = numpy.indices((32, 32))
plain = (100 + 0.1 * rows + 0.01 * cols).astype("float32")
whitebox = whitebox_workflows.WbEnvironment()
parameters = ('PARAMETER["latitude_of_origin",47],PARAMETER["central_meridian",8],'
              'PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1]]')
base = ('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],'
        'UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]]')
systems = {"UTM by its code": "EPSG:32632",
           "local transverse Mercator": f'PROJCS["site",{base},PROJECTION["Transverse_Mercator"],'
                                        f'PARAMETER["scale_factor",1],{parameters}',
           "equal area": f'PROJCS["site",{base},PROJECTION["Lambert_Azimuthal_Equal_Area"],'
                         + parameters.replace("latitude_of_origin", "latitude_of_center").replace(
                             "central_meridian", "longitude_of_center")}
for name, system in systems.items():
    path = name.replace(" ", "_") + ".tif"
    with rasterio.open(path, "w", driver="GTiff", width=32, height=32, count=1, dtype="float32",
                       crs=system, transform=rasterio.Affine(2, 0, 0, 0, -2, 64)) as file:
        file.write(plain, 1)
    with rasterio.open(path) as file:
        unit = file.crs.linear_units
    raster = whitebox.read_raster(path)
    area = whitebox.hydrology.d8_flow_accum(dem=raster, out_type="ca").to_numpy()
    print(f"{name}: GDAL says {unit}, Whitebox EPSG:{raster.crs_epsg()},",
          f"smallest catchment {numpy.nanmin(area):.3g} square metres")
PY

grep -q 'UTM by its code: GDAL says metre, Whitebox EPSG:32632, smallest catchment 4 square' seen.txt
grep -qE 'local transverse Mercator: GDAL says metre, Whitebox EPSG:4326, smallest catchment [0-9.]+e\+10 square' seen.txt
grep -qE 'equal area: GDAL says metre, Whitebox EPSG:4326, smallest catchment [0-9.]+e\+10 square' seen.txt
echo "The behaviour is as described."
