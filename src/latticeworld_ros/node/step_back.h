#ifndef LATTICEWORLD_ROS_NODE_STEP_BACK_H_
#define LATTICEWORLD_ROS_NODE_STEP_BACK_H_

namespace latticeworld {

// The calling thread, and those that it makes, step back behind the simulation's where there are
// too few cores, whatever priority the process was started with: a world or a map may take a little
// longer to make, the clock must not stall. Calling it again changes nothing. A wish: where the
// system refuses it, nothing happens.
void StepBack();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_STEP_BACK_H_
