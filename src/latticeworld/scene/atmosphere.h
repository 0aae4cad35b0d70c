#ifndef LATTICEWORLD_SCENE_ATMOSPHERE_H_
#define LATTICEWORLD_SCENE_ATMOSPHERE_H_

#include <Eigen/Core>

#include "latticeworld/environment/attributes.h"

namespace latticeworld {

// Weather and light of a world.
struct Atmosphere {
  Weather weather = Weather::kSunny;
  double visibility_m = 10000.0;                             // meteorological optical range
  double rain_mmph = 0.0;                                    // rainfall [mm/h]
  double snow_depth_m = 0.0;                                 // on level ground
  Eigen::Vector3d wind_mps = Eigen::Vector3d::Zero();        // map frame, where it blows to
  Eigen::Vector3d sun_direction = Eigen::Vector3d::UnitZ();  // unit, map frame, towards the sun
  double sun_intensity = 1.0;                                // [0, 1]
  double ambient_intensity = 0.3;                            // [0, 1]
};

Atmosphere DeriveAtmosphere(const CoarseAttributes& coarse, double desert_wind_mps,
                            double wind_heading_rad);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_ATMOSPHERE_H_
