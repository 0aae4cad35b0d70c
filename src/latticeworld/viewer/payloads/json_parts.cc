#include "latticeworld/viewer/payloads/json_parts.h"

#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

Json AtmosphereJson(const Atmosphere& atmosphere) {
  Json json;
  json["weather"] = NameOf(atmosphere.weather);
  json["intensity"] = atmosphere.intensity;
  json["visibility_m"] = atmosphere.visibility_m;
  json["rain_mmph"] = atmosphere.rain_mmph;
  json["snowfall_mmph"] = atmosphere.snowfall_mmph;
  json["cloud_cover"] = atmosphere.cloud_cover;
  json["wind_mps"] = VectorJson(atmosphere.wind_mps);
  json["gust_mps"] = atmosphere.gust_mps;
  json["hour"] = atmosphere.hour;
  json["sun_direction"] = VectorJson(atmosphere.sun_direction);
  json["sun_intensity"] = atmosphere.sun_intensity;
  json["ambient_intensity"] = atmosphere.ambient_intensity;
  json["ground_wetness"] = atmosphere.ground_wetness;
  json["snow_depth_m"] = atmosphere.snow_depth_m;
  json["blown_sand"] = atmosphere.blown_sand;
  json["water_rise_m"] = atmosphere.water_rise_m;
  return json;
}

}  // namespace latticeworld
