#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_WHEEL_JOINT_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_WHEEL_JOINT_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <memory>

#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// What holds and drives a wheel: a hinge, or, where it is sprung or steered, ODE's Hinge2, whose
// first axis is the trunk's upright one.
class WheelJoint {
 public:
  // The trunk stands with base_link at the origin and the wheel at its center_m, both unturned.
  // load_n: that the spring carries at rest; it is preloaded by so much, so that the wheel then
  // stands at center_m.
  WheelJoint(dWorldID world, const WheelSpec& spec, double load_n, dBodyID trunk, dBodyID wheel);
  ~WheelJoint();
  WheelJoint(const WheelJoint&) = delete;
  WheelJoint& operator=(const WheelJoint&) = delete;

  // Sets motor, steering and spring for the next step. deflection_m: of the wheel from its place,
  // upwards.
  void Drive(double rate_radps, double steer_rad, double step_s, double deflection_m);

  Eigen::Vector3d Axis() const;  // unit, map frame, to the left
  // These tell about the last step; effort is what the motor exerts about the axle, by the joint's
  // feedback.
  JointReading Reading() const;
  JointReading Steering() const;

  // What the joint exerted in the last step; a snapshot has it.
  dJointFeedback* feedback() { return &feedback_; }

 private:
  const WheelSpec& spec_;
  const bool hinge2_;
  dJointID joint_ = nullptr;
  dBodyID trunk_;
  dBodyID wheel_;
  double sag_m_ = 0.0;
  dJointFeedback feedback_ = {};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_WHEEL_JOINT_H_
