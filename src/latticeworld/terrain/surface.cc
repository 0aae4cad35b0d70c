#include "latticeworld/terrain/surface.h"

namespace latticeworld {
namespace {

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
SurfaceProperties Dry(SurfaceClass surface) {
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

}  // namespace

SurfaceProperties PropertiesOf(SurfaceClass surface, Weather weather) {
  SurfaceProperties properties = Dry(surface);
  // Snow stays snow and a bed stays wet, whatever falls.
  if (surface == SurfaceClass::kSnow || surface == SurfaceClass::kWaterBed) return properties;
  const bool hard = properties.cone_index_kpa >= kHardConeIndex_kPa;
  switch (weather) {
    case Weather::kRain:
      // Paved and stony ground keeps less of its grip than soil (asphalt 0.85 to 0.6, earth road
      // 0.68 to 0.55); soil softens to about half its cone index when it is wet through.
      properties.friction *= hard ? 0.70 : 0.80;
      properties.rolling_resistance *= hard ? 1.05 : 1.40;
      if (!hard) properties.cone_index_kpa *= 0.5;
      break;
    case Weather::kSnow:
      // A thin cover of snow decides the grip; what it lies on still carries.
      properties.friction = properties.friction * 0.25 + 0.05;
      properties.rolling_resistance += 0.020;
      break;
    case Weather::kSandstorm:
      properties.friction *= 0.85;
      properties.rolling_resistance *= 1.20;
      break;
    case Weather::kSunny:
    case Weather::kCloudy:
    case Weather::kFog:
      break;
  }
  return properties;
}

}  // namespace latticeworld
