// How a body is kept, brought back and hashed.

#include <cstring>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/ode_body.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

template <typename T, std::size_t kSize>
void Copy(const T* from, std::array<T, kSize>* to) {
  std::memcpy(to->data(), from, sizeof(T) * kSize);
}

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

template <typename T, std::size_t kSize>
void AddAll(Digest* digest, const std::array<T, kSize>& values) {
  digest->AddBytes(values.data(), sizeof(values));
}

}  // namespace

// Holds the trunk where it is.
void OdeBody::Anchor() {
  control_.anchor_pose = StateOf(trunk());
  if (anchor_ == nullptr) return;
  const Eigen::Vector3d pivot = TrunkPoint(spec_->anchor->pivot_m);
  dJointSetHingeAnchor(anchor_, pivot.x(), pivot.y(), pivot.z());
  dJointSetHingeAxis(anchor_, 0.0, 0.0, 1.0);
  dJointEnable(anchor_);
}

BodyState OdeBody::Save() const {
  BodyState state;
  state.control = control_;
  for (const dBodyID part : parts_) state.parts.push_back(StateOf(part));
  for (const auto& joint : wheels_) state.feedback.push_back(*joint->feedback());
  for (const auto& joint : links_) state.feedback.push_back(*joint->feedback());
  return state;
}

void OdeBody::Restore(const BodyState& state) {
  control_ = state.control;
  SetInertia();
  if (control_.anchored) {
    SetPoseBits(trunk(), state.control.anchor_pose);
    Anchor();
    control_.anchor_pose = state.control.anchor_pose;
  } else if (anchor_ != nullptr) {
    dJointDisable(anchor_);
  }
  SetEnabled(!stands());
  for (std::size_t i = 0; i < parts_.size(); ++i) SetState(parts_[i], state.parts[i]);
  std::size_t next = 0;
  for (const auto& joint : wheels_) *joint->feedback() = state.feedback[next++];
  for (const auto& joint : links_) *joint->feedback() = state.feedback[next++];
  Moved();
}

void OdeBody::AddTo(Digest* digest) const {
  for (const dBodyID part : parts_) {
    const PartState state = StateOf(part);
    AddAll(digest, state.position_m);
    AddAll(digest, state.quaternion);
    AddAll(digest, state.linear_mps);
    AddAll(digest, state.angular_radps);
    AddAll(digest, state.force_n);
    AddAll(digest, state.torque_nm);
  }
  for (int i = 0; i < 3; ++i) digest->Add(control_.walk_velocity_mps[i]);
  for (const WheelCommand& wheel : control_.wheels) {
    digest->Add(wheel.rate_radps);
    digest->Add(wheel.steer_rad);
  }
  for (const JointTarget& joint : control_.joints) {
    digest->Add(joint.mode);
    digest->Add(joint.value);
  }
  digest->Add(control_.still_s);
  digest->Add(control_.overdrawn_s);
  digest->Add(control_.resting);
  digest->Add(control_.upright);
  digest->Add(control_.anchored);
  digest->Add(control_.spoiled);
  const auto add_feedback = [digest](const dJointFeedback& feedback) {
    for (const dReal* v : {feedback.f1, feedback.t1, feedback.f2, feedback.t2}) {
      for (int i = 0; i < 3; ++i) digest->Add(v[i]);
    }
  };
  for (const auto& joint : wheels_) add_feedback(*joint->feedback());
  for (const auto& joint : links_) add_feedback(*joint->feedback());
  if (control_.anchored) {
    AddAll(digest, control_.anchor_pose.position_m);
    AddAll(digest, control_.anchor_pose.quaternion);
  }
}

}  // namespace latticeworld
