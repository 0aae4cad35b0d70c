"""Hears an episode that is played, until so many AgentStates and its end have come, and prints the
words of all of them and the stamps of the clock as JSON. The master is that of ROS_MASTER_URI.
Usage: hear_episode.py COUNT"""

import json
import sys
import threading

import rospy
from rosgraph_msgs.msg import Clock

from latticeworld.msg import AgentStates, EpisodeEnd


def main():
    wanted = int(sys.argv[1])
    states, clock, ended, heard = [], [], threading.Event(), threading.Event()

    def on_states(message):
        states.append(str(message))
        if len(states) == wanted:
            heard.set()

    rospy.init_node("hear_episode", disable_signals=True)
    rospy.Subscriber("/agents", AgentStates, on_states, queue_size=None)
    rospy.Subscriber("/clock", Clock, lambda m: clock.append(m.clock.to_nsec()), queue_size=None)
    rospy.Subscriber("/episode/end", EpisodeEnd, lambda _: ended.set())
    print("ready", flush=True)
    # Each topic has a connection of its own: the end may come before what was told before it.
    if heard.wait(60.0):
        ended.wait(60.0)
    print(json.dumps({"ended": ended.is_set(), "states": states, "clock": clock}))


if __name__ == "__main__":
    main()
