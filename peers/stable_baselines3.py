"""Stable-Baselines3 learns with PPO over environments of one world, and loads what it learned."""
# module: latticeworld
# shared: torch==2.15.0
# pypi: stable-baselines3==2.9.2 gymnasium==1.4.0 pettingzoo==1.27.0

import numpy
import stable_baselines3
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.env_checker import check_env
from stable_baselines3.common.env_util import make_vec_env
from stable_baselines3.common.evaluation import evaluate_policy
from stable_baselines3.common.vec_env import VecNormalize

import latticeworld as lw
from meadow import meadow
from peer import FOLDER, Peer

STEPS = 512


def learn(world, seed):
    """A policy after two updates."""
    env = make_vec_env(lambda: lw.make_env(world, max_actions=30), n_envs=2, seed=seed)
    normal = VecNormalize(env, norm_obs_keys=["scan", "goal"])
    model = PPO("MultiInputPolicy", normal, n_steps=STEPS // 4, batch_size=64, n_epochs=2, seed=seed,
                device="cpu")
    model.learn(STEPS)
    return model


def weights(model):
    return torch.nn.utils.parameters_to_vector(model.policy.parameters()).detach().numpy()


def main():
    torch.set_num_threads(1)
    peer = Peer("Stable-Baselines3", stable_baselines3.__version__, "`make_env`",
                "`MultiInputPolicy`, and `make_vec_env`, as `make_vec` is Gymnasium's VectorEnv and "
                "not its VecEnv")
    world = lw.World.load(str(meadow()))
    check_env(lw.make_env(world, max_actions=30), skip_render_check=True)
    peer.check("check_env", True, "nothing wrong")
    model, again = learn(world, 1), learn(world, 1)
    other = weights(learn(world, 2))
    peer.check(f"PPO, {STEPS} steps", numpy.isfinite(weights(model)).all(),
               f"{weights(model).size} weights, all finite; VecNormalize takes the observations")
    peer.check("the same seed", numpy.array_equal(weights(model), weights(again)) and
               not numpy.array_equal(weights(model), other), "the same weights, bit for bit")
    model.save(FOLDER / "model.zip")
    loaded = PPO.load(FOLDER / "model.zip", device="cpu")
    peer.check("saved and loaded", numpy.array_equal(weights(model), weights(loaded)),
               "the same weights")
    env = model.get_env()
    env.training = False
    rewards, lengths = evaluate_policy(model, env, n_eval_episodes=4, return_episode_rewards=True,
                                       warn=False)
    peer.check("evaluate_policy", all(0 < length <= 30 for length in lengths),
               f"episodes of {lengths} actions, return {numpy.mean(rewards):.2f}")
    try:
        PPO("MultiInputPolicy", lw.make_vec(2, worlds=[world]), device="cpu")
        refused = ""
    except Exception as error:  # whatever it says
        refused = f"{type(error).__name__}: {error}"
    peer.check("make_vec given as it is", bool(refused), f"refused: {refused[:120]}")
    peer.finish()


main()
