#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_LAID_AS_HOUSES_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_LAID_AS_HOUSES_H_

#include <string>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// What a plan lays as houses, though the words name a building of another kind ("a lighthouse"), or
// lays on an island, though the words have it in the water ("a barn in the lake"): a warning each,
// with what there is instead.
std::vector<std::string> WarningsOfHouses(const LayoutPlan& plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_LAID_AS_HOUSES_H_
