#ifndef LATTICEWORLD_ENVIRONMENT_FINE_ATTRIBUTES_H_
#define LATTICEWORLD_ENVIRONMENT_FINE_ATTRIBUTES_H_

#include <array>
#include <string>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

// Continuous parameters that a type lacks (ValuesOf) keep their defaults and are not in the JSON.
struct FineAttribute {
  std::string season_variant;
  std::string material;
  double density = 0.5;                            // [0, 1]
  std::array<double, 3> rotation_deg = {0, 0, 0};  // Euler angles roll, pitch, yaw, [0, 360)
  double scale = 1.0;                              // [0.25, 4]
  double height_m = 0.0;                           // lake: level above its shore's low, [-5, 5]
  double wind_mps = 0.0;                           // desert: [0, 40]
  double slope_deg = 0.0;  // snow mountain: steepest snow-covered slope, [0, 90]
};

using FineAttributes = std::array<FineAttribute, kAssetTypeCount>;  // by AssetType

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_FINE_ATTRIBUTES_H_
