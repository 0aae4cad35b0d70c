#include "simulation/kinematic_world.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "latticeworld/simulation/ode/ode_world.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.02;
constexpr int kStepsOfThought = 5;

}  // namespace

KinematicWorld::KinematicWorld(std::shared_ptr<const Scene> scene, std::uint64_t seed)
    : scene_(std::move(scene)),
      seed_(seed),
      surfaces_(*scene_, scene_->atmosphere.ground()),
      gusts_(seed),
      paths_(*scene_),
      physics_(MakeOdeWorld(scene_)) {}

Agent& KinematicWorld::Add(const std::string& species, double x_m, double y_m, double heading_rad) {
  const auto id = static_cast<AgentId>(agents_.size() + 1);
  Agent& agent = agents_.emplace(id, Agent(id, RandomStream(seed_, "agent " + std::to_string(id))))
                     .first->second;
  agent.name = species + std::to_string(id);
  agent.species = species_->Find(species);
  LW_CHECK(agent.species != nullptr, "no species " + species);
  agent.hit_points = agent.species->hit_points;
  agent.motion.position_m = {x_m, y_m, scene_->terrain->ground.HeightAt({x_m, y_m})};
  agent.motion.orientation = Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ());
  return agent;
}

Surroundings KinematicWorld::World() {
  near_.Rebuild(scene_->geometry().size_m(), agents_);
  Surroundings world;
  world.scene = scene_.get();
  world.changes = &changes_;
  world.map_version = map_version_;
  world.atmosphere = &scene_->atmosphere;
  world.surfaces = &surfaces_;
  world.gusts = &gusts_;
  world.paths = &paths_;
  world.near = &near_;
  world.agents = &agents_;
  world.physics = physics_.get();
  world.events = &events_;
  world.step_s = kStep_s;
  world.pursuit_distance_m = 25.0;
  world.step = step_;
  world.episode_step = step_;
  return world;
}

void KinematicWorld::Move(Agent* agent) {
  const VelocityCommand wanted = Follow(agent->mind.steering, *agent);
  const double change_mps = agent->species->acceleration_mps2 * kStep_s;
  double& forward_mps = agent->driven.linear_mps.x();
  forward_mps += std::clamp(wanted.linear_mps.x() - forward_mps, -change_mps, change_mps);
  double yaw_rate_radps = wanted.yaw_rate_radps;
  if (TurningRadius(*agent->species) > 0.0) {
    const double most_radps = std::abs(forward_mps) / TurningRadius(*agent->species);
    yaw_rate_radps = std::clamp(yaw_rate_radps, -most_radps, most_radps);
  }
  const double yaw_rad = agent->motion.yaw_rad() + kStep_s * yaw_rate_radps;
  agent->motion.orientation = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  agent->motion.linear_velocity_mps =
      forward_mps * Eigen::Vector3d(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
  agent->motion.position_m += kStep_s * agent->motion.linear_velocity_mps;
  agent->motion.position_m.z() = scene_->terrain->ground.HeightAt(agent->place());
}

void KinematicWorld::Run(double seconds, const Steer& steer) {
  const auto steps = static_cast<int>(std::lround(seconds / kStep_s));
  for (int i = 0; i < steps; ++i) {
    Surroundings world = World();
    paths_.Update(changes_);
    for (auto& [id, agent] : agents_) {
      if (agent.alive() && (step_ + id) % kStepsOfThought == 0)
        agent.mind.steering = steer(&agent, &world);
    }
    for (auto& [id, agent] : agents_) {
      if (agent.alive()) Move(&agent);
    }
    ++step_;
    for (const auto& [id, agent] : agents_) {
      for (const auto& [other_id, other] : agents_) {
        if (other_id <= id) continue;
        least_gap_m_ =
            std::min(least_gap_m_, DistanceBetween(agent.place(), other.place()) -
                                       agent.species->radius_m - other.species->radius_m);
      }
    }
  }
}

}  // namespace latticeworld
