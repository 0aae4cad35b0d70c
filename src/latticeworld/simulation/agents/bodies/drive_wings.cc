#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/drives.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"
#include "latticeworld/simulation/agents/limits.h"

namespace latticeworld {
namespace {

constexpr double kVelocityGain_hz = 3.0;    // of thrust on the velocity error
constexpr double kWindCompensation = 0.95;  // share of the mean wind's drag that a flyer counters
constexpr double kThrustToWeight = 2.0;     // largest
constexpr double kCeiling_m = 300.0;        // above the highest ground: none climbs further

}  // namespace

void DriveWings(const Agent& agent, const Surroundings& world) {
  const Species& species = *agent.species;
  const double mass_kg = species.mass_kg;
  const Eigen::Vector3d& velocity = agent.motion.linear_velocity_mps;
  const Eigen::Vector3d drag = AirDrag(species.drag_area_m2, world.WindAt(agent.place()), velocity);
  Eigen::Vector3d thrust = Eigen::Vector3d::Zero();
  if (agent.alive()) {
    Eigen::Vector3d wanted = agent.motion.orientation * agent.driven.linear_mps;
    const double ceiling_m = world.scene->terrain->ground.max_m() + kCeiling_m;
    if (agent.motion.position_m.z() > ceiling_m) wanted.z() = std::min(wanted.z(), -1.0);
    thrust =
        mass_kg *
            (kVelocityGain_hz * (wanted - velocity) + kGravity_mps2 * Eigen::Vector3d::UnitZ()) -
        kWindCompensation * AirDrag(species.drag_area_m2, world.atmosphere->wind_mps, velocity);
    const double limit_n = kThrustToWeight * mass_kg * kGravity_mps2;
    thrust = NoLongerThan(limit_n, thrust);
    TurnTo(agent, agent.driven.yaw_rate_radps, world.physics);
  }
  world.physics->AddForce(agent.body, thrust + drag);
}

}  // namespace latticeworld
