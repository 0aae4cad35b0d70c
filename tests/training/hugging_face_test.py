"""Fine-tuning of a Hugging Face checkpoint, a tiny random one, and their LLaMA beside ours."""

import contextlib
import io
import os
import tempfile
import unittest

os.environ["HF_HUB_OFFLINE"] = "1"

import tiny_talks
import torch
from latticeworld_training import finetune_hugging_face, llama
from tokenizers import Tokenizer, decoders, models, pre_tokenizers, trainers
from transformers import AutoModelForCausalLM, LlamaConfig, LlamaForCausalLM, PreTrainedTokenizerFast


def make_checkpoint(directory):
    texts = [content for talk in tiny_talks.conversations(16) for _, content in talk]
    made = Tokenizer(models.BPE())
    made.pre_tokenizer = pre_tokenizers.ByteLevel(add_prefix_space=False)
    made.decoder = decoders.ByteLevel()
    alphabet = pre_tokenizers.ByteLevel.alphabet()
    made.train_from_iterator(
        texts, trainers.BpeTrainer(vocab_size=400, special_tokens=["<unk>", "<s>", "</s>"], initial_alphabet=alphabet)
    )
    tokenizer = PreTrainedTokenizerFast(tokenizer_object=made, bos_token="<s>", eos_token="</s>", unk_token="<unk>")
    torch.manual_seed(2)
    config = LlamaConfig(
        vocab_size=len(tokenizer), hidden_size=32, intermediate_size=64, num_hidden_layers=2, num_attention_heads=4,
        num_key_value_heads=2, max_position_embeddings=512, bos_token_id=1, eos_token_id=2, rms_norm_eps=1e-5,
        tie_word_embeddings=True,
    )
    LlamaForCausalLM(config).save_pretrained(directory)
    tokenizer.save_pretrained(directory)
    return tokenizer


def weights_as_ours(state, sizes):
    """Hugging Face turns the two halves of a head against each other, ours turns neighbours."""

    def neighbours(weights, heads):
        half = sizes.width // sizes.heads // 2
        return weights.view(heads, 2, half, -1).transpose(1, 2).reshape(weights.shape)

    ours = {"embeddings.weight": state["model.embed_tokens.weight"], "output_norm.weight": state["model.norm.weight"]}
    names = {
        "input_layernorm": "attention_norm", "self_attn.v_proj": "value", "self_attn.o_proj": "attention_output",
        "post_attention_layernorm": "feed_forward_norm", "mlp.gate_proj": "gate", "mlp.up_proj": "up",
        "mlp.down_proj": "down",
    }
    for i in range(sizes.layers):
        theirs = f"model.layers.{i}."
        for name, own in names.items():
            ours[f"layers.{i}.{own}.weight"] = state[f"{theirs}{name}.weight"]
        ours[f"layers.{i}.query.weight"] = neighbours(state[f"{theirs}self_attn.q_proj.weight"], sizes.heads)
        ours[f"layers.{i}.key.weight"] = neighbours(state[f"{theirs}self_attn.k_proj.weight"], sizes.kv_heads)
    return ours


class HuggingFaceTest(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.checkpoint = os.path.join(self.directory.name, "checkpoint")
        self.tokenizer = make_checkpoint(self.checkpoint)

    def finetune(self, out, *more):
        data = os.path.join(self.directory.name, "talks.jsonl")
        tiny_talks.write_conversations(data, 16)
        arguments = ["--checkpoint", self.checkpoint, "--data", data, "--out", os.path.join(self.directory.name, out)]
        arguments += ["--batch-size", "8", "--rate", "5e-3", "--checkpoint-steps", "4", *more]
        with contextlib.redirect_stdout(io.StringIO()):
            return finetune_hugging_face.main(arguments)

    def test_our_llama_is_theirs(self):
        theirs = AutoModelForCausalLM.from_pretrained(self.checkpoint).eval()
        sizes = llama.LlamaSizes(
            tokens=len(self.tokenizer), width=32, layers=2, heads=4, kv_heads=2, hidden=64, context=512
        )
        ours = llama.Llama(sizes).eval()
        ours.load_state_dict(weights_as_ours(theirs.state_dict(), sizes))
        tokens = torch.randint(0, len(self.tokenizer), (2, 100))
        with torch.no_grad():
            self.assertLess(float((theirs(tokens).logits - ours(tokens)).abs().max()), 1e-5)

    def test_the_answer_alone_counts(self):
        talk = tiny_talks.conversations(1)[0]
        example = finetune_hugging_face.encode_llama2(self.tokenizer, talk)
        text = self.tokenizer.decode(example.tokens)
        self.assertEqual(
            text, f"<s>[INST] <<SYS>>\n{talk[0][1]}\n<</SYS>>\n\n{talk[1][1]} [/INST]{talk[2][1].rstrip()}</s>"
        )
        counted = [token for token, counts in zip(example.tokens, example.answers) if counts]
        self.assertEqual(self.tokenizer.decode(counted), talk[2][1].rstrip() + "</s>")

    def test_fine_tuning_lowers_the_loss_and_goes_on_where_it_was(self):
        whole = self.finetune("whole", "--epochs", "4")
        self.assertLess(whole[-1], 0.8 * whole[0])
        begun = self.finetune("cut", "--epochs", "4", "--most-steps", "4")
        self.assertEqual(begun + self.finetune("cut", "--epochs", "4"), whole)
        model = AutoModelForCausalLM.from_pretrained(os.path.join(self.directory.name, "cut", "model"))
        first = AutoModelForCausalLM.from_pretrained(self.checkpoint)
        self.assertGreater(float((model.model.norm.weight - first.model.norm.weight).abs().max()), 1e-3)

    def test_a_batch_in_parts_is_the_same_batch(self):
        whole = self.finetune("whole", "--epochs", "2")
        parts = self.finetune("parts", "--epochs", "2", "--at-once", "3")
        for one, other in zip(whole, parts):
            self.assertAlmostEqual(one, other, places=4)


if __name__ == "__main__":
    unittest.main()
