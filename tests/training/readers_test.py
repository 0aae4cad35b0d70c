"""Examples of readers, adapters, and the joining of a base model with one."""

import glob
import json
import os
import pathlib
import tempfile
import unittest

import numpy
import torch

from latticeworld_training import adapters, gguf, join_reader, llama, reader_examples, say_plans, small_language

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])


class ExamplesTest(unittest.TestCase):
    def examples(self):
        return reader_examples.read_examples(sorted(glob.glob(str(ROOT / "training/examples/**/*.jsonl"), recursive=True)))

    def test_every_sentence_has_a_form(self):
        examples = self.examples()
        self.assertGreater(sum(e["kind"] == "layout" for e in examples), 8000)
        self.assertGreater(sum(e["kind"] == "environment" for e in examples), 4000)
        for example in examples:
            self.assertEqual(reader_examples.faults_of(example), [], example["text"])

    def test_no_text_of_the_test_part_or_of_the_authors_left_out_is_among_them(self):
        kept = set()
        for kind in ("layout", "environment"):
            for part in ("test", "development", "first_sight"):
                path = ROOT / f"benchmarks/fidelity/{kind}_{part}.json"
                kept |= {item["instruction"] for item in json.loads(path.read_text(encoding="utf-8"))
                         if part != "development" or item["id"].startswith("f13")}
        self.assertEqual([e["text"] for e in self.examples() if e["text"] in kept], [])

    def test_no_text_of_an_author_left_out_is_trained_on(self):
        left_out = reader_examples.read_examples(sorted(glob.glob(str(ROOT / "training/examples/left_out/*.jsonl"))))
        trained = reader_examples.read_examples(sorted(glob.glob(str(ROOT / "training/examples/*.jsonl"))))
        self.assertEqual({e["author"] for e in left_out} & {e["author"] for e in trained}, set())
        texts = {(e["kind"], e["text"]) for e in left_out}
        self.assertEqual([e["text"] for e in trained if (e["kind"], e["text"]) in texts], [])

    def test_lines_of_authors_are_read_and_wrong_ones_named(self):
        lines = ["V: a child", "T: a lake\\nplease", "S: A lake.", "W: nothing much", "S: -"]
        first, second = reader_examples.parse_lines(lines, "layout", "x")
        self.assertEqual((first["text"], first["sentences"], first["vocabulary"]), ("a lake\nplease", ["A lake"], "suburb"))
        self.assertEqual(reader_examples.answer_of(second), "-")
        with self.assertRaisesRegex(ValueError, "line 1"):
            reader_examples.parse_lines(["a lake"], "layout", "x")
        self.assertTrue(reader_examples.faults_of({"kind": "layout", "text": "x", "sentences": ["A zorblax"]}))

    def test_drawn_plans_are_said_in_words_of_the_language(self):
        import random
        draws = random.Random(4)
        for _ in range(200):
            line = say_plans.draw_plans.draw_layout(draws)
            sentences = small_language.split(line[3:])
            said = say_plans.Speaker(draws).manner([say_plans.Speaker(draws).say(s) for s in sentences])
            self.assertTrue(said.strip())
            for sentence in sentences:
                self.assertIsNotNone(small_language.form_of(sentence, "layout"), sentence)


class AdapterTest(unittest.TestCase):
    def model(self):
        torch.manual_seed(1)
        return llama.Llama(llama.LlamaSizes(tokens=50, width=64, layers=2, heads=4, kv_heads=2, hidden=96))

    def test_a_new_adapter_changes_nothing_and_a_joined_one_is_the_same_model(self):
        model = self.model()
        tokens = torch.arange(10)[None]
        before = model(tokens)
        adapters.adapt(model, rank=32)
        self.assertTrue(torch.allclose(model(tokens), before))
        for name, weights in model.named_parameters():
            if name.endswith(".b"):
                torch.nn.init.normal_(weights, std=0.1)
        after = model(tokens).detach()
        self.assertFalse(torch.allclose(after, before, atol=1e-3))
        joined = self.model()
        joined.load_state_dict({**joined.state_dict(), **adapters.joined(model)})
        self.assertTrue(torch.allclose(joined(tokens), after, atol=1e-5))

    def test_only_adapters_learn(self):
        model = self.model()
        adapters.adapt(model, rank=32)
        learning = [name for name, weights in model.named_parameters() if weights.requires_grad]
        self.assertEqual(len(learning), 2 * 2 * len(adapters.ADAPTED))
        self.assertTrue(all(name.endswith((".a", ".b")) for name in learning))


class JoinTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        random = numpy.random.default_rng(2)
        self.matrix = random.normal(size=(64, 32)).astype(numpy.float32)
        self.a = random.normal(size=(32, 32)).astype(numpy.float32)
        self.b = 0.1 * random.normal(size=(64, 32)).astype(numpy.float32)
        base = gguf.GgufWriter()
        base.add("general.architecture", gguf.STRING, "llama")
        base.add("llama.rope.freq_base", gguf.FLOAT32, 10000.0)
        base.add_array("tokenizer.ggml.tokens", gguf.STRING, ["a", "b"])
        base.add_tensor("blk.0.attn_q.weight", self.matrix, gguf.F32)
        base.add_tensor("output_norm.weight", numpy.ones(32, numpy.float32), gguf.F32)
        base.write(self.path("base.gguf"))

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write_adapter(self, digest):
        adapter = gguf.GgufWriter()
        adapter.add("general.name", gguf.STRING, "a reader")
        adapter.add(join_reader.KEY, gguf.STRING, digest)
        adapter.add_tensor("blk.0.attn_q.weight.a", self.a, gguf.Q8_0)
        adapter.add_tensor("blk.0.attn_q.weight.b", self.b, gguf.Q8_0)
        adapter.write(self.path("adapter.gguf"))

    def test_the_joined_matrix_is_the_sum(self):
        self.write_adapter(join_reader.sha256_of(self.path("base.gguf")))
        join_reader.join(self.path("base.gguf"), self.path("adapter.gguf"), self.path("out.gguf"))
        metadata, tensors = gguf.read_gguf(self.path("out.gguf"))
        self.assertEqual(metadata["general.name"], "a reader")
        self.assertEqual(metadata["tokenizer.ggml.tokens"], ["a", "b"])
        wanted = self.matrix + self.b @ self.a
        self.assertLess(numpy.abs(tensors["blk.0.attn_q.weight"] - wanted).max(), 0.06)
        self.assertEqual(tensors["output_norm.weight"].tolist(), [1.0] * 32)

    def test_another_base_is_refused(self):
        self.write_adapter("0" * 64)
        with self.assertRaisesRegex(ValueError, "belongs to the base"):
            join_reader.join(self.path("base.gguf"), self.path("adapter.gguf"), self.path("out.gguf"))
        self.assertFalse(os.path.exists(self.path("out.gguf")))

    def test_half_bytes_are_read(self):
        block = numpy.float16(0.5).tobytes() + numpy.float16(-2).tobytes() + bytes(i | (15 - i) << 4 for i in range(16))
        values = gguf._values(block, gguf.Q4_1, 32)
        self.assertEqual(values[:16].tolist(), [0.5 * i - 2 for i in range(16)])
        self.assertEqual(values[16:].tolist(), [0.5 * (15 - i) - 2 for i in range(16)])


if __name__ == "__main__":
    unittest.main()
