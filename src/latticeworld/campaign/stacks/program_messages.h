#ifndef LATTICEWORLD_CAMPAIGN_STACKS_PROGRAM_MESSAGES_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_PROGRAM_MESSAGES_H_

#include <string>

#include "latticeworld/campaign/stacks/robot_stack.h"

namespace latticeworld {

// What a stack that is a program is told and answers: one JSON object a line, docs/campaigns.md.

// The first line: the robot, the goal and the map.
std::string EncodeBegin(const StackTask& task, const StackInput& start, double control_hz);
// One step. scans: whether those of the input are told.
std::string EncodeUpdate(const StackInput& input, bool scans);

// The answer to the first. Errors: FAILED_PRECONDITION (it refuses the task), INVALID_ARGUMENT.
Status DecodeReady(const std::string& line);
// The answer to a step. Errors: INVALID_ARGUMENT with what is legal.
Result<StackOutput> DecodeOutput(const std::string& line);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_PROGRAM_MESSAGES_H_
