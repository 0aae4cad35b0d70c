"""What the rostests share: a client of world_server, and waiting for messages without sleeping."""

import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from std_srvs.srv import Trigger

from latticeworld import srv
from latticeworld.msg import Status

LAYOUT = ("A lake in the lower left, dense forest in the upper left, farmland on the right, a road "
          "from the west to the east, and a small village in the center.")
ENVIRONMENT = ("A sunny summer noon. Five sheep graze in the upper right, two goblins patrol near "
               "the lower right, an eagle circles above, and a wheeled robot waits in the center.")
TIMEOUT_S = 60.0  # for what must happen; far beyond what it takes


class Collector:
    """Every message of a topic, in order. A context: it ends with it."""

    def __init__(self, topic, message_type):
        self._changed = threading.Condition()
        self._messages = []
        # Not every message of /clock, though: rospy itself listens to it with a queue of 1.
        self._subscriber = rospy.Subscriber(topic, message_type, self._add, queue_size=None)

    def _add(self, message):
        with self._changed:
            self._messages.append(message)
            self._changed.notify_all()

    def messages(self):
        with self._changed:
            return list(self._messages)

    def wait_for(self, predicate, timeout_s=TIMEOUT_S):
        """The first message, old or new, for which predicate is true; fails without one."""
        deadline = time.monotonic() + timeout_s
        seen = 0
        with self._changed:
            while True:
                for message in self._messages[seen:]:
                    if predicate(message):
                        return message
                seen = len(self._messages)
                left = deadline - time.monotonic()
                if left <= 0:
                    raise AssertionError(f"none of {seen} messages is what is waited for")
                self._changed.wait(left)

    def wait_for_next(self, timeout_s=TIMEOUT_S):
        with self._changed:
            count = len(self._messages)
            if not self._changed.wait_for(lambda: len(self._messages) > count, timeout_s):
                raise AssertionError(f"no message after {count}")
            return self._messages[count]

    def wait_until_connected(self):
        """Until a publisher counts this process among its subscribers.

        The subscriber's own count goes up before its thread so much as connects, and what is
        published in between is lost.
        """
        topic = self._subscriber.resolved_name
        wait_until(lambda: any(sends_here(node, topic) for node in publishers_of(topic)),
                   f"a publisher of {topic}")

    def close(self):
        self._subscriber.unregister()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def publishers_of(topic):
    """The names of the nodes that the master knows as publishers of topic."""
    publishers, _, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    return [node for name, nodes in publishers if name == topic for node in nodes]


def sends_here(node, topic):
    """Whether node has a link to this process over which it sends topic."""
    try:
        uri = rosgraph.Master(rospy.get_name()).lookupNode(node)
        _, _, links = xmlrpc.client.ServerProxy(uri).getBusInfo(rospy.get_name())
    except (rosgraph.MasterException, OSError):  # it has ended meanwhile
        return False
    return any(link[1] == rospy.get_name() and link[2] == "o" and link[4] == topic
               for link in links)


def wait_until(condition, what, timeout_s=TIMEOUT_S):
    """For what only the master can tell: asks again and again."""
    deadline = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"not within {timeout_s} s: {what}")
        threading.Event().wait(0.02)


def service(name, service_type):
    rospy.wait_for_service(name, timeout=TIMEOUT_S)
    return rospy.ServiceProxy(name, service_type)


class World:
    """The services of world_server."""

    def __init__(self):
        self.generate_world = service("generate_world", srv.GenerateWorld)
        self.get_world = service("get_world", srv.GetWorld)
        self.save_world = service("save_world", srv.SaveWorld)
        self.load_world = service("load_world", srv.LoadWorld)
        self.list_worlds = service("list_worlds", srv.ListWorlds)
        self.query_terrain = service("query_terrain", srv.QueryTerrain)
        self.query_things = service("query_things", srv.QueryThings)
        self.spawn_agent = service("spawn_agent", srv.SpawnAgent)
        self.remove_agent = service("remove_agent", srv.RemoveAgent)
        self.reset_world = service("reset_world", srv.ResetWorld)
        self.step = service("step", srv.Step)
        self.set_policy = service("set_policy", srv.SetPolicy)
        self.spawn_element = service("spawn_element", srv.SpawnElement)
        self.remove_element = service("remove_element", srv.RemoveElement)
        self.open_gate = service("open_gate", srv.OpenGate)
        self.save_snapshot = service("save_snapshot", srv.SaveSnapshot)
        self.restore_snapshot = service("restore_snapshot", srv.RestoreSnapshot)
        self.set_real_time_factor = service("set_real_time_factor", srv.SetRealTimeFactor)
        self.pause = service("pause", Trigger)
        self.unpause = service("unpause", Trigger)

    def generate(self, seed=7, size=128.0, layout=LAYOUT, environment=ENVIRONMENT, **fields):
        """A small world; fails when it is refused."""
        answer = self.generate_world(layout_instruction=layout,
                                     environment_instruction=environment, seed=seed, size=size,
                                     **fields)
        assert answer.status.code == Status.OK, answer.status.message
        return answer


class ServerTest(unittest.TestCase):
    """A test of a world_server that runs."""

    @classmethod
    def setUpClass(cls):
        cls.world = World()

    def assert_ok(self, answer):
        self.assertEqual(Status.OK, answer.status.code, answer.status.message)
        return answer

    def assert_refused(self, answer, code, *words):
        """Refused with the code, and the message says each of the words."""
        self.assertEqual(code, answer.status.code, answer.status.message)
        for word in words:
            self.assertIn(word, answer.status.message)


class WorldTest(ServerTest):
    """Each test begins with the world of the instructions above, not paused."""

    def setUp(self):
        self.world.generate()
        self.assertTrue(self.world.unpause().success)


def run(name, *tests):
    """The main of a test node. One class a node: rostest's results have one name."""
    rospy.init_node(name)
    for test in tests:
        rostest.rosrun("latticeworld", name, test)
