"""Models that are larger than the file they begin with, and say the same."""

import contextlib
import io
import os
import tempfile
import unittest

import torch
import tiny_talks
from latticeworld_training import export_gguf, gguf, grow_gguf, llama


def tiny_file(directory, kind="f32"):
    """A file of a random tiny model, with the model and its tokenizer."""
    torch.manual_seed(4)
    spelling = tiny_talks.tiny_tokenizer()
    model = llama.Llama(tiny_talks.tiny_sizes(len(spelling)))
    for name, weights in model.named_parameters():
        if "norm" in name:
            torch.nn.init.uniform_(weights, 0.5, 1.5)
    path = os.path.join(directory, "tiny.gguf")
    export_gguf.export(model, spelling, path, kind, "tiny")
    return path, model.eval(), spelling


class ReadGgufTest(unittest.TestCase):
    def test_what_was_written_comes_back(self):
        exact = {"f32": 0.0, "f16": 1e-3, "q8_0": 1e-2}
        with tempfile.TemporaryDirectory() as directory:
            for kind, most in exact.items():
                path, model, spelling = tiny_file(directory, kind)
                metadata, tensors = gguf.read_gguf(path)
                self.assertEqual(metadata["general.name"], "tiny")
                self.assertEqual(metadata["tokenizer.ggml.tokens"], spelling.pieces)
                self.assertEqual(metadata["tokenizer.ggml.add_bos_token"], True)
                self.assertEqual(grow_gguf.sizes_of(metadata).hidden, model.sizes.hidden)
                self.assertEqual(len(tensors), len(model.state_dict()))
                for name, weights in model.state_dict().items():
                    difference = torch.from_numpy(tensors[export_gguf.tensor_name(name)].copy()) - weights
                    self.assertLessEqual(float(difference.abs().max()), most * float(weights.abs().max()), name)

    def test_other_files_are_refused(self):
        with tempfile.TemporaryDirectory() as directory:
            path, _, _ = tiny_file(directory)
            with open(path, "rb") as file:
                whole = file.read()
            for bad in (b"", b"GGUF", b"what" + whole[4:], whole[:2000], whole[:-400]):
                with open(path, "wb") as file:
                    file.write(bad)
                with self.assertRaisesRegex(ValueError, "tiny.gguf cannot be read"):
                    gguf.read_gguf(path)


class GrowTest(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path, self.model, self.spelling = tiny_file(self.directory.name)

    def grow(self, *arguments):
        out = os.path.join(self.directory.name, "grown")
        grow_gguf.main([self.path, "--out", out, *arguments])
        return export_gguf.load_run(out)

    def test_the_larger_model_says_the_same(self):
        tokens = torch.randint(0, len(self.spelling), (3, 50))
        with torch.no_grad():
            wanted = self.model(tokens)
            for arguments in ([], ["--layers", "5"], ["--width", "64"], ["--hidden", "96"],
                              ["--width", "96", "--hidden", "160", "--layers", "3"]):
                model, spelling = self.grow(*arguments)
                self.assertEqual(spelling.pieces, self.spelling.pieces)
                self.assertLess(float((model(tokens) - wanted).abs().max()), 1e-4 * float(wanted.abs().max()), arguments)

    def test_what_is_new_learns(self):
        model, _ = self.grow("--width", "64", "--hidden", "96", "--layers", "3")
        before = {name: weights.detach().clone() for name, weights in model.named_parameters()}
        optimizer = torch.optim.AdamW(model.parameters(), lr=1e-2, weight_decay=0.0)
        for _ in range(3):
            tokens = torch.randint(0, len(self.spelling), (4, 30))
            optimizer.zero_grad()
            torch.nn.functional.cross_entropy(model(tokens)[:, :-1].flatten(0, 1), tokens[:, 1:].flatten()).backward()
            optimizer.step()
        small = self.model.state_dict()
        for name, weights in model.named_parameters():
            new = (weights - before[name]).abs() > 0
            if name in small:
                new[tuple(slice(0, size) for size in small[name].shape)] = True
            self.assertGreater(float(new.float().mean()), 0.99, name)

    def test_sizes_that_cannot_be_are_refused(self):
        for arguments, reason in ((["--width", "16"], "less than the file's 32"), (["--layers", "1"], "less than"),
                                  (["--width", "40"], "no multiple of the 16")):
            error = io.StringIO()
            with self.assertRaises(SystemExit), contextlib.redirect_stderr(error):
                self.grow(*arguments)
            self.assertIn(reason, error.getvalue())


if __name__ == "__main__":
    unittest.main()
