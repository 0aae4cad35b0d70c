#ifndef LATTICEWORLD_SCENE_WEATHER_ATMOSPHERE_H_
#define LATTICEWORLD_SCENE_WEATHER_ATMOSPHERE_H_

#include <Eigen/Core>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

// The latitude of a world that lies nowhere on the earth [deg].
inline constexpr double kUsualLatitude_deg = 45.0;
// How strong a weather is when nobody says: moderate rain, moderate snow, ...
inline constexpr double kUsualIntensity = 0.5;
// Peak of three seconds over the mean of ten minutes in open country with few obstacles: gust
// factor 1.66 (Harper, Kepert and Ginger, Guidelines for converting between various wind averaging
// periods, WMO/TD-No. 1555, 2010, table 1.1).
inline constexpr double kGustsOverMean = 0.66;

// Weather and light of a world at one moment.
struct Atmosphere {
  Weather weather = Weather::kSunny;
  double intensity = kUsualIntensity;  // of that weather, [0, 1]: slight .. as strong as it gets
  // Meteorological optical range: over it a beam of light keeps 5 % of its flux (WMO-No. 8). > 0
  double visibility_m = 20000.0;
  double rain_mmph = 0.0;      // rainfall [mm/h]
  double snowfall_mmph = 0.0;  // as water [mm/h]
  double cloud_cover = 0.0;    // share of the sky, [0, 1]

  Eigen::Vector3d wind_mps = Eigen::Vector3d::Zero();  // mean, map frame, where it blows to
  double gust_mps = 0.0;                               // peak over the mean, >= 0

  // Time by the sun, and where on the earth.
  double hour = 12.0;                        // [0, 24), 12: the sun stands highest
  double day_of_year = 172.0;                // [1, 366)
  double latitude_deg = kUsualLatitude_deg;  // [-90, 90]
  double direct_light = 1.0;                 // share of sunlight that clouds and haze let through
  double diffuse_light = 0.8;                // share of the brightest sky, [0, 1]
  Eigen::Vector3d sun_direction = Eigen::Vector3d::UnitZ();  // unit, map frame, towards the sun
  double sun_intensity = 1.0;                                // [0, 1]
  double ambient_intensity = 0.3;                            // [0, 1]

  // What the weather has made of ground and waters.
  double ground_wetness = 0.0;  // [0, 1]
  double snow_depth_m = 0.0;    // on level ground, >= 0
  double blown_sand = 0.0;      // loose cover of sand, [0, 1]
  double water_rise_m = 0.0;    // of lakes and rivers over their mean level; may be negative

  GroundState ground() const { return {ground_wetness, snow_depth_m, blown_sand}; }
};

// The weather of coarse attributes at an intensity, in their season and at their time of day.
// desert_wind_mps: at least so much wind blows in deserts and sandstorms. latitude_deg: [-90, 90];
// south of the equator the seasons lie half a year later.
Atmosphere DeriveAtmosphere(const CoarseAttributes& coarse, double desert_wind_mps,
                            double wind_heading_rad, double latitude_deg = kUsualLatitude_deg,
                            double intensity = kUsualIntensity);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_WEATHER_ATMOSPHERE_H_
