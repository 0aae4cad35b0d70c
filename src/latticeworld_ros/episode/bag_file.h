#ifndef LATTICEWORLD_ROS_EPISODE_BAG_FILE_H_
#define LATTICEWORLD_ROS_EPISODE_BAG_FILE_H_

#include <ros/time.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld_ros/episode/disk_reserve.h"

namespace latticeworld {

enum class BagCompression : std::uint8_t { kNone, kLz4, kBz2 };
constexpr std::array<EnumName<BagCompression>, 3> EnumNames(BagCompression) {
  return {{{BagCompression::kNone, "none"},
           {BagCompression::kLz4, "lz4"},
           {BagCompression::kBz2, "bz2"}}};
}

// A message of any type, and where it came from.
struct BagMessage {
  std::string topic;
  ros::Time time;  // under which it is kept; when it was heard, before that is decided
  topic_tools::ShapeShifter::ConstPtr message;
  // The connection has it, and its threads read it too: it is never changed. Null: one is made of
  // the message.
  boost::shared_ptr<ros::M_string> header;

  std::uint64_t bytes() const { return message->size(); }
  bool latched() const;
  std::string caller() const;  // the node that published it; empty: the header does not say
};

// One rosbag that is being written: NAME.active until it is whole. What was written is readable
// after rosbag reindex, whatever becomes of this process, up to the last Flush. Room on the disk is
// taken before a message is written, its index included, so that a full disk leaves a whole bag.
class BagFile {
 public:
  // path: as it is called once it is whole. Errors: ALREADY_EXISTS (whole or active),
  // RESOURCE_EXHAUSTED, NOT_FOUND, PERMISSION_DENIED, INTERNAL.
  static Result<std::unique_ptr<BagFile>> Create(const std::filesystem::path& path,
                                                 BagCompression compression);
  ~BagFile();  // finishes it

  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  // Errors: RESOURCE_EXHAUSTED (nothing was written: Finish makes a whole bag), INTERNAL (the disk
  // fails, and nothing more can be done with this file).
  // last: it is small, and room for it is there already.
  Status Write(const BagMessage& message, bool last = false);
  // Ends the chunk that is open, so that it can be read whatever happens. Errors: INTERNAL.
  Status Flush();
  // Writes the index, waits for the disk and gives the file its name. Errors: INTERNAL, and those
  // of RenameFile.
  Status Finish();

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& active_path() const { return active_path_; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  explicit BagFile(std::filesystem::path path);
  // What the index takes that Finish writes, at most.
  std::uint64_t IndexBytes() const;
  void CountChunk();
  // INTERNAL: there is nothing more that can be done with the file.
  Status GiveUp(const std::string& why);

  const std::filesystem::path path_, active_path_;
  DiskReserve reserve_;
  std::unique_ptr<rosbag::Bag> bag_;                  // null: finished, or given up
  std::uint64_t bytes_ = 0;                           // of the file, roughly
  std::uint64_t open_bytes_ = 0, open_messages_ = 0;  // of the open chunk, without compression
  std::uint64_t chunks_ = 0;
  std::set<std::string> connections_;   // topics and who publishes them
  std::uint64_t definition_bytes_ = 0;  // of their types
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_BAG_FILE_H_
