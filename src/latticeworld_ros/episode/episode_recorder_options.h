#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDER_OPTIONS_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDER_OPTIONS_H_

#include <XmlRpcValue.h>

#include <string>

#include "latticeworld/common/result.h"

namespace latticeworld {

// The parameters of episode_recorder; launch_cfg/episode_recorder.yaml has one entry a field.
struct EpisodeRecorderOptions {
  std::string directory = "~/.ros/latticeworld/episodes";
  std::string compression = "lz4";  // none, lz4, bz2
  int buffer_mb = 256;              // [1, 65536] of messages that wait for the disk [MiB]
};

// The options that the node's private parameters say; absent ones keep their defaults. Errors:
// INVALID_ARGUMENT naming every unknown name, wrong type and illegal value.
Result<EpisodeRecorderOptions> RecorderOptionsFromParameters(const XmlRpc::XmlRpcValue& parameters);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDER_OPTIONS_H_
