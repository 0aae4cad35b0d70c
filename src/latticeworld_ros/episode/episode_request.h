#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_REQUEST_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_REQUEST_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/episode/episode_listener.h"
#include "latticeworld_ros/episode/episode_recording.h"

namespace latticeworld {

// What start_episode asks for.
struct EpisodeRequest {
  EpisodeRecordingOptions
      options;  // name (may be empty), compression and limits; the rest is usual
  TopicFilter filter;
};

// usual_compression: of a request that names none. Errors: INVALID_ARGUMENT with every violation.
Result<EpisodeRequest> ReadEpisodeRequest(const latticeworld_msgs::StartEpisode::Request& request,
                                          const std::string& usual_compression);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_REQUEST_H_
