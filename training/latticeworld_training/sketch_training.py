"""Trains the network that turns sketches into land.

  python3 -m latticeworld_training.sketch_training --pairs pairs --out runs/sketch
"""

import argparse
import json
import math
import os
import time
from dataclasses import dataclass

import numpy
import torch
from torch import nn

from .checkpoint import load_checkpoint, read_checkpoint, save_checkpoint
from .curves import LossCurve
from .sketch_network import (Discriminators, Generator, SketchNetworkOptions, adversarial_loss, discriminator_loss,
                             feature_loss, land_loss)
from .sketch_pairs import SketchPairs
from .whole_files import whole_file


@dataclass
class SketchTrainingOptions:
    """Rate, betas and the weight of the features are those of Pix2PixHD where it has them."""

    rate: float = 4e-4
    betas: tuple = (0.5, 0.999)
    discriminator_rate: float = 2e-4
    batch_size: int = 4
    small_steps: int = 1500  # first, on half the grid and without discriminators: where is it high at all?
    plain_steps: int = 600  # then on the whole grid, still without
    adversarial_steps: int = 900  # then with them
    feature_weight: float = 10.0
    adversarial_weight: float = 1.0
    land_weight: float = 20.0
    check_pairs: int = 32  # the last ones, which are never trained on
    checkpoint_steps: int = 50
    seed: int = 1

    def steps(self):
        return self.small_steps + self.plain_steps + self.adversarial_steps


class _Optimizers:
    """Both, as save_checkpoint wants one."""

    def __init__(self, *optimizers):
        self.optimizers = optimizers

    def state_dict(self):
        return [optimizer.state_dict() for optimizer in self.optimizers]

    def load_state_dict(self, states):
        for optimizer, state in zip(self.optimizers, states):
            optimizer.load_state_dict(state)


@torch.no_grad()
def correlations(generator, pairs, indices, device=None):
    """Pearson correlation of made and real heights, one a pair."""
    result = []
    for i in indices:
        sketch, height = pairs.batch([i])
        made = generator(sketch.to(device)).cpu().flatten()
        result.append(float(numpy.corrcoef(made.numpy(), height.flatten().numpy())[0, 1]))
    return result


def fit(pairs, small_pairs, directory, network=None, options=None, device=None, most_steps=None, say=print):
    """Trains for most_steps more steps, or to the end. pairs: SketchPairs; small_pairs: the same on half the grid.
    `directory` gets checkpoint.pt, network.json, loss.csv, loss.png; a run that finds a checkpoint there goes on from
    it, and measures what it would have measured. Returns the generator and its loss at each step of this call."""
    network, options = network or SketchNetworkOptions(), options or SketchTrainingOptions()
    os.makedirs(directory, exist_ok=True)
    torch.manual_seed(options.seed)
    model = nn.ModuleDict({"generator": Generator(network), "discriminators": Discriminators(network)}).to(device)
    generator, discriminators = model["generator"], model["discriminators"]
    optimizers = _Optimizers(
        torch.optim.Adam(generator.parameters(), lr=options.rate, betas=options.betas),
        torch.optim.Adam(discriminators.parameters(), lr=options.discriminator_rate, betas=options.betas))
    checkpoint = os.path.join(directory, "checkpoint.pt")
    curve = LossCurve(os.path.join(directory, "loss.csv"), ["land", "features", "judged", "correlation"])
    step, before_s = 0, 0.0
    if os.path.exists(checkpoint):
        rest = load_checkpoint(checkpoint, model, optimizers)
        step, before_s = rest["step"], rest["seconds"]
        say(f"goes on at step {step}")
    curve.keep_until(step)
    with whole_file(os.path.join(directory, "network.json")) as file:
        json.dump(network.as_dict(), file, indent=1)

    kept = max(len(pairs) - options.check_pairs, 1)
    begin, losses, recent = time.monotonic(), [], []
    last = min(options.steps(), step + (most_steps or options.steps()))

    def save():
        values = {name: float(numpy.mean([row[name] for row in recent if name in row]))
                  for name in ("land", "features", "judged") if any(name in row for row in recent)}
        now = small_pairs if step <= options.small_steps else pairs
        if kept < len(pairs):
            values["correlation"] = float(numpy.mean(correlations(generator, now, range(kept, len(pairs)), device)))
        # The curve first: a run that ends in between measures this step again, and no point of it is lost.
        curve.add(step, **values)
        spent_s = before_s + time.monotonic() - begin
        save_checkpoint(checkpoint, model, optimizers, step=step, seconds=spent_s, network=network.as_dict())
        curve.draw(os.path.join(directory, "loss.png"), "losses of the generator, correlation with unseen land")
        recent.clear()
        say(f"step {step} of {options.steps()}, {spent_s:.0f} s: " +
            ", ".join(f"{name} {value:.4f}" for name, value in values.items()))

    while step < last:
        random = numpy.random.RandomState([options.seed, step])  # a step's draws depend on the step alone
        now = small_pairs if step < options.small_steps else pairs
        sketch, height = (t.to(device) for t in now.batch(random.randint(0, kept, options.batch_size), random))
        done = step / options.steps()
        for optimizer, rate in zip(optimizers.optimizers, (options.rate, options.discriminator_rate)):
            for group in optimizer.param_groups:
                group["lr"] = rate * min((step + 1) / 50, 0.02 + 0.98 * 0.5 * (1 + math.cos(math.pi * done)))
        made = generator(sketch)
        values = {"land": land_loss(made, height)}
        loss = options.land_weight * values["land"]
        if step >= options.small_steps + options.plain_steps:
            real, fake = discriminators(sketch, height), discriminators(sketch, made.detach())
            judged = discriminator_loss(real, fake)
            optimizers.optimizers[1].zero_grad()
            judged.backward()
            optimizers.optimizers[1].step()
            real, fake = discriminators(sketch, height), discriminators(sketch, made)
            values["features"], values["judged"] = feature_loss(real, fake), adversarial_loss(fake)
            loss = (loss + options.feature_weight * values["features"] +
                    options.adversarial_weight * values["judged"])
        optimizers.optimizers[0].zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(generator.parameters(), 1.0)
        optimizers.optimizers[0].step()
        step += 1
        recent.append({name: float(value.detach()) for name, value in values.items()})
        losses.append(float(loss.detach()))
        if step % options.checkpoint_steps == 0 or step == last:
            save()
    return generator, losses


def read_generator(directory):
    """The generator as it was last saved there."""
    state = read_checkpoint(os.path.join(directory, "checkpoint.pt"))
    generator = Generator(SketchNetworkOptions(**state["rest"]["network"]))
    prefix = "generator."
    generator.load_state_dict(
        {name[len(prefix):]: value for name, value in state["model"].items() if name.startswith(prefix)})
    return generator.eval()


def main():
    defaults, sizes = SketchTrainingOptions(), SketchNetworkOptions()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", required=True, help="directory of NAME_sketch.png and NAME_height.png")
    parser.add_argument("--out", required=True, help="directory for checkpoint and curves; a run there goes on")
    parser.add_argument("--device", default=None, help="cpu, cuda")
    parser.add_argument("--threads", type=int, default=1)
    for name in ("small_steps", "plain_steps", "adversarial_steps", "batch_size", "seed", "rate"):
        value = getattr(defaults, name)
        parser.add_argument("--" + name.replace("_", "-"), type=type(value), default=value)
    for name in ("width", "blocks", "levels"):
        parser.add_argument("--" + name, type=int, default=getattr(sizes, name))
    given = parser.parse_args()
    torch.set_num_threads(given.threads)
    chosen = vars(given)
    options = SketchTrainingOptions(
        **{name: chosen[name] for name in ("small_steps", "plain_steps", "adversarial_steps", "batch_size", "seed", "rate")})
    network = SketchNetworkOptions(width=given.width, blocks=given.blocks, levels=given.levels)
    pairs = SketchPairs(given.pairs)
    small = pairs.halved()
    print(f"{len(pairs)} pairs, {sum(p.numel() for p in Generator(network).parameters())} weights", flush=True)
    fit(pairs, small, given.out, network, options, given.device, say=lambda text: print(text, flush=True))


if __name__ == "__main__":
    main()
