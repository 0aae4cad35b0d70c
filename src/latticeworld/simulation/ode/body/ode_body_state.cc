// How a body is kept, brought back and hashed.

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/body/ode_body.h"

namespace latticeworld {
namespace {

void AddControl(const BodyControl& control, Digest* digest) {
  for (int i = 0; i < 3; ++i) digest->Add(control.walk_velocity_mps[i]);
  for (const WheelCommand& wheel : control.wheels) {
    digest->Add(wheel.rate_radps);
    digest->Add(wheel.steer_rad);
  }
  for (const JointTarget& joint : control.joints) {
    digest->Add(joint.mode);
    digest->Add(joint.value);
  }
  digest->Add(control.still_s);
  digest->Add(control.overdrawn_s);
  digest->Add(control.resting);
  digest->Add(control.upright);
  digest->Add(control.anchored);
  digest->Add(control.spoiled);
}

void AddFeedback(const dJointFeedback& feedback, Digest* digest) {
  for (const dReal* v : {feedback.f1, feedback.t1, feedback.f2, feedback.t2}) {
    for (int i = 0; i < 3; ++i) digest->Add(v[i]);
  }
}

}  // namespace

BodyState OdeBody::Save() const {
  BodyState state;
  state.control = control_;
  state.parts.reserve(parts_.all().size());
  for (const dBodyID part : parts_.all()) state.parts.push_back(StateOf(part));
  parts_.ForEachFeedback(
      [&state](dJointFeedback* feedback) { state.feedback.push_back(*feedback); });
  return state;
}

void OdeBody::Restore(const BodyState& state) {
  control_ = state.control;
  parts_.SetUpright(control_.upright);
  if (control_.anchored) {
    SetPoseBits(parts_.trunk(), control_.anchor_pose);
    HoldByHinge();
  } else if (parts_.anchor_hinge() != nullptr) {
    parts_.anchor_hinge()->Release();
  }
  parts_.SetEnabled(!stands());
  for (std::size_t i = 0; i < state.parts.size(); ++i) SetState(parts_.part(i), state.parts[i]);
  std::size_t next = 0;
  parts_.ForEachFeedback([&](dJointFeedback* feedback) { *feedback = state.feedback[next++]; });
  solids_.Moved();
}

void OdeBody::AddTo(Digest* digest) const {
  for (const dBodyID part : parts_.all()) AddState(StateOf(part), digest);
  AddControl(control_, digest);
  parts_.ForEachFeedback(
      [digest](const dJointFeedback* feedback) { AddFeedback(*feedback, digest); });
  if (control_.anchored) AddPose(control_.anchor_pose, digest);
}

}  // namespace latticeworld
