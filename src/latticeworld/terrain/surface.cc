#include "latticeworld/terrain/surface.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// Snow of this depth hides about two thirds of what it lies on from a tyre. Estimate.
constexpr double kCoveringSnow_m = 0.02;
// Hard-packed snow (Wong 2008, table 1.2).
constexpr double kSnowFriction = 0.20;
// What ploughing through snow adds to the rolling resistance, nearly all of it at a depth of a few
// of these. Estimate, after the shallow-snow trials of Richmond, Motion resistance of wheeled
// vehicles in snow (CRREL Report 95-7, 1995): it grows with depth and slower than in proportion.
constexpr double kDeepSnowRolling = 0.10;
constexpr double kRollingSnow_m = 0.15;
constexpr double kSnowConeIndex_kPa = 100.0;
constexpr double kConeDepth_m = 0.15;  // over which a cone index is the mean
// Nothing slides more easily than wet ice (Wong 2008: ice 0.1), nor rolls worse than in deep mud.
constexpr double kLeastFriction = 0.05;
constexpr double kMostRolling = 0.6;

double Between(double a, double b, double share) { return a + share * (b - a); }

}  // namespace

// Friction and rolling resistance: Wong, Theory of Ground Vehicles (4th ed. 2008), tables 1.2
// (average peak adhesion: asphalt and concrete dry 0.8-0.9, wet 0.5-0.7, gravel 0.6, earth road dry
// 0.68, wet 0.55, hard-packed snow 0.2, ice 0.1) and 1.1 (rolling resistance of car tyres: concrete
// and asphalt 0.013, rolled gravel 0.02, unpaved road 0.05, field 0.1-0.35). Estimates, between the
// surfaces of those tables that they resemble: grass, forest floor, rock, building land, snow's
// rolling resistance, and the bed of waters.
//
// Cone index: estimates within the ranges of trafficability surveys. Knight and Freitag (1962) and
// the field manual TM 5-530 call 80 to 100 psi (550 to 690 kPa) in the critical layer enough for
// any number of passes of wheeled vehicles, and 20 to 50 psi (140 to 340 kPa) the limit of light
// ones; tilled loam has 100 to 600 kPa, firm turf 800 to 2000, fresh to settled snow 20 to 200.
SurfaceProperties DryPropertiesOf(SurfaceClass surface) {
  switch (surface) {
    case SurfaceClass::kGrass:
      return {0.60, 0.060, 1000.0};
    case SurfaceClass::kForestFloor:
      return {0.55, 0.080, 600.0};
    case SurfaceClass::kFarmland:
      return {0.55, 0.100, 400.0};
    case SurfaceClass::kBarren:
      return {0.65, 0.050, 1500.0};
    case SurfaceClass::kRoad:
      return {0.85, 0.013, kHardConeIndex_kPa};
    case SurfaceClass::kBuilding:
      return {0.80, 0.015, kHardConeIndex_kPa};
    case SurfaceClass::kRock:
      return {0.75, 0.030, kHardConeIndex_kPa};
    case SurfaceClass::kSnow:
      return {0.20, 0.080, 100.0};
    case SurfaceClass::kWaterBed:
      return {0.40, 0.150, 80.0};
  }
  return {0.60, 0.060, 1000.0};
}

SurfaceProperties Weathered(SurfaceClass surface, const SurfaceProperties& dry,
                            const GroundState& state) {
  SurfaceProperties properties = dry;
  // Snow stays snow and a bed stays wet, whatever falls.
  if (surface != SurfaceClass::kSnow && surface != SurfaceClass::kWaterBed) {
    const double wetness = std::clamp(state.wetness, 0.0, 1.0);
    const double sand = std::clamp(state.blown_sand, 0.0, 1.0);
    const double depth_m = std::max(0.0, state.snow_depth_m);
    const bool hard = dry.cone_index_kpa >= kHardConeIndex_kPa;
    // Loose sand rolls under a tyre. Estimate.
    properties.friction *= Between(1.0, 0.85, sand);
    properties.rolling_resistance *= Between(1.0, 1.20, sand);
    // Paved and stony ground loses more of its grip than soil (Wong 2008: asphalt 0.85 to 0.6,
    // earth road 0.68 to 0.55); soil softens to about half its cone index when it is wet through.
    properties.friction *= Between(1.0, hard ? 0.70 : 0.80, wetness);
    properties.rolling_resistance *= Between(1.0, hard ? 1.05 : 1.40, wetness);
    if (!hard) properties.cone_index_kpa *= Between(1.0, 0.5, wetness);
    // A thin cover of snow decides the grip, while what it lies on still carries.
    const double covered = 1.0 - std::exp(-depth_m / kCoveringSnow_m);
    properties.friction =
        Between(properties.friction, std::min(properties.friction, kSnowFriction), covered);
    properties.rolling_resistance += kDeepSnowRolling * (1.0 - std::exp(-depth_m / kRollingSnow_m));
    properties.cone_index_kpa =
        Between(properties.cone_index_kpa, std::min(properties.cone_index_kpa, kSnowConeIndex_kPa),
                std::min(1.0, depth_m / kConeDepth_m));
  }
  properties.friction = std::max(properties.friction, kLeastFriction);
  properties.rolling_resistance = std::min(properties.rolling_resistance, kMostRolling);
  return properties;
}

double ClimbableSlope(const SurfaceProperties& surface, double grip, bool on_wheels) {
  return std::atan(grip * surface.friction - (on_wheels ? surface.rolling_resistance : 0.0));
}

}  // namespace latticeworld
