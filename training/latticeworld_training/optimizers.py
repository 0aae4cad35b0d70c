"""What takes the steps of training."""

import torch

OPTIMIZERS = ("adamw", "muon")
# Of the quintic polynomial whose iterations draw all singular values to about 1 (Jordan et al. 2024).
QUINTIC = (3.4445, -4.7750, 2.0315)
# Root mean square of a step of a matrix, as a share of the rate: about that of AdamW's steps, so that one rate does for both
# (Liu et al. 2025).
STEP_SIZE = 0.2


def orthogonalized(matrix, iterations=5):
    """Nearly U V^T of a matrix (rows, columns) = U S V^T: Newton and Schulz's iterations need no decomposition. The
    singular values of what comes back lie between 0.6 and 1.3, but for those that were next to nothing."""
    a, b, c = QUINTIC
    x = matrix / (matrix.norm() + 1e-7)
    tall = x.shape[0] > x.shape[1]
    x = x.T if tall else x
    for _ in range(iterations):
        square = x @ x.T
        x = a * x + (b * square + c * square @ square) @ x
    return x.T if tall else x


class Muon(torch.optim.Optimizer):
    """Gradients of matrices, averaged with momentum and made orthogonal (Jordan et al. 2024): no direction of a matrix
    waits for another. Decay of weights is AdamW's. PyTorch has it from 2.9 on; Debian's is older."""

    def __init__(self, matrices, lr, momentum=0.95, weight_decay=0.0):
        super().__init__(matrices, {"lr": lr, "momentum": momentum, "weight_decay": weight_decay})

    @torch.no_grad()
    def step(self, closure=None):
        for group in self.param_groups:
            for weights in group["params"]:
                if weights.grad is None:
                    continue
                state = self.state[weights]
                if not state:
                    state["average"] = torch.zeros_like(weights)
                average = state["average"].lerp_(weights.grad, 1 - group["momentum"])
                direction = orthogonalized(weights.grad.lerp(average, group["momentum"]))
                weights.mul_(1 - group["lr"] * group["weight_decay"])
                # An orthogonal matrix has a root mean square of one over the root of its longer side.
                weights.add_(direction, alpha=-group["lr"] * STEP_SIZE * max(weights.shape) ** 0.5)


class Together:
    """Optimizers of different weights that step as one."""

    def __init__(self, *optimizers):
        self.optimizers = optimizers

    @property
    def param_groups(self):
        return [group for optimizer in self.optimizers for group in optimizer.param_groups]

    def zero_grad(self):
        for optimizer in self.optimizers:
            optimizer.zero_grad()

    def step(self):
        for optimizer in self.optimizers:
            optimizer.step()

    def state_dict(self):
        return [optimizer.state_dict() for optimizer in self.optimizers]

    def load_state_dict(self, states):
        for optimizer, state in zip(self.optimizers, states):
            optimizer.load_state_dict(state)


def make_optimizer(model, options):
    """What FitOptions ask for, one of OPTIMIZERS. Muon takes the matrices of a Llama's layers, AdamW all else: embeddings are tables, whose
    rows have nothing to do with each other."""
    settings = {"lr": options.rate, "weight_decay": options.weight_decay}
    if options.optimizer == "adamw":
        return torch.optim.AdamW(model.parameters(), betas=options.betas, **settings)
    named = [(name.startswith("layers.") and w.dim() == 2, w) for name, w in model.named_parameters()]
    return Together(
        Muon([w for matrix, w in named if matrix], **settings),
        torch.optim.AdamW([w for matrix, w in named if not matrix], betas=options.betas, **settings),
    )
