"""What sees: each stage learns, goes on after a kill as if there had been none, and changes only what it may."""

import copy
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy
import tiny_lands
import torch
from latticeworld_training import (chat_data, export_eyes, export_gguf, fitting, llama, tokenizer, vision_data,
                                   vision_stages)
from latticeworld_training.vision_network import Projection, VisionOptions, contrastive_loss
from PIL import Image
from tiny_lands import SIDES, land

TOY = {"side": 16, "patch": 4, "width": 32, "heads": 2, "layers": 2, "text_layers": 1, "shared": 16}


class VisionTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        torch.set_num_threads(1)
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = tiny_lands.write_split(cls.folder.name, "relief", "train")
        cls.pictures = vision_data.read_pictures(cls.path, TOY["side"])
        texts = [content for picture in cls.pictures for _, content in picture.messages]
        cls.tokenizer = tokenizer.train_tokenizer(texts, most_fours=8, most_words=60)
        cls.network = VisionOptions(tokens=len(cls.tokenizer), **TOY)
        torch.manual_seed(3)
        cls.blind = cls.new_language_model()  # knows what is said, and not when
        examples, _ = chat_data.encode_all(cls.tokenizer, [picture.messages for picture in cls.pictures], 128)
        options = fitting.FitOptions(rate=1e-2, epochs=30, batch_size=16, checkpoint_steps=1000)
        fitting.fit(cls.blind, examples, [], os.path.join(cls.folder.name, "blind"), options, say=cls.quiet)
        cls.contrasted, cls.contrast_losses = cls.contrast(os.path.join(cls.folder.name, "contrast"))
        cls.seeing, cls.projection = cls.copy_of(cls.blind), cls.new_projection()
        cls.together_losses = cls.together(os.path.join(cls.folder.name, "together"), cls.projection, cls.seeing)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @staticmethod
    def quiet(_):
        pass

    @classmethod
    def new_language_model(cls):
        return llama.Llama(llama.LlamaSizes(tokens=len(cls.tokenizer), width=32, layers=2, heads=2, kv_heads=2,
                                            hidden=64, context=128))

    @classmethod
    def copy_of(cls, language_model):
        model = cls.new_language_model()
        model.load_state_dict(language_model.state_dict())
        return model

    @classmethod
    def new_projection(cls):
        torch.manual_seed(5)
        return Projection(cls.network, 32)

    @classmethod
    def encoder(cls):
        return copy.deepcopy(cls.contrasted.heights).eval()

    @classmethod
    def contrast(cls, out, **more):
        options = vision_stages.contrast_options(epochs=20, batch_size=8, rate=2e-3, checkpoint_steps=5)
        return vision_stages.contrast(cls.pictures, cls.tokenizer, out, cls.network, options, say=cls.quiet, **more)

    @classmethod
    def align(cls, out, language_model, **more):
        options = vision_stages.align_options(epochs=40, batch_size=8, rate=1e-2, checkpoint_steps=5)
        return vision_stages.align(cls.encoder(), language_model, cls.tokenizer, cls.pictures, out, options,
                                   say=cls.quiet, **more)

    @classmethod
    def together(cls, out, projection, language_model, **more):
        options = vision_stages.together_options(epochs=60, batch_size=8, rate=3e-3, checkpoint_steps=5)
        return vision_stages.together(cls.encoder(), projection, language_model, cls.tokenizer, cls.pictures, out,
                                      options, say=cls.quiet, **more)

    def test_schedules_are_the_methods(self):
        self.assertEqual(vision_stages.contrast_options().epochs, 10)
        aligned, learned = vision_stages.align_options(), vision_stages.together_options()
        self.assertEqual((aligned.epochs, aligned.rate), (12, 5e-4))
        self.assertEqual((learned.epochs, learned.rate, learned.batch_size), (4, 5e-5, 32))
        self.assertEqual((learned.betas, learned.weight_decay), ((0.9, 0.999), 0.001))

    def test_heights_are_read_whatever_their_scale(self):
        self.assertEqual(len(self.pictures), 16)
        height = self.pictures[0].height
        self.assertEqual(height.shape, (16, 16))
        self.assertAlmostEqual(float(height.mean()), 0, places=5)
        self.assertAlmostEqual(float(height.std()), 1, places=5)
        self.assertGreater(height[0].mean(), height[-1].mean() + 1)  # row 0 is north

    def test_heights_of_any_size_are_means_over_equal_cells(self):
        path = os.path.join(self.folder.name, "ramp.png")
        for samples in (33, 50, 96):
            ramp = numpy.arange(samples, dtype=numpy.uint16)[None].repeat(samples, 0)
            Image.fromarray(ramp).save(path)
            height = vision_data.read_height(path, 16)
            steps = numpy.diff(height[0])
            self.assertLess(steps.max() - steps.min(), 0.1 * steps.mean(), samples)
            self.assertTrue((height == height[:1]).all())

    def test_pictures_are_spoken_of_as_at_work(self):
        prompts = pathlib.Path(os.environ["LATTICEWORLD_ROOT"], "src/latticeworld/language/remote/prompts")
        relief = (prompts / "relief.txt").read_text(encoding="utf-8").strip()
        picture = (prompts / "relief_image.txt").read_text(encoding="utf-8").strip()
        said = relief.replace("{{caption}}", "high ground in the north")
        self.assertEqual(vision_data.told_of_picture(f"A lake.\n\n{said}\n\nWrite."),
                         f"A lake.\n\n{said}\n{picture}\n\nWrite.")
        self.assertEqual(vision_data.told_of_picture("A lake."), "A lake.")

    def test_what_is_exported_sees_as_in_training(self):
        folder = os.path.join(self.folder.name, "eyes")
        os.makedirs(folder, exist_ok=True)
        model_file = os.path.join(folder, "seeing.gguf")
        export_gguf.export(self.seeing, self.tokenizer, model_file, "f32", sees=True)
        export_eyes.export_eyes(self.encoder(), self.projection, export_eyes.eyes_path(model_file), "f32")
        # Divides into 16 cells neither way.
        picture = os.path.join(folder, "land.png")
        Image.fromarray(land("west", 300, samples=53)).save(picture)
        tokens = chat_data.prompt_tokens(self.tokenizer, [("user", "Where is it high?")])
        question = json.dumps({"picture": picture, "tokens": tokens}) + "\n"
        done = subprocess.run([os.environ["LATTICEWORLD_LOCAL_ANSWERS"], model_file], input=question, text=True,
                              stdout=subprocess.PIPE, check=True)
        answer = numpy.array(json.loads(done.stdout))
        height = torch.from_numpy(vision_data.read_height(picture, 16))[None, None]
        with torch.no_grad():
            seen = self.projection(self.encoder().features(height))
            embedded = torch.cat([seen, self.seeing.embeddings(torch.tensor([tokens]))], 1)
            ours = self.seeing.logits(self.seeing.features(embedded))[0, -1].numpy()
            unseen = self.seeing(torch.tensor([tokens]))[0, -1].numpy()
        self.assertLess(abs(answer - ours).max(), 1e-3)
        self.assertGreater(abs(unseen - ours).max(), 0.1)

    def test_a_run_is_exported_with_its_eyes_by_one_command(self):
        folder = os.path.join(self.folder.name, "exported")
        blind, out = os.path.join(self.folder.name, "blind"), os.path.join(folder, "seeing.gguf")
        os.makedirs(folder, exist_ok=True)
        self.tokenizer.save(os.path.join(blind, "tokenizer.json"))
        with open(os.path.join(blind, "model.json"), "w", encoding="utf-8") as file:
            json.dump(vars(self.blind.sizes), file)
        export_gguf.main([blind, "--vision", self.folder.name, "--type", "f32", "--out", out])
        wanted = os.path.join(folder, "wanted.gguf")
        export_gguf.export(self.seeing, self.tokenizer, wanted, "f32", sees=True)
        export_eyes.export_eyes(self.encoder(), self.projection, export_eyes.eyes_path(wanted), "f32")
        for path in (str, export_eyes.eyes_path):
            with open(path(out), "rb") as exported, open(path(wanted), "rb") as before:
                self.assertEqual(exported.read(), before.read())

    def test_a_bad_line_is_named(self):
        path = os.path.join(self.folder.name, "relief", "bad.jsonl")
        with open(path, "w", encoding="utf-8") as file:
            file.write('{"messages": [], "images": ["images/none.png"]}\n')
        with self.assertRaisesRegex(ValueError, "bad.jsonl, line 1.*none.png"):
            vision_data.read_pictures(path, 16)

    def test_features_are_of_the_last_layer_but_one(self):
        encoder = self.encoder()
        heights = vision_data.height_tensor(self.pictures[:2])
        features = encoder.features(heights)
        self.assertEqual(features.shape, (2, 16, 32))
        with torch.no_grad():
            for weight in encoder.layers[-1].parameters():
                weight.fill_(7.0)
        self.assertTrue(torch.equal(encoder.features(heights), features))
        with torch.no_grad():
            encoder.layers[0].down.bias.add_(1.0)
        self.assertFalse(torch.allclose(encoder.features(heights), features))
        projection = Projection(self.network, 48)
        self.assertEqual(projection(features).shape, (2, 4, 48))

    def test_equal_captions_are_both_right(self):
        scores = torch.tensor([[9.0, 9.0, 0.0], [9.0, 9.0, 0.0], [0.0, 0.0, 9.0]])
        same = torch.tensor([[True, True, False], [True, True, False], [False, False, True]])
        self.assertAlmostEqual(float(contrastive_loss(scores, same)), 2 / 3 * numpy.log(2), places=3)

    def test_contrast_finds_the_caption_of_unseen_land(self):
        self.assertLess(self.contrast_losses[-1], 0.7 * self.contrast_losses[0])
        captions = [f"It is highest in the {side}." for side in SIDES]
        tokens, lengths = vision_data.caption_tensors(self.tokenizer, captions, self.network.text_length)
        right = 0
        for i in range(40):
            path = os.path.join(self.folder.name, "unseen.png")
            Image.fromarray(land(list(SIDES)[i % 4], 100 + i)).save(path)
            height = torch.from_numpy(vision_data.read_height(path, 16))[None, None]
            right += int(self.contrasted(height, tokens, lengths).argmax()) == i % 4
        self.assertGreaterEqual(right, 36)
        again = vision_stages.read_encoder(os.path.join(self.folder.name, "contrast"))
        heights = vision_data.height_tensor(self.pictures)
        self.assertTrue(torch.equal(again.features(heights), self.contrasted.heights.features(heights)))

    def test_align_changes_the_projection_alone(self):
        language_model = self.copy_of(self.seeing)
        _, losses = self.align(os.path.join(self.folder.name, "align"), language_model)
        self.assertLess(losses[-1], 0.7 * losses[0])
        for name, value in language_model.state_dict().items():
            self.assertTrue(torch.equal(value, self.seeing.state_dict()[name]), name)

    def test_together_says_what_is_seen(self):
        self.assertLess(self.together_losses[-1], 0.7 * self.together_losses[0])
        # With another land before the same words, the answer is less likely.
        other = [vision_data.Picture(self.pictures[(i + 1) % 4].height, picture.messages)
                 for i, picture in enumerate(self.pictures)]
        own, others = (float(vision_stages.answer_loss(self.encoder(), self.projection, self.seeing, self.tokenizer,
                                                       some)) for some in (self.pictures, other))
        self.assertGreater(others, own + 0.1)

    def test_the_encoder_stays_after_its_own_stage(self):
        encoder = self.encoder()
        options = vision_stages.together_options(epochs=1, batch_size=8)
        vision_stages.together(encoder, self.new_projection(), self.copy_of(self.blind), self.tokenizer,
                               self.pictures, os.path.join(self.folder.name, "frozen"), options, say=self.quiet)
        for name, value in self.contrasted.heights.state_dict().items():
            self.assertTrue(torch.equal(value, encoder.state_dict()[name]), name)

    def test_every_stage_goes_on_as_if_never_interrupted(self):
        def contrast(out, **more):
            return self.contrast(out, **more)[1]

        def align(out, **more):
            return self.align(out, self.copy_of(self.blind), **more)[1]

        def together(out, **more):
            return self.together(out, self.new_projection(), self.copy_of(self.blind), **more)

        for stage in (contrast, align, together):
            with self.subTest(stage.__name__):
                whole, parts = (os.path.join(self.folder.name, stage.__name__ + kind) for kind in ("-whole", "-parts"))
                losses = stage(whole, most_steps=6)
                self.assertEqual(losses, stage(parts, most_steps=2) + stage(parts, most_steps=4))
                with open(os.path.join(parts, "loss.csv"), newline="", encoding="utf-8") as file:
                    self.assertEqual([row["step"] for row in csv.DictReader(file)], ["2", "5", "6"])


if __name__ == "__main__":
    unittest.main()
