#ifndef LATTICEWORLD_CAMPAIGN_STACKS_PROGRAM_STACK_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_PROGRAM_STACK_H_

#include <memory>

#include "latticeworld/campaign/stacks/robot_stack.h"

namespace latticeworld {

// A program of the user's, in lockstep with the simulation: started by Begin, asked at every step,
// ended with this object. Whatever it does wrong fails the trial, with the reason.
std::unique_ptr<RobotStack> MakeProgramStack(const StackProgram& program);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_PROGRAM_STACK_H_
