"""A world in this process, as environments know a running world_server."""

import types

import numpy as np

from . import _core
from .learning.errors import ServerError
from .learning.free_space import FreeSpace
from .learning.view import View


class LocalFreeSpace(FreeSpace):
    """The same places, found by the core."""

    def _reachable(self, row, column, reach):
        return _core.reachable(self._free, row, column, reach, self.NEAR)


class LocalServer:
    """One world and its simulation; what happens in it is what happens on a world_server.

    world: a World. sensors: as Simulation has it. Raises latticeworld.LatticeWorldError.
    """

    def __init__(self, world, sensors="scanner", **simulation):
        self._sensors, self._options = sensors, simulation
        self._closed = False
        self.load(world)

    def load(self, world):
        """Another world takes the place of this one, from the next reset on."""
        self._must_be_open("load")
        self.world = world
        self.world_id, self.size_m = world.id, world.size_m
        self.simulation = _core.Simulation(world, sensors=self._sensors, **self._options)
        self._free_spaces = {}

    def reset(self, seed):
        self._must_be_open("reset")
        self.simulation.reset(seed)

    def advance(self, velocities, steps, options):
        """({robot: View}, the state's hash where options.state_hash); see Server.advance."""
        self._must_be_open("advance")
        simulation = self.simulation
        for robot, (forward_mps, yaw_rate_radps) in velocities.items():
            simulation.command(robot, float(forward_mps), float(yaw_rate_radps))
        simulation.step(steps, list(velocities) if options.sectors > 0 else [])
        there = set(simulation.agents)
        events = simulation.events
        views = {}
        for robot in velocities:
            if robot not in there:
                continue
            scan_m = (simulation.sectors(robot, options.sectors, options.max_range_m)
                      if options.sectors > 0 else np.zeros(0, np.float32))
            views[robot] = view_of_row(robot, simulation.view(robot), scan_m, events)
        return views, simulation.hash() if options.state_hash else ""

    def spawn(self, name, **fields):
        """A controllable agent; fields: of Simulation.spawn, or of latticeworld/SpawnAgent."""
        self._must_be_open("spawn")
        return spawn(self.simulation, name, fields)

    def occupancy(self):
        """As nav_msgs/OccupancyGrid has it, row 0 south."""
        cells = self.world.occupancy_for(self._options.get("robot_species", "wheeled robot"))
        half_m = 0.5 * self.world.size_m
        place = types.SimpleNamespace(x=-half_m, y=-half_m)
        info = types.SimpleNamespace(resolution=float(np.float32(self.world.resolution_m)),
                                     width=cells.shape[1], height=cells.shape[0],
                                     origin=types.SimpleNamespace(position=place))
        return types.SimpleNamespace(info=info, data=cells[::-1].ravel())

    def footprint_radius(self, robot):
        """Radius of the circle around base_link that holds the robot's body in plan [m]."""
        return self.simulation.agent(robot)["radius_m"]

    def free_space(self, clearance_m):
        if clearance_m not in self._free_spaces:
            self._free_spaces[clearance_m] = LocalFreeSpace(self.occupancy(), clearance_m)
        return self._free_spaces[clearance_m]

    def close(self):
        self._closed = True

    def _must_be_open(self, name):
        if self._closed:
            raise ServerError(f"{name}: the environment is closed; make another one")


def spawn(simulation, name, fields):
    fields = dict(fields)
    position = fields.pop("position", None)
    if position is not None:  # geometry_msgs/Point, or (x, y)
        fields["position_m"] = ((position.x, position.y) if hasattr(position, "x")
                                else tuple(position)[:2])
    if "heading" in fields:
        fields["heading_rad"] = fields.pop("heading")
    return simulation.spawn(name, **fields)


def view_of_row(robot, row, scan_m, events):
    """row: values of _core.ROBOT_FIELDS. events: of the whole call."""
    x_m, y_m, _, yaw_rad, forward_mps, yaw_rate_radps, health, contact_n, alive = row
    return View(robot, x_m, y_m, yaw_rad, forward_mps, yaw_rate_radps, bool(alive), health,
                contact_n, scan_m, [event["kind"] for event in events if event["agent"] == robot])
