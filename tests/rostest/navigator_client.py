"""What the rostests share that send robots somewhere."""

import math
import subprocess
import tempfile

import actionlib
import roslib.packages
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid, Odometry
from nav_msgs.srv import GetPlan

from world_client import TIMEOUT_S, Collector, service, wait_until

NAVIGATOR = roslib.packages.find_node("latticeworld", "navigator")[0]
ENDED = (GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.PREEMPTED, GoalStatus.REJECTED)
GOAL_RADIUS_M = 0.5


def pose_at(x, y, heading=0.0, frame="map"):
    pose = PoseStamped()
    pose.header.frame_id = frame
    pose.pose.position.x = x
    pose.pose.position.y = y
    pose.pose.orientation.z = math.sin(heading / 2)
    pose.pose.orientation.w = math.cos(heading / 2)
    return pose


def distance(pose, x, y):
    return math.hypot(pose.position.x - x, pose.position.y - y)


class Driver:
    """A robot with a navigator: sends goals and hears what becomes of them."""

    def __init__(self, robot="robot"):
        self.robot = robot
        self.client = actionlib.SimpleActionClient(f"{robot}/move_base", MoveBaseAction)
        wait_until(lambda: self.client.wait_for_server(rospy.Duration(0.01)),
                   f"the action server of {robot}")
        self.make_plan = service(f"{robot}/move_base/make_plan", GetPlan)
        self.truth = Collector(f"{robot}/ground_truth", Odometry)
        self.odometry = Collector(f"{robot}/odom", Odometry)
        self.text = ""
        self.feedback = []

    def close(self):
        self.truth.close()
        self.odometry.close()

    def send(self, pose):
        self.feedback = []
        self.client.send_goal(MoveBaseGoal(target_pose=pose), feedback_cb=self.feedback.append)

    def wait(self, timeout_s=2 * TIMEOUT_S):
        """How the goal ended; its text is in self.text."""
        wait_until(lambda: self.client.get_state() in ENDED, "the goal's end", timeout_s)
        self.text = self.client.get_goal_status_text()
        return self.client.get_state()

    def go(self, pose):
        self.send(pose)
        return self.wait()

    def wait_until_active(self):
        wait_until(lambda: self.client.get_state() == GoalStatus.ACTIVE, "the goal is active")

    def pose(self):
        """Where the robot is; of a world whose time runs."""
        return self.truth.wait_for_next().pose.pose

    def place_at(self, length, first_deg=0):
        """The first place in a circle around the robot, from that bearing on to the left, that it
        has a way to of about `length`."""
        here = self.pose().position
        for i in range(24):
            angle = math.radians(first_deg + 15 * i)
            x, y = here.x + length * math.cos(angle), here.y + length * math.sin(angle)
            try:
                plan = self.make_plan(start=pose_at(here.x, here.y), goal=pose_at(x, y)).plan
            except rospy.ServiceException:
                continue  # no place for a robot
            went = sum(distance(b.pose, a.pose.position.x, a.pose.position.y)
                       for a, b in zip(plan.poses, plan.poses[1:]))
            if plan.poses and went < 1.3 * length:
                return x, y
        raise AssertionError(f"nothing {length} m around {here.x}, {here.y} can be gone to")


class NavigatorProcess:
    """A navigator of our own with these private parameters; remaps as NAME:=OTHER."""

    def __init__(self, name, *remaps, **parameters):
        self.name = name
        rospy.set_param(f"/{name}", parameters)
        self.output = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen([NAVIGATOR, f"__name:={name}", *remaps],
                                        stdout=self.output, stderr=subprocess.STDOUT)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
        code = self.process.wait(TIMEOUT_S)
        rospy.delete_param(f"/{self.name}")
        return code

    def text(self):
        self.output.seek(0)
        return self.output.read()


def closed_place():
    """A cell of the map that is closed, with closed ones around it."""
    with Collector("map", OccupancyGrid) as maps:
        grid = maps.wait_for(lambda m: True)
    width, data = grid.info.width, grid.data
    for row in range(3, grid.info.height - 3):
        for col in range(3, width - 3):
            if all(data[(row + r) * width + col + c] == 100
                   for r in range(-3, 4) for c in range(-3, 4)):
                return (grid.info.origin.position.x + (col + 0.5) * grid.info.resolution,
                        grid.info.origin.position.y + (row + 0.5) * grid.info.resolution)
    raise AssertionError("the map has no closed place")
