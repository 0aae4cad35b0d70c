#include "latticeworld_ros/episode/episode_recording.h"

#include <ros/console.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <system_error>

#include "latticeworld/simulation/journaled_simulator.h"
#include "latticeworld_ros/episode/bag_message.h"
#include "latticeworld_ros/episode/bag_stamp.h"
#include "latticeworld_ros/episode/server_watch.h"

namespace latticeworld {
namespace {

using latticeworld_msgs::EpisodeEnd;
using latticeworld_msgs::GetWorldBundle;
using latticeworld_msgs::StateHash;
using JournalMessage = latticeworld_msgs::JournalEntry;

constexpr char kClockTopic[] = "/clock";
// What a killed recorder loses, of wall time.
constexpr std::chrono::seconds kFlushPeriod(1);
// Messages of before the start are left out, but for latched ones; stamps of the clock lag a
// little.
const ros::Duration kLag(1.0);
// Stamps that lie further ahead are of another clock, the wall's mostly. Those of one clock lie
// ahead where the clock was heard later than they were, and of plans.
const ros::Duration kFurthestAhead(60.0);

}  // namespace

EpisodeRecording::EpisodeRecording(EpisodeRecordingOptions options)
    : options_(std::move(options)) {}

EpisodeRecording::~EpisodeRecording() { (void)End("the recorder was ended", nullptr); }

void EpisodeRecording::Add(BagMessage message) {
  const BagStamp stamp = StampOf(message);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stop_ || !progress_.reason.empty()) return;
    if (const std::uint64_t missing = gaps_.MissingBefore(message, stamp); missing > 0) {
      progress_.dropped += missing;
      ROS_WARN_STREAM_THROTTLE(10.0, missing << " messages of " << message.topic
                                             << " were lost on the way to the recorder; a slower "
                                                "real_time_factor or fewer topics help");
    }
    if (waiting_bytes_ + message.bytes() > options_.buffer_bytes) {
      ++progress_.dropped;
      return;
    }
    waiting_bytes_ += message.bytes();
    waiting_.emplace_back(std::move(message), stamp.stamp);
  }
  changed_.notify_one();
}

Status EpisodeRecording::Begin(latticeworld_msgs::EpisodeStart start,
                               latticeworld_msgs::WorldFiles world) {
  start_ = std::move(start);
  world_ = std::move(world);
  part_time_ = last_time_ = std::max(start_.header.stamp, ros::TIME_MIN);
  for (const JournalMessage& entry : start_.journal) journal_bytes_ += entry.call.size();
  last_call_ = start_.calls;
  Status opened = OpenPart();
  if (opened.ok()) {
    try {
      thread_ = std::thread([this] { Run(); });
    } catch (const std::system_error& error) {
      opened = ResourceExhausted(std::string("no thread can be had to write it: ") + error.what());
    }
  }
  if (!opened.ok()) {
    // Nothing is left of an episode that could not begin.
    if (file_ != nullptr && ClosePart().ok()) {
      std::error_code ignored;
      std::filesystem::remove(progress().paths.back(), ignored);
    }
  }
  return opened;
}

Status EpisodeRecording::End(const std::string& reason, const GetWorldBundle::Response* last) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  WantEnd(reason, /*failed=*/false);
  Status closed;
  if (file_ != nullptr) {
    if (last != nullptr) AddMissingCalls(*last);
    WriteEnd();
    closed = ClosePart();
    if (!closed.ok()) ROS_ERROR_STREAM(closed.ToString());
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_.done = true;
  return closed;
}

void EpisodeRecording::WriteEnd() {
  EpisodeEnd end;
  end.header.stamp = last_time_;
  end.header.frame_id = "map";
  end.name = start_.name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [first, until] : missing_) progress_.missing_calls += until - first + 1;
    end.reason = progress_.reason;
    end.messages = progress_.messages;
    end.dropped = progress_.dropped;
    end.missing_calls = progress_.missing_calls;
  }
  (void)file_->Write(ToBag(kEpisodeEndTopic, last_time_, end), /*last=*/true);
}

EpisodeProgress EpisodeRecording::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

bool EpisodeRecording::ended() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !progress_.reason.empty();
}

void EpisodeRecording::WantEnd(const std::string& reason, bool failed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!progress_.reason.empty()) return;
  progress_.reason = reason;
  progress_.failed = failed;
}

void EpisodeRecording::Run() {
  auto flush_due = std::chrono::steady_clock::now() + kFlushPeriod;
  for (;;) {
    decltype(waiting_) messages;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait_until(lock, flush_due, [this] { return stop_ || !waiting_.empty(); });
      if (stop_ && waiting_.empty()) return;
      messages.swap(waiting_);
      waiting_bytes_ = 0;
    }
    for (auto& [message, stamp] : messages) {
      if (!ended()) WriteOne(std::move(message), stamp);
    }
    if (std::chrono::steady_clock::now() < flush_due) continue;
    flush_due = std::chrono::steady_clock::now() + kFlushPeriod;
    const Status flushed = ended() ? Status() : file_->Flush();
    if (!flushed.ok()) WantEnd(flushed.ToString(), /*failed=*/true);
  }
}

void EpisodeRecording::WriteOne(BagMessage message, const std::optional<ros::Time>& stamp) {
  if (message.topic == kClockTopic && !KeepClock(message)) return;
  if (!message.latched() && message.time + kLag < start_.header.stamp) return;
  if (!Keep(message)) return;
  message.time = KeptTime(stamp, message.time);
  last_time_ = std::max(last_time_, message.time);
  if (message.latched()) {
    latched_[message.topic + " " + message.caller()] = message;
  }
  Status written = file_->Write(message);
  if (written.ok() && options_.split_bytes != 0 && file_->bytes() > options_.split_bytes) {
    written = NextPart();
  }
  if (!written.ok()) return WantEnd(written.ToString(), /*failed=*/true);
  const std::uint64_t bytes = finished_bytes_ + file_->bytes();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++progress_.messages;
    progress_.bytes = bytes;
  }
  if (options_.max_bytes != 0 && bytes > options_.max_bytes) {
    WantEnd("max_mb is reached", /*failed=*/false);
  }
}

ros::Time EpisodeRecording::KeptTime(const std::optional<ros::Time>& stamp, ros::Time heard) const {
  const bool usable = stamp && *stamp <= std::max(heard, last_clock_) + kFurthestAhead;
  return std::max(usable ? *stamp : heard, part_time_);
}

bool EpisodeRecording::KeepClock(const BagMessage& message) {
  const auto clock = FromBag<rosgraph_msgs::Clock>(message);
  if (clock == nullptr) return true;
  if (clock->clock < last_clock_) {
    WantEnd(std::string("time runs backward: ") + kAnotherServer, /*failed=*/false);
    return false;
  }
  last_clock_ = clock->clock;
  if (options_.max_duration_s > 0.0 &&
      last_clock_ >= start_.header.stamp + ros::Duration(options_.max_duration_s)) {
    WantEnd("max_duration is reached", /*failed=*/false);
  }
  return true;
}

bool EpisodeRecording::IsOurs(std::uint64_t run) {
  if (run > start_.run) {
    WantEnd("another world has taken the place of this one", /*failed=*/false);
  }
  return run == start_.run;
}

bool EpisodeRecording::KeepHash(const BagMessage& message) {
  const auto hash = FromBag<StateHash>(message);
  if (hash == nullptr) return false;
  // Runs and steps of one server never fall.
  if (last_hash_step_ > 0 && (hash->run < start_.run || hash->step < last_hash_step_)) {
    WantEnd(kAnotherServer, /*failed=*/false);
    return false;
  }
  if (!IsOurs(hash->run) || hash->step < start_.step) return false;
  last_hash_step_ = hash->step;
  return true;
}

bool EpisodeRecording::Keep(const BagMessage& message) {
  if (message.topic == options_.topics.state_hash) return KeepHash(message);
  if (message.topic != options_.topics.journal) return true;
  const auto entry = FromBag<JournalMessage>(message);
  if (entry == nullptr || !IsOurs(entry->run) || entry->number <= last_call_) return false;
  KeepCall(*entry);
  return true;
}

void EpisodeRecording::KeepCall(const JournalMessage& entry) {
  if (entry.number != last_call_ + 1) {
    missing_.emplace_back(last_call_ + 1, entry.number - 1);
    start_.journal_complete = false;
  }
  last_call_ = entry.number;
  if (options_.split_bytes == 0) return;  // no part comes that would begin with them
  journal_bytes_ += entry.call.size() + sizeof(JournalMessage);
  if (journal_bytes_ > kMaxJournalBytes) {
    start_.journal_complete = false;
    start_.journal.clear();
  } else {
    start_.journal.push_back(entry);
  }
}

void EpisodeRecording::AddMissingCalls(const GetWorldBundle::Response& last) {
  if (last.run != start_.run || last.world_id != start_.world_id) return;
  if (last.calls > last_call_) missing_.emplace_back(last_call_ + 1, last.calls);
  last_time_ = std::max(last_time_, last.stamp);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> still_missing;
  for (const auto& [first, until] : missing_) {
    std::uint64_t next = first;
    for (const JournalMessage& entry : last.journal) {
      if (entry.number != next || next > until) continue;
      const ros::Time time = KeptTime(entry.header.stamp, last_time_);
      if (!file_->Write(ToBag(options_.topics.journal, time, entry)).ok()) break;
      ++next;
    }
    if (next <= until) still_missing.emplace_back(next, until);
  }
  missing_ = std::move(still_missing);
  StateHash hash;
  hash.header.stamp = last.stamp;
  hash.header.frame_id = "map";
  hash.world_id = last.world_id;
  hash.run = last.run;
  hash.calls = last.calls;
  hash.step = last.step;
  hash.episode_step = last.episode_step;
  hash.state_hash = last.state_hash;
  (void)file_->Write(ToBag(options_.topics.state_hash, last_time_, hash), /*last=*/true);
}

std::filesystem::path EpisodeRecording::PartPath(std::uint32_t part) const {
  const std::string number = options_.split_bytes == 0 ? "" : ".part" + std::to_string(part);
  return options_.directory / (options_.name + number + ".bag");
}

Status EpisodeRecording::OpenPart() {
  LW_ASSIGN_OR_RETURN(file_, BagFile::Create(PartPath(start_.part), options_.compression));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.active_path = file_->active_path().string();
  }
  LW_RETURN_IF_ERROR(file_->Write(ToBag(kEpisodeStartTopic, part_time_, start_, true)));
  LW_RETURN_IF_ERROR(file_->Write(ToBag(kEpisodeWorldTopic, part_time_, world_, true)));
  for (const auto& [publisher, message] : latched_) {
    BagMessage again = message;
    again.time = part_time_;
    LW_RETURN_IF_ERROR(file_->Write(again));
  }
  LW_RETURN_IF_ERROR(file_->Flush());
  if (options_.split_bytes != 0 && 2 * file_->bytes() > options_.split_bytes) {
    return ResourceExhausted("split_mb leaves no room: what every file begins with takes " +
                             std::to_string((file_->bytes() >> 20) + 1) + " MiB");
  }
  return Status();
}

Status EpisodeRecording::NextPart() {
  LW_RETURN_IF_ERROR(ClosePart());
  ++start_.part;
  part_time_ = std::max(part_time_, last_clock_);
  return OpenPart();
}

Status EpisodeRecording::ClosePart() {
  const Status finished = file_->Finish();
  const std::unique_ptr<BagFile> file = std::move(file_);
  finished_bytes_ += file->bytes();
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_.bytes = finished_bytes_;
  if (finished.ok()) {
    progress_.paths.push_back(file->path().string());
    progress_.active_path.clear();
  }
  return finished;
}

}  // namespace latticeworld
