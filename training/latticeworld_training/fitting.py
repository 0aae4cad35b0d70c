"""Fitting a language model to conversations, so that an interrupted run goes on where it was."""

import math
import os
import random
import time
from dataclasses import dataclass

import torch
from torch.nn import functional

from .chat_data import IGNORED, batch_tensors, batches_of_epoch, without_prompt
from .checkpoint import load_checkpoint, save_checkpoint
from .curves import LossCurve
from .optimizers import make_optimizer


@dataclass
class FitOptions:
    """The defaults are the method's for a LLaMA-2-7B that is fine-tuned on text."""

    optimizer: str = "adamw"  # or "muon", which learns from scratch in a fraction of the steps
    rate: float = 5e-5
    betas: tuple = (0.9, 0.999)
    weight_decay: float = 0.001
    epochs: int = 4
    batch_size: int = 32
    at_once: int = 0  # examples whose gradients are summed into a batch's, where memory is short; 0: all
    warmup_steps: int = 0  # over which the rate rises
    decay: str = "none"  # or "cosine": down to a twentieth at the last step
    most_gradient: float = 1.0  # norm that gradients are cut to
    most_steps: int = 0  # 0: all of the epochs
    most_seconds: float = 0.0  # after which the run ends, its rate having fallen with the time; 0: no limit
    unprompted_share: float = 0.0  # of examples whose answer is learned without what was asked, for guidance
    seed: int = 1
    checkpoint_steps: int = 200  # between two checkpoints
    check_examples: int = 256  # of the validation set, for one point of its curve


def answer_loss(model, tokens, targets):
    """Cross-entropy [nats a token] of the assistant's tokens."""
    features = model.features(model.embeddings(tokens))
    counted = targets != IGNORED
    return functional.cross_entropy(model.logits(features[counted]), targets[counted])


def add_gradients(model, batch, at_once, device=None):
    """Adds the gradients of a batch's loss, which is returned with the tokens that were read."""
    at_once = at_once or len(batch)
    all_counted = sum(sum(example.answers[1:]) for example in batch)
    loss_of_batch, tokens_read = 0.0, 0
    for begin in range(0, len(batch), at_once):
        tokens, targets = batch_tensors(batch[begin : begin + at_once], device)
        share = int((targets != IGNORED).sum()) / max(all_counted, 1)
        loss = answer_loss(model, tokens, targets) * share
        loss.backward()
        loss_of_batch += float(loss.detach())
        tokens_read += tokens.numel()
    return loss_of_batch, tokens_read


@torch.no_grad()
def validation_loss(model, examples, batch_size, device=None):
    """The same over many examples; every token counts alike."""
    model.eval()
    sum_nats, count = 0.0, 0
    ordered = sorted(examples, key=lambda example: len(example.tokens))
    for begin in range(0, len(ordered), batch_size):
        tokens, targets = batch_tensors(ordered[begin : begin + batch_size], device)
        counted = int((targets != IGNORED).sum())
        sum_nats += float(answer_loss(model, tokens, targets)) * counted
        count += counted
    model.train()
    return sum_nats / max(count, 1)


def _batch(examples, indices, options, step):
    draws = random.Random(f"{options.seed} unprompted {step}")
    some = [examples[i] for i in indices]
    return [without_prompt(each) if draws.random() < options.unprompted_share else each for each in some]


def _rate(options, step, steps, spent_s):
    if step < options.warmup_steps:
        return options.rate * (step + 1) / options.warmup_steps
    if options.decay != "cosine":
        return options.rate
    done = step / max(steps, 1)
    if options.most_seconds:
        done = max(done, spent_s / options.most_seconds)
    return options.rate * (0.05 + 0.95 * 0.5 * (1 + math.cos(math.pi * min(done, 1.0))))


def fit(model, examples, validation, directory, options, device=None, say=print):
    """Trains; `directory` gets checkpoint.pt, loss.csv and loss.png, and a run that finds a checkpoint there goes on
    from it. Returns the training losses of all steps of this call [nats a token]."""
    os.makedirs(directory, exist_ok=True)
    model.to(device)
    torch.manual_seed(options.seed)
    optimizer = make_optimizer(model, options)
    checkpoint = os.path.join(directory, "checkpoint.pt")
    curve = LossCurve(os.path.join(directory, "loss.csv"), ["training", "validation"])
    step, spent_before_s, tokens_seen = 0, 0.0, 0
    if os.path.exists(checkpoint):
        rest = load_checkpoint(checkpoint, model, optimizer)
        step, spent_before_s, tokens_seen = rest["step"], rest["seconds"], rest["tokens"]
        say(f"goes on at step {step}")
    curve.keep_until(step)

    begin = time.monotonic()
    batches_each = math.ceil(len(examples) / options.batch_size)
    steps = options.epochs * batches_each
    steps = min(steps, options.most_steps or steps)
    losses, recent = [], []

    def spent_s():
        return spent_before_s + time.monotonic() - begin

    def save():
        values = {"training": sum(recent) / len(recent)} if recent else {}
        if validation:
            some = validation[: options.check_examples]
            values["validation"] = validation_loss(model, some, options.batch_size, device)
        # The curve first: a run that ends in between measures this step again, and no point of it is lost.
        curve.add(step, **values)
        save_checkpoint(checkpoint, model, optimizer, step=step, seconds=spent_s(), tokens=tokens_seen)
        curve.draw(os.path.join(directory, "loss.png"), "loss [nats a token of the answer]")
        recent.clear()
        figures = ", ".join(f"{name} {value:.4f}" for name, value in values.items())
        say(f"step {step} of {steps}, {spent_s():.0f} s, {tokens_seen} tokens: {figures}")

    model.train()
    epoch = -1
    while step < steps and not (options.most_seconds and spent_s() >= options.most_seconds):
        if step // batches_each != epoch:
            epoch = step // batches_each
            batches = batches_of_epoch(examples, options.batch_size, options.seed, epoch)
        for group in optimizer.param_groups:
            group["lr"] = _rate(options, step, steps, spent_s())
        optimizer.zero_grad()
        batch = _batch(examples, batches[step % batches_each], options, step)
        loss, tokens_read = add_gradients(model, batch, options.at_once, device)
        torch.nn.utils.clip_grad_norm_(model.parameters(), options.most_gradient)
        optimizer.step()
        step += 1
        tokens_seen += tokens_read
        losses.append(loss)
        recent.append(loss)
        if step % options.checkpoint_steps == 0:
            save()
    if recent:
        save()
    return losses
