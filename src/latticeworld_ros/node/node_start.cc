#include "latticeworld_ros/node/node_start.h"

#include <malloc.h>
#include <ros/param.h>

#include "latticeworld_ros/node/descriptors.h"

namespace latticeworld {

void PrepareNode() {
  (void)RaiseDescriptorLimit();
#if defined(M_ARENA_MAX)
  // Threads share one heap. glibc gives each one of its own, where memory stays that others could
  // have: making worlds of 32 to 256 m one after the other, world_server took 168 to 209 MB, now
  // some 120. Few allocations are large enough to wait for each other.
  mallopt(M_ARENA_MAX, 1);
#endif
  if (!ros::param::has("/use_sim_time")) ros::param::set("/use_sim_time", true);
}

}  // namespace latticeworld
