"""skrl learns with PPO over many worlds at once, given as Gymnasium's VectorEnv."""
# module: latticeworld
# shared: torch==2.15.0
# pypi: skrl==2.1.1 gymnasium==1.4.0 pettingzoo==1.27.0

import importlib.metadata

import torch
from skrl.envs.wrappers.torch import wrap_env
from skrl.utils import set_seed
from skrl.utils.runner.torch import Runner

import latticeworld as lw
from meadow import meadow
from peer import FOLDER, Peer

STEPS, ROLLOUT, LONGEST, COUNT = 192, 32, 10, 4


def settings(seed):
    parts = ", ".join(f"OBSERVATIONS['{name}']" for name in ("goal", "scan", "velocity"))
    layers = [{"name": "net", "input": f"concatenate([{parts}])", "layers": [32, 32],
               "activations": "elu"}]
    return {
        "seed": seed,
        "models": {"separate": True,
                   "policy": {"class": "GaussianMixin", "network": layers, "output": "ACTIONS"},
                   "value": {"class": "DeterministicMixin", "network": layers, "output": "ONE"}},
        "memory": {"class": "RandomMemory", "memory_size": -1},
        "agent": {"class": "PPO", "rollouts": ROLLOUT, "learning_epochs": 2, "mini_batches": 2,
                  "experiment": {"directory": str(FOLDER), "experiment_name": f"run{seed}",
                                 "write_interval": 0, "checkpoint_interval": 0}},
        "trainer": {"class": "SequentialTrainer", "timesteps": STEPS, "headless": True,
                    "disable_progressbar": True}}


class Watched:
    """How many steps of an environment's places come right after one that ended an episode, and of
    these how many had no reward: their action was not carried out."""

    def __init__(self, env):
        self.step_of, self.ended = env.step, None
        self.after = self.idle = 0
        env.step = self.step

    def step(self, actions):
        found = self.step_of(actions)
        if self.ended is not None:
            self.after += int(self.ended.sum())
            self.idle += int((self.ended & (found[1] == 0.0)).sum())
        self.ended = found[2] | found[3]
        return found


def learn(world, seed, mode="SameStep", first=True):
    """first: the seed is set before the environment is wrapped."""
    if first:
        set_seed(seed)
    env = lw.make_vec(COUNT, worlds=[world], max_actions=LONGEST, autoreset_mode=mode)
    watched = Watched(env)
    runner = Runner(wrap_env(env, wrapper="gymnasium", verbose=False), settings(seed))
    runner.run("train")
    weights = torch.nn.utils.parameters_to_vector(runner.agent.policy.parameters()).detach()
    env.close()
    return weights, watched


def main():
    torch.set_num_threads(1)
    peer = Peer("skrl", importlib.metadata.version("skrl"), "`make_vec`",
                "networks that put the parts of the observation together (`concatenate([...])`); "
                "`set_seed` before `wrap_env`, whose environment the Runner's seed does not reach; "
                "`make_vec(..., autoreset_mode=\"SameStep\")`: it learns from the step in which "
                "Gymnasium's `NextStep` only resets, as if its action had been carried out")
    world = lw.World.load(str(meadow()))
    first, same_step = learn(world, 1)
    again, _ = learn(world, 1)
    other, _ = learn(world, 2)
    peer.check(f"PPO, {STEPS} steps of {COUNT} worlds", bool(torch.isfinite(first).all()),
               f"{first.numel()} weights of the policy, all finite")
    peer.check("the same seed", torch.equal(first, again) and not torch.equal(first, other),
               "the same weights, bit for bit, after `set_seed` before `wrap_env`")
    set_seed(7)
    late, _ = learn(world, 1, first=False)
    peer.check("the seed of the Runner's configuration alone", not torch.equal(first, late),
               "other weights: the environment keeps the seed of before")
    _, next_step = learn(world, 1, "NextStep")
    peer.check("steps without effect after an episode's end",
               same_step.idle == 0 and next_step.idle == next_step.after > 0,
               f"{same_step.idle} of {same_step.after} with SameStep, {next_step.idle} of "
               f"{next_step.after} with NextStep")
    peer.finish()


main()
