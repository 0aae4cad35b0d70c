#ifndef LATTICEWORLD_ROS_EPISODE_BAG_CHECK_H_
#define LATTICEWORLD_ROS_EPISODE_BAG_CHECK_H_

#include <filesystem>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Checks that a bag is well formed before rosbag reads it, which ends the process on some damaged
// bags: that records and their fields lie within the file, and those of chunks within their chunk;
// that chunks unpack to the size that they name, 1 GiB at most; that indices lead to messages; that
// the bag is not encrypted. Reads the whole bag once, a chunk at a time. Errors: DATA_LOSS saying
// at which byte what is wrong; NOT_FOUND. A bag without an index is left to rosbag, which refuses
// it.
Status CheckBag(const std::filesystem::path& bag);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_BAG_CHECK_H_
