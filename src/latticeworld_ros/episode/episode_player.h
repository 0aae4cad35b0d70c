#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_PLAYER_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_PLAYER_H_

#include <ros/ros.h>

#include "latticeworld/common/status.h"
#include "latticeworld_ros/episode/episode_reader.h"

namespace latticeworld {

// Publishes what an episode holds under the recorded stamps, the clock too; latched topics are
// latched. Left out is what only a world_server is meant for: commands, and what the proof needs.
// rate: recorded over wall time, > 0. Blocks until the end, or until ROS shuts down. Errors:
// FAILED_PRECONDITION (somebody else publishes the clock), DATA_LOSS.
Status PlayEpisode(ros::NodeHandle node, const EpisodeReader& reader, double rate);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_PLAYER_H_
