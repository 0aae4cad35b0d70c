#ifndef LATTICEWORLD_ROS_PUBLISHING_WORLD_MESSAGES_H_
#define LATTICEWORLD_ROS_PUBLISHING_WORLD_MESSAGES_H_

#include <grid_map_msgs/GridMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <octomap_msgs/Octomap.h>
#include <ros/time.h>
#include <sensor_msgs/Image.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/shared_ptr.hpp>
#include <memory>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/server/world_server_options.h"

namespace latticeworld {

// Every latched message of a world. They are made before the world runs, get its stamp when it
// begins, and never change afterwards.
struct WorldMessages {
  boost::shared_ptr<latticeworld_msgs::WorldInfo> info;
  boost::shared_ptr<latticeworld_msgs::Layout> layout;
  boost::shared_ptr<latticeworld_msgs::Environment> environment;
  boost::shared_ptr<octomap_msgs::Octomap> octomap_full;
  boost::shared_ptr<octomap_msgs::Octomap> octomap_binary;
  boost::shared_ptr<nav_msgs::OccupancyGrid> map;
  boost::shared_ptr<nav_msgs::OccupancyGrid> scan_map;
  boost::shared_ptr<grid_map_msgs::GridMap> height_map;
  boost::shared_ptr<sensor_msgs::Image> height_image;
  boost::shared_ptr<visualization_msgs::MarkerArray> markers;
};

// Height map and octomaps are made coarser, and markers fewer, where their message would have
// options.most_message_bytes or more.
// stages: gets what was done and how long it took. Works on two threads. Errors: CANCELLED,
// INVALID_ARGUMENT (an octree resolution that does not suit the world).
Result<WorldMessages> BuildWorldMessages(const World& world, const WorldServerOptions& options,
                                         const Progress& progress, std::vector<StageTime>* stages);

// What maps showed so far.
struct ShownMaps {
  const WorldMessages& messages;
  const SceneChanges& changes;
};

// The messages of a world in which things fell, moved or went, or weather made another ground: map
// and height map are made anew with that stamp, octomaps, scan map and markers where more than the
// ground is different, and all others are the ones of before. Works on one thread, for the world
// runs meanwhile. Errors: CANCELLED, INVALID_ARGUMENT.
Result<WorldMessages> RebuildMaps(const World& world, const WorldServerOptions& options,
                                  const SceneChanges& changes, ros::Time stamp,
                                  const Progress& progress, const ShownMaps& before);

// Sets the stamp of all of them.
void SetStamp(ros::Time stamp, WorldMessages* messages);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_WORLD_MESSAGES_H_
