"""transformers reads the model files that are shipped: its tokens, its rendering of the chat template
and its likeliest continuations beside LatticeWorld's own."""
# shared: torch==2.15.0
# pypi: transformers==5.24.0 tokenizers==0.23.3 gguf==0.19.0 sentencepiece==0.2.3 accelerate==1.15.0

import json
import logging
import subprocess
import sys

import gguf
import torch
import transformers

from conversations import MODELS, REPOSITORY, conversations
from peer import Peer, PROGRAM

sys.path.insert(0, str(REPOSITORY / "training"))
from latticeworld_training.tokenizer import Tokenizer  # noqa: E402

NEXT = 30
KINDS = {"layouts.gguf": "layout", "environments.gguf": "environment"}


def true_tokenizer(path):
    fields = gguf.GGUFReader(path).fields
    return Tokenizer(fields["tokenizer.ggml.tokens"].contents(),
                     fields["tokenizer.ggml.scores"].contents())


def laid_out(true, messages):
    """Tokens of a prompt as training lays it out."""
    newline = true.encode("\n")
    tokens = [1]
    for message in messages:
        if message["role"] == "user":
            tokens += [2] + true.encode("user\n" + message["content"]) + [3] + newline
    return tokens + [2] + true.encode("assistant\n")


def likeliest(path, prompts):
    """The NEXT tokens that LatticeWorld's decoder finds likeliest after each prompt."""
    program = PROGRAM.replace("/latticeworld/latticeworld", "/latticeworld/local_answers")
    lines = "".join(json.dumps({"tokens": tokens, "count": NEXT}) + "\n" for tokens in prompts)
    said = subprocess.run([program, path], input=lines, stdout=subprocess.PIPE, text=True,
                          check=True).stdout
    return [json.loads(line) for line in said.splitlines()]


def check_tokens(peer, name, read, true, talks):
    texts = [message["content"] for messages in talks for message in messages]
    same = sum(read.encode(text, add_special_tokens=False) == true.encode(text) for text in texts)
    lost = sum(read.decode(read.encode(text, add_special_tokens=False)).strip() != text.strip()
               for text in texts)
    peer.check(f"{name}, tokens", lost == 0, f"{same} of {len(texts)} texts the same as in "
               f"training; {len(texts) - lost} come back from theirs")


def check_template(peer, name, read, talks):
    messages = [{"role": "system", "content": "You draw maps."}] + [
        message for message in talks[0] if message["role"] == "user"]
    text = read.apply_chat_template(messages, tokenize=False, add_generation_prompt=True)
    wanted = (f"{read.bos_token}<|im_start|>user\n{messages[-1]['content']}<|im_end|>\n"
              "<|im_start|>assistant\n")
    marks = [read.convert_tokens_to_ids(mark) for mark in ("<s>", "<|im_start|>", "<|im_end|>")]
    whole = read(text, add_special_tokens=False)["input_ids"]
    peer.check(f"{name}, chat template", text == wanted and marks == [1, 2, 3],
               "as in training, without the system message; its marks are " +
               ("single tokens" if whole.count(2) == 2 and whole.count(3) == 1 else
                f"not single tokens: {whole[:6]}"))


def check_model(peer, name, prompts):
    model = transformers.AutoModelForCausalLM.from_pretrained(str(MODELS), gguf_file=name,
                                                              dtype=torch.float32)
    wanted = likeliest(MODELS / name, prompts)
    agreed = 0
    for tokens, own in zip(prompts, wanted):
        with torch.no_grad():
            found = model.generate(torch.tensor([tokens]), max_new_tokens=len(own), do_sample=False,
                                   eos_token_id=3, pad_token_id=0)[0, len(tokens):].tolist()
        agreed += next((i for i, (a, b) in enumerate(zip(found, own)) if a != b), len(own))
    total = sum(map(len, wanted))
    peer.check(f"{name}, likeliest tokens", agreed > 0.9 * total,
               f"given training's tokens, {agreed} of {total} are those of LatticeWorld's decoder; "
               f"{sum(p.numel() for p in model.parameters())} weights")


def main():
    logging.disable(logging.WARNING)
    torch.set_num_threads(1)
    peer = Peer("transformers", transformers.__version__, "`models/*.gguf`",
                "give it tokens of llama.cpp or of `latticeworld_training.tokenizer`")
    for name, kind in KINDS.items():
        talks = conversations(kind)
        read = transformers.AutoTokenizer.from_pretrained(str(MODELS), gguf_file=name)
        true = true_tokenizer(MODELS / name)
        check_tokens(peer, name, read, true, talks)
        check_template(peer, name, read, talks)
        check_model(peer, name, [laid_out(true, messages) for messages in talks[:4]])
    peer.finish()


main()
