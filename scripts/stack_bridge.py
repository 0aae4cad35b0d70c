"""What a navigation stack of ROS nodes sees and says, for launch_stack.py: one robot, one goal."""

import array
import math
import threading

import rospy
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import TransformStamped, Twist
from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult
from nav_msgs.msg import OccupancyGrid, Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan, PointCloud2, PointField

BEGIN_S = 1.0  # simulated time 0 means "no time yet" to ROS
# Messages of two topics come in any order: what the robot senses is told for so long before its
# goal, which a stack refuses that has no odometry yet.
SENSED_FIRST_S = 0.5
ENDED = {GoalStatus.SUCCEEDED: "succeeded", GoalStatus.ABORTED: "aborted",
         GoalStatus.REJECTED: "rejected", GoalStatus.PREEMPTED: "preempted",
         GoalStatus.RECALLED: "recalled", GoalStatus.LOST: "lost"}
RANGE_M = 100.0  # that no scanner of ours sees beyond


class Bridge:
    """Publishes what the robot knows, and keeps what it is told. Names lie below `robot`."""

    def __init__(self, robot, task):
        self.frames = (f"{robot}/odom", f"{robot}/base_link", robot)
        self.lock = threading.Lock()
        self.velocity, self.result, self.last_seq = (0.0, 0.0), None, 0
        # The clock stands still until update: nothing here may wait for it.
        self.clock = rospy.Publisher("/clock", Clock, queue_size=10)
        rospy.init_node("launch_stack", disable_signals=True)
        self.transforms = tf2_ros.TransformBroadcaster()
        self.fixed = tf2_ros.StaticTransformBroadcaster()
        self.odometry = rospy.Publisher(f"{robot}/odom", Odometry, queue_size=10)
        self.scan = rospy.Publisher(f"{robot}/scan", LaserScan, queue_size=10)
        self.points = rospy.Publisher(f"{robot}/points", PointCloud2, queue_size=10)
        self.goal = rospy.Publisher(f"{robot}/move_base/goal", MoveBaseActionGoal, queue_size=1)
        self.map = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        rospy.Subscriber(f"{robot}/cmd_vel", Twist, self.on_command)
        rospy.Subscriber(f"{robot}/move_base/result", MoveBaseActionResult, self.on_result)
        self.sensors, self.is_sent, self.task = {}, False, task
        self.map.publish(map_message(task.map))
        self.fixed.sendTransform([transform("map", self.frames[0], 0.0,
                                            (0, 0, 0, 0, 0, 0, 1))])

    def on_command(self, message):
        with self.lock:
            self.velocity = (message.linear.x, message.angular.z)

    def on_result(self, message):
        with self.lock:
            self.result = message

    def is_heard(self):
        """Whether a node takes goals, and every node that asked the master for one of our topics
        is connected: what is told before would not reach it. Tells the time, for nodes to begin."""
        self.clock.publish(Clock(rospy.Time(BEGIN_S)))
        _, _, (_, subscribers, _) = rospy.get_master().getSystemState()
        nodes = {topic: len(names) for topic, names in subscribers}
        return self.goal.get_num_connections() > 0 and all(
            one.get_num_connections() >= nodes.get(one.resolved_name, 0)
            for one in (self.map, self.odometry, self.scan, self.points, self.goal))

    def command(self):
        with self.lock:
            return self.velocity

    def ended(self):
        """(how, text): how is empty while the goal is under way."""
        with self.lock:
            if self.result is None:
                return "", ""
            return (ENDED.get(self.result.status.status, str(self.result.status.status)),
                    self.result.status.text)

    def tell(self, now):
        stamp = rospy.Time(BEGIN_S + now.time_s)
        self.clock.publish(Clock(stamp))
        odom, base, _ = self.frames
        self.transforms.sendTransform(transform(odom, base, stamp, now.pose))
        for scan in now.scans:
            self.tell_scan(scan, now)
        message = Odometry()
        message.header.stamp, message.header.frame_id, message.child_frame_id = stamp, odom, base
        set_pose(message.pose.pose.position, message.pose.pose.orientation, now.pose)
        message.twist.twist.linear.x = now.speed_mps
        message.twist.twist.angular.z = now.turn_rate_radps
        self.odometry.publish(message)
        if not self.is_sent and now.time_s >= SENSED_FIRST_S:
            self.send_goal(stamp)

    def send_goal(self, stamp):
        goal = MoveBaseActionGoal()
        goal.header.stamp = goal.goal_id.stamp = stamp
        goal.goal_id.id = "trial"
        target = goal.goal.target_pose
        target.header.stamp, target.header.frame_id = stamp, "map"
        target.pose.position.x, target.pose.position.y = self.task.goal.x_m, self.task.goal.y_m
        target.pose.orientation.w = 1.0
        self.goal.publish(goal)
        self.is_sent = True

    def tell_scan(self, scan, now):
        _, base, robot = self.frames
        frame = f"{robot}/scan" if scan.planar else f"{robot}/points"
        if frame not in self.sensors:
            self.sensors[frame] = transform(base, frame, 0.0, relative(now.pose, scan.pose))
            self.fixed.sendTransform(list(self.sensors.values()))
        stamp = rospy.Time(BEGIN_S + scan.time_s)
        if scan.planar:
            self.scan.publish(laser_scan(scan, frame, stamp))
        else:
            self.points.publish(point_cloud(scan, frame, stamp))


def set_pose(position, orientation, pose):
    position.x, position.y, position.z = pose[:3]
    orientation.x, orientation.y, orientation.z, orientation.w = pose[3:]


def transform(parent, child, stamp, pose):
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = parent, child
    message.header.stamp = stamp if isinstance(stamp, rospy.Time) else rospy.Time(stamp)
    set_pose(message.transform.translation, message.transform.rotation, pose)
    return message


def multiply(a, b):
    """Of quaternions (x, y, z, w)."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


def relative(base, other):
    """The pose `other` as seen from `base`; both in one frame."""
    inverse = (-base[3], -base[4], -base[5], base[6])
    offset = tuple(b - a for a, b in zip(base[:3], other[:3])) + (0.0,)
    x, y, z, _ = multiply(multiply(inverse, offset), base[3:])
    return (x, y, z) + multiply(inverse, other[3:])


def map_message(grid):
    message = OccupancyGrid()
    message.header.frame_id = "map"
    message.info.resolution = grid.resolution_m
    message.info.width, message.info.height = grid.cols, grid.rows
    message.info.origin.position.x, message.info.origin.position.y = grid.origin_m
    message.info.origin.orientation.w = 1.0
    message.data = list(array.array("b", grid.costs))
    return message


def laser_scan(scan, frame, stamp):
    """The beams of one revolution by their angles, in equal steps; the nearest of a step counts."""
    beams = []
    for points, is_hit in ((scan.hits, True), (scan.misses, False)):
        for x, y in zip(points[0::3], points[1::3]):
            beams.append((math.atan2(y, x), math.hypot(x, y) if is_hit else math.inf))
    beams.sort()
    message = LaserScan()
    message.header.stamp, message.header.frame_id = stamp, frame
    message.range_min, message.range_max = 0.02, RANGE_M
    if len(beams) < 2:
        return message
    message.angle_min, message.angle_max = beams[0][0], beams[-1][0]
    message.angle_increment = (message.angle_max - message.angle_min) / (len(beams) - 1)
    ranges = [math.inf] * len(beams)
    for angle, distance in beams:
        step = round((angle - message.angle_min) / message.angle_increment)
        ranges[step] = min(ranges[step], distance)
    message.ranges = ranges
    return message


def point_cloud(scan, frame, stamp):
    message = PointCloud2()
    message.header.stamp, message.header.frame_id = stamp, frame
    message.height, message.width = 1, len(scan.hits) // 3
    message.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")]
    message.point_step, message.row_step = 12, 12 * message.width
    message.is_dense = True
    message.data = scan.hits.tobytes()
    return message
