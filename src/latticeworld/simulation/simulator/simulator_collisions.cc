#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/minds/fights.h"
#include "latticeworld/simulation/collisions.h"
#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {
namespace {

constexpr double kCollisionPause_s = 1.0;  // collisions of one agent are told no more often

}  // namespace

void SimulatorImpl::Collide() {
  for (const Impact& impact : ImpactsOf(physics_->contacts(), *physics_)) {
    const Contact& contact = impact.contact;
    const auto agent_of = [this](BodyId body) {
      const auto found = agent_of_body_.find(body);
      return found == agent_of_body_.end() ? AgentId{0} : found->second;
    };
    const bool bodies = contact.kind == ContactKind::kBody;
    const AgentId id = agent_of(contact.body);
    const AgentId other = bodies ? agent_of(contact.other) : 0;
    if (id != 0) Suffer(id, impact, contact.normal, NameOfOther(contact), other);
    if (other != 0) Suffer(other, impact, -contact.normal, NameOfBody(contact.body), id);
  }
}

void SimulatorImpl::Suffer(AgentId id, const Impact& impact, const Eigen::Vector3d& push,
                           const std::string& other, AgentId other_id) {
  Surroundings world = World();
  Agent& agent = agents_.at(id);
  if (episode_step_ >= agent.next_collision) {
    agent.next_collision = world.In(kCollisionPause_s);
    world.Tell(EventKind::kCollided, agent, other);
  }
  if (!agent.alive()) return;
  const double mass_kg = physics_->SpecOf(agent.body).total_mass_kg();
  const double damage = CollisionDamage(*agent.species, impact.impulse_ns / mass_kg);
  if (damage > 0.0) {
    if (other_id != 0) {
      agent.mind.hit_by = other_id;
      agent.mind.hit_at = episode_step_;
    }
    Harm(&agent, damage, other, &world);
    if (!agent.alive()) return;
  }
  const double height_m = impact.contact.position_m.z() - agent.motion.position_m.z();
  FeelCollision(&agent, impact.impulse_ns * push, height_m, &world);
}

std::string SimulatorImpl::NameOfOther(const Contact& contact) const {
  switch (contact.kind) {
    case ContactKind::kBoundary:
      return "boundary";
    case ContactKind::kAsset:
      return std::string(NameOf(scene_->assets[contact.other].kind));
    default:
      return NameOfBody(contact.other);
  }
}

std::string SimulatorImpl::NameOfBody(BodyId body) const {
  const auto agent = agent_of_body_.find(body);
  if (agent != agent_of_body_.end()) return agents_.at(agent->second).name;
  if (const auto tree = felling_->AssetOf(body)) return Felling::NameOf(*tree);
  return props_->NameOf(body);
}

}  // namespace latticeworld
