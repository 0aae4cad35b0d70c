"""The three stages that give a language model eyes, each of them restartable.

1. contrast: encoder of height maps and encoder of captions, so that a map finds its caption.
2. align: the projection alone learns to put what the encoder sees before the words, by captioning.
3. together: projection and language model learn the task (captions, layouts) end to end; the encoder stays.
"""

import math
import os
import time
from dataclasses import dataclass

import numpy
import torch
from torch import nn
from torch.nn import functional

from .chat_data import IGNORED
from .checkpoint import load_checkpoint, read_checkpoint, save_checkpoint
from .curves import LossCurve
from .vision_data import caption_tensors, conversation_tensors, height_tensor
from .vision_network import HeightAndCaption, Projection, VisionOptions, contrastive_loss


@dataclass
class StageOptions:
    """Epochs and rates of the stages that have one in the method are its own; see the three below."""

    epochs: int
    rate: float
    batch_size: int = 32
    betas: tuple = (0.9, 0.999)
    weight_decay: float = 0.001
    most_gradient: float = 1.0
    checkpoint_steps: int = 50
    seed: int = 1


def contrast_options(**changes):
    """The method fine-tunes CLIP; from nothing, the rate has to be a higher one."""
    return StageOptions(**{"epochs": 10, "rate": 5e-4, **changes})


def align_options(**changes):
    return StageOptions(**{"epochs": 12, "rate": 5e-4, **changes})


def together_options(**changes):
    return StageOptions(**{"epochs": 4, "rate": 5e-5, **changes})


def fit_stage(trained, loss_of, count, directory, options, check=None, rest=None, most_steps=None, say=print):
    """Trains the weights of `trained` (a module) on loss_of(indices of examples), a loss each step, over `count`
    examples. `directory` gets checkpoint.pt, loss.csv and loss.png; a run that finds a checkpoint there goes on from
    it. check: called at each checkpoint for the loss on what is not trained on. rest: kept in the checkpoint.
    Returns the losses of this call's steps."""
    os.makedirs(directory, exist_ok=True)
    optimizer = torch.optim.AdamW(trained.parameters(), lr=options.rate, betas=options.betas,
                                  weight_decay=options.weight_decay)
    checkpoint = os.path.join(directory, "checkpoint.pt")
    curve = LossCurve(os.path.join(directory, "loss.csv"), ["training", "validation"])
    step, before_s = 0, 0.0
    if os.path.exists(checkpoint):
        was = load_checkpoint(checkpoint, trained, optimizer)
        step, before_s = was["step"], was["seconds"]
        say(f"goes on at step {step}")
    curve.keep_until(step)
    each = math.ceil(count / options.batch_size)
    last = min(options.epochs * each, step + (most_steps or options.epochs * each))
    begin, losses, recent = time.monotonic(), [], []
    trained.train()
    while step < last:
        order = numpy.random.RandomState([options.seed, step // each]).permutation(count)
        indices = order[options.batch_size * (step % each) :][: options.batch_size]
        optimizer.zero_grad()
        loss = loss_of([int(i) for i in indices])
        loss.backward()
        nn.utils.clip_grad_norm_(trained.parameters(), options.most_gradient)
        optimizer.step()
        step += 1
        losses.append(float(loss.detach()))
        recent.append(losses[-1])
        if step % options.checkpoint_steps == 0 or step == last:
            values = {"training": float(numpy.mean(recent))}
            if check:
                with torch.no_grad():
                    values["validation"] = float(check())
            # The curve first: a run that ends in between measures this step again, and no point of it is lost.
            curve.add(step, **values)
            spent_s = before_s + time.monotonic() - begin
            save_checkpoint(checkpoint, trained, optimizer, step=step, seconds=spent_s, **(rest or {}))
            curve.draw(os.path.join(directory, "loss.png"), "loss")
            recent.clear()
            say(f"step {step} of {options.epochs * each}, {spent_s:.0f} s: " +
                ", ".join(f"{name} {value:.4f}" for name, value in values.items()))
    return losses


def _batches(count, size):
    return [list(range(begin, min(begin + size, count))) for begin in range(0, count, size)]


def contrast(pictures, tokenizer, directory, network=None, options=None, validation=(), device=None, **more):
    """Stage 1, on pictures whose answer is a caption. Returns the model and its losses."""
    options = options or contrast_options()
    network = network or VisionOptions(tokens=len(tokenizer))
    torch.manual_seed(options.seed)
    model = HeightAndCaption(network).to(device)

    def loss_on(some):
        captions = [picture.answer() for picture in some]
        same = torch.tensor([[a == b for a in captions] for b in captions], device=device)
        tokens, lengths = caption_tensors(tokenizer, captions, network.text_length, device)
        return contrastive_loss(model(height_tensor(some, device), tokens, lengths), same)

    def check():
        parts = [loss_on([validation[i] for i in part]) for part in _batches(len(validation), options.batch_size)]
        return sum(parts) / len(parts)

    losses = fit_stage(model, lambda indices: loss_on([pictures[i] for i in indices]), len(pictures), directory,
                       options, check if validation else None, {"network": network.as_dict()}, **more)
    return model, losses


def read_encoder(directory):
    """The encoder of height maps that `contrast` left in its directory."""
    state = read_checkpoint(os.path.join(directory, "checkpoint.pt"))
    model = HeightAndCaption(VisionOptions(**state["rest"]["network"]))
    model.load_state_dict(state["model"])
    return model.heights.eval()


def answer_loss(encoder, projection, language_model, tokenizer, pictures, device=None):
    """Cross-entropy [nats a token] of the answers' tokens, after what is seen and the words before them."""
    with torch.no_grad():
        features = encoder.features(height_tensor(pictures, device))
    seen = projection(features)
    tokens, targets = conversation_tensors(tokenizer, pictures, device)
    embedded = torch.cat([seen, language_model.embeddings(tokens)], 1)
    made = language_model.features(embedded)[:, seen.shape[1] :]
    counted = targets != IGNORED
    return functional.cross_entropy(language_model.logits(made[counted]), targets[counted])


def _fit_eyes(trained, parts, tokenizer, pictures, directory, options, validation, device, more):
    encoder, projection, language_model = parts
    encoder.to(device).requires_grad_(False)

    def loss_on(some):
        return answer_loss(encoder, projection, language_model, tokenizer, some, device)

    def check():
        parts = [loss_on([validation[i] for i in part]) for part in _batches(len(validation), options.batch_size)]
        return sum(parts) / len(parts)

    return fit_stage(trained, lambda indices: loss_on([pictures[i] for i in indices]), len(pictures), directory,
                     options, check if validation else None, **more)


def align(encoder, language_model, tokenizer, pictures, directory, options=None, validation=(), device=None, **more):
    """Stage 2: the projection alone. Returns it and its losses; encoder and language model stay as they are."""
    options = options or align_options()
    torch.manual_seed(options.seed)
    projection = Projection(encoder.options, language_model.sizes.width).to(device)
    language_model.to(device).requires_grad_(False)
    losses = _fit_eyes(projection, (encoder, projection, language_model), tokenizer, pictures, directory, options,
                       validation, device, more)
    return projection, losses


def together(encoder, projection, language_model, tokenizer, pictures, directory, options=None, validation=(),
             device=None, **more):
    """Stage 3: projection and language model, changed in place. Returns the losses."""
    options = options or together_options()
    torch.manual_seed(options.seed)
    language_model.to(device).requires_grad_(True)
    projection.to(device).requires_grad_(True)
    both = nn.ModuleDict({"projection": projection, "language_model": language_model})
    return _fit_eyes(both, (encoder, projection, language_model), tokenizer, pictures, directory, options, validation,
                     device, more)
