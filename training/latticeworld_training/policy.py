"""A policy that drives a robot to a goal by what its scanner sees: its input, its network, and its file."""

import torch
from torch import nn

SECTORS = 36  # of the scan, from right to left
RANGE_M = 20.0
LEAST_ACTION = (-0.3, -1.2)  # forward [m/s], yaw rate [rad/s]
MOST_ACTION = (1.0, 1.2)
INPUTS = SECTORS + 5
WIDTH = 128


def features(observations):
    """What the network is given of observations: dict of arrays `scan` (n, SECTORS) [m], `velocity` (n, 2)
    [m/s, rad/s] and `goal` (n, 2) [m, in base_link] -> (n, INPUTS) float32. Near things count most: a return at d is
    1 / (1 + d); the goal is its direction and d / (1 + d)."""
    scan, velocity, goal = (torch.as_tensor(observations[name]).float() for name in ("scan", "velocity", "goal"))
    distance = goal.norm(dim=1, keepdim=True).clamp(min=1e-6)
    return torch.cat((1.0 / (1.0 + scan), velocity, goal / distance, distance / (1.0 + distance)), 1)


def layers(outputs, gain):
    """Two hidden layers of tanh, with the orthogonal beginning that is usual for policies."""
    parts = []
    for inputs in (INPUTS, WIDTH):
        linear = nn.Linear(inputs, WIDTH)
        nn.init.orthogonal_(linear.weight, 2.0**0.5)
        nn.init.zeros_(linear.bias)
        parts += [linear, nn.Tanh()]
    last = nn.Linear(WIDTH, outputs)
    nn.init.orthogonal_(last.weight, gain)
    nn.init.zeros_(last.bias)
    return nn.Sequential(*parts, last)


class Policy(nn.Module):
    """The mean and the spread of actions, each in -1 .. 1 of what is allowed, and what is to be expected of rewards."""

    def __init__(self):
        super().__init__()
        self.actor = layers(2, 0.01)
        self.critic = layers(1, 1.0)
        self.log_spread = nn.Parameter(torch.full((2,), -0.5))

    def distribution(self, inputs):
        return torch.distributions.Normal(self.actor(inputs), self.log_spread.exp().expand(len(inputs), 2))

    def value(self, inputs):
        return self.critic(inputs).squeeze(1)


def action_of(drawn):
    """(n, 2) of the distribution -> forward [m/s] and yaw rate [rad/s]."""
    least, most = torch.tensor(LEAST_ACTION), torch.tensor(MOST_ACTION)
    return least + (drawn.clamp(-1.0, 1.0) + 1.0) / 2.0 * (most - least)


def write_onnx(policy, path):
    """The mean action as ONNX: `features` (n, INPUTS) -> `action` (n, 2), forward [m/s] and yaw rate [rad/s]."""
    import onnx
    from onnx import TensorProto, helper, numpy_helper

    nodes, weights, before = [], [], "features"
    linears = [part for part in policy.actor if isinstance(part, nn.Linear)]
    for number, linear in enumerate(linears):
        for name, values in (("weight", linear.weight), ("bias", linear.bias)):
            weights.append(numpy_helper.from_array(values.detach().numpy(), f"{name}{number}"))
        nodes.append(helper.make_node("Gemm", [before, f"weight{number}", f"bias{number}"], [f"sum{number}"], transB=1))
        before = f"sum{number}"
        if number + 1 < len(linears):
            nodes.append(helper.make_node("Tanh", [before], [f"hidden{number}"]))
            before = f"hidden{number}"
    least, most = torch.tensor(LEAST_ACTION), torch.tensor(MOST_ACTION)
    for name, values in (("one", torch.tensor(1.0)), ("minus_one", torch.tensor(-1.0)),
                         ("half_span", (most - least) / 2.0), ("middle", (most + least) / 2.0)):
        weights.append(numpy_helper.from_array(values.numpy(), name))
    nodes += [helper.make_node("Clip", [before, "minus_one", "one"], ["share"]),
              helper.make_node("Mul", ["share", "half_span"], ["about"]),
              helper.make_node("Add", ["about", "middle"], ["action"])]
    graph = helper.make_graph(
        nodes, "goal_policy", [helper.make_tensor_value_info("features", TensorProto.FLOAT, ["n", INPUTS])],
        [helper.make_tensor_value_info("action", TensorProto.FLOAT, ["n", 2])], weights)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], producer_name="latticeworld")
    model.ir_version = 8
    onnx.checker.check_model(model)
    onnx.save(model, path)
