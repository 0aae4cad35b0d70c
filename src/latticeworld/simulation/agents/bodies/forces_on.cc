#include "latticeworld/simulation/agents/bodies/forces_on.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/footing.h"
#include "latticeworld/simulation/agents/minds/fights.h"
#include "latticeworld/simulation/water_forces.h"

namespace latticeworld {
namespace {

constexpr double kAirDensity_kgpm3 = 1.225;
// Wind on what stands on the ground: lighter pushes than this share of its weight are no matter,
// and only heavier ones could move what rests.
constexpr double kFeltWind = 0.02;
constexpr double kWakingWind = 0.10;
constexpr double kYawGain_hz = 10.0;

// The water above base_link harms it bit by bit.
void Drown(Agent* agent, double under_m, Surroundings* world) {
  const Species& species = *agent->species;
  if (under_m <= species.drowning_depth_m || !agent->alive()) {
    agent->posture.water_s = 0.0;
    return;
  }
  agent->posture.water_s += world->step_s;
  agent->hit_points -= species.hit_points * world->step_s / species.drowning_time_s;
  if (agent->alive()) return;
  world->Tell(EventKind::kDrowned, *agent, "water");
  Die(agent, "water", world);
}

}  // namespace

Eigen::Vector3d AirDrag(double drag_area_m2, const Eigen::Vector3d& wind_mps,
                        const Eigen::Vector3d& velocity_mps) {
  const Eigen::Vector3d relative_mps = wind_mps - velocity_mps;
  return 0.5 * kAirDensity_kgpm3 * drag_area_m2 * relative_mps.norm() * relative_mps;
}

void BlowOn(const Agent& agent, const Surroundings& world) {
  const Species& species = *agent.species;
  const double weight_n = species.mass_kg * kGravity_mps2;
  // Nobody looks for gusts where not even the strongest is felt.
  const double strongest_mps =
      world.atmosphere->wind_mps.norm() + GustField::kBoundOfLength * world.atmosphere->gust_mps;
  const double strongest_n =
      0.5 * kAirDensity_kgpm3 * species.drag_area_m2 * strongest_mps * strongest_mps;
  if (strongest_n < kFeltWind * weight_n) return;
  Eigen::Vector3d push =
      AirDrag(species.drag_area_m2, world.WindAt(agent.place()), agent.motion.linear_velocity_mps);
  push.z() = 0.0;
  const double least = world.physics->IsResting(agent.body) ? kWakingWind : kFeltWind;
  if (push.norm() >= least * weight_n) world.physics->AddForce(agent.body, push);
}

void Float(Agent* agent, Surroundings* world) {
  const double depth_m = world->WaterDepthAt(agent->place());
  if (depth_m <= 0.0) {
    agent->posture.water_s = 0.0;
    return;
  }
  const Species& species = *agent->species;
  const Buoyancy buoyancy = {species.mass_kg / species.density_kgpm3, species.water_drag_area_m2};
  ActOfWater(*world->scene->terrain, *world->atmosphere, buoyancy, agent->body, world->physics);
  const double surface_m = world->scene->terrain->ground.HeightAt(agent->place()) + depth_m;
  Drown(agent, surface_m - agent->motion.position_m.z(), world);
}

// At equal effort speed goes with the square root of the terrain factor of Pandolf, Givoni and
// Goldman (1977), which for soft snow is 2.5 at a depth of 15 cm, 3.3 at 25 and 4.1 at 35, and 1 on
// bare ground.
double SpeedInSnow(double depth_m) {
  return 1.0 / std::sqrt(std::min(1.0 + 20.0 * depth_m, 1.3 + 8.0 * depth_m));
}

Eigen::Vector3d WithinSlope(const Agent& agent, const Surroundings& world,
                            const Eigen::Vector3d& velocity_mps) {
  constexpr double kOnSomething_m = 0.25;  // above the ground: on a stone, a stem
  if (velocity_mps.isZero()) return velocity_mps;
  const HeightField& ground = world.scene->terrain->ground;
  const Species& species = *agent.species;
  const Eigen::Vector3d normal = ground.NormalAt(agent.place());
  const Eigen::Vector2d down = normal.head<2>();  // its length is the sine of the slope
  const double sine = down.norm();
  if (sine <= std::sin(species.max_slope_rad)) return velocity_mps;
  const double downward_mps = velocity_mps.head<2>().dot(down) / sine;
  if (downward_mps >= 0.0) return velocity_mps;
  if (agent.motion.position_m.z() > ground.HeightAt(agent.place()) + kOnSomething_m ||
      StandsOnDeck(world, agent)) {
    return velocity_mps;
  }
  Eigen::Vector3d limited = velocity_mps;
  limited.head<2>() -= downward_mps / sine * down;
  return limited;
}

void TurnTo(const Agent& agent, double yaw_rate_radps, PhysicsWorld* physics) {
  const double error = yaw_rate_radps - agent.motion.angular_velocity_radps.z();
  if (yaw_rate_radps == 0.0 && std::abs(error) < 1e-3) return;
  const double inertia_kgm2 = physics->SpecOf(agent.body).inertia_kgm2.z();
  physics->AddTorque(agent.body, {0.0, 0.0, inertia_kgm2 * kYawGain_hz * error});
}

}  // namespace latticeworld
