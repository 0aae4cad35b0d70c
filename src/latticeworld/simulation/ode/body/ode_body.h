#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_ODE_BODY_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_ODE_BODY_H_

#include <ode/ode.h>

#include <memory>
#include <vector>

#include "latticeworld/simulation/ode/body/body_control.h"
#include "latticeworld/simulation/ode/body/body_energy.h"
#include "latticeworld/simulation/ode/body/body_parts.h"
#include "latticeworld/simulation/ode/body/body_solids.h"
#include "latticeworld/simulation/ode/body/part_state.h"
#include "latticeworld/simulation/ode/body/step_start.h"
#include "latticeworld/simulation/ode/body/stillness.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// Everything of a body that changes, to go back to.
struct BodyState {
  BodyControl control;
  std::vector<PartState> parts;
  std::vector<dJointFeedback> feedback;
};

// One body of a PhysicsWorld: what it is made of, what it was told, and what becomes of it around a
// step.
class OdeBody {
 public:
  OdeBody(dWorldID world, BodyId id, std::shared_ptr<const BodySpec> spec);
  OdeBody(const OdeBody&) = delete;
  OdeBody& operator=(const OdeBody&) = delete;
  // Is made anew in that world, as the last of its bodies, between steps: same state, same bits.
  void MoveTo(dWorldID world);

  BodyId id() const { return id_; }
  const BodySpec& spec() const { return *spec_; }
  const std::shared_ptr<const BodySpec>& shared_spec() const { return spec_; }
  const BodyParts& parts() const { return parts_; }
  const BodyControl& control() const { return control_; }
  double AnchorAngle() const;

  // Moves it as a whole.
  void SetMotion(const BodyMotion& motion);
  void SetWalkVelocity(const Eigen::Vector3d& velocity_mps);
  void SetWheel(std::size_t i, const WheelCommand& command);
  void SetJoint(std::size_t i, const JointTarget& target);
  void SetUpright(bool upright);
  void SetAnchored(bool anchored);
  void AddImpulse(const Eigen::Vector3d& impulse_ns, const Eigen::Vector3d& point_m);
  // Whether a force at a point may be added: it is finite, not zero, and the body is not held fast.
  // Wakes the body.
  bool TakesForce(const Eigen::Vector3d& force_n, const Eigen::Vector3d& point_m);
  void Spoil() { control_.spoiled = true; }
  // Forgets that it was spoiled; true where it was.
  bool Mend() {
    const bool spoiled = control_.spoiled;
    control_.spoiled = false;
    return spoiled;
  }

  // Neither moves nor is moved in this step: rests, or is held fast.
  bool stands() const { return control_.resting || fixed(); }
  bool resting() const { return control_.resting; }
  bool fixed() const {
    return control_.anchored && (!spec_->anchor || spec_->anchor->kind == AnchorKind::kFixed);
  }
  // Nothing is wanted of it and it hardly moves.
  bool still() const { return fixed() || IsStill(parts_, control_); }
  void Wake();

  const std::vector<BodySolid>& PosedSolids() { return solids_.Posed(); }
  // Ball around all solids and ground samples; radius < 0: there are no solids.
  const Eigen::Vector3d& BallCenter() const { return solids_.BallCenter(); }
  double ball_radius_m() const { return solids_.ball_radius_m(); }
  // Returns a counter for whoever counts contacts of bodies, and leaves 0 behind.
  int* contact_count() { return &contact_count_; }

  // These stand around a step: BeginStep sets motors and springs and notes what to go back to;
  // FinishStep limits speeds and lets the body rest. FinishStep: false when the body strayed (and
  // was put back).
  void BeginStep(double step_s);
  bool FinishStep(double step_s);
  // The watch over energy, between BeginStep and FinishStep. What has energy taken from it again
  // and again, FinishStep puts back.
  const BodyEnergy& energy() const { return energy_; }
  void TakeEnergy(double energy_j) { energy_.Take(energy_j); }

  BodyState Save() const;
  void Restore(const BodyState& state);
  void AddTo(Digest* digest) const;

 private:
  // Has its hinge, where it has one, hold the trunk where it is.
  void HoldByHinge();
  // Lets the body rest after a step when it has been still for long enough.
  void UpdateRest(double step_s);

  const BodyId id_;
  const std::shared_ptr<const BodySpec> spec_;
  BodyParts parts_;
  BodyControl control_;
  BodySolids solids_;
  StepStart start_;
  BodyEnergy energy_;
  int contact_count_ = 0;
  double fastest_before_mps_ = 0.0;  // may grow by what forces give
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_ODE_BODY_H_
