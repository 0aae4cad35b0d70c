#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {

// Copies of all that the future depends on. What is derived of it (names, bodies, the grid of who
// is where, paths) is made again.
struct SimulatorImpl::Snapshot : SimulatorSnapshot {
  explicit Snapshot(const SimulatorImpl& of)
      : scene(of.scene_),
        options(of.options_),
        seed(of.seed_),
        episode_step(of.episode_step_),
        spawn_random(of.spawn_random_),
        weather(*of.weather_),
        map_version(of.map_version_),
        map_ground(of.map_ground_),
        last_agent(of.last_agent_),
        agents(of.agents_),
        frozen_until(of.frozen_until_),
        strays(of.strays_),
        slowed_until(of.slowed_until_),
        team_policies(of.team_policies_),
        trees(of.felling_->state()),
        props(of.props_->state()),
        physics(of.physics_->Save()) {}

  const std::shared_ptr<const Scene> scene;  // kept: the weather looks at it
  const SimulatorOptions options;            // holds the species that the agents point at
  const std::uint64_t seed, episode_step;
  const RandomStream spawn_random;
  const RunningWeather weather;
  const std::uint64_t map_version;
  const std::optional<GroundState> map_ground;
  const AgentId last_agent;
  const std::map<AgentId, Agent> agents;
  const std::map<AgentId, std::uint64_t> frozen_until;
  const std::map<std::string, Stray> strays;
  const std::map<BodyId, std::uint64_t> slowed_until;
  const std::map<int, std::string> team_policies;
  const Felling::State trees;
  const Props::State props;
  const std::shared_ptr<const PhysicsSnapshot> physics;
};

namespace {

bool AreSame(const SimulatorOptions& a, const SimulatorOptions& b) {
  return a.step_s == b.step_s && a.command_timeout_s == b.command_timeout_s &&
         a.pursuit_distance_m == b.pursuit_distance_m && a.day_length_s == b.day_length_s &&
         a.species == b.species && a.robot_species == b.robot_species;
}

}  // namespace

std::shared_ptr<const SimulatorSnapshot> SimulatorImpl::Save() const {
  return std::make_shared<const Snapshot>(*this);
}

Status SimulatorImpl::Restore(const SimulatorSnapshot& snapshot) {
  const auto* of = dynamic_cast<const Snapshot*>(&snapshot);
  if (of == nullptr || of->scene != scene_) {
    return InvalidArgument("the snapshot is of another world");
  }
  if (!AreSame(of->options, options_)) {
    return InvalidArgument("the snapshot is of a simulator with other options");
  }
  seed_ = of->seed;
  episode_step_ = of->episode_step;
  spawn_random_ = of->spawn_random;
  const Atmosphere before = weather_->now();
  weather_.emplace(of->weather);
  surfaces_.emplace(*scene_, weather_->now().ground());
  if (!AreAlike(before, weather_->now())) {
    TellWeather(std::string(NameOf(weather_->now().weather)));
  }
  map_version_ = of->map_version;
  map_ground_ = of->map_ground;
  last_agent_ = of->last_agent;
  agents_ = of->agents;
  in_order_.clear();
  frozen_until_ = of->frozen_until;
  strays_ = of->strays;
  slowed_until_ = of->slowed_until;
  lost_.clear();
  team_policies_ = of->team_policies;
  ids_.clear();
  agent_of_body_.clear();
  for (const auto& [id, agent] : agents_) {
    ids_[agent.name] = id;
    agent_of_body_[agent.body] = id;
  }
  physics_->Restore(*of->physics);
  felling_->Restore(of->trees);
  props_->Restore(of->props);
  ListChanges();
  paths_.Update(changes_);
  near_ = AgentGrid();
  state_.reset();
  return Status();
}

}  // namespace latticeworld
