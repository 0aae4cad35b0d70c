#ifndef LATTICEWORLD_GENERATION_ELEMENTS_JSON_H_
#define LATTICEWORLD_GENERATION_ELEMENTS_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// elements.json: an array with one object an element and a key for each field of Element.
std::string EncodeElements(const std::vector<Element>& elements);

// Sorted by name. agents: whose names elements cannot have. Errors: DATA_LOSS naming the element
// (counted from 0) and what is wrong: keys, types, names that are not unique or not legal in ROS,
// sizes, masses and strengths that no element of its kind has, a place outside the world.
Result<std::vector<Element>> DecodeElements(std::string_view content, const GridGeometry& geometry,
                                            const std::vector<AgentStart>& agents);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_ELEMENTS_JSON_H_
