#include <algorithm>
#include <cmath>

#include "latticeworld/scene/agents/spawn_rules.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {
namespace {

constexpr int kRespawnTries = 16;
constexpr double kRespawnNear_m = 15.0;
constexpr std::uint64_t kTurnsBetweenTries = 10;  // before it looks for a place again

}  // namespace

double SimulatorImpl::StartHeight(const Agent& agent, WorldPoint place) const {
  const double ground_m = scene_->terrain->ground.HeightAt(place);
  const double depth_m = WaterDepthAt(*scene_->terrain, weather_->now(), place);
  switch (agent.species->plan) {
    case BodyPlan::kFlyer:
      return ground_m + depth_m + std::max(0.0, agent.start.height_above_ground_m);
    case BodyPlan::kSwimmer:
      return ground_m + std::max(0.1, 0.5 * (depth_m - agent.species->height_m));
    default:
      return ground_m;
  }
}

Agent& SimulatorImpl::Begin(const AgentStart& start, const Species& species,
                            const std::string& policy) {
  const AgentId id = ++last_agent_;
  Agent& agent = agents_.emplace(id, Agent(id, RandomStream(seed_, "agent " + std::to_string(id))))
                     .first->second;
  agent.name = start.name;
  agent.species = &species;
  agent.state = start.state;
  agent.team = start.team;
  agent.controllable = start.controllable;
  agent.policy = policy;
  agent.start = start;
  in_order_.clear();
  ids_[agent.name] = id;
  Embody(&agent, start.position);
  return agent;
}

void SimulatorImpl::Embody(Agent* agent, WorldPoint place) {
  agent->hit_points = agent->species->hit_points;
  agent->died_at = 0;
  agent->behaviour = agent->controllable ? Behaviour::kControlled : BehaviourIn(agent->state);
  agent->posture = {};
  agent->command.reset();
  agent->joint_targets.clear();
  agent->strike_wanted = false;
  agent->next_blow = 0;
  agent->driven = {};
  agent->body =
      physics_->Add(BodyOf(*agent->species), {place.x_m, place.y_m, StartHeight(*agent, place)},
                    agent->start.heading_rad);
  agent->motion = physics_->MotionOf(agent->body);
  agent_of_body_[agent->body] = agent->id;

  Mind mind(agent->mind.random);
  mind.home = place;
  mind.home_z_m = agent->motion.position_m.z();
  mind.turn_side = mind.random.Chance(0.5) ? 1 : -1;
  mind.steering.heading_rad = agent->start.heading_rad;
  if (agent->species->plan == BodyPlan::kFlyer) mind.steering.base_z_m = mind.home_z_m;
  agent->mind = std::move(mind);
}

std::optional<WorldPoint> SimulatorImpl::PlaceToRespawn(Agent* agent) {
  const Species& species = *agent->species;
  WorldPoint place = agent->start.position;
  for (int i = 0; i < kRespawnTries; ++i) {
    if (CheckSpawn(*scene_, weather_->now(), species.category, species.radius_m, place, &changes_)
            .ok() &&
        CheckFree(species, place, agent->id).ok()) {
      return place;
    }
    const double heading_rad = agent->mind.random.Uniform(-M_PI, M_PI);
    place = Ahead(agent->start.position, heading_rad,
                  agent->mind.random.Uniform(2.0 * species.radius_m, kRespawnNear_m));
  }
  return std::nullopt;
}

void SimulatorImpl::Respawn() {
  Surroundings world = World();
  for (Agent* agent : in_order_) {
    if (!HasTurn(agent->id) || agent->alive() || IsFrozen(agent->id)) continue;
    if (agent->species->respawn_s <= 0.0) continue;
    const std::uint64_t due = agent->died_at + world.StepsIn(agent->species->respawn_s);
    if (episode_step_ < due || (episode_step_ - due) / turns_ % kTurnsBetweenTries != 0) continue;
    const std::optional<WorldPoint> place = PlaceToRespawn(agent);
    if (!place.has_value()) continue;
    agent_of_body_.erase(agent->body);
    physics_->Remove(agent->body);
    Embody(agent, *place);
    world.Tell(EventKind::kRespawned, *agent, "");
  }
}

}  // namespace latticeworld
