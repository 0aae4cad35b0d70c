"""From strokes to heights after Wang et al. 2018, "High-resolution image synthesis and semantic manipulation with
conditional GANs" (Pix2PixHD): a generator that works on a small grid and comes back, and patch discriminators at
several scales. Smaller than theirs: OpenCV has to run the generator on a processor. Heights of the way down are added
on the way up, so that strokes stay where they were drawn."""

from dataclasses import asdict, dataclass

import torch
from torch import nn
from torch.nn import functional
from torch.nn.utils import spectral_norm


@dataclass
class SketchNetworkOptions:
    width: int = 16  # channels on half the grid; doubled with each level below
    levels: int = 4  # halvings of the grid
    blocks: int = 5  # residual blocks on the smallest grid
    discriminator_width: int = 16
    discriminator_layers: int = 3
    scales: int = 2  # discriminators, each on half the grid of the one before

    def as_dict(self):
        return asdict(self)


def _doubled(x):
    """On a grid twice as fine, interpolated linearly: samples that are merely repeated leave their grid in the land."""
    return functional.interpolate(x, scale_factor=2.0, mode="bilinear", align_corners=False)


class ResidualBlock(nn.Module):
    """x + gain * f(x). The gain begins at 0, which takes the place of normalization (De and Smith 2020): whatever N
    is, and on a processor, a normalization would cost more than it gives. dilation: carries strokes far."""

    def __init__(self, channels, dilation):
        super().__init__()
        self.first = nn.Conv2d(channels, channels, 3, padding=dilation, dilation=dilation)
        self.second = nn.Conv2d(channels, channels, 3, padding=1)
        self.gain = nn.Parameter(torch.zeros(1))

    def forward(self, x):
        y = self.second(functional.leaky_relu(self.first(functional.leaky_relu(x, 0.2)), 0.2))
        return x + self.gain * y


class Generator(nn.Module):
    """(count, 3, N, N) strokes as RGB in [0, 1] -> (count, 1, N, N) heights, as a rule in [0, 1]; N a multiple of
    2^levels."""

    def __init__(self, options):
        super().__init__()
        widths = [options.width << level for level in range(options.levels)]
        self.stem = nn.Conv2d(3, widths[0], 5, stride=2, padding=2)
        self.down = nn.ModuleList(
            nn.Conv2d(a, b, 3, stride=2, padding=1) for a, b in zip(widths[:-1], widths[1:]))
        self.blocks = nn.ModuleList(ResidualBlock(widths[-1], 1 << (i % 4)) for i in range(options.blocks))
        self.up = nn.ModuleList(
            nn.Conv2d(b, a, 3, padding=1) for a, b in zip(widths[-2::-1], widths[:0:-1]))
        self.fine = nn.Conv2d(widths[0], max(widths[0] // 2, 4), 3, padding=1)
        self.strokes = nn.Conv2d(3, max(widths[0] // 2, 4), 3, padding=1)
        self.last = nn.Conv2d(max(widths[0] // 2, 4), 1, 5, padding=2)

    def forward(self, sketch):
        ink = 1 - sketch  # paper is nothing
        x = self.stem(ink)
        levels = []
        for down in self.down:
            levels.append(x)
            x = down(functional.leaky_relu(x, 0.2))
        for block in self.blocks:
            x = block(x)
        for up in self.up:
            x = _doubled(x)
            x = up(functional.leaky_relu(x, 0.2)) + levels.pop()
        x = _doubled(functional.leaky_relu(x, 0.2))
        x = functional.leaky_relu(self.fine(x) + self.strokes(ink), 0.2)
        return 0.5 + self.last(x)


class PatchDiscriminator(nn.Module):
    """Says of every patch whether land and sketch belong together; gives what each layer sees as well."""

    def __init__(self, options):
        super().__init__()
        width = options.discriminator_width
        widths = [4] + [min(width << i, 8 * width) for i in range(options.discriminator_layers)]
        self.layers = nn.ModuleList(
            spectral_norm(nn.Conv2d(a, b, 4, stride=2, padding=1)) for a, b in zip(widths[:-1], widths[1:]))
        self.judge = nn.Conv2d(widths[-1], 1, 3, padding=1)

    def forward(self, sketch, height):
        x = torch.cat([sketch, height], 1)
        seen = []
        for layer in self.layers:
            x = functional.leaky_relu(layer(x), 0.2)
            seen.append(x)
        return self.judge(x), seen


class Discriminators(nn.Module):
    def __init__(self, options):
        super().__init__()
        self.scales = nn.ModuleList(PatchDiscriminator(options) for _ in range(options.scales))

    def forward(self, sketch, height):
        answers = []
        for scale in self.scales:
            answers.append(scale(sketch, height))
            sketch, height = functional.avg_pool2d(sketch, 2), functional.avg_pool2d(height, 2)
        return answers


def discriminator_loss(real, fake):
    """Least squares (Mao et al. 2017)."""
    return sum(((r - 1) ** 2).mean() + (f**2).mean() for (r, _), (f, _) in zip(real, fake)) / len(real)


def adversarial_loss(fake):
    return sum(((f - 1) ** 2).mean() for f, _ in fake) / len(fake)


def feature_loss(real, fake):
    """What the discriminators see of the real land and of the made one, apart."""
    terms = [functional.l1_loss(f, r.detach())
             for (_, seen_real), (_, seen_fake) in zip(real, fake) for r, f in zip(seen_real, seen_fake)]
    return sum(terms) / len(terms)


def land_loss(made, height, scales=4):
    """Heights and slopes apart, on several grids, each half the one before. It takes the place of the features of a
    picture network in Pix2PixHD, which knows nothing of heights."""
    loss = 0
    for scale in range(scales):
        loss = loss + functional.l1_loss(made, height)
        for axis in (2, 3):
            loss = loss + 2 * functional.l1_loss(torch.diff(made, dim=axis), torch.diff(height, dim=axis))
        made, height = functional.avg_pool2d(made, 2), functional.avg_pool2d(height, 2)
    return loss / scales
