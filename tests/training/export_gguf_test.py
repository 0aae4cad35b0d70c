"""Model files: what PyTorch, this project's decoder and llama.cpp make of them.

LATTICEWORLD_LOCAL_ANSWERS: the program local_answers. LATTICEWORLD_LLAMA_ANSWERS and LATTICEWORLD_LLAMA_DIRECTORY:
llama_answers.mjs and where node-llama-cpp is installed; where they are given, llama.cpp is asked, else this project's
decoder.
"""

import functools
import json
import os
import subprocess
import tempfile
import unittest
from unittest import mock

import numpy
import torch
import tiny_talks
from latticeworld_training import chat_data, export_gguf, gguf, reader_examples
from latticeworld_training.tokenizer import BEGIN, TURN_BEGIN, TURN_END

TEXTS = [
    "A lake lies in the north.",
    "  two  blanks ",
    "GGGGGGGGWWWWFFAB\nGG",
    "M\u00fcnchen \u6c34 </s><0x41>",
    "WSRDGGGG" * 5,
    '{\n  "fine": {\n      "grass": 0.5,\n                    "tree"',
]


def asks_llama():
    return "LATTICEWORLD_LLAMA_DIRECTORY" in os.environ


def ask(model_file, questions):
    """Answers of the program under test to each question about a model file."""
    if asks_llama():
        command = ["./node", os.environ["LATTICEWORLD_LLAMA_ANSWERS"], model_file]
        directory = os.environ["LATTICEWORLD_LLAMA_DIRECTORY"]
    else:
        command, directory = [os.environ["LATTICEWORLD_LOCAL_ANSWERS"], model_file], None
    lines = "".join(json.dumps(question) + "\n" for question in questions)
    done = subprocess.run(command, input=lines, stdout=subprocess.PIPE, text=True, cwd=directory, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


@functools.lru_cache(maxsize=None)
def exported_run():
    """A folder (TemporaryDirectory) with a run and its model files by type, the model, tokenizer and talks."""
    directory = tempfile.TemporaryDirectory()
    model, tokenizer, talks, _ = tiny_talks.learned_by_heart(os.path.join(directory.name, "run"), 4, 100)
    files = {kind: os.path.join(directory.name, kind + ".gguf") for kind in gguf.TENSOR_TYPES}
    for kind, path in files.items():
        export_gguf.export(model, tokenizer, path, kind, "tiny")
    return directory, files, model, tokenizer, talks


class ExportedModel(unittest.TestCase):
    def setUp(self):
        self.directory, self.files, self.model, self.tokenizer, self.talks = exported_run()


class AgreementTest(ExportedModel):
    def test_texts_become_the_same_tokens(self):
        answers = ask(self.files["f16"], [{"text": text} for text in TEXTS])
        self.assertEqual(answers, [self.tokenizer.encode(text) for text in TEXTS])

    def test_answers_are_those_that_were_learned(self):
        for kind in ("f16", "q8_0"):
            questions, wanted = [], []
            for talk in self.talks:
                answer = self.tokenizer.encode(talk[2][1].rstrip()) + [TURN_END]
                prompt = chat_data.prompt_tokens(self.tokenizer, talk[:2])
                questions.append({"tokens": prompt, "count": len(answer)})
                wanted.append(answer)
            self.assertEqual(ask(self.files[kind], questions), wanted, kind)


class LocalDecoderTest(ExportedModel):
    def test_logits_are_those_of_pytorch(self):
        tokens = [BEGIN] + self.tokenizer.encode(" ".join(TEXTS))
        with torch.no_grad():
            ours = self.model(torch.tensor([tokens]))[0, -1].numpy()
        for kind, most in (("f32", 2e-4), ("f16", 5e-2), ("q8_0", 0.6)):
            answer = numpy.array(ask(self.files[kind], [{"tokens": tokens}])[0])
            self.assertLess(abs(answer - ours).max(), most, kind)

    def test_conversations_are_laid_out_as_in_training(self):
        talk = self.talks[0]
        messages = [{"role": role, "content": content} for role, content in talk[:2]]
        answer = ask(self.files["q8_0"], [{"messages": messages}])[0]
        self.assertEqual(answer, chat_data.prompt_tokens(self.tokenizer, talk[:2]))

    def test_a_reader_is_asked_as_it_was_taught(self):
        # How the template of a base looks that adds a system message where a conversation begins without one.
        of_base = ("{% for message in messages %}{% if loop.first and messages[0]['role'] != 'system' %}"
                   "{{ '<|im_start|>system\nBe kind.<|im_end|>\n' }}{% endif %}{{ '<|im_start|>' + message['role'] + '\n' + "
                   "message['content'] + '<|im_end|>\n' }}{% endfor %}{{ '<|im_start|>assistant\n' }}")
        path = os.path.join(self.directory.name, "reader.gguf")
        with mock.patch.object(export_gguf, "CHAT_TEMPLATE", of_base):
            export_gguf.export(self.model, self.tokenizer, path)
        for kind in ("layout", "environment"):
            messages = [{"role": "system", "content": kind}, {"role": "user", "content": "A lake lies in the north."}]
            asked = ask(path, [{"messages": messages}])[0]
            taught = reader_examples.PROMPT.format(kind=kind, text="A lake lies in the north.")
            self.assertEqual(asked[0], BEGIN)
            self.assertEqual("".join(self.tokenizer.pieces[token] if token in (TURN_BEGIN, TURN_END)
                                     else self.tokenizer.decode([token]) for token in asked[1:]), taught)

    def test_a_run_is_exported_by_one_command(self):
        run, out = os.path.join(self.directory.name, "run"), os.path.join(self.directory.name, "run.gguf")
        self.tokenizer.save(os.path.join(run, "tokenizer.json"))
        with open(os.path.join(run, "model.json"), "w", encoding="utf-8") as file:
            json.dump(vars(self.model.sizes), file)
        export_gguf.main([run, "--out", out, "--type", "q8_0", "--name", "tiny"])
        with open(out, "rb") as exported, open(self.files["q8_0"], "rb") as before:
            self.assertEqual(exported.read(), before.read())


class QuantizedTest(unittest.TestCase):
    def test_values_come_back_to_half_a_step(self):
        values = numpy.random.default_rng(1).normal(size=(5, 64)).astype(numpy.float32)
        values[0, :32] = 0.0
        packed = numpy.frombuffer(gguf.quantized(values), dtype=[("scale", "<f2"), ("values", "i1", 32)])
        back = (packed["scale"].astype(numpy.float32)[:, None] * packed["values"]).reshape(values.shape)
        most = abs(values).reshape(-1, 32).max(1)
        self.assertTrue((abs(back - values).reshape(-1, 32).max(1) <= most / 127 * 0.57).all())

    def test_rows_that_do_not_divide_are_refused(self):
        with self.assertRaisesRegex(ValueError, "33 values"):
            gguf.quantized(numpy.zeros((2, 33), numpy.float32))


def load_tests(loader, _, __):
    cases = [AgreementTest] if asks_llama() else [AgreementTest, LocalDecoderTest, QuantizedTest]
    return unittest.TestSuite(loader.loadTestsFromTestCase(case) for case in cases)


if __name__ == "__main__":
    unittest.main()
