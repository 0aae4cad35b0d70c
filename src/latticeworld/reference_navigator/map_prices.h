#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_MAP_PRICES_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_MAP_PRICES_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {

// (rows x cols) what a metre over each cell of the map counts as, kClosedCell where the robot's
// centre cannot be.
Grid<float> MapPrices(const CostMap& map, const NavigatorOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_MAP_PRICES_H_
