"""Teaches a wheeled robot to reach goals by scan, in generated worlds, by PPO (Schulman et al. 2017).

    python3 -m latticeworld_training.train_policy --out run --minutes 50
    python3 -m latticeworld_training.train_policy --out run --export models/goal_policy.onnx

Needs the module `latticeworld` (docs/learning.md) and PyTorch; --export also onnx. The same command again goes on
where it was interrupted. Worlds are drawn anew every few episodes, beside those that run.
"""

import argparse
import os
import time

import numpy as np
import torch

from .checkpoint import load_checkpoint, save_checkpoint
from .curves import LossCurve
from .policy import LEAST_ACTION, MOST_ACTION, RANGE_M, SECTORS, Policy, action_of, features, write_onnx

LAYOUTS = (
    "Flat grassland, some trees.", "A wood with clearings.", "A village with streets, gardens around it.",
    "Gentle hills of grass with scattered trees.", "Grassland with rocks scattered around.",
    "An orchard and fields, a few houses.", "Houses and roads everywhere.", "A meadow between two woods.",
)
ENVIRONMENT = "A sunny summer noon. A wheeled robot waits in the center."
STEPS = 128  # of every world between two lessons
EPOCHS, PARTS = 4, 8  # of a lesson: passes over its steps, and pieces of a pass
DISCOUNT, TRACE = 0.99, 0.95  # of rewards to come, and of their estimates (GAE, Schulman et al. 2016)
CLIP, VALUE_SHARE, ENTROPY_SHARE = 0.2, 0.5, 0.003
SAVED_EVERY_S = 120.0
FIRST_WORLD = 100000  # worlds of training have seeds from here on


def make_worlds(given):
    import latticeworld as lw

    return lw.make_vec(
        given.worlds, layout=list(LAYOUTS), environment=ENVIRONMENT, world_seed=FIRST_WORLD + given.seed,
        episodes_per_world=8, threads=given.threads, autoreset_mode="SameStep", max_actions=400,
        task=lambda robot: lw.GoalTask(distance_m=(3.0, 24.0)), sectors=SECTORS, max_range_m=RANGE_M,
        forward_mps=(LEAST_ACTION[0], MOST_ACTION[0]), yaw_rate_radps=(LEAST_ACTION[1], MOST_ACTION[1]))


class Steps:
    """STEPS steps of all worlds: (STEPS, worlds, ...)."""

    def __init__(self, worlds):
        from .policy import INPUTS

        self.inputs = torch.zeros(STEPS, worlds, INPUTS)
        self.drawn = torch.zeros(STEPS, worlds, 2)
        self.log_probability, self.rewards, self.values, self.ended = (torch.zeros(STEPS, worlds) for _ in range(4))

    def advantages(self, next_value):
        """Estimates of what an action was better by than what was expected, and of the rewards to come."""
        better, found = torch.zeros_like(next_value), torch.zeros_like(self.rewards)
        for t in reversed(range(STEPS)):
            goes_on = 1.0 - self.ended[t]
            after = self.values[t + 1] if t + 1 < STEPS else next_value
            better = self.rewards[t] + DISCOUNT * goes_on * after - self.values[t] + DISCOUNT * TRACE * goes_on * better
            found[t] = better
        return found, found + self.values


class Driver:
    """Drives all worlds with a policy, and counts how episodes end."""

    def __init__(self, env, seed):
        self.env = env
        observations, _ = env.reset(seed=seed)
        self.inputs = features(observations)
        self.reached, self.episodes = 0, 0

    def drive(self, policy, steps):
        for t in range(STEPS):
            with torch.no_grad():
                distribution = policy.distribution(self.inputs)
                drawn = distribution.sample()
                steps.values[t] = policy.value(self.inputs)
            steps.inputs[t], steps.drawn[t] = self.inputs, drawn
            steps.log_probability[t] = distribution.log_prob(drawn).sum(1)
            observations, rewards, terminated, truncated, infos = self.env.step(action_of(drawn).numpy())
            steps.rewards[t] = torch.as_tensor(rewards).float()
            if truncated.any():  # the episode was cut off, not at its end: what would have come counts
                self.add_cut_off(policy, steps, t, truncated, infos)
            steps.ended[t] = torch.as_tensor(terminated | truncated).float()
            self.count(terminated | truncated, infos)
            self.inputs = features(observations)

    @staticmethod
    def add_cut_off(policy, steps, t, truncated, infos):
        for world in np.flatnonzero(truncated):
            last = {name: np.asarray(value)[None] for name, value in infos["final_obs"][world].items()}
            with torch.no_grad():
                steps.rewards[t, world] += DISCOUNT * policy.value(features(last))[0]

    def count(self, over, infos):
        if not over.any():
            return
        self.episodes += int(over.sum())
        self.reached += int(np.sum(np.asarray(infos["final_info"]["is_success"], bool) & over))


def learn(policy, optimizer, steps, next_value):
    """One lesson of PPO. Returns the mean loss."""
    advantages, returns = steps.advantages(next_value)
    inputs, drawn = steps.inputs.flatten(0, 1), steps.drawn.flatten(0, 1)
    before, advantages, returns = (part.flatten() for part in (steps.log_probability, advantages, returns))
    advantages = (advantages - advantages.mean()) / (advantages.std() + 1e-8)
    losses = []
    for _ in range(EPOCHS):
        for part in torch.randperm(len(inputs)).chunk(PARTS):
            distribution = policy.distribution(inputs[part])
            ratio = (distribution.log_prob(drawn[part]).sum(1) - before[part]).exp()
            gain = torch.min(ratio * advantages[part], ratio.clamp(1.0 - CLIP, 1.0 + CLIP) * advantages[part]).mean()
            error = (policy.value(inputs[part]) - returns[part]).square().mean()
            loss = -gain + VALUE_SHARE * error - ENTROPY_SHARE * distribution.entropy().sum(1).mean()
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(policy.parameters(), 0.5)
            optimizer.step()
            losses.append(float(loss.detach()))
    return float(np.mean(losses))


def train(given, policy, optimizer, checkpoint, spent, lessons):
    curve = LossCurve(os.path.join(given.out, "reached.csv"), ["reached", "reward"])
    curve.keep_until(lessons * STEPS * given.worlds)
    env = make_worlds(given)
    driver, steps = Driver(env, given.seed + lessons), Steps(given.worlds)
    # A processor that others use as well does not shorten the lesson.
    began = time.process_time()
    worked = lambda: spent + time.process_time() - began
    saved = worked()
    try:
        while worked() < 60.0 * given.minutes:
            for group in optimizer.param_groups:
                group["lr"] = given.rate * max(0.05, 1.0 - worked() / (60.0 * given.minutes))
            driver.drive(policy, steps)
            with torch.no_grad():
                next_value = policy.value(driver.inputs)
            learn(policy, optimizer, steps, next_value)
            lessons += 1
            if driver.episodes >= 100:
                share, reward = driver.reached / driver.episodes, float(steps.rewards.mean())
                curve.add(lessons * STEPS * given.worlds, reached=share, reward=reward)
                print(f"{worked() / 60:.1f} min, {lessons * STEPS * given.worlds} decisions: {share:.2f} of "
                      f"{driver.episodes} episodes reached their goal", flush=True)
                driver.reached, driver.episodes = 0, 0
            if worked() - saved > SAVED_EVERY_S:
                saved = worked()
                save_checkpoint(checkpoint, policy, optimizer, spent=saved, lessons=lessons)
    finally:
        env.close()
    save_checkpoint(checkpoint, policy, optimizer, spent=worked(), lessons=lessons)
    curve.draw(os.path.join(given.out, "reached.png"), "share of episodes that reached their goal, reward an action")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True, help="folder of the run")
    parser.add_argument("--minutes", type=float, default=50.0, help="of all processors' time together [50]")
    parser.add_argument("--worlds", type=int, default=32, help="side by side [32]")
    parser.add_argument("--threads", type=int, default=0, help="that step worlds; 0: as many as cores [0]")
    parser.add_argument("--rate", type=float, default=3e-4, help="of learning, falling to a twentieth [0.0003]")
    parser.add_argument("--seed", type=int, default=1, help="[1]")
    parser.add_argument("--export", metavar="FILE", help="writes the run's policy as ONNX, and does nothing else")
    given = parser.parse_args(arguments)

    torch.manual_seed(given.seed)
    torch.set_num_threads(1)
    os.makedirs(given.out, exist_ok=True)
    policy = Policy()
    optimizer = torch.optim.Adam(policy.parameters(), lr=given.rate, eps=1e-5)
    checkpoint = os.path.join(given.out, "policy.pt")
    rest = load_checkpoint(checkpoint, policy, optimizer) if os.path.exists(checkpoint) else {"spent": 0.0, "lessons": 0}
    if given.export:
        write_onnx(policy, given.export)
    else:
        train(given, policy, optimizer, checkpoint, **rest)


if __name__ == "__main__":
    main()
