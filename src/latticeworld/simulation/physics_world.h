#ifndef LATTICEWORLD_SIMULATION_PHYSICS_WORLD_H_
#define LATTICEWORLD_SIMULATION_PHYSICS_WORLD_H_

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/simulation/body_spec.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

class Digest;

using BodyId = std::uint32_t;  // never used twice by one world; 0 is no body

// map_from_base and its velocities, all in the map frame.
struct BodyMotion {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d linear_velocity_mps = Eigen::Vector3d::Zero();  // of the origin of base_link
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();

  double yaw_rad() const {
    const Eigen::Vector3d forward = orientation * Eigen::Vector3d::UnitX();
    return std::atan2(forward.y(), forward.x());
  }
};

enum class ContactKind : std::uint8_t { kGround, kAsset, kBody, kBoundary };

struct Contact {
  BodyId body = 0;
  ContactKind kind = ContactKind::kGround;
  std::uint32_t other = 0;  // kAsset: index of the asset; kBody: BodyId; else 0
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, into `body`
  double depth_m = 0.0;
  double approach_mps = 0.0;  // speed at which the two come together, >= 0
  // What the contact exerted on `body` in the step, map frame [N]. Zero before the solver ran; not
  // measured for kGround and kBoundary, where it stays zero.
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
};

enum class JointMode : std::uint8_t { kFree, kPosition, kVelocity, kEffort };
struct JointTarget {
  JointMode mode = JointMode::kFree;
  double value = 0.0;  // [rad], [rad/s] or [N m], by mode; beyond the joint's limits it is clamped
};
struct JointReading {
  double angle_rad = 0.0;
  double rate_radps = 0.0;
  double effort_nm = 0.0;  // of its motor in the last step
};

// Decides about what a body hits while a step looks for contacts.
class ContactJudge {
 public:
  virtual ~ContactJudge() = default;
  // True: what was hit (an asset, or an anchored body) gives way and holds nothing up in this step.
  // Called in the order in which contacts are listed, for those that approach faster than
  // 0.05 m/s; force_n is zero. It may look at the contact's bodies, which the step has not moved
  // yet, and at no others, and changes nothing of the world.
  virtual bool GivesWay(const Contact& contact) = 0;
};

// A world's whole state, to go back to. Opaque: of the back end that made it.
class PhysicsSnapshot {
 public:
  virtual ~PhysicsSnapshot() = default;
};

// Rigid bodies over the ground and among the solid assets of one scene. Same calls, same motions,
// bit for bit, on the same build, whatever other worlds do in the process; also after Restore.
class PhysicsWorld {
 public:
  virtual ~PhysicsWorld() = default;

  // Puts base_link at that place and heading: wheeled bodies lean with the ground, and no sample,
  // wheel or foot begins below it.
  virtual BodyId Add(const BodySpec& spec, const Eigen::Vector3d& position_m, double yaw_rad) = 0;
  // Exactly there, moving so.
  virtual BodyId Add(const BodySpec& spec, const BodyMotion& motion) = 0;
  virtual void Remove(BodyId body) = 0;
  virtual const BodySpec& SpecOf(BodyId body) const = 0;

  // What the feet of a body (its ground samples) push towards until told otherwise, map frame.
  // Traction is limited by friction. Zero: it stands and holds.
  virtual void SetWalkVelocity(BodyId body, const Eigen::Vector3d& velocity_mps) = 0;
  // Rate that the motor of a driven wheel drives it towards [rad/s] within its torque, and the
  // angle to which a steered one turns (left positive) [rad], until told otherwise.
  virtual void SetWheel(BodyId body, std::size_t wheel, double rate_radps, double steer_rad) = 0;
  virtual JointReading WheelOf(BodyId body, std::size_t wheel) const = 0;
  // Returns the angle and rate of a wheel's steering (left positive); all zero if it is not
  // steered.
  virtual JointReading SteeringOf(BodyId body, std::size_t wheel) const = 0;
  // Sets what a joint strives for; it holds until the next call.
  virtual void SetJoint(BodyId body, std::size_t link, const JointTarget& target) = 0;
  virtual JointReading JointOf(BodyId body, std::size_t link) const = 0;
  // Pose of a link's frame (BodySpec) in the map.
  virtual BodyMotion LinkMotionOf(BodyId body, std::size_t link) const = 0;
  // Act during the next step, map frame [N], [N m]: at the centre of mass of the trunk, or at a
  // point of it.
  virtual void AddForce(BodyId body, const Eigen::Vector3d& force_n) = 0;
  virtual void AddForceAt(BodyId body, const Eigen::Vector3d& force_n,
                          const Eigen::Vector3d& point_m) = 0;
  virtual void AddTorque(BodyId body, const Eigen::Vector3d& torque_nm) = 0;
  // Changes the body's momentum at once, at a point of the trunk [N s].
  virtual void AddImpulse(BodyId body, const Eigen::Vector3d& impulse_ns,
                          const Eigen::Vector3d& point_m) = 0;

  // upright: it never pitches or rolls, as BodySpec::upright says at first. Made upright, it stands
  // straight where its base is, heading as it did.
  virtual void SetUpright(BodyId body, bool upright) = 0;
  virtual bool IsUpright(BodyId body) const = 0;
  // An anchored body comes loose, or is held again where it is.
  virtual void SetAnchored(BodyId body, bool anchored) = 0;
  virtual bool IsAnchored(BodyId body) const = 0;
  // kHinge anchors: torque about the hinge towards opening, and the angle that it has [rad].
  virtual double AnchorAngleOf(BodyId body) const = 0;

  // Whether an asset is there at all: one that fell or went has no collider. At first all are.
  virtual void SetAssetPresent(std::uint32_t asset, bool present) = 0;
  // What weather has made of the ground from the next step on; at first it is the scene's. Bodies
  // that rest wake up when their hold on the ground changes.
  virtual void SetGround(const GroundState& ground) = 0;
  // judge: outlives the world or is taken away; nullptr: nothing gives way.
  virtual void SetJudge(ContactJudge* judge) = 0;

  // Moves a body as a whole; wheels and links keep their places on it.
  virtual void Place(BodyId body, const BodyMotion& motion) = 0;
  virtual BodyMotion MotionOf(BodyId body) const = 0;
  // Deepest that any wheel, foot or sample of the body is below the ground [m], 0 where none is.
  virtual double SinkageOf(BodyId body) const = 0;
  virtual bool IsResting(BodyId body) const = 0;
  // Kinetic and potential energy of the body, wheels and links included, above z = 0 [J].
  virtual double EnergyOf(BodyId body) const = 0;

  // solver_seed: of the solver's order of constraints.
  virtual void Step(double step_s, std::uint64_t solver_seed) = 0;
  // Returns the contacts of the last step, in the order in which they were found.
  virtual const std::vector<Contact>& contacts() const = 0;
  // Bodies that met numbers not finite in the last step, a part of which became 30 m/s faster than
  // forces explain, or that go on gaining energy; each is back where it was, at rest. Increasing.
  virtual const std::vector<BodyId>& strayed() const = 0;
  // Bodies that gained more energy in the last step than can have been given to them, and were
  // slowed down to what can; increasing. Empty right after Restore.
  virtual const std::vector<BodyId>& slowed() const = 0;

  virtual std::shared_ptr<const PhysicsSnapshot> Save() const = 0;
  // snapshot: of a world of the same back end over the same scene.
  virtual void Restore(const PhysicsSnapshot& snapshot) = 0;
  // All that the future of the bodies depends on.
  virtual void AddTo(Digest* digest) const = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PHYSICS_WORLD_H_
