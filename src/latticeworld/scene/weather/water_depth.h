#ifndef LATTICEWORLD_SCENE_WEATHER_WATER_DEPTH_H_
#define LATTICEWORLD_SCENE_WEATHER_WATER_DEPTH_H_

#include <algorithm>

#include "latticeworld/scene/weather/atmosphere.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Depth of water above the ground under the weather of the moment [m], 0 where dry. Waters rise and
// fall within their shores: what is dry at the mean level stays dry.
inline double WaterDepthAt(const Terrain& terrain, const Atmosphere& atmosphere, WorldPoint place) {
  const double mean_m = terrain.WaterDepthAt(place);
  return mean_m > 0.0 ? std::max(0.0, mean_m + atmosphere.water_rise_m) : 0.0;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_WEATHER_WATER_DEPTH_H_
