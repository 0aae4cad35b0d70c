#include "latticeworld/sensing/motion/wandering_bias.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/sensing/counter_noise.h"

namespace latticeworld {
namespace {

// After this many correlation times, exp(-45) of a value is left: less than a double's last digit
// of it.
constexpr double kForgotten = 45.0;
constexpr double kMostSteps = 1e7;

}  // namespace

WanderingBias::WanderingBias(std::uint64_t key, const Eigen::Vector3d& stddev, double interval_s,
                             double correlation_s)
    : key_(key),
      stddev_(stddev),
      phi_(std::exp(-interval_s / correlation_s)),
      innovation_(std::sqrt(-std::expm1(-2.0 * interval_s / correlation_s))),
      memory_(static_cast<std::uint64_t>(
          std::min(kMostSteps, std::ceil(kForgotten * correlation_s / interval_s)))) {}

Eigen::Vector3d WanderingBias::At(std::uint64_t k) {
  if (stddev_.isZero(0.0)) return Eigen::Vector3d::Zero();
  // The walk starts at the beginning, or so far back that what was before no longer matters.
  if (!begun_ || k < k_ || k - k_ > memory_) {
    k_ = k > memory_ ? k - memory_ : 0;
    unit_ = NormalsAt(key_, k_);
    begun_ = true;
  }
  for (; k_ < k; ++k_) unit_ = phi_ * unit_ + innovation_ * NormalsAt(key_, k_ + 1);
  return stddev_.cwiseProduct(unit_);
}

}  // namespace latticeworld
