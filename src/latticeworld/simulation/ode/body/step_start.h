#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_STEP_START_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_STEP_START_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "latticeworld/simulation/ode/body/body_parts.h"

namespace latticeworld {

// How one body was when a step of it began: to go back to, and to compare with.
class StepStart {
 public:
  struct Part {
    std::array<dReal, 3> position_m;
    std::array<dReal, 4> quaternion;
    Eigen::Vector3d velocity_mps, spin_radps;
  };

  // parts: outlive it.
  explicit StepStart(const BodyParts& parts) : of_(parts), parts_(parts.all().size()) {}
  StepStart(const StepStart&) = delete;
  StepStart& operator=(const StepStart&) = delete;

  // Keeps where the parts are; after it, once forces are known, how they move and what acts on the
  // trunk.
  void KeepPoses();
  void KeepMotion();
  // Puts the parts back there, at rest.
  void GoBack() const;

  const std::vector<Part>& parts() const { return parts_; }
  const Eigen::Vector3d& force_n() const { return force_n_; }  // on the trunk
  const Eigen::Vector3d& torque_nm() const { return torque_nm_; }

 private:
  const BodyParts& of_;
  std::vector<Part> parts_;
  Eigen::Vector3d force_n_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_nm_ = Eigen::Vector3d::Zero();
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_STEP_START_H_
