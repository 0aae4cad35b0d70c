#ifndef LATTICEWORLD_ROS_CONVERSION_JOURNAL_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_JOURNAL_CONVERSION_H_

#include <ros/time.h>

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/episode/replay.h"
#include "latticeworld/episode/world_files.h"
#include "latticeworld/simulation/journal.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// stamp: of the moment after the call.
latticeworld_msgs::JournalEntry ToJournalEntryMessage(const JournalEntry& entry, ros::Time stamp,
                                                      const std::string& world_id,
                                                      std::uint64_t run);
// Errors: DATA_LOSS saying which call is none.
Result<JournalEntry> ToJournalEntry(const latticeworld_msgs::JournalEntry& message);

RecordedHash ToRecordedHash(const latticeworld_msgs::StateHash& message);

std::vector<latticeworld_msgs::WorldFile> ToWorldFileMessages(const std::vector<WorldFile>& files);
std::vector<WorldFile> ToWorldFiles(const std::vector<latticeworld_msgs::WorldFile>& messages);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_JOURNAL_CONVERSION_H_
