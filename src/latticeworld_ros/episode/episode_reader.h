#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_READER_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_READER_H_

#include <rosbag/bag.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/episode/episode_record.h"
#include "latticeworld/episode/replay.h"
#include "latticeworld/generation/world.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// A recorded episode, read from its bags alone. Errors of all: DATA_LOSS (the bag is damaged, was
// not closed, or lacks something, which is named), FAILED_PRECONDITION (of another version, or
// compressed as rosbag cannot read it).
class EpisodeReader {
 public:
  // paths: of one episode's parts, in order; at least one. Also: NOT_FOUND, INVALID_ARGUMENT (parts
  // of different episodes).
  static Result<std::unique_ptr<EpisodeReader>> Open(
      const std::vector<std::filesystem::path>& paths);

  const latticeworld_msgs::EpisodeStart& start() const { return start_; }
  const std::vector<std::unique_ptr<rosbag::Bag>>& bags() const { return bags_; }

  // The world of the episode. Errors: as UnpackWorld.
  Result<std::shared_ptr<const World>> ReadWorld() const;
  // Reads where agents were and what happened.
  Result<EpisodeRecord> ReadRecord() const;
  // What the episode is simulated again by. warnings: gets what cannot be proven, and why.
  Result<ReplayPlan> ReadPlan(std::vector<std::string>* warnings) const;

 private:
  EpisodeReader() = default;

  // Every message of a type, with its topic.
  template <typename Message, typename Use>
  Status ForAll(const Use& use) const;

  std::vector<std::unique_ptr<rosbag::Bag>> bags_;
  latticeworld_msgs::EpisodeStart start_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_READER_H_
