#include "latticeworld/simulation/ode/ode_body.h"

#include <cmath>

#include "latticeworld/common/digest.h"

namespace latticeworld {
namespace {

// Upright bodies turn about z alone: pitch and roll meet this many times their inertia.
constexpr double kUprightInertiaFactor = 1e4;
constexpr double kStillSpeed_mps = 0.02;
constexpr double kStillRate_radps = 0.03;
constexpr double kStillTime_s = 0.5;

Eigen::Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }
Eigen::Quaterniond OrientationOf(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return {q[0], q[1], q[2], q[3]};
}
void SetOrientation(dBodyID body, const Eigen::Quaterniond& orientation) {
  const dQuaternion q = {orientation.w(), orientation.x(), orientation.y(), orientation.z()};
  dBodySetQuaternion(body, q);
}
void SetVelocities(dBodyID body, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular) {
  dBodySetLinearVel(body, linear.x(), linear.y(), linear.z());
  dBodySetAngularVel(body, angular.x(), angular.y(), angular.z());
}
void AddBody(Digest* digest, dBodyID body) {
  for (int i = 0; i < 3; ++i) {
    digest->Add(dBodyGetPosition(body)[i]);
    digest->Add(dBodyGetLinearVel(body)[i]);
    digest->Add(dBodyGetAngularVel(body)[i]);
  }
  for (int i = 0; i < 4; ++i) digest->Add(dBodyGetQuaternion(body)[i]);
}

}  // namespace

OdeBody::OdeBody(dWorldID world, const BodySpec& spec) : spec_(spec), trunk_(dBodyCreate(world)) {
  dMass mass;
  const double lock = spec.upright ? kUprightInertiaFactor : 1.0;
  dMassSetParameters(&mass, spec.mass_kg, 0.0, 0.0, 0.0, spec.inertia_kgm2.x() * lock,
                     spec.inertia_kgm2.y() * lock, spec.inertia_kgm2.z(), 0.0, 0.0, 0.0);
  dBodySetMass(trunk_, &mass);
  if (spec.upright) dBodySetGyroscopicMode(trunk_, 0);

  mass_kg_ = spec.mass_kg;
  for (const WheelSpec& wheel : spec.wheels) {
    mass_kg_ += wheel.mass_kg;
    const dBodyID body = dBodyCreate(world);
    dMassSetSphereTotal(&mass, wheel.mass_kg, wheel.radius_m);
    dBodySetMass(body, &mass);
    dBodySetGyroscopicMode(body, 0);
    dBodySetFiniteRotationMode(body, 1);
    wheels_.push_back(body);
  }
  SetMotion(BodyMotion());
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, wheels_[i], trunk_);
    const Eigen::Vector3d center = WheelCenter(i);
    dJointSetHingeAnchor(hinge, center.x(), center.y(), center.z());
    dJointSetHingeAxis(hinge, 0.0, 1.0, 0.0);
    dJointSetHingeParam(hinge, dParamVel, 0.0);
    dJointSetHingeParam(hinge, dParamFMax, spec_.wheels[i].max_torque_nm);
    hinges_.push_back(hinge);
  }
}

OdeBody::~OdeBody() {
  for (const dJointID hinge : hinges_) dJointDestroy(hinge);
  for (const dBodyID wheel : wheels_) dBodyDestroy(wheel);
  dBodyDestroy(trunk_);
}

Eigen::Vector3d OdeBody::WheelCenter(std::size_t i) const {
  return ToEigen(dBodyGetPosition(wheels_[i]));
}

Eigen::Vector3d OdeBody::WheelAxis(std::size_t i) const {
  (void)i;  // every axle lies along y of the trunk
  return OrientationOf(trunk_) * Eigen::Vector3d::UnitY();
}

double OdeBody::WheelRate(std::size_t i) const {
  return ToEigen(dBodyGetAngularVel(wheels_[i])).dot(WheelAxis(i));
}

BodyMotion OdeBody::Motion() const {
  BodyMotion motion;
  motion.orientation = OrientationOf(trunk_);
  motion.position_m = ToEigen(dBodyGetPosition(trunk_)) -
                      motion.orientation * Eigen::Vector3d(0.0, 0.0, spec_.center_height_m);
  motion.angular_velocity_radps = ToEigen(dBodyGetAngularVel(trunk_));
  motion.linear_velocity_mps = VelocityAt(motion.position_m);
  return motion;
}

void OdeBody::SetMotion(const BodyMotion& motion) {
  const Eigen::Vector3d arm = motion.orientation * Eigen::Vector3d(0, 0, spec_.center_height_m);
  const Eigen::Vector3d center = motion.position_m + arm;
  dBodySetPosition(trunk_, center.x(), center.y(), center.z());
  SetOrientation(trunk_, motion.orientation);
  SetVelocities(trunk_, motion.linear_velocity_mps + motion.angular_velocity_radps.cross(arm),
                motion.angular_velocity_radps);
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Eigen::Vector3d offset = motion.orientation * spec_.wheels[i].center_m;
    const Eigen::Vector3d at = motion.position_m + offset;
    dBodySetPosition(wheels_[i], at.x(), at.y(), at.z());
    SetOrientation(wheels_[i], motion.orientation);
    SetVelocities(wheels_[i],
                  motion.linear_velocity_mps + motion.angular_velocity_radps.cross(offset),
                  motion.angular_velocity_radps);
  }
  Wake();
}

Prism OdeBody::Outline() const {
  const BodyMotion motion = Motion();
  const Eigen::Vector2d at = motion.position_m.head<2>();
  // A leaning body's lowest and highest points, by the height of its upright axis.
  const double up = std::abs((motion.orientation * Eigen::Vector3d::UnitZ()).z());
  const double middle = motion.position_m.z() +
                        (motion.orientation * Eigen::Vector3d(0, 0, 0.5 * spec_.height_m)).z();
  const double half =
      0.5 * spec_.height_m * up +
      (spec_.upright ? 0.0 : spec_.radius_m * std::sqrt(1.0 - std::min(1.0, up * up)));
  if (spec_.half_length_m > 0.0) {
    return Prism::Box(at, motion.yaw_rad(), spec_.half_length_m, spec_.half_width_m, middle - half,
                      middle + half);
  }
  return Prism::Round(at, spec_.radius_m, middle - half, middle + half);
}

Eigen::Vector3d OdeBody::VelocityAt(const Eigen::Vector3d& point_m) const {
  const Eigen::Vector3d arm = point_m - ToEigen(dBodyGetPosition(trunk_));
  return ToEigen(dBodyGetLinearVel(trunk_)) + ToEigen(dBodyGetAngularVel(trunk_)).cross(arm);
}

void OdeBody::SetWheelRates(double left_radps, double right_radps) {
  if (left_radps == left_radps_ && right_radps == right_radps_) return;
  left_radps_ = left_radps;
  right_radps_ = right_radps;
  Wake();
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const bool left = spec_.wheels[i].center_m.y() > 0.0;
    dJointSetHingeParam(hinges_[i], dParamVel, left ? left_radps : right_radps);
  }
}

void OdeBody::SetWalkVelocity(const Eigen::Vector3d& velocity_mps) {
  if (velocity_mps == walk_velocity_mps_) return;
  walk_velocity_mps_ = velocity_mps;
  Wake();
}

void OdeBody::KeepUpright() {
  if (!spec_.upright || resting_) return;
  const double yaw = Motion().yaw_rad();
  SetOrientation(trunk_, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
  dBodySetAngularVel(trunk_, 0.0, 0.0, dBodyGetAngularVel(trunk_)[2]);
}

bool OdeBody::still() const {
  if (walk_velocity_mps_ != Eigen::Vector3d::Zero() || left_radps_ != 0.0 || right_radps_ != 0.0) {
    return false;
  }
  return ToEigen(dBodyGetLinearVel(trunk_)).norm() < kStillSpeed_mps &&
         ToEigen(dBodyGetAngularVel(trunk_)).norm() < kStillRate_radps;
}

void OdeBody::UpdateRest(double step_s) {
  if (!spec_.may_rest || resting_) return;
  still_s_ = still() ? still_s_ + step_s : 0.0;
  if (still_s_ < kStillTime_s) return;
  resting_ = true;
  SetVelocities(trunk_, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  dBodyDisable(trunk_);
  for (const dBodyID wheel : wheels_) {
    SetVelocities(wheel, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    dBodyDisable(wheel);
  }
}

void OdeBody::Wake() {
  still_s_ = 0.0;
  if (!resting_) return;
  resting_ = false;
  dBodyEnable(trunk_);
  for (const dBodyID wheel : wheels_) dBodyEnable(wheel);
}

void OdeBody::AddTo(Digest* digest) const {
  AddBody(digest, trunk_);
  for (const dBodyID wheel : wheels_) AddBody(digest, wheel);
  for (int i = 0; i < 3; ++i) digest->Add(walk_velocity_mps_[i]);
  digest->Add(left_radps_);
  digest->Add(right_radps_);
  digest->Add(still_s_);
  digest->Add(resting_);
}

}  // namespace latticeworld
