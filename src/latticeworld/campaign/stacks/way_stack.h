#ifndef LATTICEWORLD_CAMPAIGN_STACKS_WAY_STACK_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_WAY_STACK_H_

#include <memory>

#include "latticeworld/campaign/stacks/robot_stack.h"

namespace latticeworld {

// Pure pursuit (Coulter 1992) along the task's shortest way. It sees nothing.
std::unique_ptr<RobotStack> MakeWayStack();

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_WAY_STACK_H_
