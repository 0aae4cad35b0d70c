#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_LINK_JOINT_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_LINK_JOINT_H_

#include <ode/ode.h>

#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// The motorised hinge between a link and what carries it.
class LinkJoint {
 public:
  // Joins two bodies that both stand unturned, with base_link at the origin.
  LinkJoint(dWorldID world, const LinkSpec& spec, dBodyID parent, dBodyID link);
  ~LinkJoint();
  LinkJoint(const LinkJoint&) = delete;
  LinkJoint& operator=(const LinkJoint&) = delete;

  // Sets the motor for the next step. A position is approached by a share of the error in every
  // step, within the joint's rate and effort; an effort is exerted up to the joint's rate. A free
  // joint has no motor, and turns as fast as it is turned.
  void Drive(const JointTarget& target, double step_s);
  // Effort: what the motor (or the stop) exerts about the axis, by the joint's feedback.
  JointReading Reading() const;

  // What the joint exerted in the last step; a snapshot has it.
  dJointFeedback* feedback() { return &feedback_; }

 private:
  const LinkSpec& spec_;
  dJointID joint_;
  dBodyID link_;
  dJointFeedback feedback_ = {};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_LINK_JOINT_H_
