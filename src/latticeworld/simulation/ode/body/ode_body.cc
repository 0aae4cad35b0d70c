#include "latticeworld/simulation/ode/body/ode_body.h"

#include <cmath>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {

OdeBody::OdeBody(dWorldID world, BodyId id, std::shared_ptr<const BodySpec> spec)
    : id_(id),
      spec_(std::move(spec)),
      parts_(world, *spec_),
      solids_(parts_),
      start_(parts_),
      energy_(parts_, control_, start_) {
  control_.wheels.resize(parts_.wheel_count());
  control_.joints.resize(parts_.link_count());
  control_.upright = spec_->upright;
  parts_.SetUpright(control_.upright);
  if (spec_->anchor) SetAnchored(true);
}

void OdeBody::MoveTo(dWorldID world) {
  const BodyState state = Save();
  parts_.MakeAnew(world);
  Restore(state);
}

void OdeBody::SetMotion(const BodyMotion& motion) {
  parts_.SetMotion(motion);
  solids_.Moved();
  if (control_.anchored) {
    control_.anchor_pose = StateOf(parts_.trunk());
    HoldByHinge();
  }
  Wake();
}

double OdeBody::AnchorAngle() const {
  const AnchorHinge* hinge = parts_.anchor_hinge();
  return hinge != nullptr && control_.anchored ? hinge->Angle() : 0.0;
}

void OdeBody::HoldByHinge() {
  AnchorHinge* hinge = parts_.anchor_hinge();
  if (hinge != nullptr) hinge->HoldAt(parts_.TrunkPoint(spec_->anchor->pivot_m));
}

void OdeBody::Wake() {
  control_.still_s = 0.0;
  if (!control_.resting) return;
  control_.resting = false;
  if (!fixed()) parts_.SetEnabled(true);
}

void OdeBody::SetWalkVelocity(const Eigen::Vector3d& velocity_mps) {
  if (!velocity_mps.allFinite()) return Spoil();
  if (velocity_mps == control_.walk_velocity_mps) return;
  control_.walk_velocity_mps = velocity_mps;
  Wake();
}

void OdeBody::SetWheel(std::size_t i, const WheelCommand& command) {
  if (!std::isfinite(command.rate_radps) || !std::isfinite(command.steer_rad)) return Spoil();
  LW_CHECK(i < control_.wheels.size(), "no such wheel");
  WheelCommand& known = control_.wheels[i];
  if (command.rate_radps == known.rate_radps && command.steer_rad == known.steer_rad) return;
  known = command;
  Wake();
}

void OdeBody::SetJoint(std::size_t i, const JointTarget& target) {
  if (!std::isfinite(target.value)) return Spoil();
  LW_CHECK(i < control_.joints.size(), "no such link");
  JointTarget& known = control_.joints[i];
  if (target.mode == known.mode && target.value == known.value) return;
  known = target;
  Wake();
}

void OdeBody::SetUpright(bool upright) {
  if (upright == control_.upright) return;
  control_.upright = upright;
  parts_.SetUpright(upright);
  if (upright) {
    BodyMotion motion = parts_.Motion();
    motion.orientation = Eigen::AngleAxisd(motion.yaw_rad(), Eigen::Vector3d::UnitZ());
    motion.angular_velocity_radps.head<2>().setZero();
    SetMotion(motion);
  }
  Wake();
}

void OdeBody::SetAnchored(bool anchored) {
  if (anchored == control_.anchored) return;
  control_.anchored = anchored;
  if (anchored) {
    control_.anchor_pose = StateOf(parts_.trunk());
    HoldByHinge();
  } else if (parts_.anchor_hinge() != nullptr) {
    parts_.anchor_hinge()->Release();
  }
  parts_.SetEnabled(!stands());
  Wake();
}

void OdeBody::AddImpulse(const Eigen::Vector3d& impulse_ns, const Eigen::Vector3d& point_m) {
  if (!impulse_ns.allFinite() || !point_m.allFinite()) return Spoil();
  if (fixed() || impulse_ns.isZero(0.0)) return;
  const Eigen::Matrix3d map_from_base = OrientationOf(parts_.trunk()).toRotationMatrix();
  const Eigen::Vector3d turning = (point_m - PositionOf(parts_.trunk())).cross(impulse_ns);
  const Eigen::Vector3d spin =
      ToEigen(dBodyGetAngularVel(parts_.trunk())) +
      map_from_base * (map_from_base.transpose() * turning).cwiseQuotient(parts_.Inertia(0));
  const Eigen::Vector3d velocity =
      ToEigen(dBodyGetLinearVel(parts_.trunk())) + impulse_ns / spec_->mass_kg;
  if (!velocity.allFinite() || !spin.allFinite()) return Spoil();
  Wake();
  SetVelocities(parts_.trunk(), Within(velocity, spec_->max_speed_mps),
                Within(spin, kTrunkSpin_radps));
}

bool OdeBody::TakesForce(const Eigen::Vector3d& force_n, const Eigen::Vector3d& point_m) {
  if (!force_n.allFinite() || !point_m.allFinite()) {
    Spoil();
    return false;
  }
  if (fixed() || force_n.isZero(0.0)) return false;
  // What floats is pushed in every step and shall come to rest all the same.
  if (control_.resting) Wake();
  return true;
}

}  // namespace latticeworld
