#include "latticeworld/simulation/ode/body/link_joint.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr double kPositionGain = 0.3;  // share of the error that a step undoes

}  // namespace

LinkJoint::LinkJoint(dWorldID world, const LinkSpec& spec, dBodyID parent, dBodyID link)
    : spec_(spec), joint_(dJointCreateHinge(world, nullptr)), link_(link) {
  dJointAttach(joint_, link, parent);
  dJointSetHingeAnchor(joint_, spec.anchor_m.x(), spec.anchor_m.y(), spec.anchor_m.z());
  dJointSetHingeAxis(joint_, spec.axis.x(), spec.axis.y(), spec.axis.z());
  // ODE refuses a stop that lies beyond the other one.
  dJointSetHingeParam(joint_, dParamHiStop, spec.high_rad);
  dJointSetHingeParam(joint_, dParamLoStop, spec.low_rad);
  dJointSetHingeParam(joint_, dParamHiStop, spec.high_rad);
  dJointSetFeedback(joint_, &feedback_);
}

LinkJoint::~LinkJoint() { dJointDestroy(joint_); }

void LinkJoint::Drive(const JointTarget& target, double step_s) {
  const double max_nm = spec_.max_effort_nm, max_radps = spec_.max_rate_radps;
  double effort_nm = 0.0, rate_radps = 0.0;
  switch (target.mode) {
    case JointMode::kFree:
      break;
    case JointMode::kPosition: {
      const double wanted_rad = std::clamp(target.value, spec_.low_rad, spec_.high_rad);
      const double error_rad = wanted_rad - dJointGetHingeAngle(joint_);
      rate_radps = std::clamp(kPositionGain * error_rad / step_s, -max_radps, max_radps);
      effort_nm = max_nm;
      break;
    }
    case JointMode::kVelocity:
      rate_radps = std::clamp(target.value, -max_radps, max_radps);
      effort_nm = max_nm;
      break;
    case JointMode::kEffort:
      // Exerts all of it until the joint turns as fast as it may.
      rate_radps = std::copysign(max_radps, target.value);
      effort_nm = std::min(std::abs(target.value), max_nm);
      break;
  }
  dJointSetHingeParam(joint_, dParamVel, rate_radps);
  dJointSetHingeParam(joint_, dParamFMax, effort_nm);
}

JointReading LinkJoint::Reading() const {
  JointReading reading;
  reading.angle_rad = dJointGetHingeAngle(joint_);
  reading.rate_radps = dJointGetHingeAngleRate(joint_);
  dVector3 axis, anchor;
  dJointGetHingeAxis(joint_, axis);
  dJointGetHingeAnchor(joint_, anchor);
  // Feedback is about the link's centre of mass.
  const Eigen::Vector3d arm = PositionOf(link_) - ToEigen(anchor);
  const Eigen::Vector3d about_anchor = ToEigen(feedback_.t1) + arm.cross(ToEigen(feedback_.f1));
  reading.effort_nm = about_anchor.dot(ToEigen(axis));
  return reading;
}

}  // namespace latticeworld
