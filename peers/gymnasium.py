"""Gymnasium checks the environments of a world in process and of a running world_server, and steps
them in its vector modes."""
# site: system
# module: latticeworld
# debian: python3-rospy
# pypi: gymnasium==1.4.0 pettingzoo==1.27.0 numpy==2.4.6

import warnings

import gymnasium
import numpy
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv

import latticeworld as lw
from meadow import meadow
from peer import FOLDER, Peer
from ros import Launch

ACTIONS, LONGEST, COUNT = 16, 6, 2


def make_one():
    return lw.make_env(lw.World.load(str(meadow())), max_actions=LONGEST)


def bits(observation):
    return b"".join(numpy.ascontiguousarray(observation[name]).tobytes()
                    for name in sorted(observation))


def complaints(env):
    """What check_env says, by the first words."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        check_env(env, skip_render_check=True)
    return sorted({str(one.message).replace("\x1b[33mWARN: ", "").split(".")[0] for one in said
                   if issubclass(one.category, UserWarning)})


def roll(env, seed=5):
    """The bits of a vector's observations and infos' keys under the same actions."""
    seen, _ = env.reset(seed=seed)
    found = [bits(seen)]
    for i in range(ACTIONS):
        actions = numpy.stack([[1.0, numpy.sin(i + k)] for k in range(env.num_envs)])
        seen, rewards, ended, cut, _ = env.step(actions.astype("f4"))
        found += [bits(seen), rewards.astype("f8").tobytes(), ended.tobytes(), cut.tobytes()]
    env.close()
    return found


def check_in_process(peer):
    env = make_one()
    said = complaints(env)
    env.close()
    peer.check("check_env in process", True, "no error; warns: " + ("; ".join(said) or "nothing"))
    world = lw.World.load(str(meadow()))
    for mode in ("NextStep", "SameStep"):
        ours = roll(lw.make_vec(COUNT, worlds=[world], max_actions=LONGEST, autoreset_mode=mode))
        sync = roll(SyncVectorEnv([make_one] * COUNT, autoreset_mode=mode))
        both = roll(AsyncVectorEnv([make_one] * COUNT, autoreset_mode=mode, context="spawn"))
        peer.check(f"make_vec, SyncVectorEnv and AsyncVectorEnv, {mode}", ours == sync == both,
                   f"the same bits over {ACTIONS} steps with episodes that end")
    recorded = gymnasium.wrappers.vector.RecordEpisodeStatistics(
        lw.make_vec(COUNT, worlds=[world], max_actions=LONGEST))
    recorded.reset(seed=1)
    lengths = []
    for _ in range(ACTIONS):
        *_, infos = recorded.step(recorded.action_space.sample())
        if "episode" in infos:
            lengths += infos["episode"]["l"][infos["_episode"]].tolist()
    recorded.close()
    peer.check("RecordEpisodeStatistics", set(lengths) <= set(range(1, LONGEST + 1)) and lengths,
               f"lengths {lengths}")


def check_over_ros(peer):
    """A python of its own: the client's module needs ROS's messages under the name latticeworld."""
    program = FOLDER / "over_ros.py"
    program.write_text("""
import warnings
from gymnasium.utils.env_checker import check_env
from latticeworld_gym import LatticeWorldEnv
env = LatticeWorldEnv()
with warnings.catch_warnings(record=True):
    warnings.simplefilter("always")
    check_env(env, skip_render_check=True)
first = env.reset(seed=4)[0]["goal"].tobytes() == env.reset(seed=4)[0]["goal"].tobytes()
print("FOUND no error, the same seed the same goal:", first)
env.close()
""")
    with Launch("world.launch", sensor_suite="scanner", size=64, seed=3,
                generate="Flat grassland, some trees.",
                environment="A wheeled robot waits in the center.") as server:
        done = server.python(program)
    found = [line for line in done.splitlines() if line.startswith("FOUND ")]
    peer.check("check_env over ROS", found and found[0].endswith("True"),
               found[0][6:] if found else done[-400:])


def main():
    peer = Peer("Gymnasium", gymnasium.__version__, "`make_env`, `make_vec`, `LatticeWorldEnv`",
                "AsyncVectorEnv with `context=\"spawn\"`; several environments over ROS each with a "
                "master and a server")
    check_in_process(peer)
    check_over_ros(peer)
    peer.finish()


if __name__ == "__main__":
    main()
