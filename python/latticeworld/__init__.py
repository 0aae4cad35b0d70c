"""LatticeWorld in this process, without ROS: worlds from words, simulations, learning loops.

World.generate() makes a world, Simulation steps it, make_env() and make_parallel() make environments
of Gymnasium and PettingZoo, and make_vec() steps many worlds at once by a crew of threads.
"""

import pkgutil

# ROS's messages are in a package of the same name: both are found where ROS's folders are in the
# path too.
__path__ = pkgutil.extend_path(__path__, __name__)

from ._core import ROBOT_FIELDS, SURFACES, Simulation, Snapshot, World  # noqa: E402
from .errors import (Cancelled, InvalidArgument, LatticeWorldError, NotFound,  # noqa: E402
                     OutOfMemory)
from .scanner import Scanner  # noqa: E402

__all__ = ["Cancelled", "GoalTask", "InvalidArgument", "LatticeWorldError", "LocalServer", "NotFound",
           "OutOfMemory", "ROBOT_FIELDS", "SURFACES", "Scanner", "ServerError", "Simulation",
           "Snapshot", "Task", "World", "make_env", "make_parallel", "make_vec"]

# What needs Gymnasium or PettingZoo is imported when it is asked for.
_LATER = {"GoalTask": "learning.task", "Task": "learning.task", "ServerError": "learning.errors",
          "LocalServer": "local", "make_env": "make", "make_parallel": "make", "make_vec": "make"}


def __getattr__(name):
    if name in _LATER:
        import importlib
        return getattr(importlib.import_module(f"{__name__}.{_LATER[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}; where ROS's messages are "
                         "meant, its folders have to be in the path")
