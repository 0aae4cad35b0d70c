// The world viewer: shows browsers what a world_server does, and lets them control it.
// Parameters: launch_cfg/world_viewer.yaml. Page and protocol: docs/viewer.md.

#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <thread>
#include <utility>

#include "latticeworld_ros/node/master_watch.h"
#include "latticeworld_ros/node/node_start.h"
#include "latticeworld_ros/node/shutdown_guard.h"
#include "latticeworld_ros/viewer/viewer_node.h"
#include "latticeworld_ros/viewer/viewer_options.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "world_viewer");
  // roscpp hears SIGINT only; without taking leave the master would keep this node's topics.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  latticeworld::PrepareNode();
  XmlRpc::XmlRpcValue parameters;
  (void)ros::param::get(ros::this_node::getName(), parameters);  // none at all is legal
  const auto options = latticeworld::ViewerOptionsFromParameters(parameters);
  if (!options.ok()) {
    ROS_FATAL_STREAM(options.status().ToString());
    return EXIT_FAILURE;
  }
  try {
    ros::NodeHandle node;
    auto viewer = latticeworld::ViewerNode::Create(node, *options);
    if (!viewer.ok()) {
      ROS_FATAL_STREAM(viewer.status().ToString());
      return EXIT_FAILURE;
    }
    // What roscpp itself asks for, on its own queue: the clock.
    ros::AsyncSpinner spinner(1);
    spinner.start();
    latticeworld::MasterWatch master;
    master.Start({});
    ROS_INFO_STREAM("the world is at " << (*viewer)->address());
    while (!ros::isShuttingDown()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const latticeworld::ShutdownGuard guard(std::chrono::milliseconds(1500));
    ros::waitForShutdown();
    master.Stop();
    (*viewer).reset();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("world_viewer: " << error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
