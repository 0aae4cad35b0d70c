#ifndef LATTICEWORLD_ROS_NODE_DESCRIPTORS_H_
#define LATTICEWORLD_ROS_NODE_DESCRIPTORS_H_

#include <cstddef>

namespace latticeworld {

// A topic takes a file descriptor for each node at its other end. Where a process has no more of
// them, roscpp leaves connections out without a word.
struct DescriptorUse {
  std::size_t open = 0;   // of this process
  std::size_t limit = 0;  // soft; 0: not known

  // Whether the next connections fail: roscpp takes no call any more when few are left.
  bool is_short() const;
};

// roscpp looks at all descriptors that there may be with every connection that it takes, and holds
// 8 bytes for each meanwhile: beyond this many that would take milliseconds.
inline constexpr std::size_t kMostDescriptors = 65536;

// Raises the soft limit of this process to the hard one, or to kMostDescriptors where that is less;
// never lowers it. Returns the soft limit.
std::size_t RaiseDescriptorLimit();

DescriptorUse CountDescriptors();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_DESCRIPTORS_H_
