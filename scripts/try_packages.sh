#!/usr/bin/env bash
# Shows that the Debian packages work on a bare Debian 12 and leave nothing behind: makes one in a
# folder of its own (debootstrap), installs them there, makes the README's world, removes them.
# Needs root, debootstrap and Debian's packages. Usage: scripts/try_packages.sh FOLDER_OF_PACKAGES
set -euo pipefail
packages=$(cd "${1:?usage: try_packages.sh FOLDER_OF_PACKAGES}" && pwd)
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
# Every file but what package managers and time leave on their own.
files() {
  (cd "$bare" && find . -xdev \( -path ./proc -o -path ./var/cache -o -path ./var/lib/apt -o \
    -path ./var/lib/dpkg -o -path ./var/log -o -path ./tmp -o -path ./packages \) -prune -o -print) | sort
}

say "a bare Debian 12"
debootstrap --variant=minbase bookworm "$bare" "$mirror" >/dev/null
chmod 755 "$bare"
mount -t proc proc "$bare/proc"
echo "127.0.0.1 localhost" >"$bare/etc/hosts"  # as every installed system has it
inside apt-get update --quiet=2
files >"$bare/tmp/before"
cp -r "$packages" "$bare/packages"

say "install"
inside sh -c 'apt-get install --yes --quiet=2 --no-install-recommends -o Dpkg::Use-Pty=0 \
  /packages/ros-latticeworld_*.deb /packages/ros-latticeworld-msgs_*.deb >/tmp/install.log 2>&1' || {
  tail -n 20 "$bare/tmp/install.log" >&2
  exit 1
}
inside dpkg-query --show 'ros-latticeworld*'

say "the main job: words to a world, over ROS"
inside env HOME=/tmp ROS_HOME=/tmp/ros ROS_IP=127.0.0.1 ROS_MASTER_URI=http://127.0.0.1:11399 \
  timeout 120 bash -c '
  begin=$(date +%s)
  roslaunch --port 11399 latticeworld world.launch >/tmp/launch.log 2>&1 &
  launch=$!
  /usr/lib/latticeworld/generate_world.py --server-pid $launch --seed 37 \
    --layout "A lake in the center, forest around it." --environment "A sunny noon." || {
      cat /tmp/launch.log; exit 1; }
  echo "from start to world: $(($(date +%s) - begin)) s"
  kill -INT $launch; wait $launch || true'

say "remove"
inside sh -c 'apt-get purge --yes --quiet=2 --autoremove "ros-latticeworld*" >/dev/null 2>&1'
files >"$bare/tmp/after"
left=$(comm -13 "$bare/tmp/before" "$bare/tmp/after" | grep -i latticeworld || true)
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "nothing of it is left; $(comm -13 "$bare/tmp/before" "$bare/tmp/after" | wc -l) files of others are"
