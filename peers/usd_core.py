"""USD's own library opens exports --to usd, with instances and expanded, and validates them."""
# pypi: usd-core==26.11 numpy==2.4.6

import numpy
from pxr import Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdValidation

from ground import Ground
from peer import Peer, assets, export


def faults_of(stage):
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    found = UsdValidation.ValidationContext(validators).Validate(stage)
    return sorted({f"{fault.GetName()}: {fault.GetMessage()[:80]}" for fault in found})


def ground_of(stage):
    """Heights of the ground's vertices by their places in the frame map."""
    mesh = UsdGeom.Mesh(stage.GetPrimAtPath("/World/ground"))
    return numpy.asarray(mesh.GetPointsAttr().Get(), dtype=float)


def check_ground(peer, stage, ground):
    places = ground.places(1000, centers=True)
    by_place = {(round(x, 3), round(y, 3)): z for x, y, z in ground_of(stage)}
    ground.check(peer, [by_place.get((round(x, 3), round(y, 3)), float("nan")) for x, y in places],
                 places)


def check_instances(peer, stage):
    """Every thing of assets.csv is there once, with its number, at its place."""
    rows, seen, worst = assets(), {}, 0.0
    for prim in stage.Traverse():
        if prim.IsA(UsdGeom.PointInstancer):
            instancer = UsdGeom.PointInstancer(prim)
            matrices = instancer.ComputeInstanceTransformsAtTime(
                Usd.TimeCode.Default(), Usd.TimeCode.Default())
            for number, matrix in zip(instancer.GetIdsAttr().Get(), matrices):
                seen[number] = matrix.ExtractTranslation()
    for number, place in seen.items():
        row = rows[number]
        worst = max(worst, *(abs(place[i] - float(row[name]))
                             for i, name in enumerate(("x_m", "y_m", "z_m"))))
    peer.check("instances", len(seen) == len(rows) and worst < 1e-4,
               f"{len(seen)} of {len(rows)}, off by {worst:.2g} m at most")


def main():
    peer = Peer("OpenUSD (usd-core)", ".".join(str(part) for part in Usd.GetVersion()),
                "`--to usd`, with instances, expanded, a region")
    ground = Ground(export("heights", "heights"))
    region = "--region=-30,-20,20.3,40"
    for name, options in (("usd", ()), ("usd_expanded", ("--expand",)), ("usd_region", (region,))):
        stage = Usd.Stage.Open(str(export("usd", name, *options) / "world.usda"))
        faults = faults_of(stage)
        peer.check(f"validators on {name}", not faults, faults or "no fault")
        if name == "usd":
            peer.check("units and axis", UsdGeom.GetStageMetersPerUnit(stage) == 1.0
                       and UsdGeom.GetStageUpAxis(stage) == "Z", "1 m, z up")
            check_ground(peer, stage, ground)
            check_instances(peer, stage)
            labelled = [prim for prim in stage.Traverse()
                        if prim.HasAPI(UsdSemantics.LabelsAPI, "class")]
            labels = {label for prim in labelled
                      for label in UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get()}
            peer.check("labels", {"ground", "tree", "water"} <= labels, ", ".join(sorted(labels)))
            solids = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.CollisionAPI)]
            peer.check("colliders", len(solids) > 1, len(solids))
        if name == "usd_expanded":
            things = list(stage.GetPrimAtPath("/World/assets").GetChildren())
            peer.check("expanded things", len(things) == len(assets())
                       and all(thing.IsInstance() for thing in things), len(things))
        box = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"]).ComputeWorldBound(
            stage.GetPrimAtPath("/World/ground")).ComputeAlignedRange()
        middle = box.GetMidpoint()
        peer.check(f"ground of {name} in the middle", max(abs(middle[0]), abs(middle[1])) < 0.51,
                   f"{box.GetSize()[0]:.1f} x {box.GetSize()[1]:.1f} m")
    peer.finish()


main()
