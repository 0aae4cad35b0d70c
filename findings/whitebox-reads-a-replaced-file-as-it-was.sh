#!/usr/bin/env bash
# Whitebox Workflows gives the old raster after a file was replaced by another one of the same name.
#
# Versions: whitebox-workflows 2.0.6, rasterio 1.4.4 (GDAL 3.10.3) and numpy 2.4.6 from PyPI.
# Expected: read_raster reads the file, or looks whether it is still the one that it has read.
# Observed: A path that was read once gives the same raster for as long as the process lives, though the file has other
# heights, another size and a later time. It does so in a second WbEnvironment too. A loop that makes land, writes it
# to one file and measures it gets the figures of the first land for all.
# Since: 2.0.6 is the only version that was tried.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check whitebox-workflows==2.0.6 rasterio==1.4.4 numpy==2.4.6

venv/bin/python -W ignore - <<'PY' | tee seen.txt
import os

import numpy
import rasterio
import whitebox_workflows


def write(size, height):
    with rasterio.open("land.tif", "w", driver="GTiff", width=size, height=size, count=1, dtype="float32",
                       crs="EPSG:32632", transform=rasterio.Affine(1, 0, 0, 0, -1, size)) as file:
        file.write(numpy.full((size, size), height, "float32"), 1)


first = whitebox_workflows.WbEnvironment()
for size, height, environment in ((8, 100, first), (16, 200, first), (32, 300, whitebox_workflows.WbEnvironment())):
    if os.path.exists("land.tif"):
        os.remove("land.tif")
    write(size, height)
    os.utime("land.tif", (1.7e9 + size * 1e5, 1.7e9 + size * 1e5))
    seen = environment.read_raster("land.tif").to_numpy()
    print(f"written {size} x {size} of {height} m, read {seen.shape[0]} x {seen.shape[1]} of {seen.max():g} m")
PY

grep -q 'written 8 x 8 of 100 m, read 8 x 8 of 100 m' seen.txt
grep -q 'written 16 x 16 of 200 m, read 8 x 8 of 100 m' seen.txt
grep -q 'written 32 x 32 of 300 m, read 8 x 8 of 100 m' seen.txt
echo "The behaviour is as described."
