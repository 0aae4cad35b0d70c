#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_PART_STATE_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_PART_STATE_H_

#include <ode/ode.h>

#include <array>

namespace latticeworld {

class Digest;

// The bits of a rigid body of ODE that move.
struct PartState {
  std::array<dReal, 3> position_m;
  std::array<dReal, 4> quaternion;
  std::array<dReal, 12> rotation;
  std::array<dReal, 3> linear_mps, angular_radps;
  std::array<dReal, 3> force_n, torque_nm;  // gathered for the next step
};

PartState StateOf(dBodyID part);

// Give a part the state, or the pose of it alone, bit for bit.
void SetState(dBodyID part, const PartState& state);
void SetPoseBits(dBodyID part, const PartState& state);

void AddState(const PartState& state, Digest* digest);
void AddPose(const PartState& state, Digest* digest);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_PART_STATE_H_
