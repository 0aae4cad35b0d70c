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
  // Soil strength by the cone penetrometer of the Waterways Experiment Station [kPa]: mean over the
  // upper 15 cm. A wheel sinks into what is soft: light robots need about 20 to 50, cars and farm
  // vehicles 300 to 600. Paving and rock, which no cone enters, have kHardConeIndex_kPa.
  double cone_index_kpa;
};
inline constexpr double kHardConeIndex_kPa = 5000.0;

// Friction, rolling resistance and softness of a surface under a weather: rain and snow lower
// friction, rain softens soil. surface.cc names the source of each value and marks estimates.
SurfaceProperties PropertiesOf(SurfaceClass surface, Weather weather);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_SURFACE_H_
