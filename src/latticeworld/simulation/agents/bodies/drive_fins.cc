#include <algorithm>

#include "latticeworld/simulation/agents/bodies/drives.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"
#include "latticeworld/simulation/agents/limits.h"

namespace latticeworld {
namespace {

constexpr double kVelocityGain_hz = 3.0;  // of strokes on the velocity error
constexpr double kWaterDensity_kgpm3 = 1000.0;

}  // namespace

void DriveFins(const Agent& agent, const Surroundings& world) {
  if (!agent.alive()) return;
  const Species& species = *agent.species;
  const double depth_m = world.WaterDepthAt(agent.place());
  if (depth_m <= 0.0) return;  // it lies on the shore
  const double surface_m = world.scene->terrain->ground.HeightAt(agent.place()) + depth_m;
  const double submerged =
      std::clamp((surface_m - agent.motion.position_m.z()) / species.height_m, 0.0, 1.0);
  // Strokes push against the water that there is: up to what its acceleration and the drag at its
  // top speed take.
  const auto drag_n = [&](double speed_mps) {
    return 0.5 * kWaterDensity_kgpm3 * species.water_drag_area_m2 * speed_mps * speed_mps;
  };
  const Eigen::Vector3d& velocity = agent.motion.linear_velocity_mps;
  const Eigen::Vector3d wanted = agent.motion.orientation * agent.driven.linear_mps;
  Eigen::Vector3d thrust = species.mass_kg * kVelocityGain_hz * (wanted - velocity);
  if (velocity.norm() > 1e-6) thrust += drag_n(velocity.norm()) * velocity.normalized();
  const double most_n = species.mass_kg * species.acceleration_mps2 + drag_n(species.top_speed_mps);
  world.physics->AddForce(agent.body, submerged * NoLongerThan(most_n, thrust));
  TurnTo(agent, submerged * agent.driven.yaw_rate_radps, world.physics);
}

}  // namespace latticeworld
