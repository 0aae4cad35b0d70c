"""Low-rank adapters (Hu et al. 2021): a few weights beside a base model's own, which stay as they are."""

import math
import os

import torch
from torch import nn

from . import gguf

ADAPTED = ("query", "key", "value", "attention_output", "gate", "up", "down")
SCALE = 2.0  # of what adapters add


class AdaptedLinear(nn.Module):
    """y = (W + scale B A) x with W fixed, A (rank, inputs) and B (outputs, rank). B begins at zero."""

    def __init__(self, base, rank, scale):
        super().__init__()
        self.weight = base.weight  # (outputs, inputs)
        self.weight.requires_grad_(False)
        self.scale = scale
        self.a = nn.Parameter(torch.empty(rank, base.in_features))
        self.b = nn.Parameter(torch.zeros(base.out_features, rank))
        nn.init.kaiming_uniform_(self.a, a=math.sqrt(5))

    def forward(self, x):
        narrow = nn.functional.linear(x, self.a.to(x.dtype))
        return nn.functional.linear(x, self.weight) + nn.functional.linear(narrow, (self.b * self.scale).to(x.dtype))


def adapt(model, rank, scale=SCALE):
    """Puts adapters on every matrix of a Llama's layers; all that was there before is fixed."""
    for weights in model.parameters():
        weights.requires_grad_(False)
    for layer in model.layers:
        for name in ADAPTED:
            setattr(layer, name, AdaptedLinear(getattr(layer, name), rank, scale))


def read_adapters(path):
    """Name -> weights of a run's folder, or of a file that export_reader made, as they are trained: without the scale."""
    if os.path.isdir(path):
        return torch.load(os.path.join(path, "adapter.pt"), weights_only=False)["adapters"]
    state = {}
    for name, values in gguf.read_gguf(path)[1].items():
        _, number, part, _, which = name.split(".")
        scale = SCALE if which == "b" else 1.0
        state[f"layers.{number}.{gguf.LLAMA_PARTS[part]}.{which}"] = torch.from_numpy(values / scale)
    return state


def joined(model):
    """Name -> the matrices of the layers with their adapters added."""
    return {
        f"layers.{number}.{name}.weight": (getattr(layer, name).weight + getattr(layer, name).scale * getattr(layer, name).b
                                           @ getattr(layer, name).a).detach()
        for number, layer in enumerate(model.layers)
        for name in ADAPTED
    }
