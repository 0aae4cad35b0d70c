#include "latticeworld_ros/conversion/journal_conversion.h"

#include <utility>

#include "latticeworld/episode/journal_json.h"

namespace latticeworld {
namespace {

constexpr char kMapFrame[] = "map";

}  // namespace

latticeworld_msgs::JournalEntry ToJournalEntryMessage(const JournalEntry& entry, ros::Time stamp,
                                                      const std::string& world_id,
                                                      std::uint64_t run) {
  latticeworld_msgs::JournalEntry message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.run = run;
  message.number = entry.number;
  message.step = entry.step;
  message.call = EncodeCall(entry.call);
  return message;
}

Result<JournalEntry> ToJournalEntry(const latticeworld_msgs::JournalEntry& message) {
  auto call = DecodeCall(message.call);
  if (!call.ok()) {
    return call.status().WithContext("call " + std::to_string(message.number));
  }
  return JournalEntry{message.number, message.step, *std::move(call)};
}

RecordedHash ToRecordedHash(const latticeworld_msgs::StateHash& message) {
  return {message.step, message.calls, message.state_hash};
}

std::vector<latticeworld_msgs::WorldFile> ToWorldFileMessages(const std::vector<WorldFile>& files) {
  std::vector<latticeworld_msgs::WorldFile> messages(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    messages[i].path = files[i].path;
    messages[i].data.assign(files[i].data.begin(), files[i].data.end());
  }
  return messages;
}

std::vector<WorldFile> ToWorldFiles(const std::vector<latticeworld_msgs::WorldFile>& messages) {
  std::vector<WorldFile> files(messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i) {
    files[i].path = messages[i].path;
    files[i].data.assign(messages[i].data.begin(), messages[i].data.end());
  }
  return files;
}

}  // namespace latticeworld
