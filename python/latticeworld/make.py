"""Environments over worlds in this process."""

from . import _core
from .batch import MOST_WORLDS, Batch
from .learning.env import LatticeWorldEnv
from .learning.episode import EpisodeOptions
from .learning.parallel_env import LatticeWorldParallelEnv
from .learning.task import GoalTask
from .local import LocalServer
from .worlds import Worlds, of_list, of_words

LAYOUT = "Flat grassland, some trees."
ENVIRONMENT = "A sunny summer noon. A wheeled robot waits in the center."


def make_env(world, robot="robot", task=None, sensors="scanner", simulation=None, **options):
    """One robot of one world: Gymnasium's Env.

    world: a World. task: a Task; None: GoalTask(). sensors, simulation: as of Simulation. options:
    fields of EpisodeOptions (docs/learning.md).
    """
    EpisodeOptions(**options)  # what is wrong in it shows before anything is made
    env = LatticeWorldEnv(robot, task, LocalServer(world, sensors, **(simulation or {})), **options)
    env._owns_server = True
    return env


def make_parallel(world, robots, spawn=None, task=None, sensors="scanner", simulation=None,
                  **options):
    """Several robots of one world: PettingZoo's ParallelEnv. As LatticeWorldParallelEnv."""
    EpisodeOptions(**options)
    env = LatticeWorldParallelEnv(robots, spawn, task,
                                  LocalServer(world, sensors, **(simulation or {})), **options)
    env._owns_server = True
    return env


def make_vec(n_worlds, robots="robot", task=None, sensors="scanner", *, interface="gymnasium",
             worlds=None, layout=LAYOUT, environment=ENVIRONMENT, world_seed=1, size_m=64.0,
             resolution_m=0.5, episodes_per_world=0, threads=0, spawn=None,
             autoreset_mode="NextStep", copy=True, simulation=None, **options):
    """Many worlds at once, stepped by a crew of threads.

    n_worlds: how many. robots: a name, or several with PettingZoo's interface. task: makes a robot's
    Task from its name; None: GoalTask(). sensors, simulation: as of Simulation. interface:
    "gymnasium" (VectorEnv) or "pettingzoo" (ParallelEnv).

    Which worlds: a list that is gone round, or a function of a number 0, 1, 2 ... that answers a
    World or the arguments of World.generate; or layout and environment (a text, or a list of texts
    that is gone round) with seeds that count up from world_seed. Place i begins with number i, and
    has number i + n_worlds * j after j times episodes_per_world episodes (0: it keeps the first);
    those are made on a thread of their own while the last episode before runs.

    threads: 0: as many as cores. spawn: {robot: fields of Simulation.spawn} for robots that worlds
    do not have by themselves. options: fields of EpisodeOptions (docs/learning.md).
    Raises ValueError, TypeError, and OutOfMemory before so many worlds are made that do not fit.
    """
    if isinstance(n_worlds, bool) or not isinstance(n_worlds, int) or not (
            1 <= n_worlds <= MOST_WORLDS):
        raise ValueError(f"n_worlds is {n_worlds!r}; legal is a whole number in 1 .. {MOST_WORLDS}")
    if interface not in ("gymnasium", "pettingzoo"):
        raise ValueError(f"interface is {interface!r}; legal are \"gymnasium\" and \"pettingzoo\"")
    if not isinstance(threads, int) or not 0 <= threads <= 256:
        raise ValueError(f"threads is {threads!r}; legal is 0 (as many as cores) .. 256")
    if not isinstance(episodes_per_world, int) or episodes_per_world < 0:
        raise ValueError(f"episodes_per_world is {episodes_per_world!r}; legal is 0 (one world for "
                         "good) and more")
    names = [robots] if isinstance(robots, str) else list(robots)
    if not names or len(set(names)) < len(names) or (interface == "gymnasium" and len(names) > 1):
        raise ValueError(f"robots is {robots!r}; legal are names, each once; one alone with "
                         "Gymnasium's interface")
    episode_options = EpisodeOptions(**options)
    draw = of_words(layout, environment, world_seed, size_m=size_m, resolution_m=resolution_m)
    if worlds is not None:
        draw = worlds if callable(worlds) else of_list(worlds)
    batch = Batch(n_worlds, names, task or (lambda robot: GoalTask()), episode_options, Worlds(draw),
                  sensors, threads, spawn, episodes_per_world, **(simulation or {}))
    if interface == "pettingzoo":
        from .parallel_vec_env import LatticeWorldParallelVecEnv
        return LatticeWorldParallelVecEnv(batch)
    from .vector_env import LatticeWorldVectorEnv
    return LatticeWorldVectorEnv(batch, autoreset_mode, copy)
