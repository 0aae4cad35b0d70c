#ifndef LATTICEWORLD_ROS_NODE_NODE_START_H_
#define LATTICEWORLD_ROS_NODE_NODE_START_H_

namespace latticeworld {

// What every node does after ros::init and before its first NodeHandle, which decides for good what
// time it lives in.
//
// Sets /use_sim_time where it is unset, so that time is world_server's in whatever order nodes
// start; false, where somebody has said so, stays. Raises the limit of descriptors (descriptors.h).
// Lets all threads have one heap (glibc's mallopt).
void PrepareNode();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_NODE_START_H_
