"""Fine-tunes a checkpoint of Hugging Face's format, such as LLaMA-2-7B, on conversations (`latticeworld dataset`).

    python3 -m latticeworld_training.finetune_hugging_face --checkpoint meta-llama/Llama-2-7b-hf \\
        --data set/layout/train.jsonl --out run --device cuda --precision bf16

The defaults are the method's: AdamW, rate 5e-5, betas 0.9 and 0.999, weight decay 0.001, 4 epochs, batches of 32 (for
environments 5 epochs, batches of 64). --at-once says how many conversations of a batch fit into memory. The folder
`run` gets checkpoint.pt, loss.csv and loss.png, the same command again goes on where it was interrupted, and at its end
`run/model` is a checkpoint of the same format, which llama.cpp's convert_hf_to_gguf.py turns into a GGUF file.
"""

import argparse
import os

import torch

from .chat_data import Example, plain_answer, read_conversations
from .fitting import FitOptions, fit
from .train_language_model import add_fields, filled


def encode_llama2(tokenizer, messages):
    """An Example of (role, content) pairs in the manner of LLaMA 2: [INST] <<SYS>> system <</SYS>> user [/INST]."""
    tokens, answers, system = [], [], ""
    for role, content in messages:
        if role == "system":
            system += f"<<SYS>>\n{content}\n<</SYS>>\n\n"
        elif role == "user":
            asked = tokenizer.encode(f"[INST] {system}{content} [/INST]", add_special_tokens=False)
            tokens += [tokenizer.bos_token_id] + asked
            answers += [False] * (1 + len(asked))
            system = ""
        else:
            said = tokenizer.encode(plain_answer(content), add_special_tokens=False) + [tokenizer.eos_token_id]
            tokens += said
            answers += [True] * len(said)
    return Example(tokens, answers)


class FeaturesOf(torch.nn.Module):
    """A causal language model of transformers with the interface of latticeworld_training.llama.Llama."""

    def __init__(self, model):
        super().__init__()
        self.model = model

    @property
    def embeddings(self):
        return self.model.get_input_embeddings()

    def features(self, embedded):
        return self.model.model(inputs_embeds=embedded, use_cache=False).last_hidden_state

    def logits(self, features):
        return self.model.get_output_embeddings()(features).float()


def main(arguments=None):
    from transformers import AutoModelForCausalLM, AutoTokenizer

    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--checkpoint", required=True, help="folder, or name at the Hub")
    parser.add_argument("--data", nargs="+", required=True, help="JSON Lines")
    parser.add_argument("--validation", nargs="*", default=[], help="JSON Lines that are not trained on")
    parser.add_argument("--out", required=True, help="folder of the run")
    parser.add_argument("--context", type=int, default=4096, help="tokens; longer conversations are left out [4096]")
    parser.add_argument("--device", default="cpu", help="cpu or cuda [cpu]")
    parser.add_argument("--precision", choices=["f32", "bf16"], default="f32", help="of weights and sums [f32]")
    options = FitOptions()
    add_fields(parser, options)
    given = parser.parse_args(arguments)

    torch.manual_seed(given.seed)
    tokenizer = AutoTokenizer.from_pretrained(given.checkpoint)
    model = AutoModelForCausalLM.from_pretrained(
        given.checkpoint, torch_dtype=torch.bfloat16 if given.precision == "bf16" else torch.float32
    )
    if given.device != "cpu":
        model.gradient_checkpointing_enable()

    def examples_of(paths):
        examples = [encode_llama2(tokenizer, messages) for messages in read_conversations(paths)]
        return [example for example in examples if len(example.tokens) <= given.context]

    os.makedirs(given.out, exist_ok=True)
    losses = fit(
        FeaturesOf(model), examples_of(given.data), examples_of(given.validation), given.out,
        filled(options, given), given.device,
    )
    model.save_pretrained(os.path.join(given.out, "model"))
    tokenizer.save_pretrained(os.path.join(given.out, "model"))
    return losses


if __name__ == "__main__":
    main()
