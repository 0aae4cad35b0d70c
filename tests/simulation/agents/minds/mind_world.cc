#include "simulation/agents/minds/mind_world.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kThought_s = 0.1;

}  // namespace

MindWorld::MindWorld(const TestScene& scene)
    : atmosphere(scene.atmosphere),
      scene_(scene.Build()),
      surfaces_(*scene_, scene.atmosphere.ground()),
      gusts_(1),
      paths_(*scene_),
      physics_(MakeOdeWorld(scene_)) {}

MindWorld::~MindWorld() = default;

Agent& MindWorld::Add(const std::string& species, int team, double x_m, double y_m,
                      double heading_rad) {
  static const std::shared_ptr<const SpeciesCatalogue> catalogue = SpeciesCatalogue::BuiltIn();
  const AgentId id = ++last_;
  Agent& agent =
      agents.emplace(id, Agent(id, RandomStream(1, "agent " + std::to_string(id)))).first->second;
  agent.name = species + "_" + std::to_string(id);
  agent.species = catalogue->Find(species);
  agent.team = team;
  agent.hit_points = agent.species->hit_points;
  const double z_m = scene_->terrain->ground.HeightAt({x_m, y_m}) + agent.species->altitude_m;
  agent.body = physics_->Add(BodyOf(*agent.species), {x_m, y_m, z_m}, heading_rad);
  agent.motion = physics_->MotionOf(agent.body);
  agent.mind.home = {x_m, y_m};
  agent.mind.home_z_m = z_m;
  agent.mind.steering.heading_rad = heading_rad;
  return agent;
}

void MindWorld::Remove(AgentId id) { agents.erase(id); }

Surroundings& MindWorld::Now() {
  near_ = AgentGrid(scene_->geometry().size_m(), agents);
  now_ = std::make_unique<Surroundings>();
  now_->scene = scene_.get();
  now_->changes = &changes;
  now_->atmosphere = &atmosphere;
  now_->surfaces = &surfaces_;
  now_->gusts = &gusts_;
  now_->paths = &paths_;
  now_->near = &near_;
  now_->agents = &agents;
  now_->physics = physics_.get();
  now_->events = &events;
  now_->step_s = kStep_s;
  now_->pursuit_distance_m = pursuit_distance_m;
  now_->step = step;
  now_->episode_step = step;
  return *now_;
}

void MindWorld::Look(Agent* agent) { Perceive(agent, Now()); }

void MindWorld::Run(double seconds, const std::map<AgentId, std::string>& policies) {
  const int thoughts = static_cast<int>(std::lround(seconds / kThought_s));
  for (int i = 0; i < thoughts; ++i) {
    step += static_cast<std::uint64_t>(std::lround(kThought_s / kStep_s));
    Surroundings& world = Now();
    for (auto& [id, agent] : agents) {
      const auto policy = policies.find(id);
      Think(&agent, policy == policies.end() ? "idler" : policy->second, &world);
    }
    for (auto& [id, agent] : agents) Fight(&agent, &world);
    for (auto& [id, agent] : agents) Go(&agent, kThought_s);
  }
}

void MindWorld::Go(Agent* agent, double seconds) {
  const VelocityCommand wanted = WantedVelocity(*agent, false, step);
  BodyMotion& motion = agent->motion;
  const double yaw_rad = motion.yaw_rad() + seconds * wanted.yaw_rate_radps;
  motion.orientation = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  motion.linear_velocity_mps = motion.orientation * wanted.linear_mps;
  motion.position_m += seconds * motion.linear_velocity_mps;
  if (agent->species->plan == BodyPlan::kFlyer || agent->species->plan == BodyPlan::kSwimmer) {
    return;
  }
  motion.position_m.z() = scene_->terrain->ground.HeightAt(agent->place());
}

double MindWorld::DistanceOf(const Agent& a, const Agent& b) const {
  return DistanceBetween(a.place(), b.place());
}

int MindWorld::Count(EventKind kind, const std::string& agent) const {
  return static_cast<int>(std::count_if(events.begin(), events.end(), [&](const Event& event) {
    return event.kind == kind && event.agent == agent;
  }));
}

}  // namespace latticeworld
