#include "latticeworld/simulation/ode/body/anchor_hinge.h"

namespace latticeworld {

AnchorHinge::AnchorHinge(dWorldID world, const AnchorSpec& spec, dBodyID trunk)
    : joint_(dJointCreateHinge(world, nullptr)) {
  dJointAttach(joint_, trunk, nullptr);
  // ODE refuses a stop that lies beyond the other one.
  dJointSetHingeParam(joint_, dParamHiStop, spec.high_rad);
  dJointSetHingeParam(joint_, dParamLoStop, spec.low_rad);
  dJointSetHingeParam(joint_, dParamHiStop, spec.high_rad);
  dJointSetHingeParam(joint_, dParamFMax, spec.friction_nm);
  dJointDisable(joint_);
}

AnchorHinge::~AnchorHinge() { dJointDestroy(joint_); }

void AnchorHinge::HoldAt(const Eigen::Vector3d& pivot_m) {
  dJointSetHingeAnchor(joint_, pivot_m.x(), pivot_m.y(), pivot_m.z());
  dJointSetHingeAxis(joint_, 0.0, 0.0, 1.0);
  dJointEnable(joint_);
}

void AnchorHinge::Release() { dJointDisable(joint_); }

double AnchorHinge::Angle() const { return dJointGetHingeAngle(joint_); }

}  // namespace latticeworld
