#include "latticeworld/simulation/ode/body/body_energy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

// Contacts push a body out of another or of the ground at up to this speed (ContactJoints), and so
// fast may joints that were torn apart bring its parts together.
constexpr double kCorrectingSpeed_mps = 2.0;
constexpr double kFastestSteering_radps = 3.0;
constexpr double kBumpStopStiffness = 20.0;  // times that of the spring, beyond its travel

bool IsEven(const Eigen::Vector3d& inertia_kgm2) {
  return inertia_kgm2.x() == inertia_kgm2.y() && inertia_kgm2.y() == inertia_kgm2.z();
}

}  // namespace

double BodyEnergy::Total() const {
  double energy_j = 0.0;
  for (std::size_t i = 0; i < parts_.all().size(); ++i) {
    const dBodyID part = parts_.part(i);
    const Eigen::Vector3d spin =
        OrientationOf(part).conjugate() * ToEigen(dBodyGetAngularVel(part));
    energy_j += parts_.Mass(i) * (kGravity_mps2 * PositionOf(part).z() +
                                  0.5 * ToEigen(dBodyGetLinearVel(part)).squaredNorm());
    energy_j += 0.5 * parts_.Inertia(i).dot(spin.cwiseAbs2());
  }
  return energy_j;
}

// A step of ODE changes velocities by impulses and then moves with the velocities that came of it:
// the work of an impulse is its product with the mean of the velocities before and after, and that
// of gravity goes with the velocity after. Spins are compared about the axes on which the impulses
// acted, those before the step: turning the axes is no work.
double BodyEnergy::Gained(double step_s) const {
  const BodyParts& parts = parts_;
  const std::vector<StepStart::Part>& start = start_.parts();
  double gained_j = 0.0;
  for (std::size_t i = 0; i < parts.all().size(); ++i) {
    const StepStart::Part& before = start[i];
    const Eigen::Vector3d velocity = ToEigen(dBodyGetLinearVel(parts.part(i)));
    const Eigen::Vector3d spin = ToEigen(dBodyGetAngularVel(parts.part(i)));
    gained_j +=
        parts.Mass(i) * (0.5 * (velocity.squaredNorm() - before.velocity_mps.squaredNorm()) +
                         kGravity_mps2 * step_s * velocity.z());
    const Eigen::Vector3d inertia = parts.Inertia(i);
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
  const StepStart::Part& trunk_before = start.front();
  const Eigen::Vector3d way_mps =
      ToEigen(dBodyGetLinearVel(parts.trunk())) + trunk_before.velocity_mps;
  const Eigen::Vector3d turn_radps =
      ToEigen(dBodyGetAngularVel(parts.trunk())) + trunk_before.spin_radps;
  return gained_j -
         0.5 * step_s * (start_.force_n().dot(way_mps) + start_.torque_nm().dot(turn_radps));
}

double BodyEnergy::OfMotors(double step_s) const {
  double energy_j = 0.0;
  for (std::size_t i = 0; i < parts_.wheel_count(); ++i) {
    const WheelSpec& wheel = parts_.spec().wheels[i];
    double power_w = wheel.max_torque_nm * std::abs(control_.wheels[i].rate_radps);
    if (wheel.max_steering_rad > 0.0) {
      power_w += parts_.mass_kg() * kGravity_mps2 * (wheel.radius_m + wheel.width_m) *
                 kFastestSteering_radps;
    }
    energy_j += power_w * step_s;
    if (wheel.spring_npm <= 0.0) continue;
    const double lifted_m =
        (PositionOf(parts_.part(1 + i)) - parts_.TrunkPoint(wheel.center_m)).norm();
    const double pressed_m =
        lifted_m + parts_.mass_kg() * kGravity_mps2 / wheel.spring_npm;  // no less than it is
    const double factor = lifted_m > wheel.travel_m ? 1.0 + kBumpStopStiffness : 1.0;
    energy_j += 0.5 * factor * wheel.spring_npm * pressed_m * pressed_m;
  }
  for (std::size_t i = 0; i < parts_.link_count(); ++i) {
    if (control_.joints[i].mode == JointMode::kFree) continue;
    const LinkSpec& link = parts_.spec().links[i];
    energy_j += link.max_effort_nm * link.max_rate_radps * step_s;
  }
  return energy_j;
}

double BodyEnergy::OfCorrection() const {
  const double speed_mps = kCorrectingSpeed_mps + control_.walk_velocity_mps.norm();
  return 0.5 * parts_.mass_kg() * speed_mps * speed_mps;
}

void BodyEnergy::Take(double energy_j) {
  taken_ = true;
  double motion_j = 0.0;
  for (std::size_t i = 0; i < parts_.all().size(); ++i) {
    const Eigen::Vector3d spin =
        OrientationOf(parts_.part(i)).conjugate() * ToEigen(dBodyGetAngularVel(parts_.part(i)));
    motion_j += 0.5 * parts_.Mass(i) * ToEigen(dBodyGetLinearVel(parts_.part(i))).squaredNorm();
    motion_j += 0.5 * parts_.Inertia(i).dot(spin.cwiseAbs2());
  }
  // All by one factor: what the joints between the parts ask of their speeds still holds.
  const double left = motion_j > energy_j ? std::sqrt(1.0 - energy_j / motion_j) : 0.0;
  for (const dBodyID part : parts_.all()) {
    SetVelocities(part, left * ToEigen(dBodyGetLinearVel(part)),
                  left * ToEigen(dBodyGetAngularVel(part)));
  }
}

bool BodyEnergy::WasTaken() { return std::exchange(taken_, false); }

}  // namespace latticeworld
