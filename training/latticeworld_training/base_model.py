"""A LLaMA model file of somebody else's as a base to train on: weights, sizes, byte-level tokenizer."""

import numpy
import torch
import gguf
from tokenizers import Tokenizer, decoders, models, pre_tokenizers

from .gguf import LLAMA_PARTS
from .llama import Llama, LlamaSizes

def _field(reader, key):
    return reader.get_field(key).contents()


def read_base(path):
    """(Llama in float32, tokenizer of `tokenizers`) of a GGUF file with output weights that are the embeddings."""
    reader = gguf.GGUFReader(path)
    arch = _field(reader, "general.architecture")
    sizes = LlamaSizes(
        tokens=len(_field(reader, "tokenizer.ggml.tokens")), width=_field(reader, f"{arch}.embedding_length"),
        layers=_field(reader, f"{arch}.block_count"), heads=_field(reader, f"{arch}.attention.head_count"),
        kv_heads=_field(reader, f"{arch}.attention.head_count_kv"), hidden=_field(reader, f"{arch}.feed_forward_length"),
        context=_field(reader, f"{arch}.context_length"),
        norm_epsilon=_field(reader, f"{arch}.attention.layer_norm_rms_epsilon"),
        rope_base=_field(reader, f"{arch}.rope.freq_base"))
    with torch.device("meta"):
        model = Llama(sizes)
    state = {}
    for tensor in reader.tensors:
        values = torch.from_numpy(numpy.array(gguf.quants.dequantize(tensor.data, tensor.tensor_type), dtype=numpy.float32))
        if tensor.name == "token_embd.weight":
            state["embeddings.weight"] = values
        elif tensor.name == "output_norm.weight":
            state["output_norm.weight"] = values
        elif tensor.name.startswith("blk."):
            _, number, part, _ = tensor.name.split(".")
            state[f"layers.{number}.{LLAMA_PARTS[part]}.weight"] = values
    model.load_state_dict(state, assign=True)
    return model, byte_tokenizer(_field(reader, "tokenizer.ggml.tokens"), _field(reader, "tokenizer.ggml.merges"))


def byte_tokenizer(tokens, merges):
    """Byte-level BPE with the pre-tokenizer "smollm": digits one by one, then GPT-2's words."""
    tokenizer = Tokenizer(models.BPE({token: i for i, token in enumerate(tokens)}, [tuple(m.split(" ")) for m in merges]))
    tokenizer.pre_tokenizer = pre_tokenizers.Sequence(
        [pre_tokenizers.Digits(individual_digits=True), pre_tokenizers.ByteLevel(add_prefix_space=False, use_regex=True)])
    tokenizer.decoder = decoders.ByteLevel()
    tokenizer.add_special_tokens(["<|im_start|>", "<|im_end|>"])
    return tokenizer
