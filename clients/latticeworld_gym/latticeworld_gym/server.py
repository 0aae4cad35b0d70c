"""The services of world_server that a learning loop needs, over connections that stay open."""

import numpy
import rosgraph
import rospy
from geometry_msgs.msg import Twist, Vector3
from nav_msgs.srv import GetMap
from std_srvs.srv import Trigger

from latticeworld.msg import AgentCommand, Status
from latticeworld.srv import (GetWorld, Lockstep, LockstepRequest, LockstepResponse, ResetWorld,
                              SpawnAgent)

from .errors import ServerError
from .free_space import FreeSpace
from .view import view_of


class NumpyResponse(LockstepResponse):
    """Its arrays of numbers are numpy's, which are read far quicker than tuples."""

    def deserialize(self, data):
        return self.deserialize_numpy(data, numpy)


class NumpyLockstep(Lockstep):
    _request_class = LockstepRequest
    _response_class = NumpyResponse


SERVICES = {"lockstep": NumpyLockstep, "reset_world": ResetWorld, "get_world": GetWorld,
            "spawn_agent": SpawnAgent, "static_map": GetMap, "pause": Trigger, "unpause": Trigger}
HOW_TO_START = ('start one with: roslaunch latticeworld world.launch generate:="Flat grassland '
                'everywhere." environment:="A wheeled robot waits in the center."')


class Server:
    """A running world_server, paused for as long as this is open.

    Needs a world (generate_world or load_world). Makes the process a ROS node unless it is one.
    timeout_s: wall time that services may take to appear. Raises ServerError.
    """

    def __init__(self, timeout_s=10.0):
        self._closed = True
        if not rosgraph.is_master_online():
            raise ServerError(f"no ROS master at {rosgraph.get_master_uri()} (ROS_MASTER_URI); "
                              + HOW_TO_START)
        if not rospy.core.is_initialized():
            rospy.init_node("latticeworld_gym", anonymous=True, disable_signals=True)
        self._calls = {}
        for name, kind in SERVICES.items():
            try:
                rospy.wait_for_service(name, timeout=timeout_s)
            except rospy.ROSException as error:
                raise ServerError(f"no service {name} within {timeout_s} s (all of "
                                  f"{', '.join(SERVICES)} are needed): is world_server running? "
                                  + HOW_TO_START) from error
            self._calls[name] = rospy.ServiceProxy(name, kind, persistent=name == "lockstep")
        self._episode = 0  # of the last reset; 0: any
        self._species = {}  # of the agents of the last lockstep call, by name
        self._closed = False
        world = self._look_at_world()
        self._was_paused = world.paused
        if not world.paused:
            self._call("pause")

    def reset(self, seed):
        """Back to the start state; seed: of behaviour and noise, 1 .. 2^64 - 1, 0: as it is.

        From now on lockstep() is held to the episode that begins: where somebody else resets the
        world in between, it raises ServerError. Another world than before is looked at anew.
        """
        answer = self._call("reset_world", seed=seed)
        self._episode = answer.episode
        if answer.world_id != self.world_id:
            self._look_at_world()
        return answer

    def lockstep(self, velocities, steps, scan=False, observe=(), strikes=(), state_hash=False):
        """velocities: {agent: (forward [m/s], yaw rate [rad/s])}. The Lockstep response."""
        commands = [AgentCommand(agent=agent, velocity=Twist(linear=Vector3(x=float(forward)),
                                                             angular=Vector3(z=float(yaw_rate))))
                    for agent, (forward, yaw_rate) in velocities.items()]
        answer = self._call("lockstep", commands=commands, steps=steps, scan=scan,
                            observe=list(observe), strikes=list(strikes), hash=state_hash,
                            episode=self._episode)
        self._species = {one.state.name: one.state.species for one in answer.observations}
        return answer

    def advance(self, velocities, steps, options):
        """What an Episode asks for: ({robot: View} of those that are in the world, the state's hash
        where options.state_hash). velocities: as of lockstep(); options: EpisodeOptions."""
        answer = self.lockstep(velocities, steps, scan=options.sectors > 0,
                               state_hash=options.state_hash)
        views = {observation.state.name: view_of(observation, answer.events, options.sectors,
                                                 options.max_range_m)
                 for observation in answer.observations}
        return views, answer.state_hash

    def spawn(self, name, **fields):
        """A controllable agent; fields: of latticeworld/SpawnAgent."""
        fields.setdefault("controllable", True)
        return self._call("spawn_agent", name=name, **fields)

    def occupancy(self):
        """nav_msgs/OccupancyGrid of the world, frame map."""
        return self._call("static_map").map

    def footprint_radius(self, robot):
        """Radius of the circle around base_link that holds the body of a robot in plan [m]; of one
        that the last lockstep call observed."""
        return self._radii_m[self._species[robot]]

    def free_space(self, clearance_m):
        """The places that are so far away from all that is not free."""
        return FreeSpace(self.occupancy(), clearance_m)

    def close(self):
        """Lets time run again if it ran before. Can be called again."""
        if self._closed:
            return
        try:
            if not self._was_paused:
                self._call("unpause")
        finally:
            self._closed = True
            self._calls["lockstep"].close()

    def _look_at_world(self):
        world = self._call("get_world")
        self.world_id = world.info.world_id
        self.size_m = world.info.size
        self._radii_m = dict(zip(world.species, world.species_radii))
        return world

    def _call(self, name, /, **fields):
        if self._closed:
            raise ServerError(f"{name}: the environment is closed; make another one")
        try:
            answer = self._calls[name](**fields)
        except (rospy.ServiceException, rospy.ROSException) as error:
            raise ServerError(f"{name} failed: {error}; the server may have ended") from error
        status = getattr(answer, "status", None)
        if status is not None and status.code != Status.OK:
            raise ServerError(f"{name} was refused (code {status.code}): {status.message}")
        if not getattr(answer, "success", True):
            raise ServerError(f"{name} was refused: {answer.message}")
        return answer
