#ifndef LATTICEWORLD_GENERATION_BUNDLE_BRIDGES_JSON_H_
#define LATTICEWORLD_GENERATION_BUNDLE_BRIDGES_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

// bridges.json: an array with one object a bridge, a key for each field of Bridge, and clearance_m.
std::string EncodeBridges(const std::vector<Bridge>& bridges);

// Errors: DATA_LOSS naming the bridge (counted from 0) and what is wrong: keys, types, numbers out
// of range, places outside the world, lines without length, supports that do not follow each other.
Result<std::vector<Bridge>> DecodeBridges(std::string_view content, const GridGeometry& geometry);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_BRIDGES_JSON_H_
