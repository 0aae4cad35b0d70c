// What happens to a body around a step.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_body.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr double kStillSpeed_mps = 0.02;
constexpr double kStillRate_radps = 0.03;
constexpr double kStillPartRate_radps = 0.1;
constexpr double kTremble = 3.0;  // times as much of what stands on motors
constexpr double kStillTime_s = 0.5;
constexpr double kArrived_rad = 0.05;  // a joint this near to its target has come there
constexpr double kStalled = 0.95;      // share of its effort with which a joint strives in vain
// A step may make a body faster by this much for no reason that is known here: a blow of something
// that moves fast, a motor, the ground pushing it out.
constexpr double kMostGain_mps = 30.0;
constexpr double kLongestOverdrawn_s = 0.25;  // time to come out of what it is in

bool IsFinite(dBodyID part) {
  // A sum is finite only where all its terms are, unless they are too large to be right anyhow.
  const dReal* x = dBodyGetPosition(part);
  const dReal* q = dBodyGetQuaternion(part);
  const dReal* v = dBodyGetLinearVel(part);
  const dReal* w = dBodyGetAngularVel(part);
  return std::isfinite(x[0] + x[1] + x[2] + q[0] + q[1] + q[2] + q[3] + v[0] + v[1] + v[2] + w[0] +
                       w[1] + w[2]);
}

}  // namespace

void OdeBody::SetEnabled(bool enabled) {
  for (const dBodyID part : parts_) {
    if (enabled) {
      dBodyEnable(part);
    } else {
      SetVelocities(part, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
      dBodySetForce(part, 0.0, 0.0, 0.0);
      dBodySetTorque(part, 0.0, 0.0, 0.0);
      dBodyDisable(part);
    }
  }
}

bool OdeBody::Brakes() const {
  for (const WheelCommand& wheel : control_.wheels) {
    if (wheel.rate_radps != 0.0) return false;
  }
  return !wheels_.empty();
}

// On its way to a position, and not stalled by what it cannot overcome.
bool OdeBody::IsArriving(std::size_t link) const {
  const JointTarget& target = control_.joints[link];
  if (target.mode != JointMode::kPosition) return false;
  const LinkSpec& spec = spec_->links[link];
  const JointReading reading = links_[link]->Reading();
  const double wanted_rad = std::clamp(target.value, spec.low_rad, spec.high_rad);
  return std::abs(wanted_rad - reading.angle_rad) > kArrived_rad &&
         std::abs(reading.effort_nm) < kStalled * spec.max_effort_nm;
}

bool OdeBody::still() const {
  if (fixed()) return true;
  if (!control_.walk_velocity_mps.isZero(0.0)) return false;
  if (!wheels_.empty() && !Brakes()) return false;
  for (const JointTarget& joint : control_.joints) {
    const bool pushes = joint.mode == JointMode::kVelocity || joint.mode == JointMode::kEffort;
    if (pushes && joint.value != 0.0) return false;
  }
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (IsArriving(i)) return false;
  }
  const double factor = links_.empty() ? 1.0 : kTremble;
  const auto below = [factor](const dReal* v, double limit) {
    return ToEigen(v).squaredNorm() < factor * limit * factor * limit;
  };
  if (!below(dBodyGetLinearVel(trunk()), kStillSpeed_mps) ||
      !below(dBodyGetAngularVel(trunk()), kStillRate_radps)) {
    return false;
  }
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    if (!below(dBodyGetAngularVel(parts_[i]), kStillPartRate_radps)) return false;
  }
  return true;
}

void OdeBody::Wake() {
  control_.still_s = 0.0;
  if (!control_.resting) return;
  control_.resting = false;
  if (!fixed()) SetEnabled(true);
}

void OdeBody::UpdateRest(double step_s) {
  if (!spec_->may_rest) return;
  control_.still_s = still() ? control_.still_s + step_s : 0.0;
  if (control_.still_s < kStillTime_s) return;
  control_.resting = true;
  SetEnabled(false);
}

void OdeBody::KeepUpright() {
  const dReal* r = dBodyGetRotation(trunk());
  const double half_rad = 0.5 * std::atan2(r[4], r[0]);
  SetOrientation(trunk(), {std::cos(half_rad), 0.0, 0.0, std::sin(half_rad)});
  dBodySetAngularVel(trunk(), 0.0, 0.0, dBodyGetAngularVel(trunk())[2]);
}

// Of parts whose speeds are finite. How fast parts may spin, ODE limits by itself.
double OdeBody::FastestPart() const {
  double most = 0.0;
  for (const dBodyID part : parts_) {
    most = std::max(most, ToEigen(dBodyGetLinearVel(part)).squaredNorm());
  }
  return std::sqrt(most);
}

void OdeBody::BeginStep(double step_s) {
  const Eigen::Vector3d up = Turned(trunk(), Eigen::Vector3d::UnitZ());
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelSpec& wheel_spec = spec_->wheels[i];
    const double deflection_m =
        wheel_spec.spring_npm > 0.0
            ? (PositionOf(wheel(i)) - TrunkPoint(wheel_spec.center_m)).dot(up)
            : 0.0;
    const WheelCommand& command = control_.wheels[i];
    wheels_[i]->Drive(command.rate_radps, command.steer_rad, step_s, deflection_m);
  }
  for (std::size_t i = 0; i < links_.size(); ++i) links_[i]->Drive(control_.joints[i], step_s);

  for (std::size_t i = 0; i < parts_.size(); ++i) {
    std::copy_n(dBodyGetPosition(parts_[i]), 3, before_[i].position_m.begin());
    std::copy_n(dBodyGetQuaternion(parts_[i]), 4, before_[i].quaternion.begin());
  }
  LimitForces(step_s);
  KeepForEnergy();
  const double force_n = ToEigen(dBodyGetForce(trunk())).norm();
  fastest_before_mps_ = FastestPart() + step_s * force_n / spec_->mass_kg;
}

void OdeBody::LimitForces(double step_s) {
  for (const dBodyID part : parts_) {
    control_.spoiled = control_.spoiled || !ToEigen(dBodyGetForce(part)).allFinite() ||
                       !ToEigen(dBodyGetTorque(part)).allFinite() ||
                       !ToEigen(dBodyGetLinearVel(part)).allFinite() ||
                       !ToEigen(dBodyGetAngularVel(part)).allFinite();
  }
  // FinishStep finds it spoiled; what it does until then moves nobody else.
  if (control_.spoiled) return PutBack();
  const Eigen::Vector3d force_n = ToEigen(dBodyGetForce(trunk()));
  if (!force_n.isZero(0.0)) {
    const Eigen::Vector3d velocity = ToEigen(dBodyGetLinearVel(trunk()));
    const Eigen::Vector3d faster = velocity + force_n * (step_s / spec_->mass_kg);
    const Eigen::Vector3d most = Within(faster, std::max(velocity.norm(), spec_->max_speed_mps));
    if (most != faster) {
      const Eigen::Vector3d less_n = (most - velocity) * (spec_->mass_kg / step_s);
      dBodySetForce(trunk(), less_n.x(), less_n.y(), less_n.z());
    }
  }
  const Eigen::Vector3d torque_nm = ToEigen(dBodyGetTorque(trunk()));
  if (!torque_nm.isZero(0.0)) {
    const Eigen::Matrix3d map_from_base = OrientationOf(trunk()).toRotationMatrix();
    const Eigen::Vector3d inertia = TrunkInertia();
    const Eigen::Vector3d gain =
        (map_from_base.transpose() * torque_nm).cwiseQuotient(inertia) * step_s;
    // ODE itself limits the spin to which this is added.
    const Eigen::Vector3d most = Within(gain, 2.0 * kTrunkSpin_radps);
    if (most != gain) {
      const Eigen::Vector3d less_nm = map_from_base * most.cwiseProduct(inertia) / step_s;
      dBodySetTorque(trunk(), less_nm.x(), less_nm.y(), less_nm.z());
    }
  }
}

void OdeBody::PutBack() {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Before& pose = before_[i];
    dBodySetPosition(parts_[i], pose.position_m[0], pose.position_m[1], pose.position_m[2]);
    dBodySetQuaternion(parts_[i], pose.quaternion.data());
    SetVelocities(parts_[i], Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    dBodySetForce(parts_[i], 0.0, 0.0, 0.0);
    dBodySetTorque(parts_[i], 0.0, 0.0, 0.0);
  }
  Moved();
}

void OdeBody::LimitSpeed() {
  const Eigen::Vector3d v = ToEigen(dBodyGetLinearVel(trunk()));
  const double speed_mps = v.norm();
  if (speed_mps <= spec_->max_speed_mps) return;
  const Eigen::Vector3d too_much = v * (1.0 - spec_->max_speed_mps / speed_mps);
  for (const dBodyID part : parts_) {
    const Eigen::Vector3d less = ToEigen(dBodyGetLinearVel(part)) - too_much;
    dBodySetLinearVel(part, less.x(), less.y(), less.z());
  }
}

bool OdeBody::FinishStep(double step_s) {
  bool sound = !control_.spoiled;
  for (const dBodyID part : parts_) sound = sound && IsFinite(part);
  sound = sound && FastestPart() <= fastest_before_mps_ + kMostGain_mps;
  control_.overdrawn_s = std::max(0.0, control_.overdrawn_s + (overdrawn_ ? step_s : -step_s));
  overdrawn_ = false;
  sound = sound && control_.overdrawn_s <= kLongestOverdrawn_s;
  if (!sound) {
    PutBack();
    control_.spoiled = false;
    control_.still_s = 0.0;
    control_.overdrawn_s = 0.0;
    return false;
  }
  LimitSpeed();
  if (control_.upright) KeepUpright();
  Moved();
  UpdateRest(step_s);
  return true;
}

}  // namespace latticeworld
