#include "latticeworld/simulation/ode/body/stillness.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr double kStillSpeed_mps = 0.02;
constexpr double kStillRate_radps = 0.03;
constexpr double kStillPartRate_radps = 0.1;
constexpr double kTremble = 3.0;       // times as much of what stands on motors
constexpr double kArrived_rad = 0.05;  // a joint this near to its target has come there
constexpr double kStalled = 0.95;      // share of its effort with which a joint strives in vain

// Returns whether a joint is on its way to a position, and not stalled by what it cannot overcome.
bool IsArriving(const LinkJoint& joint, const LinkSpec& spec, const JointTarget& target) {
  if (target.mode != JointMode::kPosition) return false;
  const JointReading reading = joint.Reading();
  const double wanted_rad = std::clamp(target.value, spec.low_rad, spec.high_rad);
  return std::abs(wanted_rad - reading.angle_rad) > kArrived_rad &&
         std::abs(reading.effort_nm) < kStalled * spec.max_effort_nm;
}

// It is not told to walk, to roll or to turn a joint.
bool IsIdle(const BodyParts& parts, const BodyControl& control) {
  if (!control.walk_velocity_mps.isZero(0.0)) return false;
  if (parts.wheel_count() > 0 && !control.Brakes()) return false;
  for (const JointTarget& joint : control.joints) {
    const bool pushes = joint.mode == JointMode::kVelocity || joint.mode == JointMode::kEffort;
    if (pushes && joint.value != 0.0) return false;
  }
  for (std::size_t i = 0; i < parts.link_count(); ++i) {
    if (IsArriving(parts.link_joint(i), parts.spec().links[i], control.joints[i])) return false;
  }
  return true;
}

}  // namespace

bool IsStill(const BodyParts& parts, const BodyControl& control) {
  if (!IsIdle(parts, control)) return false;
  const double factor = parts.link_count() == 0 ? 1.0 : kTremble;
  const auto below = [factor](const dReal* v, double limit) {
    return ToEigen(v).squaredNorm() < factor * limit * factor * limit;
  };
  if (!below(dBodyGetLinearVel(parts.trunk()), kStillSpeed_mps) ||
      !below(dBodyGetAngularVel(parts.trunk()), kStillRate_radps)) {
    return false;
  }
  for (std::size_t i = 1; i < parts.all().size(); ++i) {
    if (!below(dBodyGetAngularVel(parts.part(i)), kStillPartRate_radps)) return false;
  }
  return true;
}

}  // namespace latticeworld
