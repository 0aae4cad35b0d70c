#include "latticeworld/terrain/water/shallow_rivers.h"

#include "latticeworld/terrain/water/banks.h"

namespace latticeworld {

bool RiversAreShallow(double size_m) {
  constexpr double kShallow_m = 0.3;
  return internal::RiverDepth_m(size_m) <= kShallow_m;
}

}  // namespace latticeworld
