#ifndef LATTICEWORLD_SCENE_WEATHER_WIND_H_
#define LATTICEWORLD_SCENE_WEATHER_WIND_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

// Turbulence that the mean wind carries over the world as it is (Taylor 1938): a sum of waves whose
// lengths and strengths follow the longitudinal spectrum of von Karman (1948), with directions and
// phases drawn from the seed. Smooth in place and time.
class GustField {
 public:
  // Each horizontal component stays within kBound of gust_mps, the vertical one within half of
  // that, and the length of all three within kBoundOfLength. So the strongest gust along the wind
  // in ten minutes is gust_mps on average over the seeds (0.93 to 1.08 of it for means of 5 to
  // 22 m/s).
  static constexpr double kBound = 1.3;
  static constexpr double kBoundOfLength = 1.5 * kBound;  // sqrt(1 + 1 + 0.5 * 0.5)

  explicit GustField(std::uint64_t seed);

  // Wind at a place [m/s], map frame: the mean and gusts. drift_m: how far the mean wind
  // has carried the air since the field began, its integral over time.
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

#endif  // LATTICEWORLD_SCENE_WEATHER_WIND_H_
