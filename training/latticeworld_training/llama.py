"""A language model of LLaMA's architecture (Touvron et al. 2023), plain and small."""

import dataclasses
import math

import torch
from torch import nn
from torch.nn import functional


@dataclasses.dataclass
class LlamaSizes:
    """What a model is made of; heads divide width, kv_heads divide heads, width / heads is even.

    Files in q8_0 want width and hidden to be multiples of 32."""

    tokens: int = 2000  # in the vocabulary
    width: int = 128  # of a token's embedding
    layers: int = 5
    heads: int = 4  # of queries
    kv_heads: int = 4  # of keys and values
    hidden: int = 352  # of the feed-forward network
    context: int = 1024  # tokens
    norm_epsilon: float = 1e-5
    rope_base: float = 10000.0

    def check(self):
        """Raises ValueError for sizes that do not go together."""
        if self.width % self.heads or self.heads % self.kv_heads or self.width // self.heads % 2:
            raise ValueError(f"{self.width} values cannot be shared by {self.heads} heads over {self.kv_heads} of keys")


class RootMeanSquareNorm(nn.Module):
    """Zhang and Sennrich 2019."""

    def __init__(self, width, epsilon):
        super().__init__()
        self.weight = nn.Parameter(torch.ones(width))
        self.epsilon = epsilon

    def forward(self, x):
        return x * torch.rsqrt(x.pow(2).mean(-1, keepdim=True) + self.epsilon) * self.weight


def rope_angles(sizes, length, device=None):
    """Cosines and sines, each (length, head width / 2), of rotary positions (Su et al. 2021)."""
    head_width = sizes.width // sizes.heads
    turns = sizes.rope_base ** (-torch.arange(0, head_width, 2, device=device).float() / head_width)
    angles = torch.arange(length, device=device).float()[:, None] * turns
    return angles.cos(), angles.sin()


def turn(x, cosines, sines):
    """Rotates each pair of neighbouring values. x: (batch, length, heads, head width)."""
    even, odd = x[..., 0::2], x[..., 1::2]
    cosines, sines = cosines[:, None], sines[:, None]
    return torch.stack((even * cosines - odd * sines, even * sines + odd * cosines), -1).flatten(-2)


class LlamaLayer(nn.Module):
    def __init__(self, sizes):
        super().__init__()
        self.sizes = sizes
        kv_width = sizes.kv_heads * (sizes.width // sizes.heads)
        self.attention_norm = RootMeanSquareNorm(sizes.width, sizes.norm_epsilon)
        self.query = nn.Linear(sizes.width, sizes.width, bias=False)
        self.key = nn.Linear(sizes.width, kv_width, bias=False)
        self.value = nn.Linear(sizes.width, kv_width, bias=False)
        self.attention_output = nn.Linear(sizes.width, sizes.width, bias=False)
        self.feed_forward_norm = RootMeanSquareNorm(sizes.width, sizes.norm_epsilon)
        self.gate = nn.Linear(sizes.width, sizes.hidden, bias=False)
        self.up = nn.Linear(sizes.width, sizes.hidden, bias=False)
        self.down = nn.Linear(sizes.hidden, sizes.width, bias=False)

    def forward(self, x, angles, mask):
        x = x + self.attend(self.attention_norm(x), angles, mask)
        normed = self.feed_forward_norm(x)
        return x + self.down(functional.silu(self.gate(normed)) * self.up(normed))

    def attend(self, x, angles, mask):
        batch, length, _ = x.shape
        head_width = self.sizes.width // self.sizes.heads
        queries = turn(self.query(x).view(batch, length, -1, head_width), *angles).transpose(1, 2)
        keys = turn(self.key(x).view(batch, length, -1, head_width), *angles).transpose(1, 2)
        values = self.value(x).view(batch, length, -1, head_width).transpose(1, 2)
        share = self.sizes.heads // self.sizes.kv_heads
        if share > 1:
            keys, values = keys.repeat_interleave(share, 1), values.repeat_interleave(share, 1)
        scores = (queries / math.sqrt(head_width)) @ keys.transpose(2, 3) + mask
        attended = (scores.softmax(-1) @ values).transpose(1, 2).reshape(batch, length, -1)
        return self.attention_output(attended)


class Llama(nn.Module):
    """Output weights are the embeddings."""

    def __init__(self, sizes):
        super().__init__()
        sizes.check()
        self.sizes = sizes
        self.embeddings = nn.Embedding(sizes.tokens, sizes.width)
        self.layers = nn.ModuleList(LlamaLayer(sizes) for _ in range(sizes.layers))
        self.output_norm = RootMeanSquareNorm(sizes.width, sizes.norm_epsilon)
        for name, weights in self.named_parameters():
            if weights.dim() == 2:
                deep = name.endswith(("attention_output.weight", "down.weight"))
                nn.init.normal_(weights, std=0.02 / math.sqrt(2 * sizes.layers) if deep else 0.02)

    def features(self, embedded):
        """What the last layer makes of embeddings (batch, length, width), of the same shape. Embeddings of
        anything may stand where those of tokens do."""
        length = embedded.shape[1]
        angles = rope_angles(self.sizes, length, embedded.device)
        mask = torch.full((length, length), -math.inf, device=embedded.device).triu(1)
        x = embedded
        for layer in self.layers:
            x = layer(x, angles, mask)
        return self.output_norm(x)

    def forward(self, tokens):
        """Logits (batch, length, vocabulary) for what follows each token (batch, length)."""
        return self.logits(self.features(self.embeddings(tokens)))

    def logits(self, features):
        return features @ self.embeddings.weight.T
