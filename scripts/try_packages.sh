#!/usr/bin/env bash
# Shows that the Debian packages work on a bare Debian 12 and leave nothing behind: makes one in a
# folder of its own (debootstrap), installs all three there, makes a world over ROS in less than a
# minute, asks for the viewer's page as Containerfile has it served, builds a package of somebody
# else against them (tests/packaging/out_of_tree), and removes them. Ends with 1 where any of it is
# not so.
# Needs root, debootstrap and Debian's packages. Usage: scripts/try_packages.sh FOLDER_OF_PACKAGES
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=$(cd "${1:?usage: try_packages.sh FOLDER_OF_PACKAGES}" && pwd)
names=(ros-latticeworld ros-latticeworld-msgs liblatticeworld-dev)
most_s=60  # from roslaunch to a world
# Debian comes from where this machine has it from.
mirror=${LATTICEWORLD_DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' | grep -v security | head -n 1)}
bare=$(mktemp -d "${TMPDIR:-/tmp}/latticeworld_bare.XXXXXX")

tidy() {
  mountpoint --quiet "$bare/proc" && umount "$bare/proc"
  rm -rf --one-file-system "$bare"
}
trap tidy EXIT

say() { echo "== $*"; }
inside() { LC_ALL=C DEBIAN_FRONTEND=noninteractive chroot "$bare" "$@"; }
install() {  # names and patterns of files in there; says what apt-get said where that fails
  inside sh -c "apt-get install --yes --quiet=2 --no-install-recommends -o Dpkg::Use-Pty=0 $*" \
    >"$bare/tmp/install.log" 2>&1 || { tail -n 20 "$bare/tmp/install.log" >&2; exit 1; }
}
with_ros() {  # a script for bash in there, with a ROS master's address of its own
  inside env HOME=/tmp ROS_HOME=/tmp/ros ROS_IP=127.0.0.1 ROS_MASTER_URI=http://127.0.0.1:11399 \
    timeout 600 bash -c "$1"
}
# Every file but what package managers and time leave on their own.
files() {
  (cd "$bare" && find . -xdev \( -path ./proc -o -path ./var/cache -o -path ./var/lib/apt -o \
    -path ./var/lib/dpkg -o -path ./var/log -o -path ./tmp -o -path ./packages -o \
    -path ./out_of_tree \) -prune -o -print) | sed 's/^\.//' | sort
}
# The files and folders that our packages alone bring.
ours() {
  inside dpkg-query --listfiles "${names[@]}" | sort --unique |
    inside xargs dpkg-query --search 2>/dev/null |
    awk -F ': ' '{ others = 0; count = split($1, owners, ", ")
                   for (i = 1; i <= count; ++i) others += owners[i] !~ /latticeworld/
                   if (!others) print $2 }'
}
# Of what is new by the name list $1: what has our name, or lies where only our packages were.
left_of_ours() {
  awk 'NR == FNR { ours[$0]; next }
       { found = /latticeworld/
         for (path = $0; path != "" && !found; sub(/\/[^\/]*$/, "", path)) found = path in ours
         if (found) print }' "$bare/tmp/ours" "$1"
}

say "a bare Debian 12"
debootstrap --variant=minbase bookworm "$bare" "$mirror" >/dev/null
chmod 755 "$bare"
mount -t proc proc "$bare/proc"
echo "127.0.0.1 localhost" >"$bare/etc/hosts"  # as every installed system has it
inside apt-get update --quiet=2
files >"$bare/tmp/before"
cp -r "$packages" "$bare/packages"
cp -r "$root/tests/packaging/out_of_tree" "$bare/out_of_tree"

say "install what runs"
install '/packages/ros-latticeworld_*.deb' '/packages/ros-latticeworld-msgs_*.deb'
inside dpkg-query --show 'ros-latticeworld*'

say "the main job: words to a world, over ROS"
with_ros '
  begin=$(date +%s)
  roslaunch --port 11399 latticeworld world.launch >/tmp/launch.log 2>&1 &
  launch=$!
  /usr/lib/latticeworld/generate_world.py --server-pid $launch --seed 37 \
    --layout "A lake in the center, forest around it." --environment "A sunny noon." || {
      cat /tmp/launch.log; exit 1; }
  echo $(($(date +%s) - begin)) >/tmp/seconds
  kill -INT $launch; wait $launch || true'
seconds=$(cat "$bare/tmp/seconds")
echo "from start to world: $seconds s"
[ "$seconds" -le "$most_s" ] || { echo "that is more than $most_s s" >&2; exit 1; }

say "the page, as Containerfile has it served"
with_ros '
  roslaunch --port 11399 latticeworld viewer.launch port:=0 >/tmp/viewer.log 2>&1 &
  launch=$!
  until address=$(rostopic echo -n 1 /viewer/address 2>/dev/null); do
    kill -0 $launch || { cat /tmp/viewer.log; exit 1; }
  done
  python3 - "$address" <<END
import re, sys, urllib.request
page = urllib.request.urlopen(re.search("http://[^ \"]+", sys.argv[1]).group())
print("page:", page.status, len(page.read()), "bytes")
END
  kill -INT $launch; wait $launch || true'

say "install what builds, and build a package of somebody else"
install '/packages/liblatticeworld-dev_*.deb' catkin cmake g++ libroscpp-dev make
inside sh -c 'cmake -S /out_of_tree -B /tmp/out_of_tree && cmake --build /tmp/out_of_tree' \
  >"$bare/tmp/build.log" 2>&1 || { tail -n 40 "$bare/tmp/build.log" >&2; exit 1; }
inside find /tmp/out_of_tree -name words_to_message -type f -exec {} \; | grep '^world-'

say "remove"
ours >"$bare/tmp/ours"
inside sh -c 'apt-get purge --yes --quiet=2 --autoremove "*latticeworld*" catkin cmake g++ make \
  libroscpp-dev >/dev/null 2>&1'
files | comm -13 "$bare/tmp/before" - >"$bare/tmp/new"
left=$(left_of_ours "$bare/tmp/new")
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "nothing of it is left; $(wc -l <"$bare/tmp/new") files of others are"
