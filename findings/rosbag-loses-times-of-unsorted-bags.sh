#!/usr/bin/env bash
# ROS 1's rosbag returns wrong messages for a range of times if a bag from rosbags was not written in the order of time.
#
# Versions: rosbags 0.11.9 from PyPI, python3-rosbag 1.15.15+ds-2 of Debian 12.
# Expected: Bags carry the time of every message in their index, and messages need not come in the order of time. Both
# libraries accept a time that lies before the last one when they write, and both return their own bags by time, so
# that it should not matter which of the two has written a bag.
# Observed: rosbag sorts its index when it writes and trusts the index to be sorted when it reads. rosbags writes the
# index in the order of arrival and sorts when it reads. A bag of rosbags with times 5, 3, 4, 1, 2 is hence right in
# rosbags, whereas rosbag yields 5, 3, 4, 1, 2, first all of one topic and then all of the other, and it finds no
# message at all until time 3. No error and no warning is given. The same messages written by rosbag come out right.
# Since: It lies in the order of the index's entries, which the description of the bag format 2.0 leaves open. Writing the
# messages in the order of time avoids it.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

have=$(dpkg-query -W -f '${Version}' python3-rosbag)
[ "$have" = 1.15.15+ds-2 ] || { echo "python3-rosbag is $have, not 1.15.15+ds-2."; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check rosbags==0.11.9 numpy==2.4.6

venv/bin/python - <<'PY'
from rosbags.rosbag1 import Writer
from rosbags.typesys import Stores, get_typestore

store = get_typestore(Stores.ROS1_NOETIC)
Int32 = store.types["std_msgs/msg/Int32"]
with Writer("rosbags.bag") as writer:
    connections = [writer.add_connection(topic, Int32.__msgtype__, typestore=store) for topic in ("/a", "/b")]
    for second in (5, 3, 4, 1, 2):
        for connection in connections:
            writer.write(connection, second * 10**9, store.serialize_ros1(Int32(second), Int32.__msgtype__))
PY
/usr/bin/python3 - <<'PY' | tee seen.txt
import rosbag
import rospy
from std_msgs.msg import Int32

with rosbag.Bag("rosbag.bag", "w") as bag:
    for second in (5, 3, 4, 1, 2):
        for topic in ("/a", "/b"):
            bag.write(topic, Int32(second), rospy.Time(second))
for name in ("rosbag.bag", "rosbags.bag"):
    with rosbag.Bag(name) as bag:
        def times(**limits):
            return " ".join(f"{topic[1]}{time.secs}" for topic, _, time in bag.read_messages(**limits))
        print(f"{name} in rosbag, all: {times()}.")
        print(f"{name} in rosbag, until time 3: {times(end_time=rospy.Time(3))}.")
PY
venv/bin/python - <<'PY' | tee -a seen.txt
from rosbags.rosbag1 import Reader

for name in ("rosbag.bag", "rosbags.bag"):
    with Reader(name) as bag:
        def times(**limits):
            return " ".join(f"{connection.topic[1]}{time // 10**9}" for connection, time, _ in bag.messages(**limits))
        print(f"{name} in rosbags, all: {times()}.")
        print(f"{name} in rosbags, until time 3: {times(stop=3 * 10**9 + 1)}.")
PY

grep -q '^rosbags.bag in rosbag, all: a5 a3 a4 a1 a2 b5 b3 b4 b1 b2\.' seen.txt
grep -q '^rosbags.bag in rosbag, until time 3: \.' seen.txt
grep -q '^rosbag.bag in rosbag, all: a1 b1 a2 b2 a3 b3 a4 b4 a5 b5\.' seen.txt
grep -q '^rosbag.bag in rosbag, until time 3: a1 b1 a2 b2 a3 b3\.' seen.txt
grep -q '^rosbags.bag in rosbags, all: a1 b1 a2 b2 a3 b3 a4 b4 a5 b5\.' seen.txt
grep -q '^rosbags.bag in rosbags, until time 3: a1 b1 a2 b2 a3 b3\.' seen.txt
echo "The behaviour is as described."
