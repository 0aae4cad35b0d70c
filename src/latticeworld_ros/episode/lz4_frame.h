#ifndef LATTICEWORLD_ROS_EPISODE_LZ4_FRAME_H_
#define LATTICEWORLD_ROS_EPISODE_LZ4_FRAME_H_

#include <filesystem>

namespace latticeworld {

// Whether a bag has a chunk that begins as a legal LZ4 frame of a kind that roslz4 does not read:
// it reads frames of independent blocks with a checksum of the content, and without its size,
// checksums of blocks or a dictionary. False also where the file cannot be read that far.
bool HasForeignLz4Frame(const std::filesystem::path& bag);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_LZ4_FRAME_H_
