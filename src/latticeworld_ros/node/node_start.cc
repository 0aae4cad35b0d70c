#include "latticeworld_ros/node/node_start.h"

#include <ros/param.h>

#include "latticeworld_ros/node/descriptors.h"

namespace latticeworld {

void PrepareNode() {
  (void)RaiseDescriptorLimit();
  if (!ros::param::has("/use_sim_time")) ros::param::set("/use_sim_time", true);
}

}  // namespace latticeworld
