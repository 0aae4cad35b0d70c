#!/usr/bin/env bash
# ROS 1 cannot read the LZ4 chunks of bags that rosbags writes, though rosbag info shows nothing wrong.
#
# Versions: rosbags 0.11.9 and lz4 4.4.5 from PyPI, python3-roslz4 and python3-rosbag 1.15.15+ds-2 of Debian 12.
# Expected: A bag's LZ4 chunk is a standard LZ4 frame, which any complete decoder reads. Content size and checksum are
# optional parts of a frame, and a decoder has to take it with and without them.
# Observed: ROS 1's roslz4 only takes the kind of frame that it writes itself: without the content size and with the
# content checksum. rosbags writes the opposite in both respects. The index of such a bag is uncompressed, so that
# "rosbag info" counts its messages, but reading the first message ends with "malformed data to decompress".
# Since: rosbags 0.9.15, 0.9.23 and 0.10.11 call the compressor in the same way. BZ2 chunks of rosbags are readable.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

for package in python3-roslz4 python3-rosbag; do
    have=$(dpkg-query -W -f '${Version}' "$package")
    [ "$have" = 1.15.15+ds-2 ] || { echo "$package is $have, not 1.15.15+ds-2."; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check rosbags==0.11.9 lz4==4.4.5 numpy==2.4.6

venv/bin/python - <<'PY'
import lz4.frame
from rosbags.rosbag1 import Writer
from rosbags.typesys import Stores, get_typestore

store = get_typestore(Stores.ROS1_NOETIC)
String = store.types["std_msgs/msg/String"]
for kind in ("LZ4", "BZ2"):
    writer = Writer(kind + ".bag")
    writer.set_compression(getattr(Writer.CompressionFormat, kind))
    with writer:
        connection = writer.add_connection("/words", String.__msgtype__, typestore=store)
        for second in range(1, 6):
            raw = store.serialize_ros1(String("sheep " * 50), String.__msgtype__)
            writer.write(connection, second * 10**9, raw)

# These are the four kinds of frame, each of the same 6000 bytes.
for size in (False, True):
    for checksum in (False, True):
        with open(f"size={size},checksum={checksum}.lz4", "wb") as file:
            file.write(lz4.frame.compress(b"sheep " * 1000, store_size=size, content_checksum=checksum, block_linked=False))
PY
/usr/bin/python3 - <<'PY' | tee seen.txt
import glob
import rosbag
import roslz4

for kind in ("LZ4", "BZ2"):
    bag = rosbag.Bag(kind + ".bag")
    try:
        print(kind, "bag: the index counts", bag.get_message_count(), "messages and", len(list(bag.read_messages())), "are read")
    except OSError as error:
        print(kind, "bag: the index counts", bag.get_message_count(), "messages and reading ends with:", error)
for name in sorted(glob.glob("size=*.lz4")):
    try:
        print(name, "is", "right" if roslz4.decompress(open(name, "rb").read()) == b"sheep " * 1000 else "wrong")
    except OSError as error:
        print(name, "ends with:", error)
PY
venv/bin/python -c '
from rosbags.rosbag1 import Reader
with Reader("LZ4.bag") as bag:
    print("rosbags itself reads", len(list(bag.messages())), "messages of the LZ4 bag.")'

grep -q 'LZ4 bag: the index counts 5 messages and reading ends with: malformed data' seen.txt
grep -q 'BZ2 bag: the index counts 5 messages and 5 are read' seen.txt
[ "$(grep -c 'ends with: malformed' seen.txt)" = 4 ] || exit 1
grep -q 'size=False,checksum=True.lz4 is right' seen.txt
echo "The behaviour is as described."
