#include "latticeworld/simulation/ode/body/part_state.h"

#include <cstring>

#include "latticeworld/common/digest.h"

namespace latticeworld {
namespace {

template <typename T, std::size_t kSize>
void Copy(const T* from, std::array<T, kSize>* to) {
  std::memcpy(to->data(), from, sizeof(T) * kSize);
}

template <typename T, std::size_t kSize>
void AddAll(const std::array<T, kSize>& values, Digest* digest) {
  digest->AddBytes(values.data(), sizeof(values));
}

}  // namespace

PartState StateOf(dBodyID part) {
  PartState state;
  Copy(dBodyGetPosition(part), &state.position_m);
  Copy(dBodyGetQuaternion(part), &state.quaternion);
  Copy(dBodyGetRotation(part), &state.rotation);
  Copy(dBodyGetLinearVel(part), &state.linear_mps);
  Copy(dBodyGetAngularVel(part), &state.angular_radps);
  Copy(dBodyGetForce(part), &state.force_n);
  Copy(dBodyGetTorque(part), &state.torque_nm);
  return state;
}

// ODE's setters normalise, which may move the last bit: its own storage takes the bits as they are.
void SetPoseBits(dBodyID part, const PartState& state) {
  dBodySetPosition(part, state.position_m[0], state.position_m[1], state.position_m[2]);
  std::memcpy(const_cast<dReal*>(dBodyGetQuaternion(part)), state.quaternion.data(),
              sizeof(state.quaternion));
  std::memcpy(const_cast<dReal*>(dBodyGetRotation(part)), state.rotation.data(),
              sizeof(state.rotation));
}

void SetState(dBodyID part, const PartState& state) {
  SetPoseBits(part, state);
  const auto& v = state.linear_mps;
  const auto& w = state.angular_radps;
  dBodySetLinearVel(part, v[0], v[1], v[2]);
  dBodySetAngularVel(part, w[0], w[1], w[2]);
  dBodySetForce(part, state.force_n[0], state.force_n[1], state.force_n[2]);
  dBodySetTorque(part, state.torque_nm[0], state.torque_nm[1], state.torque_nm[2]);
}

void AddPose(const PartState& state, Digest* digest) {
  AddAll(state.position_m, digest);
  AddAll(state.quaternion, digest);
}

void AddState(const PartState& state, Digest* digest) {
  AddPose(state, digest);
  AddAll(state.linear_mps, digest);
  AddAll(state.angular_radps, digest);
  AddAll(state.force_n, digest);
  AddAll(state.torque_nm, digest);
}

}  // namespace latticeworld
