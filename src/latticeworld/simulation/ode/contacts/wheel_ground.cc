#include "latticeworld/simulation/ode/contacts/wheel_ground.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kTractionPerMobility = 0.3;  // of Wismer and Luth
constexpr double kPascalPerKilopascal = 1000.0;
// A wheel whose own resistance takes all of its traction spins; the line through that point would
// stand upright.
constexpr double kMostDemand = 0.95;
constexpr double kLeastDemand = 0.02;
constexpr double kMostSlip = 0.8;
// Rolling resistance takes at most this share of the speed in one step: more would swing.
constexpr double kMostBraking = 0.5;

}  // namespace

double SlipPerForce(const WheelLoad& load, const SurfaceProperties& surface, double friction,
                    double rate_radps) {
  const double load_n = load.mass_kg * kGravity_mps2;
  const double mobility = surface.cone_index_kpa * kPascalPerKilopascal * load.wheel.width_m * 2.0 *
                          load.wheel.radius_m / load_n;
  const double demand =
      std::clamp(surface.rolling_resistance / friction, kLeastDemand, kMostDemand);
  const double slip = std::min(kMostSlip, -std::log1p(-demand) / (kTractionPerMobility * mobility));
  return slip * std::abs(rate_radps) * load.wheel.radius_m / (demand * friction * load_n);
}

void ResistRolling(const RollingContact& contact, const SurfaceProperties& surface, double step_s) {
  const double length = contact.forward.norm();
  if (length < 1e-6) return;  // it lies on its side
  const dReal* v = dBodyGetLinearVel(contact.wheel);
  const Eigen::Vector3d along = contact.forward / length;
  const double speed_mps = Eigen::Vector3d(v[0], v[1], v[2]).dot(along);
  const double resistance_n = surface.rolling_resistance * contact.load_kg * kGravity_mps2 *
                              std::max(0.0, contact.normal.z()) * contact.share;
  const double stopping_n =
      kMostBraking * contact.load_kg * std::abs(speed_mps) / step_s * contact.share;
  const Eigen::Vector3d force =
      (speed_mps > 0.0 ? -1.0 : 1.0) * std::min(resistance_n, stopping_n) * along;
  dBodyAddForce(contact.wheel, force.x(), force.y(), force.z());
}

}  // namespace latticeworld
