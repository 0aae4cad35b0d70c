#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_ODE_GROUND_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_ODE_GROUND_H_

#include <Eigen/Core>
#include <array>
#include <memory>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/contacts/ground_contact.h"
#include "latticeworld/simulation/ode/contacts/traction.h"
#include "latticeworld/simulation/ode/island_group.h"

namespace latticeworld {

// The ground of an OdeWorld: what weather has made of it, how deep bodies are in it, and where a
// step finds them on it.
class OdeGround {
 public:
  // Everything of it that changes, to go back to.
  struct State {
    GroundState weathered;
    // Friction by SurfaceClass when a change of it last woke the bodies up.
    std::array<double, kSurfaceClassCount> woken_friction{};
  };

  explicit OdeGround(std::shared_ptr<const Scene> scene);

  // What weather has made of it; true: what rests on it may feel the change and is to wake up.
  bool SetWeathered(const GroundState& weathered);

  // Returns what PhysicsWorld::SinkageOf says.
  double SinkageOf(const OdeBody& body) const;
  // Moves a body straight up, until nothing of it is below the ground.
  void LiftOut(OdeBody* body) const;
  // Notes in its group where wheels, feet and samples of a body touch the ground.
  void Touch(OdeBody* body, double step_s, IslandGroup* group) const;

  const State& state() const { return state_; }
  void Restore(const State& state);
  void AddTo(Digest* digest) const;

 private:
  const HeightField& heights() const { return scene_->terrain->ground; }
  const SurfaceProperties& SurfaceAt(const Eigen::Vector3d& at) const;
  void TouchWithWheels(OdeBody* body, double step_s, IslandGroup* group) const;
  void TouchWithSamples(OdeBody* body, IslandGroup* group) const;
  Traction SampleTraction(const OdeBody& body, const GroundContact& contact, bool walks) const;

  std::shared_ptr<const Scene> scene_;
  State state_;
  SurfaceTable surfaces_;  // under that state
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_ODE_GROUND_H_
