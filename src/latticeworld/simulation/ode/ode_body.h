#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_BODY_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_BODY_H_

#include <ode/ode.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/link_joint.h"
#include "latticeworld/simulation/ode/solid.h"
#include "latticeworld/simulation/ode/wheel_joint.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// The bits of a rigid body of ODE that move.
struct PartState {
  std::array<dReal, 3> position_m;
  std::array<dReal, 4> quaternion;
  std::array<dReal, 12> rotation;
  std::array<dReal, 3> linear_mps, angular_radps;
  std::array<dReal, 3> force_n, torque_nm;  // gathered for the next step
};

inline constexpr double kTrunkSpin_radps = 50.0;  // fastest

struct WheelCommand {
  double rate_radps = 0.0;
  double steer_rad = 0.0;
};

// What a body was told and what else of it changes.
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
};

// Everything of a body that changes, to go back to.
struct BodyState {
  BodyControl control;
  std::vector<PartState> parts;
  std::vector<dJointFeedback> feedback;
};

// One body of a PhysicsWorld: a rigid trunk and, on joints, its wheels and links. Its parts are the
// trunk, then wheels, then links.
class OdeBody {
 public:
  OdeBody(dWorldID world, BodyId id, std::shared_ptr<const BodySpec> spec);
  ~OdeBody();
  OdeBody(const OdeBody&) = delete;
  OdeBody& operator=(const OdeBody&) = delete;
  // Is made anew in that world, as the last of its bodies, between steps: same state, same bits.
  void MoveTo(dWorldID world);

  BodyId id() const { return id_; }
  const BodySpec& spec() const { return *spec_; }
  const std::shared_ptr<const BodySpec>& shared_spec() const { return spec_; }
  std::size_t part_count() const { return parts_.size(); }
  dBodyID part(std::size_t i) const { return parts_[i]; }
  dBodyID trunk() const { return parts_[0]; }
  // Indices are checked: callers of PhysicsWorld give them.
  dBodyID wheel(std::size_t i) const { return parts_[1 + WheelIndex(i)]; }
  dBodyID link(std::size_t i) const { return parts_[1 + wheels_.size() + LinkIndex(i)]; }
  std::size_t wheel_count() const { return wheels_.size(); }
  std::size_t link_count() const { return links_.size(); }
  double mass_kg() const { return mass_kg_; }  // with wheels and links

  BodyMotion Motion() const;
  // Moves it as a whole.
  void SetMotion(const BodyMotion& motion);
  BodyMotion LinkMotion(std::size_t i) const;
  // A point of base_link, or of a link given where it is with all joints at 0, in the map.
  Eigen::Vector3d TrunkPoint(const Eigen::Vector3d& in_base_m) const;
  Eigen::Vector3d LinkPoint(std::size_t i, const Eigen::Vector3d& in_base_m) const;
  Eigen::Vector3d WheelAxis(std::size_t i) const { return wheels_[WheelIndex(i)]->Axis(); }
  JointReading WheelReading(std::size_t i) const { return wheels_[WheelIndex(i)]->Reading(); }
  JointReading SteeringReading(std::size_t i) const { return wheels_[WheelIndex(i)]->Steering(); }
  JointReading LinkReading(std::size_t i) const { return links_[LinkIndex(i)]->Reading(); }
  double AnchorAngle() const;

  const BodyControl& control() const { return control_; }
  void SetWalkVelocity(const Eigen::Vector3d& velocity_mps);
  void SetWheel(std::size_t i, const WheelCommand& command);
  void SetJoint(std::size_t i, const JointTarget& target);
  void SetUpright(bool upright);
  void SetAnchored(bool anchored);
  void AddImpulse(const Eigen::Vector3d& impulse_ns, const Eigen::Vector3d& point_m);
  // Whether a force at a point may be added: it is finite, not zero, and the body is not held fast.
  // Wakes the body.
  bool TakesForce(const Eigen::Vector3d& force_n, const Eigen::Vector3d& point_m);
  double Energy() const;  // as PhysicsWorld::EnergyOf
  // The watch over energy, between BeginStep and FinishStep. What the step gave to it beyond the
  // work of gravity and of the forces that were added [J]; negative: what it lost to others, to
  // friction and to shocks.
  double EnergyGained(double step_s) const;
  // The most that its motors and springs can have given in a step [J].
  double EnergyOfMotors(double step_s) const;
  // The most that pushing it out of what it is in, and walking, can have given in a step [J].
  double EnergyOfCorrection() const;
  // Slows all of it down until it has that much less energy of motion, or none. Again and again:
  // FinishStep puts it back.
  void TakeEnergy(double energy_j);
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
  // It has wheels and none of them is to turn.
  bool Brakes() const;
  // Nothing is wanted of it and it hardly moves.
  bool still() const;
  void Wake();

  // Solids in the order of shapes, then wheels; part of each. Posed where the body is.
  struct BodySolid {
    Solid solid;
    std::size_t part;
  };
  std::vector<BodySolid>& PosedSolids();
  // Ball around all solids and ground samples; radius < 0: there are no solids.
  const Eigen::Vector3d& BallCenter() const { return ball_in_map_m_; }
  double ball_radius_m() const { return ball_radius_m_; }
  // For whoever counts contacts of bodies, and leaves 0 behind.
  int* contact_count() { return &contact_count_; }

  // Around a step: motors, springs and what to go back to before it; then, after it, speed limits
  // and rest. FinishStep: false when the body strayed (and was put back).
  void BeginStep(double step_s);
  bool FinishStep(double step_s);

  BodyState Save() const;
  void Restore(const BodyState& state);
  void AddTo(Digest* digest) const;

 private:
  // Its parts and joints in a world of ODE, as they begin.
  void Make(dWorldID world);
  void Unmake();
  void MakeSolids();
  void MakeBall();
  void SetInertia();
  void SetEnabled(bool enabled);
  void Anchor();
  void KeepUpright();
  std::size_t WheelIndex(std::size_t i) const {
    LW_CHECK(i < wheels_.size(), "no such wheel");
    return i;
  }
  std::size_t LinkIndex(std::size_t i) const {
    LW_CHECK(i < links_.size(), "no such link");
    return i;
  }
  // About the trunk's axes, as SetInertia has it.
  Eigen::Vector3d TrunkInertia() const;
  double PartMass(std::size_t i) const;
  Eigen::Vector3d PartInertia(std::size_t i) const;  // about its own axes
  void KeepForEnergy();
  bool IsArriving(std::size_t link) const;
  // Keeps forces within what may come of them; stops a body whose forces or speeds are not finite.
  void LimitForces(double step_s);
  void LimitSpeed();
  double FastestPart() const;
  void PutBack();
  void UpdateRest(double step_s);
  // Is called whenever the trunk or another part is elsewhere.
  void Moved() {
    posed_ = false;
    ball_in_map_m_ = TrunkPoint(ball_center_m_);
  }

  const BodyId id_;
  std::shared_ptr<const BodySpec> spec_;
  double mass_kg_ = 0.0;
  std::vector<dBodyID> parts_;
  std::vector<std::unique_ptr<WheelJoint>> wheels_;
  std::vector<std::unique_ptr<LinkJoint>> links_;
  dJointID anchor_ = nullptr;  // kHinge
  BodyControl control_;

  std::vector<BodySolid> solids_;
  int contact_count_ = 0;
  bool posed_ = false;
  Eigen::Vector3d ball_center_m_ = Eigen::Vector3d::Zero();  // in base_link
  Eigen::Vector3d ball_in_map_m_ = Eigen::Vector3d::Zero();  // where that is: asked of all at once
  double ball_radius_m_ = -1.0;

  struct Before {
    std::array<dReal, 3> position_m;
    std::array<dReal, 4> quaternion;
    Eigen::Vector3d velocity_mps, spin_radps;
  };
  std::vector<Before> before_;                                // of the parts, before the step
  Eigen::Vector3d force_before_n_ = Eigen::Vector3d::Zero();  // on the trunk, with the torque
  Eigen::Vector3d torque_before_nm_ = Eigen::Vector3d::Zero();
  bool overdrawn_ = false;           // TakeEnergy was called in the step at hand
  double fastest_before_mps_ = 0.0;  // may grow by what forces give
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_BODY_H_
