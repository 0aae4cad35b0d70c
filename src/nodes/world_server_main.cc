// The world server: generate_world turns text into a running world, and everything around it.
// Parameters: launch_cfg/world_server.yaml. Services and topics: docs/interfaces.md.

#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <thread>
#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld_ros/node/node_start.h"
#include "latticeworld_ros/node/parameters.h"
#include "latticeworld_ros/node/shutdown_guard.h"
#include "latticeworld_ros/server/world_server.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow fails to be written, no more
  ros::init(argc, argv, "world_server");
  // roscpp hears SIGINT only; without taking leave the master would keep this node's topics.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  latticeworld::PrepareNode();

  // Parameters, models and files that are not legal end the node at once.
  XmlRpc::XmlRpcValue parameters;
  (void)ros::param::get(ros::this_node::getName(), parameters);  // none at all is legal
  const auto options = latticeworld::OptionsFromParameters(parameters);
  if (!options.ok()) {
    ROS_FATAL_STREAM(options.status().ToString());
    return EXIT_FAILURE;
  }
  latticeworld::LocalModelOptions local = options->local;
  local.layout_model = latticeworld::ExpandHome(local.layout_model).string();
  local.environment_model = latticeworld::ExpandHome(local.environment_model).string();
  latticeworld::ReaderModelOptions reader = options->reader_model;
  reader.model = latticeworld::ExpandHome(reader.model).string();
  auto language = latticeworld::LoadLanguage(options->remote, local, reader);
  if (!language.ok()) {
    ROS_FATAL_STREAM(language.status().ToString());
    return EXIT_FAILURE;
  }
  auto sketches = latticeworld::SketchTranslator::Load(
      latticeworld::ExpandHome(options->sketch_model).string());
  if (!sketches.ok()) {
    ROS_FATAL_STREAM(sketches.status().WithContext("sketch_model").ToString());
    return EXIT_FAILURE;
  }
  auto catalogue = latticeworld::Catalogue::BuiltIn();
  if (!options->catalogue.empty()) {
    auto loaded = latticeworld::Catalogue::Load({latticeworld::ExpandHome(options->catalogue)});
    if (!loaded.ok()) {
      ROS_FATAL_STREAM(loaded.status().WithContext("catalogue").ToString());
      return EXIT_FAILURE;
    }
    catalogue = *std::move(loaded);
  }
  try {
    // The node serves until ROS shuts down.
    ros::NodeHandle node;
    auto server = std::make_unique<latticeworld::WorldServer>(node, *options, *std::move(language),
                                                              *std::move(sketches), catalogue);
    ROS_INFO("ready: call generate_world or load_world");
    // From the first word of it on: taking leave of a master that hangs has no end either.
    while (!ros::isShuttingDown()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const latticeworld::ShutdownGuard guard(std::chrono::milliseconds(1500));
    ros::waitForShutdown();
    server.reset();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("world_server: " << error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
