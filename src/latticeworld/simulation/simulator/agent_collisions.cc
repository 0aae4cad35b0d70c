#include "latticeworld/simulation/simulator/agent_collisions.h"

#include <string>

#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/minds/fights.h"
#include "latticeworld/simulation/collisions.h"

namespace latticeworld {
namespace {

constexpr double kCollisionPause_s = 1.0;  // collisions of one agent are told no more often

// An agent's side of a collision.
struct Side {
  AgentId agent = 0;
  AgentId other = 0;                               // the other side; 0: it is no agent
  std::string other_name;                          // or what it is
  Eigen::Vector3d push = Eigen::Vector3d::Zero();  // unit, away from the other side
};

// Tells it, hurts and knocks over.
void Suffer(const Side& side, const Impact& impact, RunningWorld* running) {
  Surroundings world = running->ForAgents();
  Agent& agent = world.agents->at(side.agent);
  if (world.episode_step >= agent.next_collision) {
    agent.next_collision = world.In(kCollisionPause_s);
    world.Tell(EventKind::kCollided, agent, side.other_name);
  }
  if (!agent.alive()) return;
  const double mass_kg = world.physics->SpecOf(agent.body).total_mass_kg();
  const double damage = CollisionDamage(*agent.species, impact.impulse_ns / mass_kg);
  if (damage > 0.0) {
    if (side.other != 0) {
      agent.mind.hit_by = side.other;
      agent.mind.hit_at = world.episode_step;
    }
    Harm(&agent, damage, side.other_name, &world);
    if (!agent.alive()) return;
  }
  const double height_m = impact.contact.position_m.z() - agent.motion.position_m.z();
  FeelCollision(&agent, impact.impulse_ns * side.push, height_m, &world);
}

std::string NameOfOther(const Contact& contact, const RunningWorld& world) {
  switch (contact.kind) {
    case ContactKind::kBoundary:
      return "boundary";
    case ContactKind::kAsset:
      return std::string(NameOf(world.scene->assets[contact.other].kind));
    default:
      return world.NameOf(contact.other);
  }
}

}  // namespace

void CollideAgents(RunningWorld* world) {
  const PhysicsWorld& physics = world->dynamic_scene.physics();
  for (const Impact& impact : ImpactsOf(physics.contacts(), physics)) {
    const Contact& contact = impact.contact;
    const bool bodies = contact.kind == ContactKind::kBody;
    const AgentId id = world->agents.IdOfBody(contact.body);
    const AgentId other = bodies ? world->agents.IdOfBody(contact.other) : 0;
    if (id != 0) {
      Side side;
      side.agent = id;
      side.other = other;
      side.other_name = NameOfOther(contact, *world);
      side.push = contact.normal;
      Suffer(side, impact, world);
    }
    if (other != 0) {
      Side side;
      side.agent = other;
      side.other = id;
      side.other_name = world->NameOf(contact.body);
      side.push = -contact.normal;
      Suffer(side, impact, world);
    }
  }
}

}  // namespace latticeworld
