#ifndef LATTICEWORLD_ROS_PUBLISHING_SCENE_PUBLISHER_H_
#define LATTICEWORLD_ROS_PUBLISHING_SCENE_PUBLISHER_H_

#include <ros/ros.h>

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/simulation/world_state.h"
#include "latticeworld_ros/running/map_follower.h"
#include "latticeworld_ros/running/simulation_listener.h"

namespace latticeworld {

// props (latched; while something of them changes) and world/changes (latched; when trees begin
// to fall or come to rest, or something breaks), and the maps, which follow. On the simulation
// loop's thread.
class ScenePublisher {
 public:
  // maps: outlives the publisher.
  ScenePublisher(ros::NodeHandle node, MapFollower* maps);

  void Publish(const Tick& tick, const WorldState& state);
  // The next state is no successor of the last one: everything is told again.
  void OnJump();

 private:
  // What world/changes tells apart.
  struct Standing {
    std::vector<std::uint32_t> falling, at_rest;  // assets
    std::vector<std::string> broken;              // props
    std::uint64_t map_version = 0;
  };
  static Standing StandingOf(const WorldState& state);

  MapFollower* const maps_;
  ros::Publisher props_, changes_;
  bool jumped_ = true;
  std::vector<PropSnapshot> told_props_;
  Standing told_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_SCENE_PUBLISHER_H_
