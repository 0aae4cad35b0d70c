#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDER_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDER_H_

#include <ros/ros.h>

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/episode/episode_listener.h"
#include "latticeworld_ros/episode/episode_recorder_options.h"
#include "latticeworld_ros/episode/episode_recording.h"
#include "latticeworld_ros/episode/episode_request.h"
#include "latticeworld_ros/episode/server_watch.h"
#include "latticeworld_ros/node/service_queue.h"

namespace latticeworld {

// The node: start_episode, stop_episode, list_episodes, and episode/status. One episode at a time;
// it hears what world_server and all others publish, and asks world_server for what it cannot hear.
class EpisodeRecorder {
 public:
  // options: valid.
  EpisodeRecorder(ros::NodeHandle node, const EpisodeRecorderOptions& options);
  // Ends the episode that runs; its files are whole.
  ~EpisodeRecorder();

 private:
  struct Running {
    Running(const EpisodeRecordingOptions& options, const ros::NodeHandle& node,
            const TopicFilter& filter, const std::vector<std::string>& always);
    EpisodeRecording recording;
    ServerWatch server;
    EpisodeListener listener;
  };

  Status Start(const latticeworld_msgs::StartEpisode::Request& request,
               latticeworld_msgs::StartEpisode::Response* response);
  Status Stop(latticeworld_msgs::StopEpisode::Response* response);
  void List(latticeworld_msgs::ListEpisodes::Response* response) const;

  // What a request says, with the name of the episode. Errors: INVALID_ARGUMENT, ALREADY_EXISTS.
  Result<EpisodeRequest> Read(const latticeworld_msgs::StartEpisode::Request& request) const;
  // What hears the topics of an episode and gathers its messages. Errors: RESOURCE_EXHAUSTED.
  Result<std::unique_ptr<Running>> Hear(const EpisodeRecordingOptions& options,
                                        const TopicFilter& filter) const;
  // The state from which the episode goes on. Errors: UNAVAILABLE, those of world_server.
  Result<latticeworld_msgs::GetWorldBundle::Response> AskForWorld(bool files) const;
  Status ResetWorld(std::uint64_t seed) const;
  // reason: of an end that has none of its own. ask: world_server for what was not heard.
  Status Finish(const std::string& reason, bool ask);
  // The last calls, if the server is still the first one when it has answered.
  Result<latticeworld_msgs::GetWorldBundle::Response> AskForLastCalls() const;

  // Looks for topics, tells the status, and ends an episode that has come to its end.
  void Supervise();
  void TellStatus();

  ros::NodeHandle node_;
  const EpisodeRecorderOptions options_;
  const std::filesystem::path directory_;
  ros::Publisher status_;

  std::mutex lifecycle_;              // held while an episode begins or ends
  std::unique_ptr<Running> running_;  // guarded by lifecycle_
  // Guarded by mutex_.
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stop_ = false;
  latticeworld_msgs::EpisodeStatus last_;  // as told last

  std::thread supervisor_;
  ServiceQueue services_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDER_H_
