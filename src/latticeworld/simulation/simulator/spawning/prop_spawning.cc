#include "latticeworld/simulation/simulator/spawning/prop_spawning.h"

#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/simulator/spawning/spawn_names.h"
#include "latticeworld/simulation/simulator/spawning/spawn_places.h"

namespace latticeworld {
namespace {

// FAILED_PRECONDITION when an agent on the ground or a tree that lies or falls is in its way.
Status CheckFree(const Prop& prop, const RunningWorld& world) {
  const Footprint footprint = FootprintOf(prop);
  const auto taken_by = [&prop](const std::string& what) {
    return FailedPrecondition(TextOf({prop.position.x_m, prop.position.y_m}) + " is taken by " +
                              what);
  };
  for (const auto& [id, agent] : world.agents.all()) {
    if (agent.species->plan == BodyPlan::kFlyer) continue;
    if (GapTo(footprint, agent.place()) <= agent.species->radius_m) return taken_by(agent.name);
  }
  for (const Footprint& stem : world.dynamic_scene.felling().Obstacles()) {
    if (GapBetween(footprint, stem) <= 0.0) return taken_by("a tree that lies or falls");
  }
  return Status();
}

}  // namespace

Result<std::string> AddProp(const Prop& prop, RunningWorld* world) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal element", ValidateSpawn(prop)));
  if (!prop.name.empty()) LW_RETURN_IF_ERROR(CheckNewName(prop.name, *world));
  LW_RETURN_IF_ERROR(CheckFree(prop, *world));
  Prop named = prop;
  if (named.name.empty()) named.name = NewNameFor(std::string(NameOf(prop.kind)), *world);
  DynamicScene& scene = world->dynamic_scene;
  const Result<std::string> name = scene.props().Add(named, world->map.changes());
  if (!name.ok()) return name;
  const BodyId body = scene.props().state().at(*name).body;
  world->events.Tell(EventKind::kSpawned, *name, "", scene.physics().MotionOf(body).position_m);
  world->map.NewVersion();
  world->map.List(scene);
  return name;
}

Status EraseProp(const std::string& name, RunningWorld* world) {
  DynamicScene& scene = world->dynamic_scene;
  const auto running = scene.props().state().find(name);
  if (running == scene.props().state().end()) {
    return NoneNamed("element", name, scene.props().state());
  }
  const Eigen::Vector3d position_m = scene.physics().MotionOf(running->second.body).position_m;
  LW_RETURN_IF_ERROR(scene.props().Remove(name));
  world->events.Tell(EventKind::kRemoved, name, "", position_m);
  world->map.NewVersion();
  world->map.List(scene);
  return Status();
}

}  // namespace latticeworld
