#include "latticeworld/simulation/props/blows.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// How much a body that hits gives in: a car that hits a wall at 56 km/h is crushed by about 0.6 m,
// so that its stiffness is some 680 N/m for each kilogram, here at a bumper's height of 0.4 m.
constexpr double kCrush_m2ps2 = 100.0;

}  // namespace

double ImpactMoment(double mass_kg, double approach_mps, double stiffness_nmprad) {
  return approach_mps * std::sqrt(mass_kg * stiffness_nmprad);
}

double StiffnessMet(double mass_kg, double stiffness_nmprad) {
  return 1.0 / (1.0 / stiffness_nmprad + 1.0 / (kCrush_m2ps2 * mass_kg));
}

double SpeedAfterBreaking(double mass_kg, double approach_mps, double stiffness_nmprad,
                          double moment_nm) {
  const double lost_m2ps2 = moment_nm * moment_nm / (stiffness_nmprad * mass_kg);
  return std::sqrt(std::max(0.0, approach_mps * approach_mps - lost_m2ps2));
}

double MassMet(const BodySpec& spec, const BodyMotion& motion, const Eigen::Vector3d& point_m,
               const Eigen::Vector3d& direction) {
  const Eigen::Quaterniond base_from_map = motion.orientation.conjugate();
  const Eigen::Vector3d arm = base_from_map * (point_m - motion.position_m) -
                              Eigen::Vector3d(0.0, 0.0, spec.center_height_m);
  const Eigen::Vector3d turning = arm.cross(base_from_map * direction);
  return 1.0 / (1.0 / spec.total_mass_kg() +
                turning.cwiseProduct(turning).cwiseQuotient(spec.inertia_kgm2).sum());
}

bool IsDriven(const BodySpec& spec) {
  return spec.upright || !spec.wheels.empty() || !spec.links.empty();
}

double HittingMass(const PhysicsWorld& physics, BodyId body, const Eigen::Vector3d& point_m,
                   const Eigen::Vector3d& direction) {
  const BodySpec& spec = physics.SpecOf(body);
  if (IsDriven(spec)) return spec.total_mass_kg();
  return MassMet(spec, physics.MotionOf(body), point_m, direction);
}

}  // namespace latticeworld
