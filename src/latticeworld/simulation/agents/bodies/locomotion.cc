#include "latticeworld/simulation/agents/bodies/locomotion.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/drives.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"
#include "latticeworld/simulation/agents/limits.h"

namespace latticeworld {
namespace {

constexpr double kSidewaysShare = 0.5;  // of a quadruped's top speed
// A vehicle whose upward axis has less of the vertical is overturned, until it has more of it.
constexpr double kOverturned = 0.3, kOnItsWheels = 0.5;
constexpr double kMostLever = 2.0;  // of a blow above the middle of a body

double Toward(double from, double to, double largest_change) {
  return from + std::clamp(to - from, -largest_change, largest_change);
}

void RampUp(Agent* agent, const VelocityCommand& wanted, double step_s) {
  const Species& species = *agent->species;
  const double change_mps = species.acceleration_mps2 * step_s;
  for (int i = 0; i < 3; ++i) {
    agent->driven.linear_mps[i] =
        Toward(agent->driven.linear_mps[i], wanted.linear_mps[i], change_mps);
  }
  agent->driven.yaw_rate_radps = Toward(agent->driven.yaw_rate_radps, wanted.yaw_rate_radps,
                                        4.0 * species.turn_rate_radps * step_s);
}

bool IsNothing(const VelocityCommand& command) {
  return command.yaw_rate_radps == 0.0 && command.linear_mps.isZero(0.0);
}

// A body that rests with nothing to do is looked after now and then only: waters may rise, and wind
// too. Agents take turns.
bool MayBeLeftAlone(const Agent& agent, const VelocityCommand& wanted, const Surroundings& world) {
  constexpr std::uint64_t kTurns = 16;
  if ((world.episode_step + agent.id) % kTurns == 0 || !world.physics->IsResting(agent.body)) {
    return false;
  }
  if (!agent.alive()) {
    return agent.posture.down || (!IsOnLegs(agent.species->plan) && IsNothing(agent.driven));
  }
  const bool rises = agent.posture.down && agent.species->plan != BodyPlan::kVehicle;
  return !rises && agent.posture.water_s == 0.0 && agent.joint_targets.empty() &&
         !agent.posture.commanded_joints && IsNothing(agent.driven) && IsNothing(wanted);
}

// Overturned, a vehicle does nothing until somebody puts it on its wheels again.
void SeeWhetherOverturned(Agent* agent) {
  const double up = (agent->motion.orientation * Eigen::Vector3d::UnitZ()).z();
  if (up > (agent->posture.down ? kOnItsWheels : kOverturned)) {
    if (agent->posture.down && agent->alive()) agent->behaviour = Behaviour::kIdle;
    agent->posture.down = false;
  } else {
    if (agent->alive()) agent->behaviour = Behaviour::kFallen;
    agent->posture.down = true;
  }
}

}  // namespace

VelocityCommand ClampToLimits(const Species& species, const VelocityCommand& command) {
  VelocityCommand clamped;
  clamped.yaw_rate_radps =
      std::clamp(command.yaw_rate_radps, -species.turn_rate_radps, species.turn_rate_radps);
  // Component by component first: the norm of finite numbers may be infinite.
  const double top_mps = species.top_speed_mps;
  for (int i = 0; i < 3; ++i) {
    clamped.linear_mps[i] = std::clamp(command.linear_mps[i], -top_mps, top_mps);
  }
  if (species.plan == BodyPlan::kQuadruped) {
    clamped.linear_mps.y() =
        std::clamp(clamped.linear_mps.y(), -kSidewaysShare * top_mps, kSidewaysShare * top_mps);
    clamped.linear_mps.z() = 0.0;
  } else if (species.plan == BodyPlan::kVehicle || IsOnLegs(species.plan)) {
    clamped.linear_mps.tail<2>().setZero();
  }
  clamped.linear_mps = NoLongerThan(top_mps, clamped.linear_mps);
  return clamped;
}

void Drive(Agent* agent, const VelocityCommand& wanted, Surroundings* world) {
  if (MayBeLeftAlone(*agent, wanted, *world)) return;
  const Species& species = *agent->species;
  if (species.plan == BodyPlan::kVehicle) SeeWhetherOverturned(agent);
  VelocityCommand able = agent->able() ? wanted : VelocityCommand();
  if (IsOnLegs(species.plan)) {
    const double top_mps = species.top_speed_mps * SpeedInSnow(world->atmosphere->snow_depth_m);
    able.linear_mps = NoLongerThan(top_mps, able.linear_mps);
  }
  RampUp(agent, able, world->step_s);
  switch (species.plan) {
    case BodyPlan::kVehicle:
      DriveWheels(*agent, world->physics);
      break;
    case BodyPlan::kQuadruped:
      DriveQuadruped(agent, world);
      break;
    case BodyPlan::kBiped:
    case BodyPlan::kGrazer:
      DriveLegs(agent, world);
      break;
    case BodyPlan::kFlyer:
      DriveWings(*agent, *world);
      break;
    case BodyPlan::kSwimmer:
      DriveFins(*agent, *world);
      break;
  }
  if (!KeepsAfloat(species.plan)) BlowOn(*agent, *world);
  Float(agent, world);
}

void FeelCollision(Agent* agent, const Eigen::Vector3d& impulse_ns, double height_m,
                   Surroundings* world) {
  const Species& species = *agent->species;
  if (species.plan != BodyPlan::kBiped || !agent->able()) return;
  // What hits it above its middle tips it more easily; what hits its legs takes them from under it.
  const double lever = std::clamp(2.0 * height_m / species.height_m, 1.0, kMostLever);
  const double change_mps = lever * impulse_ns.head<2>().norm() / species.mass_kg;
  if (change_mps < species.knock_over_mps) return;
  FallOver(agent, world);
  PhysicsWorld& physics = *world->physics;
  physics.SetUpright(agent->body, false);
  // It topples away from what hit it, about its feet, at the speed that the blow gave it.
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(impulse_ns).normalized();
  BodyMotion motion = physics.MotionOf(agent->body);
  motion.angular_velocity_radps += change_mps / species.height_m * axis;
  physics.Place(agent->body, motion);
}

void TakeBlow(Agent* agent, const Eigen::Vector3d& impulse_ns, double height_m,
              Surroundings* world) {
  if (!impulse_ns.allFinite() || impulse_ns.isZero()) return;
  const Eigen::Vector3d up = agent->motion.orientation * Eigen::Vector3d::UnitZ();
  world->physics->AddImpulse(agent->body, impulse_ns, agent->motion.position_m + height_m * up);
  FeelCollision(agent, impulse_ns, height_m, world);
}

}  // namespace latticeworld
