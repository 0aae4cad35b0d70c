#ifndef LATTICEWORLD_GEOMETRY_REGION_H_
#define LATTICEWORLD_GEOMETRY_REGION_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Places in words: the nine equal parts of the world, upper = north, left = west.
enum class Region : std::uint8_t {
  kUpperLeft,
  kUpper,
  kUpperRight,
  kMiddleLeft,
  kCenter,
  kMiddleRight,
  kLowerLeft,
  kLower,
  kLowerRight,
  kAnywhere,
};

constexpr std::array<EnumName<Region>, 10> EnumNames(Region) {
  return {{{Region::kUpperLeft, "upper left"},
           {Region::kUpper, "upper"},
           {Region::kUpperRight, "upper right"},
           {Region::kMiddleLeft, "middle left"},
           {Region::kCenter, "center"},
           {Region::kMiddleRight, "middle right"},
           {Region::kLowerLeft, "lower left"},
           {Region::kLower, "lower"},
           {Region::kLowerRight, "lower right"},
           {Region::kAnywhere, "anywhere"}}};
}

// A rectangle of relative coordinates: u from 0 (west) to 1 (east), v from 0 (north) to 1 (south).
struct UnitBox {
  double u_min = 0.0;
  double u_max = 1.0;
  double v_min = 0.0;
  double v_max = 1.0;
  bool Contains(double u, double v) const {
    return u >= u_min && u <= u_max && v >= v_min && v <= v_max;
  }
};

// One ninth of the unit square; all of it for kAnywhere.
UnitBox BoxOf(Region region);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMETRY_REGION_H_
