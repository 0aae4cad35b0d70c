"""Learning loops in LatticeWorld.

LatticeWorldEnv is one robot with Gymnasium's interface, LatticeWorldParallelEnv several with
PettingZoo's parallel one. What a robot is rewarded for is a Task; GoalTask is the default. The world
is a Server's: a running world_server over ROS; where `latticeworld` for Python is installed, one in
this process.
"""

from .env import LatticeWorldEnv
from .errors import ServerError
from .parallel_env import LatticeWorldParallelEnv
from .task import GoalTask, Task
from .view import View

__all__ = ["GoalTask", "LatticeWorldEnv", "LatticeWorldParallelEnv", "Server", "ServerError",
           "Task", "View"]


def __getattr__(name):
    if name == "Server":  # the rest needs no ROS
        from .server import Server
        return Server
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
