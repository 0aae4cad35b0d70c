#include "latticeworld/terrain/surface.h"

namespace latticeworld {
namespace {

// Peak adhesion and rolling resistance of rubber tyres on dry ground, after Wong, Theory of Ground
// Vehicles (4th ed. 2008), tables 1.2 (rolling resistance) and 1.3 (adhesion: asphalt and concrete
// dry 0.8-0.9, wet 0.5-0.7, gravel 0.6, earth road dry 0.68, wet 0.55, snow 0.2, ice 0.1); grass,
// forest litter and bedrock lie between the surfaces of that table that they resemble.
SurfaceProperties Dry(SurfaceClass surface) {
  switch (surface) {
    case SurfaceClass::kGrass:
      return {0.60, 0.060};
    case SurfaceClass::kForestFloor:
      return {0.55, 0.080};
    case SurfaceClass::kFarmland:
      return {0.55, 0.100};
    case SurfaceClass::kBarren:
      return {0.65, 0.050};
    case SurfaceClass::kRoad:
      return {0.85, 0.013};
    case SurfaceClass::kBuilding:
      return {0.80, 0.015};
    case SurfaceClass::kRock:
      return {0.75, 0.030};
    case SurfaceClass::kSnow:
      return {0.20, 0.080};
    case SurfaceClass::kWaterBed:
      return {0.40, 0.150};
  }
  return {0.60, 0.060};
}

}  // namespace

SurfaceProperties PropertiesOf(SurfaceClass surface, Weather weather) {
  const SurfaceProperties dry = Dry(surface);
  // Snow stays snow and a bed stays wet, whatever falls.
  if (surface == SurfaceClass::kSnow || surface == SurfaceClass::kWaterBed) return dry;
  switch (weather) {
    case Weather::kRain: {
      // Paved and stony ground keeps more of its grip than soil, which softens as well.
      const bool hard = surface == SurfaceClass::kRoad || surface == SurfaceClass::kBuilding ||
                        surface == SurfaceClass::kRock;
      return {dry.friction * (hard ? 0.70 : 0.80), dry.rolling_resistance * (hard ? 1.05 : 1.40)};
    }
    case Weather::kSnow:
      // A cover of snow decides, thinner on what is trodden and driven.
      return {dry.friction * 0.25 + 0.05, dry.rolling_resistance + 0.020};
    case Weather::kSandstorm:
      return {dry.friction * 0.85, dry.rolling_resistance * 1.20};
    case Weather::kSunny:
    case Weather::kCloudy:
    case Weather::kFog:
      break;
  }
  return dry;
}

}  // namespace latticeworld
