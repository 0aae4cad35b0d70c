#ifndef LATTICEWORLD_TERRAIN_SURFACE_H_
#define LATTICEWORLD_TERRAIN_SURFACE_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/environment/attributes.h"

namespace latticeworld {

// What the ground is made of, the same for both vocabularies.
enum class SurfaceClass : std::uint8_t {
  kGrass,
  kForestFloor,
  kFarmland,
  kBarren,
  kRoad,
  kBuilding,
  kRock,
  kSnow,
  kWaterBed
};
constexpr std::array<EnumName<SurfaceClass>, 9> EnumNames(SurfaceClass) {
  return {{{SurfaceClass::kGrass, "grass"},
           {SurfaceClass::kForestFloor, "forest floor"},
           {SurfaceClass::kFarmland, "farmland"},
           {SurfaceClass::kBarren, "barren"},
           {SurfaceClass::kRoad, "road"},
           {SurfaceClass::kBuilding, "building"},
           {SurfaceClass::kRock, "rock"},
           {SurfaceClass::kSnow, "snow"},
           {SurfaceClass::kWaterBed, "water bed"}}};
}

struct SurfaceProperties {
  double friction;            // Coulomb coefficient against rubber
  double rolling_resistance;  // coefficient of a rubber wheel
};

// Friction and rolling resistance of a surface under a weather (rain and snow lower friction).
// Values follow vehicle dynamics textbooks (Wong, Theory of Ground Vehicles, 2008).
SurfaceProperties PropertiesOf(SurfaceClass surface, Weather weather);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_SURFACE_H_
