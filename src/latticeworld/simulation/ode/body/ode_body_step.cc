// What happens to a body around a step.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

// A step may make a body faster by this much for no reason that is known here: a blow of something
// that moves fast, a motor, the ground pushing it out.
constexpr double kMostGain_mps = 30.0;
constexpr double kLongestOverdrawn_s = 0.25;  // time to come out of what it is in
constexpr double kStillTime_s = 0.5;          // after which a body rests

bool IsFinite(dBodyID part) {
  // A sum is finite only where all its terms are, unless they are too large to be right anyhow.
  const dReal* x = dBodyGetPosition(part);
  const dReal* q = dBodyGetQuaternion(part);
  const dReal* v = dBodyGetLinearVel(part);
  const dReal* w = dBodyGetAngularVel(part);
  return std::isfinite(x[0] + x[1] + x[2] + q[0] + q[1] + q[2] + q[3] + v[0] + v[1] + v[2] + w[0] +
                       w[1] + w[2]);
}

bool HasFiniteForces(dBodyID part) {
  return ToEigen(dBodyGetForce(part)).allFinite() && ToEigen(dBodyGetTorque(part)).allFinite() &&
         ToEigen(dBodyGetLinearVel(part)).allFinite() &&
         ToEigen(dBodyGetAngularVel(part)).allFinite();
}

void KeepUpright(dBodyID trunk) {
  const dReal* r = dBodyGetRotation(trunk);
  const double half_rad = 0.5 * std::atan2(r[4], r[0]);
  SetOrientation(trunk, {std::cos(half_rad), 0.0, 0.0, std::sin(half_rad)});
  dBodySetAngularVel(trunk, 0.0, 0.0, dBodyGetAngularVel(trunk)[2]);
}

// Returns the greatest speed of parts whose speeds are finite [m/s]. ODE itself limits how fast
// they spin.
double FastestOf(const std::vector<dBodyID>& parts) {
  double most = 0.0;
  for (const dBodyID part : parts) {
    most = std::max(most, ToEigen(dBodyGetLinearVel(part)).squaredNorm());
  }
  return std::sqrt(most);
}

// Keeps the force on the trunk within what may come of it.
void LimitForce(const BodyParts& parts, double step_s) {
  const BodySpec& spec = parts.spec();
  const dBodyID trunk = parts.trunk();
  const Eigen::Vector3d force_n = ToEigen(dBodyGetForce(trunk));
  if (force_n.isZero(0.0)) return;
  const Eigen::Vector3d velocity = ToEigen(dBodyGetLinearVel(trunk));
  const Eigen::Vector3d faster = velocity + force_n * (step_s / spec.mass_kg);
  const Eigen::Vector3d most = Within(faster, std::max(velocity.norm(), spec.max_speed_mps));
  if (most == faster) return;
  const Eigen::Vector3d less_n = (most - velocity) * (spec.mass_kg / step_s);
  dBodySetForce(trunk, less_n.x(), less_n.y(), less_n.z());
}

void LimitTorque(const BodyParts& parts, double step_s) {
  const dBodyID trunk = parts.trunk();
  const Eigen::Vector3d torque_nm = ToEigen(dBodyGetTorque(trunk));
  if (torque_nm.isZero(0.0)) return;
  const Eigen::Matrix3d map_from_base = OrientationOf(trunk).toRotationMatrix();
  const Eigen::Vector3d inertia = parts.Inertia(0);
  const Eigen::Vector3d gain =
      (map_from_base.transpose() * torque_nm).cwiseQuotient(inertia) * step_s;
  // ODE itself limits the spin to which this is added.
  const Eigen::Vector3d most = Within(gain, 2.0 * kTrunkSpin_radps);
  if (most == gain) return;
  const Eigen::Vector3d less_nm = map_from_base * most.cwiseProduct(inertia) / step_s;
  dBodySetTorque(trunk, less_nm.x(), less_nm.y(), less_nm.z());
}

void LimitSpeed(const BodyParts& parts) {
  const double max_speed_mps = parts.spec().max_speed_mps;
  const Eigen::Vector3d v = ToEigen(dBodyGetLinearVel(parts.trunk()));
  const double speed_mps = v.norm();
  if (speed_mps <= max_speed_mps) return;
  const Eigen::Vector3d too_much = v * (1.0 - max_speed_mps / speed_mps);
  for (const dBodyID part : parts.all()) {
    const Eigen::Vector3d less = ToEigen(dBodyGetLinearVel(part)) - too_much;
    dBodySetLinearVel(part, less.x(), less.y(), less.z());
  }
}

}  // namespace

void OdeBody::UpdateRest(double step_s) {
  if (!spec_->may_rest) return;
  control_.still_s = still() ? control_.still_s + step_s : 0.0;
  if (control_.still_s < kStillTime_s) return;
  control_.resting = true;
  parts_.SetEnabled(false);
}

void OdeBody::BeginStep(double step_s) {
  parts_.Drive(control_, step_s);
  start_.KeepPoses();
  for (const dBodyID part : parts_.all()) {
    control_.spoiled = control_.spoiled || !HasFiniteForces(part);
  }
  if (control_.spoiled) {
    // FinishStep finds it spoiled; what it does until then moves nobody else.
    start_.GoBack();
    solids_.Moved();
  } else {
    LimitForce(parts_, step_s);
    LimitTorque(parts_, step_s);
  }
  start_.KeepMotion();
  fastest_before_mps_ = FastestOf(parts_.all()) + step_s * start_.force_n().norm() / spec_->mass_kg;
}

bool OdeBody::FinishStep(double step_s) {
  bool sound = !control_.spoiled;
  for (const dBodyID part : parts_.all()) sound = sound && IsFinite(part);
  sound = sound && FastestOf(parts_.all()) <= fastest_before_mps_ + kMostGain_mps;
  control_.overdrawn_s =
      std::max(0.0, control_.overdrawn_s + (energy_.WasTaken() ? step_s : -step_s));
  sound = sound && control_.overdrawn_s <= kLongestOverdrawn_s;
  if (!sound) {
    start_.GoBack();
    solids_.Moved();
    control_.spoiled = false;
    control_.still_s = 0.0;
    control_.overdrawn_s = 0.0;
    return false;
  }
  LimitSpeed(parts_);
  if (control_.upright) KeepUpright(parts_.trunk());
  solids_.Moved();
  UpdateRest(step_s);
  return true;
}

}  // namespace latticeworld
