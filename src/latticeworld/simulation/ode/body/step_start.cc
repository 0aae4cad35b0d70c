#include "latticeworld/simulation/ode/body/step_start.h"

#include <algorithm>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {

void StepStart::KeepPoses() {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    std::copy_n(dBodyGetPosition(of_.part(i)), 3, parts_[i].position_m.begin());
    std::copy_n(dBodyGetQuaternion(of_.part(i)), 4, parts_[i].quaternion.begin());
  }
}

void StepStart::KeepMotion() {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].velocity_mps = ToEigen(dBodyGetLinearVel(of_.part(i)));
    parts_[i].spin_radps = ToEigen(dBodyGetAngularVel(of_.part(i)));
  }
  force_n_ = ToEigen(dBodyGetForce(of_.trunk()));
  torque_nm_ = ToEigen(dBodyGetTorque(of_.trunk()));
}

void StepStart::GoBack() const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const dBodyID part = of_.part(i);
    const Part& then = parts_[i];
    dBodySetPosition(part, then.position_m[0], then.position_m[1], then.position_m[2]);
    dBodySetQuaternion(part, then.quaternion.data());
    SetVelocities(part, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    dBodySetForce(part, 0.0, 0.0, 0.0);
    dBodySetTorque(part, 0.0, 0.0, 0.0);
  }
}

}  // namespace latticeworld
