#!/usr/bin/env bash
# Opening a bag of rosbags for appending in ROS 1's rosbag destroys it, even if nothing is written before it is closed.
#
# Versions: rosbags 0.11.9 from PyPI, python3-rosbag 1.15.15+ds-2 of Debian 12.
# Expected: rosbag reads and counts the uncompressed bags that rosbags writes. Appending to one adds messages, and
# "rosbag reindex" leaves a bag with the messages that it had.
# Observed: A bag begins with a header record that is padded with spaces, so that it can be overwritten in place. rosbag
# makes its header and padding 4096 bytes, without the two lengths before them. rosbags counts these 8 bytes in, so that
# its first chunk begins 8 bytes earlier. The description of the format only says that it is padded to 4 KB. When rosbag
# opens a bag for appending, it writes its own, longer header over the old one and over the first 8 bytes of the chunk.
# Afterwards neither library can open the bag. "rosbag reindex" does the same in place, without an error, and leaves a
# bag with no message, next to the copy of the original that it makes first.
# rosbag does this to no bag of its own. Reading is not affected, since readers go by the lengths.
# Since: rosbags 0.9.23 and 0.10.11 write the same shorter header.
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
    connection = writer.add_connection("/count", Int32.__msgtype__, typestore=store)
    for second in range(1, 6):
        writer.write(connection, second * 10**9, store.serialize_ros1(Int32(second), Int32.__msgtype__))
PY
/usr/bin/python3 - <<'PY' | tee seen.txt
import shutil
import struct
import subprocess
import rosbag
import rospy
from std_msgs.msg import Int32


def messages(name):
    try:
        with rosbag.Bag(name) as bag:
            return [message.data for _, message, _ in bag]
    except rosbag.ROSBagException as error:
        return f"error: {error}"


with rosbag.Bag("rosbag.bag", "w") as bag:
    for second in range(1, 6):
        bag.write("/count", Int32(second), rospy.Time(second))
for name in ("rosbag", "rosbags"):
    with open(name + ".bag", "rb") as file:
        file.readline()
        sizes = []
        for _ in range(2):
            sizes.append(struct.unpack("<I", file.read(4))[0])
            file.seek(sizes[-1], 1)
    print(f"Bag of {name}: the first record has {sizes[0]} bytes of header and {sizes[1]} bytes of padding.")
    print(f"Bag of {name}, as written: {messages(name + '.bag')}.")
    shutil.copy(name + ".bag", "appended.bag")
    rosbag.Bag("appended.bag", "a").close()
    print(f"Bag of {name}, opened for appending and closed: {messages('appended.bag')}.")
    shutil.copy(name + ".bag", "indexed.bag")
    subprocess.run(["rosbag", "reindex", "-q", "-f", "indexed.bag"], check=True)
    print(f"Bag of {name}, reindexed: {messages('indexed.bag')}.")
PY

grep -q '^Bag of rosbag: the first record has 69 bytes of header and 4027 bytes' seen.txt
grep -q '^Bag of rosbags: the first record has 69 bytes of header and 4019 bytes' seen.txt
grep -q '^Bag of rosbag, opened for appending and closed: \[1, 2, 3, 4, 5\]' seen.txt
grep -q '^Bag of rosbag, reindexed: \[1, 2, 3, 4, 5\]' seen.txt
grep -q '^Bag of rosbags, as written: \[1, 2, 3, 4, 5\]' seen.txt
grep -q '^Bag of rosbags, opened for appending and closed: error: Unindexed bag' seen.txt
grep -q '^Bag of rosbags, reindexed: \[\]' seen.txt
echo "The behaviour is as described."
