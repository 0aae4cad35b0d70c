"""What sees a height map: an encoder in the manner of CLIP (Radford et al. 2021), and the small network that turns what
it sees into words' embeddings of a language model (after Liu et al. 2023, "Visual instruction tuning")."""

import math
from dataclasses import asdict, dataclass

import torch
from torch import nn
from torch.nn import functional


@dataclass
class VisionOptions:
    side: int = 64  # samples a side of the height map that the encoder is given
    patch: int = 8  # samples a side of a patch; side is a multiple of it
    width: int = 128  # of a patch's features; a multiple of heads
    heads: int = 4
    layers: int = 4  # at least 2, since features are those of the last but one
    text_layers: int = 2
    text_length: int = 64  # tokens of a caption, the rest is left out
    shared: int = 128  # width of the space that pictures and captions share
    tokens: int = 0  # of the captions' vocabulary

    def grid(self):
        return self.side // self.patch

    def as_dict(self):
        return asdict(self)


class Block(nn.Module):
    """A transformer's layer with normalization before each half."""

    def __init__(self, width, heads):
        super().__init__()
        self.heads = heads
        self.first_norm, self.second_norm = nn.LayerNorm(width), nn.LayerNorm(width)
        self.queries_keys_values = nn.Linear(width, 3 * width)
        self.attended = nn.Linear(width, width)
        self.up, self.down = nn.Linear(width, 4 * width), nn.Linear(4 * width, width)

    def forward(self, x, mask=None):
        count, length, width = x.shape
        parts = self.queries_keys_values(self.first_norm(x)).view(count, length, 3, self.heads, width // self.heads)
        queries, keys, values = parts.permute(2, 0, 3, 1, 4)
        scores = queries @ keys.transpose(-2, -1) / math.sqrt(width // self.heads)
        if mask is not None:
            scores = scores + mask
        y = (scores.softmax(-1) @ values).transpose(1, 2).reshape(count, length, width)
        x = x + self.attended(y)
        return x + self.down(functional.gelu(self.up(self.second_norm(x))))


class HeightEncoder(nn.Module):
    """ViT (Dosovitskiy et al. 2021) of (count, 1, side, side) heights."""

    def __init__(self, options):
        super().__init__()
        self.options = options
        width = options.width
        self.patches = nn.Conv2d(1, width, options.patch, stride=options.patch)
        self.whole = nn.Parameter(0.02 * torch.randn(1, 1, width))  # what stands for the picture as a whole
        self.places = nn.Parameter(0.02 * torch.randn(1, 1 + options.grid() ** 2, width))
        self.layers = nn.ModuleList(Block(width, options.heads) for _ in range(options.layers))
        self.norm = nn.LayerNorm(width)
        self.shared = nn.Linear(width, options.shared, bias=False)

    def _begin(self, height):
        x = self.patches(height).flatten(2).transpose(1, 2)
        return torch.cat([self.whole.expand(len(x), -1, -1), x], 1) + self.places

    def features(self, height):
        """(count, grid * grid, width): of each patch, after the last layer but one, row by row from the north."""
        x = self._begin(height)
        for layer in self.layers[:-1]:
            x = layer(x)
        return x[:, 1:]

    def forward(self, height):
        """(count, shared), of length 1."""
        x = self._begin(height)
        for layer in self.layers:
            x = layer(x)
        return functional.normalize(self.shared(self.norm(x[:, 0])), dim=-1)


class CaptionEncoder(nn.Module):
    """Of captions as (count, length) tokens and (count) lengths."""

    def __init__(self, options):
        super().__init__()
        self.words = nn.Embedding(options.tokens, options.width)
        nn.init.normal_(self.words.weight, std=0.02)
        self.places = nn.Parameter(0.02 * torch.randn(1, options.text_length, options.width))
        self.layers = nn.ModuleList(Block(options.width, options.heads) for _ in range(options.text_layers))
        self.norm = nn.LayerNorm(options.width)
        self.shared = nn.Linear(options.width, options.shared, bias=False)

    def forward(self, tokens, lengths):
        length = tokens.shape[1]
        mask = torch.full((length, length), -math.inf, device=tokens.device).triu(1)
        x = self.words(tokens) + self.places[:, :length]
        for layer in self.layers:
            x = layer(x, mask)
        last = x[torch.arange(len(x), device=x.device), lengths - 1]  # it has seen all that came before
        return functional.normalize(self.shared(self.norm(last)), dim=-1)


class HeightAndCaption(nn.Module):
    """Both, and how sharply they are told apart."""

    def __init__(self, options):
        super().__init__()
        self.heights, self.captions = HeightEncoder(options), CaptionEncoder(options)
        self.sharpness = nn.Parameter(torch.tensor(math.log(1 / 0.07)))

    def forward(self, height, tokens, lengths):
        """(count, count): how well each height map goes with each caption."""
        sharpness = self.sharpness.clamp(max=math.log(100.0)).exp()
        return sharpness * self.heights(height) @ self.captions(tokens, lengths).T


def contrastive_loss(scores, same=None):
    """Each picture has to find its caption among those of the batch, and each caption its picture. same: (count,
    count) bool, pairs whose captions say the same: any of them is right."""
    if same is None:
        same = torch.eye(len(scores), dtype=torch.bool, device=scores.device)
    share = same.float() / same.float().sum(1, keepdim=True)
    rows, columns = scores.log_softmax(1), scores.T.log_softmax(1)
    return -((share * rows).sum(1).mean() + (share * columns).sum(1).mean()) / 2


class Projection(nn.Module):
    """(count, grid * grid, width) features -> (count, (grid / 2)^2, embedding) for a language model: four patches
    become one word."""

    def __init__(self, options, embedding):
        super().__init__()
        self.grid = options.grid()
        self.near = nn.Conv2d(options.width, embedding, 3, stride=2, padding=1)
        self.each = nn.Conv2d(embedding, embedding, 1)
        self.norm = nn.LayerNorm(options.width)
        # Words' embeddings are small; what is seen begins at their size.
        self.size = nn.Parameter(torch.tensor(0.1))

    def forward(self, features):
        x = self.norm(features).transpose(1, 2).reshape(len(features), -1, self.grid, self.grid)
        x = self.each(functional.gelu(self.near(x)))
        return self.size * x.flatten(2).transpose(1, 2)
