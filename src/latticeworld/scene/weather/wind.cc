#include "latticeworld/scene/weather/wind.h"

#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr double kScale_m = 80.0;  // of turbulence at some ten metres above open land
constexpr double kLongest_m = 400.0;
constexpr double kShortest_m = 6.0;
constexpr double kVerticalShare = 0.5;  // as near the ground (Panofsky and Dutton 1984)

// Energy of one octave: wave number times the spectrum.
double OctaveEnergy(double number_radpm) {
  const double x = 1.339 * kScale_m * number_radpm;
  return number_radpm / std::pow(1.0 + x * x, 5.0 / 6.0);
}

}  // namespace

GustField::GustField(std::uint64_t seed) {
  RandomStream random(seed, "gusts");
  std::array<double, kWaves> strength{};
  double sum = 0.0;
  for (int i = 0; i < kWaves; ++i) {
    const double length_m =
        kLongest_m * std::pow(kShortest_m / kLongest_m, static_cast<double>(i) / (kWaves - 1));
    const double number_radpm = 2.0 * M_PI / length_m;
    const double heading_rad = random.Uniform(-M_PI, M_PI);
    waves_[i].number_radpm = {number_radpm * std::cos(heading_rad),
                              number_radpm * std::sin(heading_rad)};
    strength[i] = std::sqrt(OctaveEnergy(number_radpm));
    sum += strength[i];
  }
  for (int i = 0; i < kWaves; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double phase_rad = random.Uniform(-M_PI, M_PI);
      const double share = kBound * strength[i] / sum * (axis == 2 ? kVerticalShare : 1.0);
      waves_[i].a[axis] = {share * std::cos(phase_rad), share * std::sin(phase_rad)};
    }
  }
}

Eigen::Vector3d GustField::WindAt(const Atmosphere& atmosphere, const Eigen::Vector2d& drift_m,
                                  WorldPoint place) const {
  if (atmosphere.gust_mps <= 0.0) return atmosphere.wind_mps;
  const Eigen::Vector2d carried = Eigen::Vector2d(place.x_m, place.y_m) - drift_m;
  Eigen::Vector3d gust = Eigen::Vector3d::Zero();
  for (const Wave& wave : waves_) {
    const double phase_rad = wave.number_radpm.dot(carried);
    const Eigen::Vector2d turn(std::cos(phase_rad), std::sin(phase_rad));
    for (int axis = 0; axis < 3; ++axis) gust[axis] += wave.a[axis].dot(turn);
  }
  return atmosphere.wind_mps + atmosphere.gust_mps * gust;
}

}  // namespace latticeworld
