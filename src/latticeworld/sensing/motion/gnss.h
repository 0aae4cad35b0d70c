#ifndef LATTICEWORLD_SENSING_MOTION_GNSS_H_
#define LATTICEWORLD_SENSING_MOTION_GNSS_H_

#include <Eigen/Core>
#include <cstdint>

#include "latticeworld/sensing/motion/motion_sensors.h"
#include "latticeworld/sensing/motion/wandering_bias.h"

namespace latticeworld {

struct Scene;
struct SensedWorld;

// Whether a standing tree's crown reaches over the point (map frame [m]), seen from above, and
// higher up.
bool IsUnderTrees(const Scene& scene, const SensedWorld& world, const Eigen::Vector3d& point_m);

// Fixes of one receiver: where it is plus a wandering and a white error, both times the canopy
// factor under trees; the error is east, north and up, on the tangent plane of the origin.
class GnssReceiver {
 public:
  GnssReceiver(const GnssModel& model, const GeoOrigin& origin, double rate_hz, std::uint64_t key);

  // k: the reading's number; time_s is left as it is.
  GnssReading Read(const Eigen::Vector3d& antenna_m, bool under_trees, std::uint64_t k);

 private:
  GnssModel model_;
  GeoOrigin origin_;
  std::uint64_t white_key_;
  WanderingBias wander_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_GNSS_H_
