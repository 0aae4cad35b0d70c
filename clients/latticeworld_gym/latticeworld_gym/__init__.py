"""Learning loops over a running LatticeWorld server.

LatticeWorldEnv is one robot with Gymnasium's interface, LatticeWorldParallelEnv several with
PettingZoo's parallel one. What a robot is rewarded for is a Task; GoalTask is the default.
"""

from .env import LatticeWorldEnv
from .parallel_env import LatticeWorldParallelEnv
from .server import Server, ServerError
from .task import GoalTask, Task
from .view import View

__all__ = ["GoalTask", "LatticeWorldEnv", "LatticeWorldParallelEnv", "Server", "ServerError",
           "Task", "View"]
