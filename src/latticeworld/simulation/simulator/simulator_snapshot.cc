#include <map>
#include <memory>
#include <optional>

#include "latticeworld/simulation/simulator/simulator_impl.h"
#include "latticeworld/simulation/simulator/weathering.h"

namespace latticeworld {
namespace {

// Copies of all that the future depends on. What is derived of it (names, bodies, who is where,
// paths) is made again.
struct Snapshot : SimulatorSnapshot {
  std::shared_ptr<const Scene> scene;  // kept: the weather looks at it
  SimulatorOptions options;            // holds the species that the agents point at
  std::uint64_t seed = 0;
  std::uint64_t episode_step = 0;
  std::optional<RunningWeather> weather;  // set in every snapshot, as is the spawner
  std::optional<AgentSpawner> spawner;
  MapState::State map;
  std::map<AgentId, Agent> agents;
  StrayWatch strays;
  TeamPolicies policies;
  DynamicScene::State dynamic_scene;
};

bool AreSame(const SimulatorOptions& a, const SimulatorOptions& b) {
  return a.step_s == b.step_s && a.command_timeout_s == b.command_timeout_s &&
         a.pursuit_distance_m == b.pursuit_distance_m && a.day_length_s == b.day_length_s &&
         a.species == b.species && a.robot_species == b.robot_species;
}

}  // namespace

std::shared_ptr<const SimulatorSnapshot> SimulatorImpl::Save() const {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->scene = world_.scene;
  snapshot->options = world_.options;
  snapshot->seed = world_.seed;
  snapshot->episode_step = world_.clock.episode_step();
  snapshot->weather = world_.weather;
  snapshot->spawner = spawner_;
  snapshot->map = world_.map.Save();
  snapshot->agents = world_.agents.all();
  snapshot->strays = strays_;
  snapshot->policies = policies_;
  snapshot->dynamic_scene = world_.dynamic_scene.Save();
  return snapshot;
}

Status SimulatorImpl::Restore(const SimulatorSnapshot& snapshot) {
  const auto* of = dynamic_cast<const Snapshot*>(&snapshot);
  if (of == nullptr || of->scene != world_.scene) {
    return InvalidArgument("the snapshot is of another world");
  }
  if (!AreSame(of->options, world_.options)) {
    return InvalidArgument("the snapshot is of a simulator with other options");
  }
  world_.seed = of->seed;
  world_.clock.SetEpisodeStep(of->episode_step);
  const Atmosphere before = world_.weather.now();
  world_.weather = *of->weather;
  if (!AreAlike(before, world_.weather.now())) TellWeather(&world_);
  world_.map.Restore(of->map);
  world_.agents.Restore(of->agents);
  world_.dynamic_scene.Restore(of->dynamic_scene);
  world_.map.List(world_.dynamic_scene);
  world_.paths.Update(world_.map.changes());
  spawner_ = *of->spawner;
  strays_ = of->strays;
  policies_ = of->policies;
  state_.reset();
  return Status();
}

}  // namespace latticeworld
