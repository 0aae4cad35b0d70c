#include "latticeworld/geometry/region.h"

#include <algorithm>

namespace latticeworld {

UnitBox BoxOf(Region region) {
  if (region == Region::kAnywhere) return {};
  const int index = static_cast<int>(region);
  const int row = index / 3;
  const int col = index % 3;
  return {col / 3.0, (col + 1) / 3.0, row / 3.0, (row + 1) / 3.0};
}

}  // namespace latticeworld
