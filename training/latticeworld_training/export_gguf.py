"""Makes a GGUF file of a trained language model, for LatticeWorld (`--local-model`) and llama.cpp.

    python3 -m latticeworld_training.export_gguf run --type q8_0 --name "layouts, 1 M" --out layout.gguf
    python3 -m latticeworld_training.export_gguf run --vision run/vision --out seeing.gguf
"""

import argparse
import json
import os

from .chat_data import CHAT_TEMPLATE
from .checkpoint import read_checkpoint
from .gguf import BOOL, F32, FLOAT32, INT32, STRING, TENSOR_TYPES, UINT32, GgufWriter
from .llama import Llama, LlamaSizes
from .tokenizer import BEGIN, TURN_END, UNKNOWN, Tokenizer

FILE_TYPES = {"f32": 0, "f16": 1, "q8_0": 7}
TENSORS_OF_LAYER = {
    "attention_norm": "attn_norm",
    "query": "attn_q",
    "key": "attn_k",
    "value": "attn_v",
    "attention_output": "attn_output",
    "feed_forward_norm": "ffn_norm",
    "gate": "ffn_gate",
    "up": "ffn_up",
    "down": "ffn_down",
}


def tensor_name(name):
    """GGUF's name of one of Llama's weights: "layers.0.query.weight" is "blk.0.attn_q.weight"."""
    parts = name.split(".")
    if parts[0] == "layers":
        return f"blk.{parts[1]}.{TENSORS_OF_LAYER[parts[2]]}.weight"
    return {"embeddings": "token_embd", "output_norm": "output_norm"}[parts[0]] + ".weight"


def add_sizes(writer, sizes):
    numbers = {
        "context_length": sizes.context,
        "embedding_length": sizes.width,
        "block_count": sizes.layers,
        "feed_forward_length": sizes.hidden,
        "attention.head_count": sizes.heads,
        "attention.head_count_kv": sizes.kv_heads,
        "rope.dimension_count": sizes.width // sizes.heads,
        "vocab_size": sizes.tokens,
    }
    for key, number in numbers.items():
        writer.add("llama." + key, UINT32, number)
    writer.add("llama.attention.layer_norm_rms_epsilon", FLOAT32, sizes.norm_epsilon)
    writer.add("llama.rope.freq_base", FLOAT32, sizes.rope_base)


def add_tokenizer(writer, tokenizer):
    writer.add("tokenizer.ggml.model", STRING, "llama")
    writer.add_array("tokenizer.ggml.tokens", STRING, tokenizer.pieces)
    writer.add_array("tokenizer.ggml.scores", FLOAT32, tokenizer.scores)
    writer.add_array("tokenizer.ggml.token_type", INT32, tokenizer.kinds)
    writer.add("tokenizer.ggml.bos_token_id", UINT32, BEGIN)
    writer.add("tokenizer.ggml.eos_token_id", UINT32, TURN_END)
    writer.add("tokenizer.ggml.unknown_token_id", UINT32, UNKNOWN)
    writer.add("tokenizer.ggml.add_bos_token", BOOL, True)
    writer.add("tokenizer.ggml.add_eos_token", BOOL, False)
    writer.add("tokenizer.ggml.add_space_prefix", BOOL, False)
    writer.add("tokenizer.chat_template", STRING, CHAT_TEMPLATE)


def export(model, tokenizer, path, weight_type="q8_0", name="latticeworld", guidance=None, sees=False):
    """Matrices in weight_type ("f32", "f16", "q8_0"), norms in f32. guidance: how far LatticeWorld moves answers away
    from those to nothing. sees: its eyes lie beside it."""
    writer = GgufWriter()
    writer.add("general.architecture", STRING, "llama")
    writer.add("general.name", STRING, name)
    writer.add("general.file_type", UINT32, FILE_TYPES[weight_type])
    if guidance is not None:
        writer.add("latticeworld.guidance", FLOAT32, guidance)
    if sees:
        writer.add("latticeworld.sees", BOOL, True)
    add_sizes(writer, model.sizes)
    add_tokenizer(writer, tokenizer)
    for key, weights in model.state_dict().items():
        values = weights.detach().cpu().float().numpy()
        writer.add_tensor(tensor_name(key), values, F32 if values.ndim == 1 else TENSOR_TYPES[weight_type])
    writer.write(path)


def load_run(directory):
    """The model, with its last checkpoint's weights, and the tokenizer of a run's folder."""
    with open(os.path.join(directory, "model.json"), encoding="utf-8") as file:
        model = Llama(LlamaSizes(**json.load(file)))
    model.load_state_dict(read_checkpoint(os.path.join(directory, "checkpoint.pt"))["model"])
    return model.eval(), Tokenizer.load(os.path.join(directory, "tokenizer.json"))


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", help="folder that train_language_model wrote")
    parser.add_argument("--out", required=True, help="the GGUF file")
    parser.add_argument("--type", choices=sorted(TENSOR_TYPES), default="q8_0", help="of the weights [q8_0]")
    parser.add_argument("--name", default="latticeworld", help="of the model [latticeworld]")
    parser.add_argument("--guidance", type=float, help="of a model that was trained with --unprompted-share, 1 to 20")
    parser.add_argument("--vision", help="folder that vision_training wrote: its language model is exported instead, "
                        "and what it sees with beside it, OUT with .eyes.gguf at its end")
    given = parser.parse_args(arguments)
    model, tokenizer = load_run(given.run)
    written = [given.out]
    if given.vision:
        # Only here: it needs Pillow.
        from .export_eyes import export_eyes, eyes_path, load_vision_run

        encoder, projection = load_vision_run(given.vision, model)
        written.append(eyes_path(given.out))
        export_eyes(encoder, projection, written[-1], "f32" if given.type == "f32" else "f16")
    export(model, tokenizer, given.out, given.type, given.name, given.guidance, bool(given.vision))
    for path in written:
        print(f"{path}: {os.path.getsize(path)} bytes")


if __name__ == "__main__":
    main()
