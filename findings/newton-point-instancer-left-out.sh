#!/usr/bin/env bash
# newton leaves out a USD PointInstancer whose prototype collides, and says nothing.
#
# Versions: newton 1.8.0 with its importers from PyPI.
# Expected: A PointInstancer is how USD says a forest. A reader makes a shape of each instance, or says that it cannot.
# Observed: The world has no shape at all: none of the 25 posts is there, and robots drive through them. No error, no
# warning. The same posts as prims of their own are all there.
# Since: 1.8.0 is the only version that was tried.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check 'newton[importers]==1.8.0'

post='uniform token axis = "Z"
            double height = 2
            double radius = 0.1'
{
    printf '#usda 1.0\n(\n  defaultPrim = "World"\n  metersPerUnit = 1\n  upAxis = "Z"\n)\ndef Xform "World"\n{\n'
    printf '  def PointInstancer "posts"\n  {\n    point3f[] positions = ['
    for i in $(seq 25); do printf '%s(%s, 10, 1)' "$([ "$i" = 1 ] || echo ', ')" "$i"; done
    printf ']\n    int[] protoIndices = ['
    for i in $(seq 25); do printf '%s0' "$([ "$i" = 1 ] || echo ', ')"; done
    printf ']\n    rel prototypes = </World/posts/post>\n'
    printf '    def Cylinder "post" (prepend apiSchemas = ["PhysicsCollisionAPI"])\n    {\n%s\n    }\n  }\n}\n' "$post"
} > instances.usda
{
    printf '#usda 1.0\n(\n  defaultPrim = "World"\n  metersPerUnit = 1\n  upAxis = "Z"\n)\ndef Xform "World"\n{\n'
    for i in $(seq 25); do
        printf '  def Cylinder "post_%s" (prepend apiSchemas = ["PhysicsCollisionAPI"])\n  {\n%s\n' "$i" "$post"
        printf '    double3 xformOp:translate = (%s, 10, 1)\n    uniform token[] xformOpOrder = ["xformOp:translate"]\n  }\n' "$i"
    done
    printf '}\n'
} > prims.usda

venv/bin/python -W ignore - <<'PY' | tee seen.txt
import newton
import warp
from pxr import Usd, UsdGeom

warp.config.quiet = True
for name in ("instances", "prims"):
    stage = Usd.Stage.Open(name + ".usda")
    box = UsdGeom.BBoxCache(0, ["default"]).ComputeWorldBound(stage.GetDefaultPrim()).ComputeAlignedRange()
    builder = newton.ModelBuilder()
    builder.add_usd(name + ".usda")
    ys = sorted({round(float(xform[1]), 3) for xform in builder.shape_transform})
    print(f"{name}: USD says y = {box.GetMin()[1]:.1f} to {box.GetMax()[1]:.1f},",
          f"newton has {builder.shape_count} shapes at y = {ys}")
PY

grep -q '^instances: USD says y = 9.9 to 10.1, newton has 0 shapes at y = \[\]' seen.txt
grep -q '^prims: USD says y = 9.9 to 10.1, newton has 25 shapes at y = \[10.0\]' seen.txt
echo "The behaviour is as described."
