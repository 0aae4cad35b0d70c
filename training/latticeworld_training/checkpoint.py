"""What a run needs to go on as if it had never been interrupted."""

import random

import numpy
import torch

from .whole_files import whole_file


def save_checkpoint(path, model, optimizer, **rest):
    """Writes weights, optimizer, random states and `rest`; the file is whole or is the one before."""
    state = {
        "model": model.state_dict(),
        "optimizer": optimizer.state_dict(),
        "torch_random": torch.get_rng_state(),
        "cuda_random": torch.cuda.get_rng_state_all() if torch.cuda.is_available() else [],
        "numpy_random": numpy.random.get_state(),
        "python_random": random.getstate(),
        "rest": rest,
    }
    with whole_file(path, "wb") as file:
        torch.save(state, file)


def read_checkpoint(path):
    """The state that save_checkpoint wrote. The file is one's own: it is unpickled."""
    if tuple(int(part) for part in torch.__version__.split(".")[:2]) >= (2, 4):
        return torch.load(path, map_location="cpu", weights_only=False)
    return torch.load(path, map_location="cpu")


def load_checkpoint(path, model, optimizer):
    """Puts everything back and returns `rest`."""
    state = read_checkpoint(path)
    model.load_state_dict(state["model"])
    optimizer.load_state_dict(state["optimizer"])
    torch.set_rng_state(state["torch_random"])
    if torch.cuda.is_available() and state["cuda_random"]:
        torch.cuda.set_rng_state_all(state["cuda_random"])
    numpy.random.set_state(state["numpy_random"])
    random.setstate(state["python_random"])
    return state["rest"]
