#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_ANCHOR_HINGE_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_ANCHOR_HINGE_H_

#include <ode/ode.h>

#include <Eigen/Core>

#include "latticeworld/simulation/body_spec.h"

namespace latticeworld {

// The upright hinge on which an anchored trunk turns in the world. At first it holds nothing.
class AnchorHinge {
 public:
  AnchorHinge(dWorldID world, const AnchorSpec& spec, dBodyID trunk);
  ~AnchorHinge();
  AnchorHinge(const AnchorHinge&) = delete;
  AnchorHinge& operator=(const AnchorHinge&) = delete;

  // Holds the trunk from where it is, which is angle 0. pivot_m: a point of the axis, map frame.
  void HoldAt(const Eigen::Vector3d& pivot_m);
  void Release();
  double Angle() const;  // [rad]

 private:
  dJointID joint_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_ANCHOR_HINGE_H_
