#!/usr/bin/env bash
# rosbags gives a ROS 1 message with constants another MD5 sum than ROS 1 does, depending on how the constant is spelt.
#
# Versions: rosbags 0.11.9 from PyPI, python3-genmsg 0.6.0-1 of Debian 12.
# Expected: ROS 1 types are told apart by an MD5 sum. rosbags computes it for registered types, and for the same text of
# a message it is the sum that genmsg computes, or else ROS nodes refuse the connection.
# Observed: ROS 1 hashes the characters of a constant as they were typed. rosbags parses the constant into a number and
# hashes how Python prints this number: "1e-3" becomes "0.001", "007" becomes "7", and digits of pi beyond the 15th
# decimal are lost. Constants such as "1.0", which Python prints alike, agree, so that most types seem right. Strings
# in quotes lose their quotes, which are part of the value in ROS 1, so that the sum and the value both differ.
# Since: rosbags 0.9.23 and 0.10.11 differ for the numbers as well, but agree for the quoted string.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

have=$(dpkg-query -W -f '${Version}' python3-genmsg)
[ "$have" = 0.6.0-1 ] || { echo "python3-genmsg is $have, not 0.6.0-1."; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check rosbags==0.11.9 numpy==2.4.6

printf '%s\n' 'float32 HALF=0.5' 'float64 ONE=1.0' 'string HASH=a # b' 'bool YES=True' \
    'float32 STEP=1e-3' 'float64 PI=3.14159265358979323846' 'int32 AGENT=007' 'string NAME="grass"' > constants.txt
/usr/bin/python3 - <<'PY' > ros1.txt
import genmsg
from genmsg import msg_loader

for line in open("constants.txt"):
    context = msg_loader.MsgContext.create_default()
    spec = msg_loader.load_msg_from_string(context, line, "demo/Type")
    print(genmsg.compute_md5(context, spec), repr(spec.constants[0].val))
PY
venv/bin/python - <<'PY' > rosbags.txt
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

for line in open("constants.txt"):
    store = get_typestore(Stores.ROS1_NOETIC)
    store.register(get_types_from_msg(line, "demo/msg/Type"))
    value = getattr(store.types["demo/msg/Type"], line.split()[1].split("=")[0])
    print(store.generate_msgdef("demo/msg/Type", ros_version=1)[1], repr(value))
PY
paste -d'|' constants.txt ros1.txt rosbags.txt | while IFS='|' read -r text ros1 rosbags; do
    [ "${ros1%% *}" = "${rosbags%% *}" ] && verdict=same || verdict=other
    echo "$verdict | $text | ROS 1: $ros1 | rosbags: $rosbags"
done | tee seen.txt

[ "$(cut -d' ' -f1 seen.txt | paste -sd' ')" = "same same same same other other other other" ]
grep -q "NAME.*ROS 1: [0-9a-f]* '\"grass\"' | rosbags: [0-9a-f]* 'grass'" seen.txt
echo "The behaviour is as described."
