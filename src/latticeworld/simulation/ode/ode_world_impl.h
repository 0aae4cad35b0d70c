#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_

#include <chrono>
#include <memory>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/ode/contacts/body_pairs.h"
#include "latticeworld/simulation/ode/contacts/ode_assets.h"
#include "latticeworld/simulation/ode/contacts/ode_ground.h"
#include "latticeworld/simulation/ode/island_groups.h"
#include "latticeworld/simulation/ode/ode_bodies.h"
#include "latticeworld/simulation/ode/search_clock.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// ode_world.cc has what callers ask for, ode_world_state.cc how it is kept, and ode_world_step.cc
// how a step goes. OdeBodies has the bodies, IslandGroups which of them are stepped together;
// BodyPairs, OdeGround, OdeAssets and TouchEdge find contacts.
class OdeWorld : public PhysicsWorld {
 public:
  OdeWorld(std::shared_ptr<const Scene> scene, int threads);

  BodyId Add(const BodySpec& spec, const Eigen::Vector3d& position_m, double yaw_rad) override;
  BodyId Add(const BodySpec& spec, const BodyMotion& motion) override;
  void Remove(BodyId body) override;
  const BodySpec& SpecOf(BodyId body) const override;

  void SetWalkVelocity(BodyId body, const Eigen::Vector3d& velocity_mps) override;
  void SetWheel(BodyId body, std::size_t wheel, double rate_radps, double steer_rad) override;
  JointReading WheelOf(BodyId body, std::size_t wheel) const override;
  JointReading SteeringOf(BodyId body, std::size_t wheel) const override;
  void SetJoint(BodyId body, std::size_t link, const JointTarget& target) override;
  JointReading JointOf(BodyId body, std::size_t link) const override;
  BodyMotion LinkMotionOf(BodyId body, std::size_t link) const override;
  void AddForce(BodyId body, const Eigen::Vector3d& force_n) override;
  void AddForceAt(BodyId body, const Eigen::Vector3d& force_n,
                  const Eigen::Vector3d& point_m) override;
  void AddTorque(BodyId body, const Eigen::Vector3d& torque_nm) override;
  void AddImpulse(BodyId body, const Eigen::Vector3d& impulse_ns,
                  const Eigen::Vector3d& point_m) override;

  void SetUpright(BodyId body, bool upright) override;
  bool IsUpright(BodyId body) const override;
  void SetAnchored(BodyId body, bool anchored) override;
  bool IsAnchored(BodyId body) const override;
  double AnchorAngleOf(BodyId body) const override;

  void SetAssetPresent(std::uint32_t asset, bool present) override;
  void SetGround(const GroundState& ground) override;
  void SetJudge(ContactJudge* judge) override { judge_ = judge; }

  void Place(BodyId body, const BodyMotion& motion) override;
  BodyMotion MotionOf(BodyId body) const override;
  double SinkageOf(BodyId body) const override;
  bool IsResting(BodyId body) const override;
  double EnergyOf(BodyId body) const override;

  void Step(double step_s, std::uint64_t solver_seed) override;
  const std::vector<Contact>& contacts() const override { return report_.contacts; }
  const std::vector<BodyId>& strayed() const override { return report_.strayed; }
  const std::vector<BodyId>& slowed() const override { return report_.slowed; }

  std::shared_ptr<const PhysicsSnapshot> Save() const override;
  void Restore(const PhysicsSnapshot& snapshot) override;
  void AddTo(Digest* digest) const override;

  std::chrono::nanoseconds collision_time() const { return clock_.Ask(); }

 private:
  // Notes what else the members of a group touch, and the joints that keep it apart.
  void FindContacts(IslandGroup* group, double step_s);

  std::shared_ptr<const Scene> scene_;
  OdeGround ground_;
  OdeAssets assets_;
  ContactJudge* judge_ = nullptr;
  BodyId last_id_ = 0;
  IslandGroups groups_;
  OdeBodies bodies_;  // in worlds of groups_, which outlive them
  BodyPairs pairs_;
  StepReport report_;  // of the last step
  SearchClock clock_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_
