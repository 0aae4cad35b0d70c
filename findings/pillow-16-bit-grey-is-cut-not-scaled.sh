#!/usr/bin/env bash
# Pillow turns a 16-bit height map into one of 8 bits by cutting at 255, so that a vision model sees white.
#
# Versions: pillow 13.0.0, datasets 5.2.0 and numpy 2.4.6 from PyPI.
# Expected: A 16-bit grey PNG that is converted to "L" or "RGB" keeps its look: 65535 becomes 255, and half of it
# becomes 128, as image programs do and as Pillow itself does for "1".
# Observed: Values over 255 become 255 and smaller ones stay as they are. A ramp of 4096 heights becomes white but for
# its darkest 16 columns. datasets.Image(mode="RGB") does so while it decodes, and with it what prepares pictures for
# vision models, which ask for RGB. Read without a mode, the same column is right.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check pillow==13.0.0 datasets==5.2.0 numpy==2.4.6

venv/bin/python -W ignore - <<'PY' | tee seen.txt
import datasets
import numpy
import PIL.Image

ramp = numpy.tile((numpy.arange(4096) * 16).astype("u2"), (2, 1))
PIL.Image.fromarray(ramp).save("heights.png")
picture = PIL.Image.open("heights.png")
column = datasets.Dataset.from_dict({"image": ["heights.png"]})


def show(name, values):
    row = numpy.asarray(values).astype(int)[0]
    row = row.reshape(len(row), -1)[:, 0]
    print(f"{name}: {len(numpy.unique(row))} values, a quarter {row[1024]}, half {row[2048]}, end {row[-1]}")


show(f"read as {picture.mode}", picture)
show("converted to L", picture.convert("L"))
show("converted to RGB", picture.convert("RGB"))
show("datasets.Image()", column.cast_column("image", datasets.Image())[0]["image"])
show('datasets.Image(mode="RGB")', column.cast_column("image", datasets.Image(mode="RGB"))[0]["image"])
PY

grep -q '^read as I;16: 4096 values, a quarter 16384, half 32768, end 65520' seen.txt
grep -q '^converted to L: 17 values, a quarter 255, half 255, end 255' seen.txt
grep -q '^converted to RGB: 17 values, a quarter 255, half 255, end 255' seen.txt
grep -q '^datasets.Image(): 4096 values' seen.txt
grep -q '^datasets.Image(mode="RGB"): 17 values, a quarter 255, half 255, end 255' seen.txt
echo "The behaviour is as described."
