"""TRL's SFTTrainer prepares our conversations and takes two steps on a tiny model of random
weights."""
# shared: torch==2.15.0
# pypi: trl==1.16.0 transformers==5.24.0 datasets==5.2.0 gguf==0.19.0 sentencepiece==0.2.3
# pypi: pillow==13.0.0

import logging
import math
import subprocess

import datasets
import torch
import transformers
import trl

from conversations import MODELS, data_set
from peer import FOLDER, PROGRAM, Peer

# ChatML with the answers marked, for `assistant_only_loss`.
MARKED = ("{{ bos_token }}{% for message in messages %}{{ '<|im_start|>' + message['role'] + '\\n' }}"
          "{% if message['role'] == 'assistant' %}{% generation %}{{ message['content'] + '<|im_end|>' }}"
          "{% endgeneration %}{% else %}{{ message['content'] + '<|im_end|>' }}{% endif %}{{ '\\n' }}"
          "{% endfor %}")


def with_pictures():
    """A data set as it is by default: whole prompts, pictures of the heights."""
    folder = FOLDER / "data"
    subprocess.run([PROGRAM, "dataset", "--generate", "6", "--seed", "3", "--layout", "--relief-share",
                    "1", "--split", "1,0", "--out", folder], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return folder


def load(folder, part="layout"):
    return datasets.load_dataset(str(folder), part, split="train", cache_dir=str(FOLDER / "cache"))


def trainer(rows, tokenizer, **options):
    config = transformers.LlamaConfig(vocab_size=len(tokenizer), hidden_size=16, intermediate_size=32,
                                      num_hidden_layers=1, num_attention_heads=2,
                                      max_position_embeddings=4096, bos_token_id=1, eos_token_id=3)
    settings = trl.SFTConfig(output_dir=str(FOLDER / "run"), use_cpu=True, bf16=False, max_steps=2,
                             per_device_train_batch_size=2, report_to="none", logging_steps=1,
                             save_strategy="no", gradient_checkpointing=False, **options)
    return trl.SFTTrainer(transformers.LlamaForCausalLM(config), args=settings, train_dataset=rows,
                          processing_class=tokenizer)


def attempt(peer, name, wanted, make):
    """What goes wrong, which is expected where wanted is not empty."""
    try:
        found, said = make(), ""
    except Exception as error:  # whatever it says
        found, said = None, f"{type(error).__name__}: {error}".replace("\n", " ")
    if wanted or said:
        peer.check(name, wanted and wanted in said, f"refused: {said[:170]}" if said else "taken")
    return found


def marked_alone(prepared, tokenizer):
    """Whether the tokens that count are the assistant's words and the mark that ends them."""
    row = prepared.train_dataset[0]
    counted = [token for token, label in zip(row["input_ids"], row["labels"]) if label != -100]
    answer = load(data_set("layout"))[0]["messages"][-1]["content"]
    return tokenizer.decode(counted).replace("<|im_end|>", "").strip() == answer.strip()


def main():
    logging.disable(logging.WARNING)
    torch.set_num_threads(1)
    datasets.disable_progress_bars()
    peer = Peer("TRL", trl.__version__, "`latticeworld dataset`, the tokenizer of `layouts.gguf`",
                "`remove_columns` of all but `messages`, or it wants a vision model for `images`; "
                "`max_length` large enough; a template with `{% generation %}` for "
                "`assistant_only_loss`")
    tokenizer = transformers.AutoTokenizer.from_pretrained(str(MODELS), gguf_file="layouts.gguf")
    tokenizer.pad_token = "<unk>"
    rows = load(with_pictures())
    attempt(peer, "with the column `images`", "vision", lambda: trainer(rows, tokenizer))
    rows = rows.select_columns(["messages"])
    plain = attempt(peer, "`messages` alone", "", lambda: trainer(rows, tokenizer))
    text = tokenizer.decode(plain.train_dataset[0]["input_ids"])
    answer = rows[0]["messages"][-1]["content"].strip()
    peer.check("`messages` alone", answer in text.replace("<0x0A>", "\n"),
               f"{plain.train_dataset.num_rows} of {rows.num_rows} rows, the whole answer in each")
    plain.train()
    losses = [entry["loss"] for entry in plain.state.log_history if "loss" in entry]
    peer.check("two steps", len(losses) == 2 and all(map(math.isfinite, losses)), f"losses {losses}")
    tokenizer.chat_template = MARKED
    lengths = [len(tokenizer.apply_chat_template(row["messages"], return_dict=True)["input_ids"])
               for row in rows]
    limit = trl.SFTConfig(output_dir=".", use_cpu=True, bf16=False).max_length
    kept = trainer(rows, tokenizer, assistant_only_loss=True).train_dataset
    cut = sum(3 not in row["input_ids"][-2:] for row in kept)
    peer.check("whole prompts with the system message",
               cut == sum(length > limit for length in lengths) + rows.num_rows - kept.num_rows,
               f"{min(lengths)} to {max(lengths)} tokens; `max_length` is {limit} unless it is said, "
               f"and cuts the end off {cut} of {rows.num_rows} answers without a word")
    short = load(data_set("layout")).select_columns(["messages"])
    prepared = trainer(short, tokenizer, assistant_only_loss=True, max_length=4096)
    peer.check("`assistant_only_loss` with marked answers", marked_alone(prepared, tokenizer),
               "the assistant's words and the end of its turn count, nothing else")
    tokenizer.chat_template = transformers.AutoTokenizer.from_pretrained(
        str(MODELS), gguf_file="layouts.gguf").chat_template
    attempt(peer, "`assistant_only_loss` with the template of the file", "e",
            lambda: trainer(short, tokenizer, assistant_only_loss=True))
    peer.finish()


main()
