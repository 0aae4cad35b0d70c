#ifndef LATTICEWORLD_GENERATION_BUNDLE_PROPS_JSON_H_
#define LATTICEWORLD_GENERATION_BUNDLE_PROPS_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// props.json: an array with one object a prop and a key for each field of Prop.
std::string EncodeProps(const std::vector<Prop>& props);

// Sorted by name. agents: whose names props cannot have. Errors: DATA_LOSS naming the prop
// (counted from 0) and what is wrong: keys, types, names that are not unique or not legal in ROS,
// sizes, masses and strengths that no prop of its kind has, a place outside the world.
Result<std::vector<Prop>> DecodeProps(std::string_view content, const GridGeometry& geometry,
                                      const std::vector<AgentStart>& agents);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_PROPS_JSON_H_
