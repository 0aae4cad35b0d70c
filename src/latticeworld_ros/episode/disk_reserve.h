#ifndef LATTICEWORLD_ROS_EPISODE_DISK_RESERVE_H_
#define LATTICEWORLD_ROS_EPISODE_DISK_RESERVE_H_

#include <cstdint>
#include <filesystem>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Takes room on the disk for a file before it is written, so that a writer that cannot go back,
// once begun, never begins what it cannot end. The file's length stays as it is. Where the file
// system cannot keep room, looks whether there is any.
class DiskReserve {
 public:
  DiskReserve() = default;
  ~DiskReserve() { Close(); }
  DiskReserve(const DiskReserve&) = delete;
  DiskReserve& operator=(const DiskReserve&) = delete;

  // Errors: NOT_FOUND, PERMISSION_DENIED, INTERNAL.
  Status Open(const std::filesystem::path& file);
  // Room for a file of that length. Errors: RESOURCE_EXHAUSTED saying what there is none of.
  Status Ensure(std::uint64_t bytes);
  // Gives back what the file did not grow into and waits until the disk has the file. Errors:
  // INTERNAL.
  Status Release();
  void Close();

 private:
  int file_ = -1;
  std::uint64_t ensured_bytes_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_DISK_RESERVE_H_
