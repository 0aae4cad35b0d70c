#!/usr/bin/env bash
# Whitebox Workflows reads compressed GeoTIFFs that have a predictor as if they had none, and gives noise for heights.
#
# Versions: whitebox-workflows 2.0.6, rasterio 1.4.4 (GDAL 3.10.3) and numpy 2.4.6 from PyPI.
# Expected: Predictors 2 (differences) and 3 (floating point) belong to TIFF, and GDAL recommends them for elevation.
# A reader undoes them, or says that it cannot.
# Observed: The stored differences come back as the heights, without an error or a warning. With predictor 3 a plain
# of 100 to 103 m has values of 1e38 and NaN, with predictor 2 whole numbers are their differences, nearly all 0 or 1.
# Size, place and coordinate system are right, and tools run over it.
# Since: 1.3.5 refuses floating-point predictors with an error.
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

heights = 100 + numpy.arange(48 * 64).reshape(48, 64) / 1024
whole = numpy.arange(48 * 64).reshape(48, 64) // 64 + 100
whitebox = whitebox_workflows.WbEnvironment()
for kind, values, predictors in (("float32", heights, (1, 2, 3)), ("int16", whole, (1, 2))):
    for predictor in predictors:
        values = values.astype(kind)
        name = f"{kind}_{predictor}.tif"
        with rasterio.open(name, "w", driver="GTiff", width=64, height=48, count=1, dtype=kind,
                           crs="EPSG:32632", transform=rasterio.Affine(1, 0, 500000, 0, -1, 5250000),
                           compress="deflate", predictor=predictor) as file:
            file.write(values, 1)
        with rasterio.open(name) as file:
            again = numpy.array_equal(file.read(1), values)
        seen = whitebox.read_raster(name).to_numpy()
        wrong = int((~(seen == values)).sum())
        print(f"{kind} predictor {predictor}: GDAL reads {'the same' if again else 'others'},",
              f"Whitebox {wrong} of {seen.size} cells wrong")
PY

grep -q 'float32 predictor 1: GDAL reads the same, Whitebox 0 of 3072' seen.txt
grep -q 'int16 predictor 1: GDAL reads the same, Whitebox 0 of 3072' seen.txt
grep -qE 'float32 predictor 2: GDAL reads the same, Whitebox [23][0-9]{3} of' seen.txt
grep -qE 'float32 predictor 3: GDAL reads the same, Whitebox [23][0-9]{3} of' seen.txt
grep -qE 'int16 predictor 2: GDAL reads the same, Whitebox [23][0-9]{3} of' seen.txt
echo "The behaviour is as described."
