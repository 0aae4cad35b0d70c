#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_

#include <ode/ode.h>

#include <array>
#include <chrono>
#include <memory>
#include <set>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/simulation/ode/asset_window.h"
#include "latticeworld/simulation/ode/body_sweep.h"
#include "latticeworld/simulation/ode/contact_joints.h"
#include "latticeworld/simulation/ode/ground_contact.h"
#include "latticeworld/simulation/ode/ode_body.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

inline constexpr double kObstacleFriction = 0.3;  // of bodies beside trunks, walls and each other

// ode_world.cc has what callers ask for, ode_world_state.cc how it is kept, ode_world_step.cc how a
// step goes, and ode_world_ground.cc, ode_world_assets.cc and ode_world_bodies.cc how it finds
// contacts.
class OdeWorld : public PhysicsWorld {
 public:
  explicit OdeWorld(std::shared_ptr<const Scene> scene);
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

  std::chrono::nanoseconds collision_time() const { return collision_time_; }

 private:
  struct Entry {
    BodyId id;
    std::unique_ptr<OdeBody> body;
    AssetWindow window;
  };
  // One side of a contact.
  struct Side {
    OdeBody* body;
    std::size_t part;
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

  // One step of ODE for what is awake: bodies with links or brakes on, and what they touch, with
  // more iterations than others.
  void Solve(double step_s, std::uint64_t solver_seed);
  // Finds the bodies to which a step gave more energy than anything that acted on them, and slows
  // them down to what can have been given.
  void WatchEnergy(double step_s);
  // Notes what touches what, and the joints that keep it apart.
  void FindContacts(double step_s);
  void TouchBodies();
  void TouchPair(OdeBody* a, OdeBody* b);
  void TouchDeck(OdeBody* body, OdeBody* deck);
  static void WakeEachOther(OdeBody* a, OdeBody* b);
  void TouchGroundOf(OdeBody* body, double step_s);
  void TouchGroundWithWheels(OdeBody* body, double step_s);
  void TouchGroundWithSamples(OdeBody* body);
  void TouchAssetsOf(Entry* entry);
  void TouchBoundaryOf(OdeBody* body, double step_s);
  void AddGroundContact(OdeBody* body, dBodyID part, const GroundContact& touch,
                        const Traction& traction);
  // Whether an anchored body or asset gives way.
  bool GivesWay(const Contact& contact) const;
  void PushBodies(Side a, Side b, const dContactGeom& geom);
  void PushAsset(Side side, const NearAsset& asset, const dContactGeom& geom);
  Traction GroundTraction(const OdeBody& body, const Eigen::Vector3d& at,
                          const Eigen::Vector3d& normal, bool walks) const;
  Traction SolidTraction(const Side& side, const Eigen::Vector3d& normal) const;

  std::shared_ptr<const Scene> scene_;
  dWorldID world_ = nullptr;
  std::unique_ptr<ContactJoints> joints_;
  GroundState ground_;
  SurfaceTable surfaces_;  // under that state
  // Friction by SurfaceClass when a change of it last woke the bodies up.
  std::array<double, kSurfaceClassCount> woken_friction_{};
  std::set<std::uint32_t> gone_assets_;
  ContactJudge* judge_ = nullptr;
  BodyId last_id_ = 0;
  std::vector<Entry> bodies_;  // by id
  std::vector<Contact> contacts_;
  std::vector<BodyId> strayed_;
  std::vector<BodyId> slowed_;  // by WatchEnergy in the last step
  std::chrono::nanoseconds collision_time_{};

  std::vector<double> gained_j_;  // by place in bodies_, in the step at hand
  std::vector<char> overdrawn_;   // by place in bodies_, in the step at hand
  std::vector<char> fine_;    // by place in bodies_: 1 solved with more iterations, 2 by the rest
  BodySweep<OdeBody> sweep_;  // of bodies with solids
  SolidContacts touch_;       // of the pair at hand
  struct SampleTouch {
    GroundContact contact;
    dBodyID part;
    bool walks;
  };
  std::vector<SampleTouch> sample_touch_;    // of the body at hand
  std::vector<GroundContacts> wheel_touch_;  // of the body at hand
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_IMPL_H_
