#include "latticeworld/simulation/simulator/spawning/agent_spawner.h"

#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/scene/agents/agent_placement.h"
#include "latticeworld/simulation/simulator/spawning/embodiment.h"
#include "latticeworld/simulation/simulator/spawning/spawn_names.h"
#include "latticeworld/simulation/simulator/spawning/spawn_places.h"
#include "latticeworld/simulation/simulator/spawning/spawn_requests.h"

namespace latticeworld {
namespace {

constexpr int kRobotTeam = 1;

// What the request leaves open is what suits the species.
AgentStart StartFor(const SpawnRequest& request, const Species& species, WorldPoint place) {
  AgentStart start;
  start.name = request.name;
  start.category = species.category;
  start.state = request.state.value_or(UsualState(species.category));
  start.team = request.team.value_or(request.controllable ? kRobotTeam : TeamOf(species.category));
  start.controllable = request.controllable;
  start.position = place;
  start.height_above_ground_m = species.altitude_m;
  start.heading_rad = request.heading_rad;
  return start;
}

}  // namespace

void AgentSpawner::SpawnStarts(RunningWorld* world) {
  const SpeciesCatalogue& catalogue = *world->options.species;
  const Species& robot = *catalogue.Find(world->options.robot_species);
  for (AgentStart start : world->scene->agents) {
    const bool is_robot = start.category == AgentCategory::kWheeledRobot;
    const Species& species = is_robot ? robot : catalogue.Of(start.category);
    start.position = PlaceToBegin(start, species, *world);
    Begin(start, species, "", world);
  }
}

Result<std::string> AgentSpawner::Spawn(const SpawnRequest& request, RunningWorld* world) {
  LW_RETURN_IF_ERROR(CheckRequest(request, *world));
  const Species& species = SpeciesFor(request, *world->options.species);
  const RandomStream random_before = random_;
  const Result<WorldPoint> place = PlaceFor(request, species, *world, &random_);
  if (!place.ok()) {
    random_ = random_before;
    return place.status();
  }
  AgentStart start = StartFor(request, species, *place);
  if (start.name.empty()) start.name = NewNameFor(species.name, *world);
  const Agent& agent = Begin(start, species, request.policy, world);
  world->events.Tell(EventKind::kSpawned, agent.name, "", agent.motion.position_m);
  return agent.name;
}

Agent& AgentSpawner::Begin(const AgentStart& start, const Species& species,
                           const std::string& policy, RunningWorld* world) {
  const AgentId id = ++last_agent_;
  Agent begun(id, RandomStream(world->seed, "agent " + std::to_string(id)));
  begun.name = start.name;
  begun.species = &species;
  begun.state = start.state;
  begun.team = start.team;
  begun.controllable = start.controllable;
  begun.policy = policy;
  begun.start = start;
  Agent& agent = world->agents.Add(std::move(begun));
  Embody(start.position, &agent, world);
  return agent;
}

void AgentSpawner::AddTo(Digest* digest) const {
  digest->Add(last_agent_);
  for (const std::uint64_t word : random_.state()) digest->Add(word);
}

}  // namespace latticeworld
