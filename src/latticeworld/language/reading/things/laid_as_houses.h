#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_LAID_AS_HOUSES_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_LAID_AS_HOUSES_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/thing_kinds.h"

namespace latticeworld {

// Returns the kind of single thing that a building's noun in the singular names or comes nearest
// to; nullptr where it means houses, or places with houses.
const ThingKind* KindOfBuilding(std::string_view noun);

// What a plan lays as houses, though the words name a building of another kind ("a lighthouse"), or
// lays on an island, though the words have it in the water ("a barn in the lake"): a warning each,
// with what there is instead.
std::vector<std::string> WarningsOfHouses(const LayoutPlan& plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_LAID_AS_HOUSES_H_
