#!/usr/bin/env bash
# GDAL writes a terrain whose first row is the southern one to ESRI's .bil format mirrored and displaced.
#
# Versions: gdal-bin 3.6.2+dfsg-1+b2 of Debian 12, and GDAL 3.10.3 inside rasterio 1.4.4 from PyPI.
# Expected: Rasters with the south first are valid (point lists in ascending order, netCDF). The formats of ESRI have
# the north first, so that a writer turns the rows around, as the AAIGrid driver of GDAL does, or else refuses.
# Observed: The driver EHdr keeps the order of the rows and drops the sign of the cell height. It ends without an error
# or a warning, and what stood in the south is then in the north. The upper edge is besides set to the southern
# edge plus one cell, so that the whole raster is displaced too.
# Since: Both versions do it.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

have=$(dpkg-query -W -f '${Version}' gdal-bin)
[ "$have" = 3.6.2+dfsg-1+b2 ] || { echo "gdal-bin is $have, not 3.6.2+dfsg-1+b2."; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check rasterio==1.4.4 numpy==2.4.6

# These are 2 x 3 cells of 2 m. The heights are 10 in the southern row, 20 in the middle one and 30 in the northern one.
for y in 1 3 5; do for x in 1 3; do echo "$x $y $(((y + 1) * 5))"; done; done > points.xyz
gdal_translate -q -ot Float32 -of AAIGrid points.xyz grid.asc
gdal_translate -q -ot Float32 -of EHdr points.xyz grid.bil 2> messages.txt
edges() { gdalinfo "$1" | sed -nE 's/^(Upper|Lower) Left *\( *([-0-9.]+), *([-0-9.]+)\).*/\1 edge at y = \3/p' | paste -sd, ; }
heights() { gdal_translate -q -of XYZ "$1" /vsistdout/ | awk '$1 == 1 {print "y = " $2 ": " $3}' | sort -k3n | paste -sd, ; }
for file in points.xyz grid.asc grid.bil; do echo "$file: $(edges "$file"); $(heights "$file")"; done | tee seen.txt
echo "GDAL's messages while it wrote the .bil: '$(cat messages.txt)'"

venv/bin/python -W ignore - <<'PY' | tee rasterio.txt
import rasterio, rasterio.shutil
rasterio.shutil.copy("points.xyz", "newer.bil", driver="EHdr")
for name in ("points.xyz", "newer.bil"):
    with rasterio.open(name) as grid:
        print(f"{name} with GDAL {rasterio.__gdal_version__}: cell height {grid.transform.e},",
              "edge of the first row at y =", grid.transform.f, "rows", grid.read(1)[:, 0].tolist())
PY

grep -q 'grid.asc.*y = 1: 10,y = 3: 20,y = 5: 30' seen.txt
grep -q 'grid.bil.*y = -3: 30,y = -1: 20,y = 1: 10' seen.txt
[ ! -s messages.txt ]
grep -q 'newer.bil with GDAL 3.10.3: cell height -2.0, edge of the first row at y = 2.0 rows \[10' rasterio.txt
echo "The behaviour is as described."
