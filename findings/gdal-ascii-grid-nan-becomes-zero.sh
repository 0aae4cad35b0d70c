#!/usr/bin/env bash
# GDAL reads the "nan" cells of an ASCII grid as height 0 if all its other cells are whole numbers.
#
# Versions: gdal-bin 3.6.2+dfsg-1+b2 of Debian 12, and GDAL 3.10.3 inside rasterio 1.4.4 from PyPI.
# Expected: GDAL reads "nan" in such grids as a number that is missing. Only floating point holds it, so the band is
# Float32 and the cell is NaN, the more so if the header says "NODATA_value nan".
# Observed: The type is guessed from the look of the numbers, and "nan" does not look like a fraction. The band is
# Int32 and the cell is 0: a hole in the terrain becomes ground at sea level that counts as valid, without a warning.
# If one other cell is written "4.0" instead of "4", then the same grid is Float32 and right. Debian's version does so
# even under "NODATA_value nan", and then announces a no-data value that no cell of an Int32 band can equal.
# Since: Both versions do it under a usual no-data value. Under "NODATA_value nan" only 3.6.2 does, and 3.10.3 is right.
# The configuration option AAIGRID_DATATYPE=Float32 avoids it.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

have=$(dpkg-query -W -f '${Version}' gdal-bin)
[ "$have" = 3.6.2+dfsg-1+b2 ] || { echo "gdal-bin is $have, not 3.6.2+dfsg-1+b2."; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check rasterio==1.4.4 numpy==2.4.6

grid() { printf '%s\n' 'ncols 3' 'nrows 2' 'xllcorner 0' 'yllcorner 0' 'cellsize 1' "NODATA_value $1" '1 nan 3' "$2 5 6"; }
grid -9999 4 > whole.asc
grid -9999 4.0 > point.asc
grid nan 4 > declared.asc

for name in whole point declared; do
    echo "$name.asc with GDAL 3.6.2: $(gdalinfo "$name.asc" | grep -oE 'Type=[A-Za-z0-9]+|NoData Value=.*' | paste -sd' ')," \
        "cells $(gdal_translate -q -of XYZ "$name.asc" /vsistdout/ | cut -d' ' -f3 | paste -sd' ')"
done | tee debian.txt
venv/bin/python -W ignore - <<'PY' | tee rasterio.txt
import rasterio
for name in ("whole", "point", "declared"):
    with rasterio.open(name + ".asc") as grid:
        print(f"{name}.asc with GDAL {rasterio.__gdal_version__}:", grid.dtypes[0], "cells",
              grid.read(1).ravel().tolist(), "valid", (grid.dataset_mask().ravel() > 0).tolist())
PY

grep -q 'whole.asc.*Type=Int32 NoData Value=-9999, cells 1 0 3 4 5 6' debian.txt
grep -q 'point.asc.*Type=Float32 NoData Value=-9999, cells 1 nan 3 4 5 6' debian.txt
grep -q 'declared.asc.*Type=Int32 NoData Value=nan, cells 1 0 3 4 5 6' debian.txt
grep -q 'whole.asc with GDAL 3.10.3: int32 cells \[1, 0, 3, 4, 5, 6\] valid \[True, True, True, True, True, True\]' rasterio.txt
grep -q 'point.asc.*float32 cells \[1.0, nan, 3.0' rasterio.txt
grep -q 'declared.asc.*float32 cells \[1.0, nan, 3.0' rasterio.txt
echo "The behaviour is as described."
