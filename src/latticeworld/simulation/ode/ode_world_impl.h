#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_

#include <ode/ode.h>

#include <array>
#include <chrono>
#include <memory>
#include <set>
#include <vector>

#include "latticeworld/common/work_crew.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/simulation/ode/asset_window.h"
#include "latticeworld/simulation/ode/body_sweep.h"
#include "latticeworld/simulation/ode/contact_joints.h"
#include "latticeworld/simulation/ode/island_group.h"
#include "latticeworld/simulation/ode/ode_body.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

inline constexpr double kObstacleFriction = 0.3;  // of bodies beside trunks, walls and each other
inline constexpr double kJudgedApproach_mps = 0.05;  // from which on the judge is asked

// ode_world.cc has what callers ask for, ode_world_state.cc how it is kept, ode_world_step.cc how a
// step goes, ode_world_groups.cc which bodies are stepped together, and ode_world_ground.cc,
// ode_world_assets.cc and ode_world_bodies.cc how it finds contacts.
class OdeWorld : public PhysicsWorld {
 public:
  OdeWorld(std::shared_ptr<const Scene> scene, int threads);
  ~OdeWorld() override;

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
  const std::vector<Contact>& contacts() const override { return contacts_; }
  const std::vector<BodyId>& strayed() const override { return strayed_; }
  const std::vector<BodyId>& slowed() const override { return slowed_; }

  std::shared_ptr<const PhysicsSnapshot> Save() const override;
  void Restore(const PhysicsSnapshot& snapshot) override;
  void AddTo(Digest* digest) const override;

  std::chrono::nanoseconds collision_time() const {
    is_timed_ = true;
    return collision_time_;
  }

 private:
  struct Entry {
    BodyId id;
    std::unique_ptr<OdeBody> body;
    std::size_t group;  // in groups_
    AssetWindow window;
  };

  const HeightField& ground() const { return scene_->terrain->ground; }
  const SurfaceProperties& SurfaceAt(const Eigen::Vector3d& at) const;
  std::size_t IndexOf(BodyId id) const;
  OdeBody& At(BodyId id) const;
  BodyId Place(const BodySpec& spec, const BodyMotion& motion, bool lift);
  void LiftOutOfGround(OdeBody* body) const;
  double Sinkage(const OdeBody& body) const;
  // Wakes what rests and may lean on something within that.
  void WakeNear(const Bounds& bounds);
  void WakeAround(OdeBody* body);

  // Has each group done, several at once where enough moves to be worth it.
  template <typename Do>
  void ForEachGroup(const Do& one);
  // The parts of a step, in their order. Notes which bodies touch each other.
  void TouchBodies();
  // Puts those that touch into one group.
  void Regroup();
  // Lists the members of groups and the joints between them.
  void GatherGroups();
  // Notes what else the members of a group touch, and the joints that keep it apart.
  void FindContacts(IslandGroup* group, double step_s);
  // Asks the judge about what was hit; false: nothing was of which it is to be asked.
  bool AskJudge();
  // Lists what the groups found and did.
  void Collect();

  std::size_t HomeOf(BodyId id) const { return id % groups_.size(); }

  void TouchPair(OdeBody* a, OdeBody* b);
  void TouchDeck(OdeBody* body, OdeBody* deck);
  static void WakeEachOther(OdeBody* a, OdeBody* b);
  void TouchGroundOf(IslandGroup* group, OdeBody* body, double step_s) const;
  void TouchGroundWithWheels(IslandGroup* group, OdeBody* body, double step_s) const;
  void TouchGroundWithSamples(IslandGroup* group, OdeBody* body) const;
  void TouchAssetsOf(IslandGroup* group, Entry* entry) const;
  void TouchBoundaryOf(IslandGroup* group, OdeBody* body, double step_s) const;
  // Whether an anchored body or asset gives way.
  bool GivesWay(const Contact& contact) const;
  void PushBodies(ContactSide a, ContactSide b, const dContactGeom& geom);
  void PushAsset(IslandGroup* group, ContactSide side, const NearAsset& asset,
                 const dContactGeom& geom) const;
  Traction GroundTraction(const OdeBody& body, const Eigen::Vector3d& at,
                          const Eigen::Vector3d& normal, bool walks) const;
  Traction SolidTraction(const ContactSide& side, const Eigen::Vector3d& normal) const;

  std::shared_ptr<const Scene> scene_;
  GroundState ground_;
  SurfaceTable surfaces_;  // under that state
  // Friction by SurfaceClass when a change of it last woke the bodies up.
  std::array<double, kSurfaceClassCount> woken_friction_{};
  std::set<std::uint32_t> gone_assets_;
  ContactJudge* judge_ = nullptr;
  BodyId last_id_ = 0;
  std::vector<std::unique_ptr<IslandGroup>> groups_;
  std::vector<Entry> bodies_;  // by id; in worlds of groups_, which outlive them
  std::vector<Contact> contacts_;
  std::vector<BodyId> strayed_;
  std::vector<BodyId> slowed_;  // in the last step
  using Clock = std::chrono::steady_clock;
  // Virtual machines take up to a microsecond to tell the time: who does not ask does not pay.
  Clock::time_point Now() const { return is_timed_ ? Clock::now() : Clock::time_point(); }

  mutable bool is_timed_ = false;
  std::chrono::nanoseconds collision_time_{};

  const int threads_;
  std::unique_ptr<WorkCrew> crew_;  // null: not needed yet
  bool in_threads_ = false;         // this step
  int steps_since_homing_ = 0;

  BodySweep<OdeBody> sweep_;                 // of bodies with solids
  SolidContacts touch_;                      // of the pair of bodies at hand
  std::vector<ContactJoint> pair_joints_;    // of two bodies, in the step at hand
  std::vector<std::size_t> wanted_, first_;  // by place in bodies_: group, first that it touches
  std::vector<std::size_t> next_;            // by group: the contact to be listed next
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_
