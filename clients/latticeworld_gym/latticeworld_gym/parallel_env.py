"""Several robots with PettingZoo's parallel interface."""

from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from .episode import Episode, EpisodeOptions
from .task import GoalTask


class LatticeWorldParallelEnv(ParallelEnv):
    """Controllable robots of a running world_server that act at the same time.

    Actions and observations are those of LatticeWorldEnv, each by the robot's name; adversaries stay
    with the simulator's own minds. A robot whose task has ended leaves `agents` and stands still.

    robots: their names. spawn: {robot: fields of latticeworld/SpawnAgent} for those that are not in
    the world's start state: they are made after every reset. task: makes a robot's Task from its
    name; None: GoalTask(). server and others: as LatticeWorldEnv. Raises ServerError.
    """

    metadata = {"render_modes": [], "name": "latticeworld_v0"}
    render_mode = None  # PettingZoo's conversions warn where it is missing

    def __init__(self, robots, spawn=None, task=None, server=None, **options):
        episode_options = EpisodeOptions(**options)
        self.possible_agents = list(robots)
        if not self.possible_agents or len(set(self.possible_agents)) < len(self.possible_agents):
            raise ValueError(f"robots is {self.possible_agents}; legal are one or more names, each "
                             "once")
        unknown = sorted(set(spawn or {}) - set(self.possible_agents))
        if unknown:
            raise ValueError(f"spawn names {', '.join(unknown)}; legal are names of robots: "
                             f"{', '.join(self.possible_agents)}")
        self.agents = []
        self._owns_server = server is None
        if server is None:
            from .server import Server  # needs ROS
            server = Server()
        self._server = server
        tasks = {robot: task(robot) if task is not None else GoalTask()
                 for robot in self.possible_agents}
        self._episode = Episode(self._server, tasks, episode_options, spawn)
        # PettingZoo wants the same object at every call.
        self._observation_spaces = {robot: self._episode.observation_space(robot)
                                    for robot in self.possible_agents}
        self._action_spaces = {robot: self._episode.action_space()
                               for robot in self.possible_agents}
        self._rng = None

    def observation_space(self, agent):
        return self._observation_spaces[agent]

    def action_space(self, agent):
        return self._action_spaces[agent]

    def reset(self, seed=None, options=None):
        if seed is not None or self._rng is None:
            self._rng, _ = seeding.np_random(seed)
        observations, infos = self._episode.begin(self._rng)
        self.agents = list(self.possible_agents)
        return observations, infos

    def step(self, actions):
        """actions: of every robot in `agents`."""
        if set(actions) != set(self.agents):
            raise ValueError(f"there are actions of {sorted(actions)}; legal are those of all "
                             f"agents: {sorted(self.agents)}")
        if not actions:
            return {}, {}, {}, {}, {}
        observations, rewards, terminations, truncated, infos = self._episode.advance(
            {robot: actions[robot] for robot in self.agents})
        truncations = {robot: truncated for robot in self.agents}
        self.agents = [robot for robot in self.agents
                       if not (terminations[robot] or truncations[robot])]
        return observations, rewards, terminations, truncations, infos

    def close(self):
        if self._owns_server:
            self._server.close()
