#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDING_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDING_H_

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/episode/bag_file.h"
#include "latticeworld_ros/episode/sequence_gaps.h"

namespace latticeworld {

// Topics of an episode's own, and those that it is proven with.
struct EpisodeTopics {
  std::string journal = "/world/journal";
  std::string state_hash = "/world/state_hash";
};
inline constexpr char kEpisodeStartTopic[] = "/episode/start";
inline constexpr char kEpisodeWorldTopic[] = "/episode/world";
inline constexpr char kEpisodeEndTopic[] = "/episode/end";
inline constexpr std::uint32_t kEpisodeFormat = 1;

struct EpisodeRecordingOptions {
  std::filesystem::path directory;
  std::string name;
  BagCompression compression = BagCompression::kLz4;
  std::uint64_t split_bytes = 0;            // 0: one file
  std::uint64_t max_bytes = 0;              // of all files; 0: no limit
  double max_duration_s = 0.0;              // of simulated time; 0: no limit
  std::uint64_t buffer_bytes = 256u << 20;  // of messages that wait for the disk
  EpisodeTopics topics;
};

// How far a recording is.
struct EpisodeProgress {
  std::vector<std::string> paths;  // that are whole
  std::string active_path;         // empty: none
  std::uint64_t bytes = 0, messages = 0, dropped = 0;
  std::string reason;   // why it wants to be ended, or was; empty: it goes on
  bool failed = false;  // the reason is an error
  bool done = false;    // nothing is written any more
  std::uint64_t missing_calls = 0;
};

// One episode on its way into its bags: messages are gathered by the threads that hear them and
// written by one of its own. Each file begins with what the episode began with, the world's files
// and the last latched messages, so that it can be used alone. A message's time in the bag is its
// stamp, and not when it came to be heard; that of what has no stamp, or one of another clock, is
// when it was heard. What is older than its file is at the file's beginning.
class EpisodeRecording {
 public:
  // Messages can be added from now on; none is written before Begin.
  explicit EpisodeRecording(EpisodeRecordingOptions options);
  ~EpisodeRecording();  // without End the files are finished all the same
  EpisodeRecording(const EpisodeRecording&) = delete;
  EpisodeRecording& operator=(const EpisodeRecording&) = delete;

  // Thread safe; drops the message where too many wait for the disk. What is dropped counts, and
  // what was lost on the way here does too.
  void Add(BagMessage message);
  // Makes the first file. Errors: as BagFile::Create.
  Status Begin(latticeworld_msgs::EpisodeStart start, latticeworld_msgs::WorldFiles world);
  // Writes what waits, the calls of `last` that were not heard of (null: it could not be asked for)
  // and the end, and finishes the last file. reason: where the recording has none of its own.
  // Errors: INTERNAL (the disk failed).
  Status End(const std::string& reason, const latticeworld_msgs::GetWorldBundle::Response* last);

  EpisodeProgress progress() const;
  const EpisodeRecordingOptions& options() const { return options_; }

 private:
  void Run();
  void WriteOne(BagMessage message, const std::optional<ros::Time>& stamp);
  // Returns the time under which a message is kept. heard: when it was.
  ros::Time KeptTime(const std::optional<ros::Time>& stamp, ros::Time heard) const;
  // False: the message is of another simulation, or is known already.
  bool Keep(const BagMessage& message);
  // False: time has run backward, which that of one server never does.
  bool KeepClock(const BagMessage& message);
  bool KeepHash(const BagMessage& message);
  // Returns whether the run is the recorded one; if it comes after that, the episode is over.
  bool IsOurs(std::uint64_t run);
  void KeepCall(const latticeworld_msgs::JournalEntry& entry);
  void AddMissingCalls(const latticeworld_msgs::GetWorldBundle::Response& last);
  void WriteEnd();
  // Errors: as BagFile::Create and Write.
  Status OpenPart();
  Status NextPart();
  Status ClosePart();
  std::filesystem::path PartPath(std::uint32_t part) const;
  void WantEnd(const std::string& reason, bool failed);
  bool ended() const;

  const EpisodeRecordingOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  // guarded by mutex_
  std::deque<std::pair<BagMessage, std::optional<ros::Time>>> waiting_;  // and their stamps
  std::uint64_t waiting_bytes_ = 0;                                      // guarded by mutex_
  bool stop_ = false;                                                    // guarded by mutex_
  EpisodeProgress progress_;                                             // guarded by mutex_
  SequenceGaps gaps_;                                                    // guarded by mutex_

  // Only the writing thread touches these, and Begin and End while it does not run.
  latticeworld_msgs::EpisodeStart start_;
  latticeworld_msgs::WorldFiles world_;
  std::unique_ptr<BagFile> file_;  // null: none is open
  std::uint64_t finished_bytes_ = 0;
  std::uint64_t journal_bytes_ = 0;
  std::uint64_t last_call_ = 0;
  ros::Time part_time_;   // at which the file begins that is open
  ros::Time last_time_;   // of all that is kept
  ros::Time last_clock_;  // that was heard
  std::uint64_t last_hash_step_ = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> missing_;  // first and last call of each gap
  std::map<std::string, BagMessage> latched_;                     // by topic and publisher
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_RECORDING_H_
