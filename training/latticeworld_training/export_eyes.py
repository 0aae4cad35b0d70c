"""Makes a GGUF file of what shows height maps to a language model; LatticeWorld reads it beside the model's own
(`layouts.eyes.gguf` beside `layouts.gguf`). `export_gguf --vision` calls this."""

import os

from .checkpoint import read_checkpoint
from .gguf import F32, STRING, TENSOR_TYPES, UINT32, GgufWriter
from .vision_network import Projection
from .vision_stages import read_encoder

ARCHITECTURE = "latticeworld-eyes"


def eyes_path(model_file):
    """Where the eyes of a model file are looked for."""
    return os.path.splitext(model_file)[0] + ".eyes.gguf"


def load_vision_run(directory, language_model):
    """Encoder and projection of a run of vision_training; language_model gets the weights of its last stage."""
    encoder = read_encoder(os.path.join(directory, "contrast"))
    projection = Projection(encoder.options, language_model.sizes.width).eval()
    state = read_checkpoint(os.path.join(directory, "together", "checkpoint.pt"))["model"]
    for name, part in (("projection.", projection), ("language_model.", language_model)):
        part.load_state_dict({key[len(name) :]: value for key, value in state.items() if key.startswith(name)})
    return encoder, projection


def _add_linear(writer, name, weight, bias, kind):
    writer.add_tensor(name + ".weight", weight, kind)
    writer.add_tensor(name + ".bias", bias, F32)


def _values(tensor):
    return tensor.detach().cpu().float().numpy()


def _add_layer(writer, number, layer, kind):
    for part in ("first_norm", "second_norm", "queries_keys_values", "attended", "up", "down"):
        module = getattr(layer, part)
        weight = _values(module.weight)
        _add_linear(writer, f"blk.{number}.{part}", weight, _values(module.bias), kind if weight.ndim == 2 else F32)


def export_eyes(encoder, projection, path, weight_type="f16"):
    """Matrices in weight_type ("f32", "f16", "q8_0"), the rest in f32. The encoder's last layer serves the contrastive
    stage alone and is left out; the projection's scale goes into its last weights."""
    options, kind = encoder.options, TENSOR_TYPES[weight_type]
    layers = encoder.layers[:-1]
    writer = GgufWriter()
    writer.add("general.architecture", STRING, ARCHITECTURE)
    numbers = {
        "side": options.side,
        "patch": options.patch,
        "width": options.width,
        "heads": options.heads,
        "hidden": encoder.layers[0].up.out_features,
        "layers": len(layers),
        "embedding": projection.each.out_channels,
    }
    for key, number in numbers.items():
        writer.add("eyes." + key, UINT32, number)
    patches = _values(encoder.patches.weight).reshape(options.width, -1)
    _add_linear(writer, "eyes.patches", patches, _values(encoder.patches.bias), kind)
    writer.add_tensor("eyes.whole.weight", _values(encoder.whole)[0, 0], F32)
    writer.add_tensor("eyes.places.weight", _values(encoder.places)[0], F32)
    for number, layer in enumerate(layers):
        _add_layer(writer, number, layer, kind)
    _add_linear(writer, "projection.norm", _values(projection.norm.weight), _values(projection.norm.bias), F32)
    # Rows of what is around a patch: (row, column, feature), where PyTorch has features first.
    near = _values(projection.near.weight).transpose(0, 2, 3, 1).reshape(projection.near.out_channels, -1)
    _add_linear(writer, "projection.near", near, _values(projection.near.bias), kind)
    size = float(projection.size)
    each = size * _values(projection.each.weight)[:, :, 0, 0]
    _add_linear(writer, "projection.each", each, size * _values(projection.each.bias), kind)
    writer.write(path)
