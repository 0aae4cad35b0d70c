#!/usr/bin/env bash
# Installs from Debian's packages what is missing to build, test and run LatticeWorld.
# Does nothing, and needs no rights, when all is there. Usage: scripts/install_dependencies.sh
set -euo pipefail
export PATH="/usr/sbin:/usr/bin:/sbin:/bin:${PATH}"

packages=(
  # building
  ca-certificates ccache clang-format cmake g++ ninja-build pkg-config
  # the core
  libbenchmark-dev libboost-dev libeigen3-dev libgtest-dev libode-dev liboctomap-dev libopencv-dev libssl-dev
  libcli11-dev libcurl4-openssl-dev libembree-dev libgdal-dev libvalijson-dev libyaml-cpp-dev
  nlohmann-json3-dev
  zlib1g-dev
  # testing against real peers
  blender gdal-bin libsdformat-dev
  octomap-tools openssl python3-numpy python3-onnx python3-pandas python3-venv python3-yaml
  chromium
  # training models
  python3-pil python3-torch
  # campaigns on a cluster of one machine
  munge slurm-client slurmctld slurmd
  # ROS: building
  catkin ros-message-generation ros-message-runtime
  libactionlib-dev libactionlib-msgs-dev libdiagnostic-msgs-dev libgeometry-msgs-dev
  libmove-base-msgs-dev libnav-msgs-dev libros-rosgraph-msgs-dev librosbag-storage-dev
  libroscpp-dev librostest-dev libsensor-msgs-dev libstd-msgs-dev libstd-srvs-dev
  libtf2-dev libtf2-msgs-dev libtf2-ros-dev libtopic-tools-dev libvisualization-msgs-dev
  ros-actionlib-msgs ros-diagnostic-msgs ros-geometry-msgs ros-move-base-msgs ros-nav-msgs
  ros-rosgraph-msgs ros-sensor-msgs ros-std-msgs ros-std-srvs ros-tf2-msgs ros-visualization-msgs
  # ROS: running
  python3-actionlib python3-rosbag python3-roslaunch python3-rosmaster python3-rosmsg python3-rosnode
  python3-rosparam python3-rospy python3-rosservice python3-rostest python3-rostopic
  python3-diagnostic-msgs python3-geometry-msgs python3-move-base-msgs python3-nav-msgs
  python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf2-msgs python3-tf2-ros
  python3-visualization-msgs
  rosbash
  # ROS: what is seen, tested without a screen
  libgl1-mesa-dri librviz-dev rviz xvfb
)

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
# Node may well come from elsewhere than Debian, whose own packages would then be in conflict.
command -v node >/dev/null || missing+=(nodejs)
command -v npm >/dev/null || missing+=(npm)
[ ${#missing[@]} -gt 0 ] || exit 0

echo "installing ${#missing[@]} Debian packages: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "these packages are missing, and installing them needs root or sudo: ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends "${missing[@]}"
