#ifndef LATTICEWORLD_GENERATION_BUNDLE_AGENTS_JSON_H_
#define LATTICEWORLD_GENERATION_BUNDLE_AGENTS_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// agents.json: an array with one object an agent and a key for each field of AgentStart.
std::string EncodeAgents(const std::vector<AgentStart>& agents);

// Errors: DATA_LOSS naming the agent (counted from 0) and what is wrong: keys, types, names that
// are not unique or not legal in ROS, a state that the category cannot be in, a place outside the
// world.
Result<std::vector<AgentStart>> DecodeAgents(std::string_view content,
                                             const GridGeometry& geometry);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_AGENTS_JSON_H_
