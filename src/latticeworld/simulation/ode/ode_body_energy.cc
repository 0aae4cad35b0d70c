// What energy a body has, what a step gave it, and what it may have been given.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_body.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

// Contacts push a body out of another or of the ground at up to this speed (ContactJoints), and so
// fast may joints that were torn apart bring its parts together.
constexpr double kCorrectingSpeed_mps = 2.0;
constexpr double kFastestSteering_radps = 3.0;
constexpr double kBumpStopStiffness = 20.0;  // times that of the spring, beyond its travel
constexpr double kBallInertia = 0.4;         // of a wheel, times its mass and its radius squared

bool IsEven(const Eigen::Vector3d& inertia_kgm2) {
  return inertia_kgm2.x() == inertia_kgm2.y() && inertia_kgm2.y() == inertia_kgm2.z();
}

}  // namespace

double OdeBody::PartMass(std::size_t i) const {
  if (i == 0) return spec_->mass_kg;
  if (i <= wheels_.size()) return spec_->wheels[i - 1].mass_kg;
  return spec_->links[i - 1 - wheels_.size()].mass_kg;
}

Eigen::Vector3d OdeBody::PartInertia(std::size_t i) const {
  if (i == 0) return TrunkInertia();
  if (i > wheels_.size()) return spec_->links[i - 1 - wheels_.size()].inertia_kgm2;
  const WheelSpec& wheel = spec_->wheels[i - 1];
  return Eigen::Vector3d::Constant(kBallInertia * wheel.mass_kg * wheel.radius_m * wheel.radius_m);
}

double OdeBody::Energy() const {
  double energy_j = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const dBodyID part = parts_[i];
    const Eigen::Vector3d spin =
        OrientationOf(part).conjugate() * ToEigen(dBodyGetAngularVel(part));
    energy_j += PartMass(i) * (kGravity_mps2 * PositionOf(part).z() +
                               0.5 * ToEigen(dBodyGetLinearVel(part)).squaredNorm());
    energy_j += 0.5 * PartInertia(i).dot(spin.cwiseAbs2());
  }
  return energy_j;
}

void OdeBody::KeepForEnergy() {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    before_[i].velocity_mps = ToEigen(dBodyGetLinearVel(parts_[i]));
    before_[i].spin_radps = ToEigen(dBodyGetAngularVel(parts_[i]));
  }
  force_before_n_ = ToEigen(dBodyGetForce(trunk()));
  torque_before_nm_ = ToEigen(dBodyGetTorque(trunk()));
}

// A step of ODE changes velocities by impulses and then moves with the velocities that came of it:
// the work of an impulse is its product with the mean of the velocities before and after, and that
// of gravity goes with the velocity after. Spins are compared about the axes on which the impulses
// acted, those before the step: turning the axes is no work.
double OdeBody::EnergyGained(double step_s) const {
  double gained_j = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Before& before = before_[i];
    const Eigen::Vector3d velocity = ToEigen(dBodyGetLinearVel(parts_[i]));
    const Eigen::Vector3d spin = ToEigen(dBodyGetAngularVel(parts_[i]));
    gained_j += PartMass(i) * (0.5 * (velocity.squaredNorm() - before.velocity_mps.squaredNorm()) +
                               kGravity_mps2 * step_s * velocity.z());
    const Eigen::Vector3d inertia = PartInertia(i);
    if (IsEven(inertia)) {
      gained_j += 0.5 * inertia.x() * (spin.squaredNorm() - before.spin_radps.squaredNorm());
      continue;
    }
    const auto& q = before.quaternion;
    const Eigen::Quaterniond part_from_map = Eigen::Quaterniond(q[0], -q[1], -q[2], -q[3]);
    const Eigen::Vector3d squares =
        (part_from_map * spin).cwiseAbs2() - (part_from_map * before.spin_radps).cwiseAbs2();
    gained_j += 0.5 * inertia.dot(squares);
  }
  const Before& trunk_before = before_.front();
  const Eigen::Vector3d way_mps = ToEigen(dBodyGetLinearVel(trunk())) + trunk_before.velocity_mps;
  const Eigen::Vector3d turn_radps = ToEigen(dBodyGetAngularVel(trunk())) + trunk_before.spin_radps;
  return gained_j -
         0.5 * step_s * (force_before_n_.dot(way_mps) + torque_before_nm_.dot(turn_radps));
}

double OdeBody::EnergyOfMotors(double step_s) const {
  double energy_j = 0.0;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelSpec& wheel = spec_->wheels[i];
    double power_w = wheel.max_torque_nm * std::abs(control_.wheels[i].rate_radps);
    if (wheel.max_steering_rad > 0.0) {
      power_w +=
          mass_kg_ * kGravity_mps2 * (wheel.radius_m + wheel.width_m) * kFastestSteering_radps;
    }
    energy_j += power_w * step_s;
    if (wheel.spring_npm <= 0.0) continue;
    const double lifted_m = (PositionOf(parts_[1 + i]) - TrunkPoint(wheel.center_m)).norm();
    const double pressed_m =
        lifted_m + mass_kg_ * kGravity_mps2 / wheel.spring_npm;  // no less than it is
    const double factor = lifted_m > wheel.travel_m ? 1.0 + kBumpStopStiffness : 1.0;
    energy_j += 0.5 * factor * wheel.spring_npm * pressed_m * pressed_m;
  }
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (control_.joints[i].mode == JointMode::kFree) continue;
    const LinkSpec& link = spec_->links[i];
    energy_j += link.max_effort_nm * link.max_rate_radps * step_s;
  }
  return energy_j;
}

double OdeBody::EnergyOfCorrection() const {
  const double speed_mps = kCorrectingSpeed_mps + control_.walk_velocity_mps.norm();
  return 0.5 * mass_kg_ * speed_mps * speed_mps;
}

void OdeBody::TakeEnergy(double energy_j) {
  overdrawn_ = true;
  double motion_j = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Eigen::Vector3d spin =
        OrientationOf(parts_[i]).conjugate() * ToEigen(dBodyGetAngularVel(parts_[i]));
    motion_j += 0.5 * PartMass(i) * ToEigen(dBodyGetLinearVel(parts_[i])).squaredNorm();
    motion_j += 0.5 * PartInertia(i).dot(spin.cwiseAbs2());
  }
  // All by one factor: what the joints between the parts ask of their speeds still holds.
  const double left = motion_j > energy_j ? std::sqrt(1.0 - energy_j / motion_j) : 0.0;
  for (const dBodyID part : parts_) {
    SetVelocities(part, left * ToEigen(dBodyGetLinearVel(part)),
                  left * ToEigen(dBodyGetAngularVel(part)));
  }
}

}  // namespace latticeworld
