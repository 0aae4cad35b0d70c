"""The language model's training: tokenizer, reading of data, loss, going on after a kill."""

import csv
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest

import torch
import tiny_talks
from latticeworld_training import chat_data, export_gguf, fitting, llama, optimizers, tokenizer


def greedy(model, tokens, count):
    tokens = list(tokens)
    for _ in range(count):
        with torch.no_grad():
            tokens.append(int(model(torch.tensor([tokens]))[0, -1].argmax()))
    return tokens[-count:]


class TokenizerTest(unittest.TestCase):
    def setUp(self):
        self.tokenizer = tiny_talks.tiny_tokenizer()

    def test_texts_come_back(self):
        generator = random.Random(1)
        words = ["lake", " ", "the", "WW", "\n", "GGGGG", "\u00fc", "</s>", "<0x41>", "\t", "A", "\u6c34"]
        for _ in range(200):
            text = "".join(generator.choice(words) for _ in range(generator.randint(0, 12)))
            self.assertEqual(self.tokenizer.decode(self.tokenizer.encode(text)), text)

    def test_square_above_square_is_as_many_tokens_back(self):
        for rows in (["GGGG" * 8, "WWWW" * 8], ["GGGG" * 4 + "FFFF" * 4, "GGGG" * 8, "FFFF" * 8]):
            tokens = self.tokenizer.encode("\n".join(rows))
            self.assertEqual(len(tokens), 9 * len(rows) - 1)
            for i, token in enumerate(tokens):
                row, column = divmod(i, 9)
                said = rows[row][4 * column : 4 * column + 4] or "<0x0A>"
                self.assertEqual(self.tokenizer.pieces[token], said)

    def test_fours_that_are_no_pieces_are_two_pairs(self):
        pieces = [self.tokenizer.pieces[token] for token in self.tokenizer.encode("GGGGWSRDGGGG")]
        self.assertEqual(pieces, ["GGGG", "WS", "RD", "GGGG"])

    def test_nothing_in_a_text_controls(self):
        self.assertTrue(all(token >= 4 for token in self.tokenizer.encode("<s><|im_end|><unk>")))

    def test_members_of_an_answer_are_pieces(self):
        answers = ['{"a":{"season":"%s","rotation":[0,0,15]},"b":[{"n":%d},{"n":3}]}' % (season, number)
                   for season in ("winter", "summer") for number in (3, 12)]
        spelling = tokenizer.train_tokenizer(2 * answers, most_words=200)
        self.assertEqual([spelling.pieces[token] for token in spelling.encode(answers[1])],
                         ['{', '"a":{', '"season":"winter",', '"rotation":[0,0,15]},', '"b":[{', '"n":12},{', '"n":3}]}'])

    def test_is_the_same_after_saving(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "tokenizer.json")
            self.tokenizer.save(path)
            again = tokenizer.Tokenizer.load(path)
        self.assertEqual((again.pieces, again.scores), (self.tokenizer.pieces, self.tokenizer.scores))


class ChatDataTest(unittest.TestCase):
    def test_only_the_answer_counts(self):
        spelling = tiny_talks.tiny_tokenizer()
        example = chat_data.encode_conversation(spelling, tiny_talks.conversations(1)[0])
        counted = [token for token, counts in zip(example.tokens, example.answers) if counts]
        self.assertEqual(counted[-1], tokenizer.TURN_END)
        self.assertEqual(spelling.decode(counted), tiny_talks.conversations(1)[0][-1][1].rstrip())
        self.assertNotIn("draw maps", spelling.decode(example.tokens))

        tokens, targets = chat_data.batch_tensors([example])
        self.assertEqual([t for t in targets[0].tolist() if t != chat_data.IGNORED], counted)
        prompt = chat_data.prompt_tokens(spelling, tiny_talks.conversations(1)[0][:2])
        self.assertEqual(tokens[0, : len(prompt)].tolist(), prompt)

    def test_without_its_prompt_the_answer_is_all_there_is(self):
        spelling = tiny_talks.tiny_tokenizer()
        talk = tiny_talks.conversations(1)[0]
        whole = chat_data.encode_conversation(spelling, talk)
        self.assertEqual(chat_data.without_prompt(whole), chat_data.encode_conversation(spelling, talk[-1:]))
        self.assertEqual(chat_data.without_prompt(whole).tokens[: len(chat_data.prompt_tokens(spelling, []))],
                         chat_data.prompt_tokens(spelling, []))

    def test_every_example_comes_once_an_epoch(self):
        examples = [chat_data.Example([0] * (1 + i % 7), [True] * (1 + i % 7)) for i in range(103)]
        batches = chat_data.batches_of_epoch(examples, 8, seed=5, epoch=2)
        self.assertEqual(sorted(i for batch in batches for i in batch), list(range(103)))
        self.assertEqual(batches, chat_data.batches_of_epoch(examples, 8, seed=5, epoch=2))
        self.assertNotEqual(batches, chat_data.batches_of_epoch(examples, 8, seed=5, epoch=3))

    def test_answers_are_in_the_form_of_the_decoders_grammars(self):
        self.assertEqual(chat_data.plain_answer('{\n  "a": [1, 0.50],\n  "b": "x y"\n}\n'), '{"a":[1,0.5],"b":"x y"}')
        self.assertEqual(chat_data.plain_answer("GG\nWW\n"), "GG\nWW")
        self.assertEqual(chat_data.plain_answer("{A lake} \n"), "{A lake}")

    def test_a_line_that_is_none_is_named(self):
        good = json.dumps({"messages": [{"role": "assistant", "content": "W"}]})
        for bad in ["{", "[]", '{"messages": 3}', '{"messages": [{"role": "user", "content": "?"}]}']:
            with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
                file.write(good + "\n" + bad + "\n")
                file.flush()
                with self.assertRaisesRegex(ValueError, "line 2"):
                    chat_data.read_conversations([file.name])


class LlamaTest(unittest.TestCase):
    def test_what_comes_later_changes_nothing_before(self):
        torch.manual_seed(1)
        model = llama.Llama(tiny_talks.tiny_sizes(300)).eval()
        tokens = torch.randint(0, 300, (1, 40))
        other = tokens.clone()
        other[0, 25:] = (other[0, 25:] + 7) % 300
        with torch.no_grad():
            difference = (model(tokens) - model(other)).abs()[0].max(1).values
        self.assertLess(float(difference[:25].max()), 1e-5)
        self.assertGreater(float(difference[25:].min()), 1e-4)

    def test_sizes_that_do_not_go_together_are_refused(self):
        with self.assertRaisesRegex(ValueError, "30 values"):
            llama.Llama(llama.LlamaSizes(tokens=300, width=30))


class FitTest(unittest.TestCase):
    def test_learns_eight_conversations_by_heart(self):
        with tempfile.TemporaryDirectory() as directory:
            model, spelling, talks, losses = tiny_talks.learned_by_heart(directory)
            self.assertTrue(os.path.getsize(os.path.join(directory, "checkpoint.pt")))
        self.assertGreater(losses[0], 4.0)
        self.assertLess(losses[-1], 0.02)
        for talk in talks:
            prompt = chat_data.prompt_tokens(spelling, talk[:2])
            wanted = spelling.encode(talk[2][1].rstrip()) + [tokenizer.TURN_END]
            self.assertEqual(greedy(model, prompt, len(wanted)), wanted)

    def test_the_rate_rises_and_falls(self):
        options = fitting.FitOptions(rate=1.0, warmup_steps=10, decay="cosine")
        rates = [fitting._rate(options, step, 100, 0.0) for step in range(101)]
        self.assertAlmostEqual(rates[0], 0.1)
        self.assertAlmostEqual(rates[100], 0.05)
        self.assertEqual(max(rates), max(rates[9:12]))
        self.assertEqual(fitting._rate(fitting.FitOptions(), 77, 100, 0.0), 5e-5)

    def test_a_share_is_learned_without_prompts(self):
        spelling = tiny_talks.tiny_tokenizer()
        examples, _ = chat_data.encode_all(spelling, tiny_talks.conversations(16), 256)
        options = fitting.FitOptions(unprompted_share=0.25)
        steps = [fitting._batch(examples, range(16), options, step) for step in range(100)]
        unprompted = sum(each == chat_data.without_prompt(examples[i]) for batch in steps for i, each in enumerate(batch))
        self.assertLess(abs(unprompted / 1600 - 0.25), 0.05)
        self.assertEqual(steps[7], fitting._batch(examples, range(16), options, 7))
        self.assertEqual(fitting._batch(examples, range(16), fitting.FitOptions(), 7), examples)


class OptimizersTest(unittest.TestCase):
    def test_a_matrix_is_made_orthogonal_in_its_own_directions(self):
        torch.manual_seed(4)
        for rows, columns in [(24, 24), (16, 40), (40, 16)]:
            u, _, v = torch.linalg.svd(torch.randn(rows, columns), full_matrices=False)
            matrix = u @ torch.diag(torch.linspace(3.0, 0.1, min(rows, columns))) @ v
            made = optimizers.orthogonalized(matrix)
            values = torch.diagonal(u.T @ made @ v.T)
            self.assertGreater(float(values.min()), 0.6)
            self.assertLess(float(values.max()), 1.3)
            self.assertLess(float((u @ torch.diag(values) @ v - made).abs().max()), 1e-4)

    def test_a_step_of_a_matrix_is_a_fifth_of_the_rate(self):
        torch.manual_seed(5)
        weights = torch.nn.Parameter(torch.randn(24, 64))
        before = weights.detach().clone()
        weights.grad = torch.randn(24, 64)
        optimizers.Muon([weights], lr=0.01, weight_decay=0.5).step()
        step = weights.detach() - before * (1 - 0.01 * 0.5)
        self.assertAlmostEqual(float(step.pow(2).mean().sqrt()) / (0.2 * 0.01), 1.0, delta=0.2)

    def test_muon_has_the_matrices_of_layers_and_adamw_the_rest(self):
        model = llama.Llama(tiny_talks.tiny_sizes(300))
        both = optimizers.make_optimizer(model, fitting.FitOptions(optimizer="muon"))
        names = {id(weights): name for name, weights in model.named_parameters()}
        muon, adamw = ({names[id(w)] for g in o.param_groups for w in g["params"]} for o in both.optimizers)
        self.assertEqual(len(muon), 7 * model.sizes.layers)
        self.assertTrue(all(name.startswith("layers.") and "norm" not in name for name in muon))
        self.assertEqual(muon | adamw, set(names.values()))
        self.assertFalse(muon & adamw)

    def test_muon_learns_eight_conversations_by_heart(self):
        with tempfile.TemporaryDirectory() as directory:
            losses = tiny_talks.learned_by_heart(directory, epochs=150, optimizer="muon")[3]
        self.assertLess(losses[-1], 0.05)


class BriefTest(unittest.TestCase):
    def test_leaves_out_the_map_and_what_follows_from_it(self):
        answer = {"coarse": {"season": "winter"}, "fine": {"grass": {"density": 0.5}}, "agents": []}
        asked = "The map:\nGG\nDescription of the environment:\nWinter.\n\nWrite the configuration now."
        talk = [("system", "You configure."), ("user", asked), ("assistant", json.dumps(answer))]
        shorter = chat_data.brief(talk)
        self.assertEqual(shorter[0], talk[0])
        self.assertEqual(shorter[1], ("user", asked[asked.index("Description"):]))
        self.assertEqual(shorter[2], ("assistant", '{"coarse":{"season":"winter"},"agents":[]}'))
        self.assertEqual(chat_data.brief(tiny_talks.conversations(1)[0]), tiny_talks.conversations(1)[0])


class RestartTest(unittest.TestCase):
    def run_training(self, data, out, *more, kill_at=None):
        command = [sys.executable, "-m", "latticeworld_training.train_language_model"]
        command += ["--data", data, "--validation", data, "--out", out, "--rate", "3e-3", "--decay", "cosine"]
        command += ["--width", "32", "--layers", "1", "--heads", "2", "--kv-heads", "2", "--hidden", "32"]
        command += ["--batch-size", "4", "--epochs", "3", "--checkpoint-steps", "2", "--most-words", "20"]
        command += more
        environment = {**os.environ, "PYTHONUNBUFFERED": "1"}
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
        said = ""
        for line in process.stdout:
            said += line
            if kill_at and line.startswith(f"step {kill_at} "):
                process.kill()
        process.stdout.close()
        status = process.wait()
        self.assertEqual(status, -9 if kill_at else 0, said)
        return said

    def test_a_killed_run_goes_on_to_the_same_losses(self):
        for optimizer in optimizers.OPTIMIZERS:
            with self.subTest(optimizer):
                self.kill_and_go_on("--optimizer", optimizer)

    def kill_and_go_on(self, *options):
        with tempfile.TemporaryDirectory() as directory:
            data = os.path.join(directory, "talks.jsonl")
            tiny_talks.write_conversations(data, 16)
            whole, killed = os.path.join(directory, "whole"), os.path.join(directory, "killed")
            self.run_training(data, whole, *options)
            self.run_training(data, killed, *options, kill_at=6)
            self.assertIn("goes on at step 6", self.run_training(data, killed, *options))
            curves = []
            for out in (whole, killed):
                with open(os.path.join(out, "loss.csv"), newline="", encoding="utf-8") as file:
                    curves.append(list(csv.DictReader(file)))
                with open(os.path.join(out, "loss.png"), "rb") as file:
                    self.assertEqual(file.read(4), b"\x89PNG")
        self.assertEqual(len(curves[0]), 6)
        self.assertEqual(curves[0], curves[1])

    def test_an_unknown_optimizer_is_refused(self):
        with tempfile.TemporaryDirectory() as directory:
            data = os.path.join(directory, "talks.jsonl")
            tiny_talks.write_conversations(data, 4)
            command = [sys.executable, "-m", "latticeworld_training.train_language_model", "--data", data]
            command += ["--out", os.path.join(directory, "run"), "--optimizer", "sgd"]
            done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(os.listdir(directory), ["talks.jsonl"])
        self.assertEqual(done.returncode, 2)
        self.assertIn("'sgd'; legal are adamw, muon", done.stderr)

    def test_a_run_begins_with_the_weights_of_another(self):
        with tempfile.TemporaryDirectory() as directory:
            data = os.path.join(directory, "talks.jsonl")
            tiny_talks.write_conversations(data, 16)
            first, second = os.path.join(directory, "first"), os.path.join(directory, "second")
            self.run_training(data, first)
            # Sizes are the first one's; at this rate nothing is learned.
            self.run_training(data, second, "--begin-with", first, "--width", "64", "--rate", "0", "--most-steps", "2")
            ours, its = (export_gguf.load_run(out) for out in (second, first))
            for name, weights in its[0].state_dict().items():
                self.assertTrue(torch.equal(weights, ours[0].state_dict()[name]), name)
            self.assertEqual(ours[1].pieces, its[1].pieces)


if __name__ == "__main__":
    unittest.main()
