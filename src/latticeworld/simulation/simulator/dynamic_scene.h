#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_DYNAMIC_SCENE_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_DYNAMIC_SCENE_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/props/felling.h"
#include "latticeworld/simulation/props/props.h"
#include "latticeworld/simulation/simulator/event_log.h"

namespace latticeworld {

// The part of a scene that moves: its props, the trees that fall, and the physics world that moves
// them and the bodies of agents. It decides for the physics what gives way to a blow.
class DynamicScene : private ContactJudge {
 public:
  // It holds nothing until Begin. physics_threads: see SimulatorOptions.
  DynamicScene(std::shared_ptr<const Scene> scene, int physics_threads);
  DynamicScene(const DynamicScene&) = delete;
  DynamicScene& operator=(const DynamicScene&) = delete;

  // Makes a new physics world, with props, trees and bridges as the scene has them and without
  // agents.
  void Begin();

  PhysicsWorld& physics() { return *physics_; }
  const PhysicsWorld& physics() const { return *physics_; }
  Props& props() { return *props_; }
  const Props& props() const { return *props_; }
  Felling& felling() { return *felling_; }
  const Felling& felling() const { return *felling_; }
  // The name of the prop or felled tree ("tree_7") that the body is of; "": of neither.
  std::string NameOf(BodyId body) const;

  // Exerts, before the physics' step, what acts on props and trees that fall.
  void Act(const Atmosphere& atmosphere, double step_s);
  // What a step did: whether trees or props are others, and whether maps show it.
  struct Outcome {
    bool changes = false;
    bool maps = false;
  };
  // Sees, after the physics' step, what breaks, falls and comes to rest, and tells it. name_of:
  // names the agent, prop or tree that a body is of.
  Outcome Step(const SimulationClock& clock, const std::function<std::string(BodyId)>& name_of,
               EventLog* events);

  // Plain data, to copy into a snapshot.
  struct State {
    std::shared_ptr<const PhysicsSnapshot> physics;
    Felling::State trees;
    Props::State props;
  };
  State Save() const;
  void Restore(const State& state);
  // Adds all that its future depends on.
  void AddTo(Digest* digest) const;

 private:
  bool GivesWay(const Contact& contact) override;

  const std::shared_ptr<const Scene> scene_;
  const int physics_threads_;
  std::unique_ptr<PhysicsWorld> physics_;
  // Both hold the physics: they go before it goes.
  std::optional<Felling> felling_;
  std::optional<Props> props_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_DYNAMIC_SCENE_H_
