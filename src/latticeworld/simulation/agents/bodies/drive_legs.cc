#include "latticeworld/simulation/agents/bodies/drives.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"

namespace latticeworld {
namespace {

constexpr double kStillSpeed_mps = 0.3;
constexpr double kStillRate_radps = 0.6;
constexpr double kTopple_mps = 0.8;  // of the head of what dies on its feet

// Balanced on its feet, a dead body would stand on. It goes down about them: a character forwards,
// an animal over its side.
void Topple(const Agent& agent, PhysicsWorld* physics) {
  const bool forwards = agent.species->plan == BodyPlan::kBiped;
  const Eigen::Vector3d axis = forwards ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  physics->SetUpright(agent.body, false);
  BodyMotion motion = physics->MotionOf(agent.body);
  motion.angular_velocity_radps +=
      kTopple_mps / agent.species->height_m * (motion.orientation * axis);
  physics->Place(agent.body, motion);
}

}  // namespace

void FallOver(Agent* agent, Surroundings* world) {
  Posture& posture = agent->posture;
  posture.down = true;
  posture.stands = false;
  posture.righting = false;
  posture.still_since = world->episode_step;
  agent->driven = VelocityCommand();
  agent->behaviour = Behaviour::kFallen;
  world->Tell(EventKind::kKnockedOver, *agent, "");
}

bool HasLainStill(Agent* agent, const Surroundings& world) {
  const BodyMotion& motion = agent->motion;
  if (motion.linear_velocity_mps.norm() > kStillSpeed_mps ||
      motion.angular_velocity_radps.norm() > kStillRate_radps) {
    agent->posture.still_since = world.episode_step;
  }
  return world.episode_step >= agent->posture.still_since + world.StepsIn(agent->species->get_up_s);
}

void DriveLegs(Agent* agent, Surroundings* world) {
  PhysicsWorld& physics = *world->physics;
  if (!agent->alive()) {
    if (!agent->posture.down) Topple(*agent, &physics);
    agent->posture.down = true;
    physics.SetWalkVelocity(agent->body, Eigen::Vector3d::Zero());
    return;
  }
  if (agent->posture.down) {
    physics.SetWalkVelocity(agent->body, Eigen::Vector3d::Zero());
    if (!HasLainStill(agent, *world)) return;
    agent->posture.down = false;
    agent->behaviour = Behaviour::kIdle;
    physics.SetUpright(agent->body, true);
    return;
  }
  const Eigen::Vector3d forward(agent->driven.linear_mps.x(), 0.0, 0.0);
  physics.SetWalkVelocity(agent->body,
                          WithinSlope(*agent, *world, agent->motion.orientation * forward));
  TurnTo(*agent, agent->driven.yaw_rate_radps, &physics);
}

}  // namespace latticeworld
