#ifndef LATTICEWORLD_TERRAIN_SURFACE_H_
#define LATTICEWORLD_TERRAIN_SURFACE_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"

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
inline constexpr int kSurfaceClassCount = 9;
constexpr std::array<EnumName<SurfaceClass>, kSurfaceClassCount> EnumNames(SurfaceClass) {
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

// What weather has made of the ground.
struct GroundState {
  double wetness = 0.0;       // [0, 1]: dry .. wet through, paving under a film of water
  double snow_depth_m = 0.0;  // >= 0
  double blown_sand = 0.0;    // [0, 1]: none .. the loose cover that a sandstorm leaves
};
inline bool operator==(const GroundState& a, const GroundState& b) {
  return a.wetness == b.wetness && a.snow_depth_m == b.snow_depth_m && a.blown_sand == b.blown_sand;
}
inline bool operator!=(const GroundState& a, const GroundState& b) { return !(a == b); }

// Returns the properties on a dry and bare summer day. surface.cc names the source of each value
// and marks estimates.
SurfaceProperties DryPropertiesOf(SurfaceClass surface);

// What becomes of a surface's dry properties: continuous in each part of the state; more water or
// more snow never gives more grip, an easier roll or firmer soil. Snow fields and the beds of
// waters stay as they are. dry: all > 0.
SurfaceProperties Weathered(SurfaceClass surface, const SurfaceProperties& dry,
                            const GroundState& state);

// Steepest slope [rad] that a body climbs without slipping, (-pi/2, pi/2): arctan of what its feet
// or wheels push with, grip times the friction, less what wheels lose to rolling. Below 0: wheels
// do not even start on level ground. grip: > 0.
double ClimbableSlope(const SurfaceProperties& surface, double grip, bool on_wheels);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_SURFACE_H_
