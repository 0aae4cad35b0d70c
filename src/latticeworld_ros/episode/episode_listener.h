#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_LISTENER_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_LISTENER_H_

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld_ros/episode/bag_file.h"

namespace latticeworld {

// Which topics an episode holds.
class TopicFilter {
 public:
  // patterns: regular expressions (ECMAScript without references back) of whole names; empty: the
  // usual ones. sensors: those of sensors too. Errors: INVALID_ARGUMENT with every violation:
  // "topics[2]".
  static Result<TopicFilter> Create(const std::vector<std::string>& patterns, bool sensors);
  bool Matches(const std::string& topic) const;
  const std::vector<std::string>& patterns() const { return patterns_; }

 private:
  std::vector<std::string> patterns_;
  std::vector<std::regex> expressions_;
};

// Hears every topic that a filter lets through, those that appear later too, of any type, on a
// thread of its own.
class EpisodeListener {
 public:
  using Sink = std::function<void(BagMessage)>;
  // always: topics that are heard although nobody may publish them yet.
  EpisodeListener(ros::NodeHandle node, TopicFilter filter, const std::vector<std::string>& always,
                  Sink sink);
  ~EpisodeListener();
  EpisodeListener(const EpisodeListener&) = delete;
  EpisodeListener& operator=(const EpisodeListener&) = delete;

  // Asks the master what there is, and hears what is new. Call from one thread at a time.
  void Discover();
  // Topics that somebody publishes and that are not connected. nullopt: the master does not say.
  std::optional<std::vector<std::string>> Unconnected() const;

 private:
  void Subscribe(const std::string& topic);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  const TopicFilter filter_;
  const Sink sink_;
  std::map<std::string, ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_LISTENER_H_
