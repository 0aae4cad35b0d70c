#include "latticeworld/simulation/ode/body/wheel_joint.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr double kSteeringRate_radps = 3.0;
constexpr double kSteeringGain = 0.3;        // share of the error that a step undoes
constexpr double kSteeringFriction = 1.0;    // of the tyre that its steering overcomes
constexpr double kBumpStopStiffness = 20.0;  // times that of the spring, beyond its travel
constexpr double kRigidErp = 0.3;
constexpr double kRigidCfm = 1e-9;

}  // namespace

WheelJoint::WheelJoint(dWorldID world, const WheelSpec& spec, double load_n, dBodyID trunk,
                       dBodyID wheel)
    : spec_(spec),
      hinge2_(spec.spring_npm > 0.0 || spec.max_steering_rad > 0.0),
      trunk_(trunk),
      wheel_(wheel) {
  if (!hinge2_) {
    joint_ = dJointCreateHinge(world, nullptr);
    dJointAttach(joint_, wheel, trunk);
    dJointSetHingeAnchor(joint_, spec.center_m.x(), spec.center_m.y(), spec.center_m.z());
    dJointSetHingeAxis(joint_, 0.0, 1.0, 0.0);
    dJointSetHingeParam(joint_, dParamFMax, spec.max_torque_nm);
  } else {
    if (spec.spring_npm > 0.0) sag_m_ = load_n / spec.spring_npm;
    const Eigen::Vector3d free = spec.center_m - Eigen::Vector3d(0.0, 0.0, sag_m_);
    SetPosition(wheel, free);
    joint_ = dJointCreateHinge2(world, nullptr);
    dJointAttach(joint_, trunk, wheel);
    dJointSetHinge2Anchor(joint_, free.x(), free.y(), free.z());
    // ODE measures how the first body, the trunk, turns against the second: the axes are reversed,
    // so that angles are those of the wheel.
    const dReal down[3] = {0.0, 0.0, -1.0}, right[3] = {0.0, -1.0, 0.0};
    dJointSetHinge2Axes(joint_, down, right);
    dJointSetHinge2Param(joint_, dParamLoStop, -spec.max_steering_rad);
    dJointSetHinge2Param(joint_, dParamHiStop, spec.max_steering_rad);
    dJointSetHinge2Param(joint_, dParamFMax2, spec.max_torque_nm);
    if (spec.max_steering_rad > 0.0) {
      const double steering_nm = kSteeringFriction * load_n * (spec.radius_m + spec.width_m);
      dJointSetHinge2Param(joint_, dParamFMax, steering_nm);
    }
    dJointSetHinge2Param(joint_, dParamSuspensionERP, kRigidErp);
    dJointSetHinge2Param(joint_, dParamSuspensionCFM, kRigidCfm);
    SetPosition(wheel, spec.center_m);
  }
  dJointSetFeedback(joint_, &feedback_);
}

WheelJoint::~WheelJoint() { dJointDestroy(joint_); }

void WheelJoint::Drive(double rate_radps, double steer_rad, double step_s, double deflection_m) {
  if (!hinge2_) {
    dJointSetHingeParam(joint_, dParamVel, rate_radps);
    return;
  }
  dJointSetHinge2Param(joint_, dParamVel2, rate_radps);
  if (spec_.max_steering_rad > 0.0) {
    const double wanted = std::clamp(steer_rad, -spec_.max_steering_rad, spec_.max_steering_rad);
    const double error_rad = wanted - dJointGetHinge2Angle1(joint_);
    dJointSetHinge2Param(
        joint_, dParamVel,
        std::clamp(kSteeringGain * error_rad / step_s, -kSteeringRate_radps, kSteeringRate_radps));
  }
  if (spec_.spring_npm <= 0.0) return;
  // An implicit spring and damper as ODE's manual gives them. The stop makes the spring stiffer by
  // what the travel is exceeded, without a jump in its force.
  double spring_npm = spec_.spring_npm;
  if (deflection_m > spec_.travel_m) {
    spring_npm *=
        1.0 + kBumpStopStiffness * (deflection_m - spec_.travel_m) / (deflection_m + sag_m_);
  }
  const double stiff = step_s * spring_npm;
  dJointSetHinge2Param(joint_, dParamSuspensionERP, stiff / (stiff + spec_.damper_nspm));
  dJointSetHinge2Param(joint_, dParamSuspensionCFM, 1.0 / (stiff + spec_.damper_nspm));
}

Eigen::Vector3d WheelJoint::Axis() const {
  if (!hinge2_) return Turned(trunk_, Eigen::Vector3d::UnitY());
  dVector3 axis;
  dJointGetHinge2Axis2(joint_, axis);
  return -ToEigen(axis);
}

JointReading WheelJoint::Reading() const {
  JointReading reading;
  if (!hinge2_) {
    reading.angle_rad = dJointGetHingeAngle(joint_);
    reading.rate_radps = dJointGetHingeAngleRate(joint_);
    reading.effort_nm = ToEigen(feedback_.t1).dot(Axis());
  } else {
    // ODE measures this angle against the sense of its rate.
    reading.angle_rad = -dJointGetHinge2Angle2(joint_);
    reading.rate_radps = dJointGetHinge2Angle2Rate(joint_);
    reading.effort_nm = ToEigen(feedback_.t2).dot(Axis());
  }
  return reading;
}

JointReading WheelJoint::Steering() const {
  JointReading reading;
  if (!hinge2_ || spec_.max_steering_rad <= 0.0) return reading;
  reading.angle_rad = dJointGetHinge2Angle1(joint_);
  reading.rate_radps = dJointGetHinge2Angle1Rate(joint_);
  reading.effort_nm = ToEigen(feedback_.t2).dot(Turned(trunk_, Eigen::Vector3d::UnitZ()));
  return reading;
}

}  // namespace latticeworld
