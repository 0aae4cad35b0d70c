#!/usr/bin/env python3
"""Exports a world and has programs of others read it: gltf-validator, Blender, libsdformat, GDAL,
NumPy, laspy, plyfile and USD. scripts/install_dependencies.sh and the build install them; laspy,
plyfile and usd-core come with LATTICEWORLD_TEST_PYPI."""

import csv
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = ""
USD = importlib.util.find_spec("pxr")
PYPI = all(importlib.util.find_spec(name) for name in ("laspy", "plyfile"))


def run(*command, timeout=240, **options):
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=timeout, check=False,
                          **options)


class ExportReadersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        made = run(PROGRAM, "generate", "--layout",
                   "A lake in the lower left, a wood in the upper left, a road from west to east, "
                   "a small village in the center.", "--environment", "A sunny summer noon. "
                   "Two sheep graze.", "--seed", "4", "--size", "64", "--resolution", "0.5",
                   "--out", cls.path / "world")
        assert made.returncode == 0, made.stdout

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def export(self, form, name, *options):
        out = self.path / name
        done = run(PROGRAM, "export", self.path / "world", "--to", form, "--out", out, *options)
        self.assertEqual(done.returncode, 0, done.stdout)
        return out

    def test_gltf_validator_finds_no_errors_and_no_warnings(self):
        modules = os.environ.get("LATTICEWORLD_NODE_MODULES", "")
        self.assertTrue((pathlib.Path(modules) / "gltf-validator").is_dir(), modules)
        files = [self.export("glb", "instanced.glb"),
                 self.export("glb", "expanded.glb", "--expand", "--region=-20,-10,5,20")]
        done = run("node", HERE / "validate_glb.cjs", modules, *files)
        self.assertEqual(done.returncode, 0, done.stdout)
        for line in done.stdout.splitlines():
            report = json.loads(line)
            self.assertEqual((report["errors"], report["warnings"]), (0, 0), line)
            self.assertGreater(report["triangles"], 10000, line)

    def test_blender_imports_it_at_its_size_and_renders_it(self):
        glb = self.export("glb", "blender.glb", "--expand", "--region=-16,-16,16,16",
                          "--plants", "large", "--detail", "2")
        picture = self.path / "blender.jpg"
        done = run("blender", "--background", "--factory-startup", "--python-exit-code", "1",
                   "--python", HERE / "render_with_blender.py", "--", glb, picture, "160", "2")
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        found = re.search(r"blender: (\d+) meshes, (\d+) objects, ([\d.]+) x ([\d.]+) x", done.stdout)
        self.assertIsNotNone(found, done.stdout[-2000:])
        # Crowns may reach beyond the region, the ground does not.
        for extent in found.groups()[2:4]:
            self.assertGreaterEqual(float(extent), 31.99)
            self.assertLess(float(extent), 48.0)
        self.assertGreater(picture.stat().st_size, 2000)

    def test_libsdformat_loads_the_world_without_errors(self):
        checker = os.environ.get("LATTICEWORLD_CHECK_SDF", "")
        self.assertTrue(checker, "built without libsdformat")
        folder = self.export("sdf", "sdf")
        done = run(checker, folder / "world.sdf", folder / "latticeworld_media" / "model.sdf")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertRegex(done.stdout, r"world\.sdf: \d+ models, 1 lights, 0 errors")

    def test_gdal_reads_the_heights_that_the_world_has(self):
        folder = self.export("geotiff", "tif")
        manifest = json.loads((self.path / "world" / "world.json").read_text())
        scale = manifest["height_png"]["scale_m"]
        offset = manifest["height_png"]["offset_m"]
        for col, row in ((0, 0), (17, 100), (64, 64), (127, 3)):
            values = [float(run("gdallocationinfo", "-valonly", file, col, row).stdout.split()[-1])
                      for file in (folder / "elevation.tif", self.path / "world" / "height.png")]
            self.assertAlmostEqual(values[0], offset + values[1] * scale / 65535,
                                   delta=scale / 65535)

    @unittest.skipUnless(PYPI, "no numpy")
    def test_numpy_loads_the_heights_that_gdal_reads(self):
        import numpy
        folder = self.export("heights", "heights")
        tif = self.export("geotiff", "tif_of_heights")
        about = json.loads((folder / "heights.json").read_text())
        layers = {name: numpy.load(folder / file) for name, file in about["layers"].items()}
        self.assertEqual({name: layer.shape for name, layer in layers.items()},
                         dict.fromkeys(layers, (about["rows"], about["cols"])))
        for col, row in ((0, 0), (17, 100), (64, 64), (127, 3)):
            read = run("gdallocationinfo", "-valonly", tif / "elevation.tif", col, row).stdout
            self.assertAlmostEqual(layers["heights"][row, col], float(read.split()[-1]), delta=1e-4)
        self.assertEqual(about["lowest"], layers["heights"].min())
        self.assertTrue((layers["water"][~numpy.isnan(layers["water"])] > about["lowest"]).all())

    @unittest.skipUnless(USD, "no usd-core")
    def test_usd_finds_no_fault_and_every_thing_at_its_place(self):
        from pxr import Usd, UsdGeom, UsdPhysics, UsdValidation
        with open(self.path / "world" / "assets.csv", encoding="utf-8") as file:
            assets = list(csv.DictReader(file))
        stages = [Usd.Stage.Open(str(self.export("usd", name, *options) / "world.usda"))
                  for name, options in (("usd", ()), ("usd_expanded", ("--expand",)),
                                        ("usd_region", ("--region=-20,-10,5,20",)))]
        validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
        for stage in stages:
            faults = UsdValidation.ValidationContext(validators).Validate(stage)
            self.assertEqual([fault.GetMessage() for fault in faults], [])
            self.assertEqual(UsdGeom.GetStageMetersPerUnit(stage), 1.0)
            self.assertEqual(UsdGeom.GetStageUpAxis(stage), "Z")
            self.assertTrue(stage.GetPrimAtPath("/World/ground").HasAPI(UsdPhysics.CollisionAPI))
        now = Usd.TimeCode.Default()
        places = {}
        for prim in stages[0].GetPrimAtPath("/World/assets").GetChildren():
            instancer = UsdGeom.PointInstancer(prim)
            for number, matrix in zip(instancer.GetIdsAttr().Get(),
                                      instancer.ComputeInstanceTransformsAtTime(now, now)):
                places[number] = matrix.ExtractTranslation()
        self.assertEqual(sorted(places), list(range(len(assets))))
        for number, asset in enumerate(assets):
            for i, name in enumerate(("x_m", "y_m", "z_m")):
                self.assertAlmostEqual(places[number][i], float(asset[name]), delta=1e-4)
        things = stages[1].GetPrimAtPath("/World/assets").GetChildren()
        self.assertEqual(len(things), len(assets))
        self.assertTrue(all(thing.IsInstance() for thing in things))

    @unittest.skipUnless(PYPI, "no laspy and plyfile")
    def test_laspy_and_plyfile_read_the_same_points(self):
        import laspy
        import numpy
        import plyfile
        las = laspy.read(self.export("las", "points.las"))
        ply = plyfile.PlyData.read(str(self.export("ply", "points.ply")))["vertex"]
        self.assertEqual(len(las.points), ply.count)
        for axis in "xyz":
            self.assertLess(numpy.abs(numpy.asarray(getattr(las, axis)) - ply[axis]).max(), 6e-4)
        self.assertTrue(numpy.array_equal(numpy.asarray(las.red) // 257, ply["red"]))
        names = dict(re.findall(r"label (\d+) (\w+)", "\n".join(
            plyfile.PlyData.read(str(self.path / "points.ply")).comments)))
        classes = {"ground": 2, "road": 11, "water": 9, "tree": 5, "building": 6}
        for number, name in names.items():
            of_label = numpy.asarray(las.classification)[ply["label"] == int(number)]
            if name in classes:
                self.assertGreater(len(of_label), 0, name)
                self.assertTrue((of_label == classes[name]).all(), name)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
