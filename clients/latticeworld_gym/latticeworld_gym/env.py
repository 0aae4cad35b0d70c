"""One robot with Gymnasium's interface."""

import gymnasium

from .episode import Episode, EpisodeOptions
from .task import GoalTask


class LatticeWorldEnv(gymnasium.Env):
    """A controllable robot of a running world_server, which stays paused meanwhile, or of a world in
    this process.

    Action: (forward [m/s], yaw rate [rad/s]), held for steps_per_action fixed steps. Observation:
    a dict of "velocity" (forward [m/s], yaw rate [rad/s]), "scan" (nearest return of each sector
    [m], from right to left) and what the task adds. Same seed and actions: the same observations,
    bit for bit, on the same build of the server.

    robot: its name. task: a Task; None: GoalTask(). server: a Server to share; None: one of its own,
    which close() ends: time runs again if it ran before. Others: fields of EpisodeOptions.
    Raises ServerError.
    """

    metadata = {"render_modes": []}

    def __init__(self, robot="robot", task=None, server=None, **options):
        episode_options = EpisodeOptions(**options)  # what is wrong in it shows without a server
        self.robot = robot
        self.task = task if task is not None else GoalTask()
        self._owns_server = server is None
        if server is None:
            from .server import Server  # needs ROS
            server = Server()
        self._server = server
        self._episode = Episode(self._server, {robot: self.task}, episode_options)
        self.action_space = self._episode.action_space()
        self.observation_space = self._episode.observation_space(robot)

    def reset(self, *, seed=None, options=None):
        """The world's start state. Without a seed episodes go on to differ; options: unused."""
        super().reset(seed=seed)
        observations, infos = self._episode.begin(self.np_random)
        return observations[self.robot], infos[self.robot]

    def step(self, action):
        observations, rewards, terminations, truncated, infos = self._episode.advance(
            {self.robot: action})
        return (observations[self.robot], rewards[self.robot], terminations[self.robot], truncated,
                infos[self.robot])

    def close(self):
        if self._owns_server:
            self._server.close()
