#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_BODY_CONTROL_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_BODY_CONTROL_H_

#include <Eigen/Core>
#include <vector>

#include "latticeworld/simulation/ode/body/part_state.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

struct WheelCommand {
  double rate_radps = 0.0;
  double steer_rad = 0.0;
};

// What a body was told and what else of it changes, besides the state of its parts.
struct BodyControl {
  Eigen::Vector3d walk_velocity_mps = Eigen::Vector3d::Zero();
  std::vector<WheelCommand> wheels;
  std::vector<JointTarget> joints;
  double still_s = 0.0;
  double overdrawn_s = 0.0;  // time of steps that gave it energy from nowhere, less that of others
  bool resting = false;
  bool upright = false;
  bool anchored = false;
  bool spoiled = false;        // was given numbers that are not finite, or too large to add up
  PartState anchor_pose = {};  // of the trunk when it was anchored; pose alone

  // It has wheels and none of them is to turn.
  bool Brakes() const {
    for (const WheelCommand& wheel : wheels) {
      if (wheel.rate_radps != 0.0) return false;
    }
    return !wheels.empty();
  }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_BODY_CONTROL_H_
