"""Hears an episode that is played, to its end, and prints the words of every AgentStates and the
stamps of the clock as JSON. The master is that of ROS_MASTER_URI."""

import json
import threading

import rospy
from rosgraph_msgs.msg import Clock

from latticeworld.msg import AgentStates, EpisodeEnd


def main():
    states, clock, ended = [], [], threading.Event()
    rospy.init_node("hear_episode", disable_signals=True)
    rospy.Subscriber("/agents", AgentStates, lambda m: states.append(str(m)), queue_size=None)
    rospy.Subscriber("/clock", Clock, lambda m: clock.append(m.clock.to_nsec()), queue_size=None)
    rospy.Subscriber("/episode/end", EpisodeEnd, lambda _: ended.set())
    print("ready", flush=True)
    ended.wait(60.0)
    print(json.dumps({"ended": ended.is_set(), "states": states, "clock": clock}))


if __name__ == "__main__":
    main()
