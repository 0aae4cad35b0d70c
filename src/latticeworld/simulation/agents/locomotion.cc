#include "latticeworld/simulation/agents/locomotion.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies.h"
#include "latticeworld/simulation/agents/species.h"

namespace latticeworld {
namespace {

constexpr double kVelocityGain_hz = 3.0;  // of thrust and strokes on the velocity error
constexpr double kAirDensity_kgpm3 = 1.225;
constexpr double kWaterDrag_hz = 0.5;       // drag acceleration per speed through water
constexpr double kWindCompensation = 0.95;  // share of the mean wind's drag that a flyer counters
// Wind on what stands on the ground: lighter pushes than this share of its weight are no matter,
// and only heavier ones could move what rests.
constexpr double kFeltWind = 0.02;
constexpr double kWakingWind = 0.10;
constexpr double kThrustToWeight = 2.0;  // largest
constexpr double kYawGain_hz = 10.0;
constexpr double kCeiling_m = 300.0;  // above the highest ground: no flyer climbs further

double Toward(double from, double to, double largest_change) {
  return from + std::clamp(to - from, -largest_change, largest_change);
}

void RampUp(Agent* agent, const VelocityCommand& wanted, double step_s) {
  const Species& species = SpeciesOf(agent->category);
  const double change_mps = species.acceleration_mps2 * step_s;
  for (int i = 0; i < 3; ++i) {
    agent->driven.linear_mps[i] =
        Toward(agent->driven.linear_mps[i], wanted.linear_mps[i], change_mps);
  }
  agent->driven.yaw_rate_radps = Toward(agent->driven.yaw_rate_radps, wanted.yaw_rate_radps,
                                        4.0 * species.turn_rate_radps * step_s);
}

void TurnTo(const Agent& agent, double yaw_rate_radps, PhysicsWorld* physics) {
  const double error = yaw_rate_radps - agent.motion.angular_velocity_radps.z();
  if (yaw_rate_radps == 0.0 && std::abs(error) < 1e-3) return;
  const Species& species = SpeciesOf(agent.category);
  const double inertia = 0.5 * species.mass_kg * agent.radius_m * agent.radius_m;
  physics->AddTorque(agent.body, {0.0, 0.0, inertia * kYawGain_hz * error});
}

void DriveWheels(const Agent& agent, PhysicsWorld* physics) {
  const double forward = agent.driven.linear_mps.x();
  const double turn = 0.5 * kWheelTrack_m * agent.driven.yaw_rate_radps;
  physics->SetWheelRates(agent.body, (forward - turn) / kWheelRadius_m,
                         (forward + turn) / kWheelRadius_m);
}

// Drag of air of that velocity on a body of that velocity [N].
Eigen::Vector3d AirDrag(double drag_area_m2, const Eigen::Vector3d& wind_mps,
                        const Eigen::Vector3d& velocity_mps) {
  const Eigen::Vector3d relative_mps = wind_mps - velocity_mps;
  return 0.5 * kAirDensity_kgpm3 * drag_area_m2 * relative_mps.norm() * relative_mps;
}

// Wind pushes what stands on the ground; what is light or broad moves.
void BlowOn(const Agent& agent, const Surroundings& world) {
  const Species& species = SpeciesOf(agent.category);
  const double weight_n = species.mass_kg * kGravity_mps2;
  // Nobody looks for gusts where not even the strongest is felt.
  const double strongest_mps =
      world.atmosphere.wind_mps.norm() + GustField::kBoundOfLength * world.atmosphere.gust_mps;
  const double strongest_n =
      0.5 * kAirDensity_kgpm3 * species.drag_area_m2 * strongest_mps * strongest_mps;
  if (strongest_n < kFeltWind * weight_n) return;
  Eigen::Vector3d push =
      AirDrag(species.drag_area_m2, world.WindAt(agent.place()), agent.motion.linear_velocity_mps);
  push.z() = 0.0;
  const double least = world.physics.IsResting(agent.body) ? kWakingWind : kFeltWind;
  if (push.norm() >= least * weight_n) world.physics.AddForce(agent.body, push);
}

// Share of its top speed that a walker keeps in snow: at equal effort speed goes with the square
// root of the terrain factor of Pandolf, Givoni and Goldman (1977), which for soft snow is 2.5 at a
// depth of 15 cm, 3.3 at 25 and 4.1 at 35, and 1 on bare ground.
double SpeedInSnow(double depth_m) {
  return 1.0 / std::sqrt(std::min(1.0 + 20.0 * depth_m, 1.3 + 8.0 * depth_m));
}

void DriveLegs(const Agent& agent, PhysicsWorld* physics) {
  const Eigen::Vector3d forward(agent.driven.linear_mps.x(), 0.0, 0.0);
  physics->SetWalkVelocity(agent.body, agent.motion.orientation * forward);
  TurnTo(agent, agent.driven.yaw_rate_radps, physics);
}

void DriveWings(const Agent& agent, const Surroundings& world) {
  const Species& species = SpeciesOf(agent.category);
  const double mass_kg = species.mass_kg;
  const Eigen::Vector3d& velocity = agent.motion.linear_velocity_mps;
  const Eigen::Vector3d drag = AirDrag(species.drag_area_m2, world.WindAt(agent.place()), velocity);
  Eigen::Vector3d thrust = Eigen::Vector3d::Zero();
  if (agent.alive()) {
    Eigen::Vector3d wanted = agent.motion.orientation * agent.driven.linear_mps;
    const double ceiling_m = world.scene.terrain->ground.max_m() + kCeiling_m;
    if (agent.motion.position_m.z() > ceiling_m) wanted.z() = std::min(wanted.z(), -1.0);
    thrust = mass_kg * (kVelocityGain_hz * (wanted - velocity) +
                        kGravity_mps2 * Eigen::Vector3d::UnitZ()) -
             kWindCompensation * AirDrag(species.drag_area_m2, world.atmosphere.wind_mps, velocity);
    const double limit_n = kThrustToWeight * mass_kg * kGravity_mps2;
    if (thrust.norm() > limit_n) thrust *= limit_n / thrust.norm();
    TurnTo(agent, agent.driven.yaw_rate_radps, &world.physics);
  }
  world.physics.AddForce(agent.body, thrust + drag);
}

void DriveFins(const Agent& agent, const Surroundings& world) {
  const Species& species = SpeciesOf(agent.category);
  const WorldPoint place = agent.place();
  const double depth_m = world.WaterDepthAt(place);
  const double surface_m = world.scene.terrain->ground.HeightAt(place) + depth_m;
  // Share of the body under water: as dense as water, so that it floats level when under.
  const double submerged =
      depth_m > 0.0
          ? std::clamp((surface_m - agent.motion.position_m.z()) / species.height_m, 0.0, 1.0)
          : 0.0;
  const Eigen::Vector3d& velocity = agent.motion.linear_velocity_mps;
  Eigen::Vector3d force = species.mass_kg * submerged *
                          (kGravity_mps2 * Eigen::Vector3d::UnitZ() - kWaterDrag_hz * velocity);
  if (agent.alive()) {
    const Eigen::Vector3d wanted = agent.motion.orientation * agent.driven.linear_mps;
    force += species.mass_kg * submerged *
             (kVelocityGain_hz * (wanted - velocity) + kWaterDrag_hz * velocity);
    TurnTo(agent, agent.driven.yaw_rate_radps, &world.physics);
  }
  world.physics.AddForce(agent.body, force);
}

}  // namespace

VelocityCommand ClampToLimits(AgentCategory category, const VelocityCommand& command) {
  const Species& species = SpeciesOf(category);
  const Locomotion locomotion = LocomotionOf(category);
  VelocityCommand clamped;
  clamped.yaw_rate_radps =
      std::clamp(command.yaw_rate_radps, -species.turn_rate_radps, species.turn_rate_radps);
  if (locomotion == Locomotion::kWheels || locomotion == Locomotion::kLegs) {
    clamped.linear_mps.x() =
        std::clamp(command.linear_mps.x(), -species.top_speed_mps, species.top_speed_mps);
    return clamped;
  }
  clamped.linear_mps = command.linear_mps;
  // Component by component first: the norm of finite numbers may be infinite.
  for (int i = 0; i < 3; ++i) {
    clamped.linear_mps[i] =
        std::clamp(clamped.linear_mps[i], -species.top_speed_mps, species.top_speed_mps);
  }
  const double speed_mps = clamped.linear_mps.norm();
  if (speed_mps > species.top_speed_mps) clamped.linear_mps *= species.top_speed_mps / speed_mps;
  return clamped;
}

void Drive(Agent* agent, const VelocityCommand& wanted, Surroundings* world) {
  const Locomotion locomotion = LocomotionOf(agent->category);
  VelocityCommand able = agent->alive() ? wanted : VelocityCommand();
  if (locomotion == Locomotion::kLegs) {
    const double top_mps =
        SpeciesOf(agent->category).top_speed_mps * SpeedInSnow(world->atmosphere.snow_depth_m);
    able.linear_mps.x() = std::clamp(able.linear_mps.x(), -top_mps, top_mps);
  }
  RampUp(agent, able, world->step_s);
  switch (locomotion) {
    case Locomotion::kWheels:
      DriveWheels(*agent, &world->physics);
      BlowOn(*agent, *world);
      break;
    case Locomotion::kLegs:
      DriveLegs(*agent, &world->physics);
      BlowOn(*agent, *world);
      break;
    case Locomotion::kWings:
      DriveWings(*agent, *world);
      break;
    case Locomotion::kFins:
      DriveFins(*agent, *world);
      break;
  }
}

}  // namespace latticeworld
