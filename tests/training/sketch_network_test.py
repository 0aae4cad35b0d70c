"""The sketch model: trained on pairs that the program writes, going on after a kill, read by the program as ONNX."""

import csv
import os
import subprocess
import tempfile
import unittest

import numpy
import torch
from latticeworld_training import sketch_export, sketch_network, sketch_pairs, sketch_training
from latticeworld_training.sketch_network import SketchNetworkOptions
from latticeworld_training.sketch_training import SketchTrainingOptions

PROGRAM = os.environ["LATTICEWORLD_PROGRAM"]
ANSWERS = os.environ["LATTICEWORLD_SKETCH_ANSWERS"]
TOY = SketchNetworkOptions(width=4, levels=3, blocks=2, discriminator_width=4, discriminator_layers=2)


class SketchNetworkTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        torch.set_num_threads(1)
        cls.folder = tempfile.TemporaryDirectory()
        cls.pairs_folder = os.path.join(cls.folder.name, "pairs")
        subprocess.run([PROGRAM, "sketch-pairs", "--count", "12", "--side", "64", "--seed", "3", "--threads", "1",
                        "--out", cls.pairs_folder], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        cls.pairs = sketch_pairs.SketchPairs(cls.pairs_folder)
        cls.small = cls.pairs.halved()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def fit(self, out, steps=(3, 3, 3), **more):
        options = SketchTrainingOptions(small_steps=steps[0], plain_steps=steps[1], adversarial_steps=steps[2],
                                        checkpoint_steps=20, check_pairs=2, rate=2e-3)
        return sketch_training.fit(self.pairs, self.small, os.path.join(self.folder.name, self.id() + out), TOY,
                                   options, say=lambda text: None, **more)

    def test_pairs_are_strokes_and_land(self):
        self.assertEqual(len(self.pairs), 12)
        sketch, height = self.pairs.batch(range(12))
        self.assertEqual((sketch.shape, height.shape), ((12, 3, 64, 64), (12, 1, 64, 64)))
        ridge = (sketch[:, 2:] == 0).float()
        valley = ((sketch[:, :1] == 0) & (sketch[:, 2:] == 1)).float()
        self.assertTrue(bool((sketch.unique() == torch.tensor([0.0, 1.0])).all()))
        high, low = (height * ridge).sum() / ridge.sum(), (height * valley).sum() / valley.sum()
        self.assertGreater(float(high), float(low) + sketch_pairs.SPREAD)
        self.assertEqual(self.small.batch([0])[0].shape, (1, 3, 32, 32))

    def test_varied_pairs_stay_pairs(self):
        random = numpy.random.RandomState(1)
        for i in range(12):
            sketch, height = self.pairs.batch([i], random)
            ridge = sketch[:, 2:] == 0
            valley = (sketch[:, :1] == 0) & ~ridge
            if ridge.any() and valley.any():
                self.assertGreater(float(height[ridge].mean()), float(height[valley].mean()))

    def test_learns_where_it_is_high(self):
        generator, losses = self.fit("a", (60, 60, 10))
        self.assertLess(numpy.mean(losses[50:60]), 0.85 * numpy.mean(losses[:10]))
        seen, fresh = range(10), sketch_network.Generator(TOY)
        self.assertGreater(numpy.mean(sketch_training.correlations(generator, self.pairs, seen)), 0.4)
        self.assertLess(numpy.mean(sketch_training.correlations(fresh, self.pairs, seen)), 0.3)

    def test_goes_on_as_if_never_interrupted(self):
        _, whole = self.fit("whole")
        parts = []
        for steps in (2, 2, 3, 2):  # cut within each of the three parts of the training
            parts += self.fit("parts", most_steps=steps)[1]
        self.assertEqual(whole, parts)
        folder = os.path.join(self.folder.name, self.id() + "parts")
        with open(os.path.join(folder, "loss.csv"), newline="", encoding="utf-8") as file:
            self.assertEqual([row["step"] for row in csv.DictReader(file)], ["2", "4", "7", "9"])
        self.assertTrue(os.path.exists(os.path.join(folder, "loss.png")))

    def test_discriminators_learn_to_tell_and_the_generator_is_told(self):
        torch.manual_seed(1)
        discriminators = sketch_network.Discriminators(TOY)
        optimizer = torch.optim.Adam(discriminators.parameters(), lr=5e-3)
        sketch, height = self.pairs.batch(range(4))
        made = torch.full_like(height, 0.5, requires_grad=True)
        losses = []
        for _ in range(30):
            loss = sketch_network.discriminator_loss(discriminators(sketch, height),
                                                     discriminators(sketch, made.detach()))
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            losses.append(float(loss.detach()))
        self.assertLess(losses[-1], 0.8 * losses[0])
        real, fake = discriminators(sketch, height), discriminators(sketch, made)
        (sketch_network.adversarial_loss(fake) + sketch_network.feature_loss(real, fake)).backward()
        self.assertGreater(float(made.grad.abs().sum()), 0)

    def test_the_program_gives_what_pytorch_gives(self):
        self.fit("run", (4, 8, 0))
        generator = sketch_training.read_generator(os.path.join(self.folder.name, self.id() + "run"))
        for name, network in (("trained", generator), ("fresh", sketch_network.Generator(TOY).eval())):
            model = os.path.join(self.folder.name, name + ".onnx")
            sketch_export.export(network, 64, model)
            sketch = os.path.join(self.pairs_folder, "000001_sketch.png")
            heights = os.path.join(self.folder.name, "heights.f32")
            strokes = os.path.join(self.folder.name, "strokes.u8")
            subprocess.run([ANSWERS, model, sketch, strokes, heights], check=True)
            read = sketch_pairs.colors_of(numpy.fromfile(strokes, numpy.uint8).reshape(64, 64))
            with torch.no_grad():
                expected = network(torch.from_numpy(read)[None]).numpy().ravel()
            numpy.testing.assert_allclose(numpy.fromfile(heights, numpy.float32), expected, atol=2e-5)

        out = os.path.join(self.folder.name, "world")
        subprocess.run([PROGRAM, "generate", "--sketch", sketch, "--sketch-model",
                        os.path.join(self.folder.name, "trained.onnx"), "--size", "64", "--resolution", "1", "--seed",
                        "1", "--layout", "Grassland everywhere.", "--out", out], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertTrue(os.listdir(out))


if __name__ == "__main__":
    unittest.main()
