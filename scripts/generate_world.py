#!/usr/bin/python3
"""Asks a running world_server for a world and prints what was made: a small rospy client.

Usage: generate_world.py --layout TEXT [--environment TEXT] [--seed N] [--size METRES] [--resolution METRES]
"""

import argparse
import os
import sys
import time

import rosgraph
import rospy
import rosservice

from latticeworld.msg import AgentStates, Status
from latticeworld.srv import GenerateWorld, GenerateWorldRequest, SaveWorld

# Background colours of the letters: the palette of the method, as 24-bit ANSI.
COLORS = {
    "suburb": {"A": (255, 194, 128), "B": (255, 0, 0), "D": (157, 127, 183), "F": (34, 139, 34),
               "G": (144, 238, 144), "R": (255, 255, 0), "W": (0, 0, 255)},
    "wild": {"B": (0, 128, 0), "F": (20, 20, 20), "R": (128, 128, 128), "S": (255, 255, 255),
             "W": (0, 0, 255)},
}


def colored(layout, vocabulary):
    """The 32 lines of a layout, each letter twice on its colour; plain where stdout is no terminal."""
    if not sys.stdout.isatty():
        return layout
    colors = COLORS[vocabulary]
    lines = []
    for line in layout.split():
        cells = []
        for letter in line:
            red, green, blue = colors[letter]
            ink = 30 if red + green + blue > 330 else 97
            cells.append(f"\033[48;2;{red};{green};{blue}m\033[{ink}m{letter}{letter}")
        lines.append("".join(cells) + "\033[0m")
    return "\n".join(lines)


def wait_for_server(server_pid, timeout_s):
    """Waits until the services are there; ends the program when the server died or time ran out."""
    begin = time.monotonic()
    told = False
    while time.monotonic() < begin + timeout_s:
        if server_pid:
            # A child of the shell that called us: gone, or a zombie, means that it ended.
            try:
                with open(f"/proc/{server_pid}/stat", encoding="utf-8") as stat:
                    if stat.read().rsplit(")", 1)[1].split()[0] == "Z":
                        sys.exit("the world server ended before it answered")
            except FileNotFoundError:
                sys.exit("the world server ended before it answered")
        try:
            if rosgraph.is_master_online() and rosservice.get_service_node("/generate_world"):
                return
        except rosservice.ROSServiceException:
            pass  # the master ended in between: it counts as not there
        if not told and time.monotonic() > begin + 3.0:
            told = True
            print(f"waiting for /generate_world at {rosgraph.get_master_uri()} ...", file=sys.stderr)
        time.sleep(0.1)
    sys.exit(f"no /generate_world service at {rosgraph.get_master_uri()} (ROS_MASTER_URI) within "
             f"{timeout_s:.0f} s; is world_server running?")


def seed_number(text):
    """A seed as the service takes it."""
    seed = int(text)
    if not 0 <= seed < 2**64:
        raise argparse.ArgumentTypeError(f"{text} is not legal; legal is 0 .. {2**64 - 1}")
    return seed


def main():
    parser = argparse.ArgumentParser(description="Generate a world through a running world_server.")
    parser.add_argument("--layout", required=True, help="what the land looks like")
    parser.add_argument("--environment", default="", help="season, weather, time, who lives there")
    parser.add_argument("--seed", type=seed_number, default=0, help="0: drawn")
    parser.add_argument("--size", type=float, default=0.0, help="side of the world [m]; 0: default")
    parser.add_argument("--resolution", type=float, default=0.0, help="cell [m]; 0: default")
    parser.add_argument("--server-pid", type=int, default=0, help=argparse.SUPPRESS)
    options = parser.parse_args(rospy.myargv()[1:])  # roslaunch adds arguments of its own

    wait_for_server(options.server_pid, timeout_s=60.0)
    rospy.init_node("generate_world_client", anonymous=True, disable_signals=True)

    request = GenerateWorldRequest(
        layout_instruction=options.layout, environment_instruction=options.environment,
        seed=options.seed, size=options.size, resolution=options.resolution)
    begin = time.monotonic()
    world = rospy.ServiceProxy("/generate_world", GenerateWorld)(request)
    answered_s = time.monotonic() - begin
    if world.status.code != Status.OK:
        sys.exit(f"generate_world failed: {world.status.message}")

    print(f"\n{world.world_id}, seed {world.seed}, generator {world.generator}, "
          f"answered in {answered_s:.2f} s\n")
    print(colored(world.layout, world.vocabulary))
    satisfied = sum(claim.satisfied for claim in world.fidelity)
    lost = f", and not understood: {', '.join(world.not_understood)}" if world.not_understood else ""
    print(f"\nfidelity: {satisfied} of {len(world.fidelity)} claims of the words are satisfied{lost}")
    print("\nstages")
    for stage in world.stages:
        print(f"  {stage.name:<12} {stage.seconds:7.3f} s")
    for warning in world.warnings:
        print(f"warning: {warning}")

    agents = rospy.wait_for_message("agents", AgentStates, timeout=10.0).agents
    print(f"\nagents: {len(agents)}")
    for agent in agents:
        place = agent.pose.position
        print(f"  {agent.name:<20} {agent.behaviour:<12} ({place.x:8.2f}, {place.y:8.2f}, {place.z:7.2f}) m")

    master = rosgraph.Master(rospy.get_name())
    print("\ntopics")
    for name, topic_type in sorted(master.getPublishedTopics("/")):
        if not name.startswith("/rosout"):
            print(f"  {name:<36} {topic_type}")

    saved = rospy.ServiceProxy("/save_world", SaveWorld)(name=world.world_id)
    if saved.status.code in (Status.OK, Status.ALREADY_EXISTS):
        print(f"\npicture  {os.path.join(saved.path, 'preview.png')}")
    else:
        print(f"\nwarning: the world was not saved: {saved.status.message}")
    sys.stdout.flush()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
    except BrokenPipeError:  # as under `| head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except (rospy.ROSException, rospy.ServiceException, rosgraph.MasterException, OSError) as error:
        sys.exit(f"world_server does not answer any more: {error}")
