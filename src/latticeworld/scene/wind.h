#ifndef LATTICEWORLD_SCENE_WIND_H_
#define LATTICEWORLD_SCENE_WIND_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/atmosphere.h"

namespace latticeworld {

// Turbulence that the mean wind carries over the world as it is (Taylor 1938): a sum of waves whose
// lengths and strengths follow the longitudinal spectrum of von Karman (1948), with directions and
// phases drawn from the seed. Smooth in place and time.
class GustField {
 public:
  explicit GustField(std::uint64_t seed);

  // Wind at a place [m/s], map frame: the mean and gusts. Each horizontal component stays within
  // gust_mps of the mean, the vertical one within half of it. drift_m: how far the mean wind has
  // carried the air since the field began, its integral over time.
  Eigen::Vector3d WindAt(const Atmosphere& atmosphere, const Eigen::Vector2d& drift_m,
                         WorldPoint place) const;

 private:
  static constexpr int kWaves = 8;
  struct Wave {
    Eigen::Vector2d number_radpm;      // wave vector
    std::array<Eigen::Vector2d, 3> a;  // of each component: times (cosine, sine)
  };
  std::array<Wave, kWaves> waves_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_WIND_H_
