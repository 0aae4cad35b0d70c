#ifndef LATTICEWORLD_SENSING_SENSED_WORLD_H_
#define LATTICEWORLD_SENSING_SENSED_WORLD_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

// The wheels of a vehicle, as encoders read them.
struct SensedWheels {
  // Angles and rates of the first driven wheel of a side, forward positive; angles go around within
  // +-pi.
  double left_rad = 0.0, right_rad = 0.0;
  double left_radps = 0.0, right_radps = 0.0;
  std::optional<double> steering_rad;  // of the middle of the steered axle; none: not steered
  double wheel_radius_m = 0.1;
  double track_m = 0.5, wheelbase_m = 0.5;
  double axle_m = 0.0;  // x in base_link of the axle that rolls without going sideways
  bool skids = false;   // it turns by wheels that are dragged sideways
};

// An agent as sensors meet it, and what it feels itself.
struct SensedAgent {
  std::string name;
  AgentCategory category = AgentCategory::kSheep;
  double height_m = 1.0, radius_m = 0.5;  // of its species: its mesh has this size
  Eigen::Isometry3d map_from_base = Eigen::Isometry3d::Identity();
  Eigen::Vector3d linear_velocity_mps = Eigen::Vector3d::Zero();     // of base_link, in map
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();  // in base_link
  bool has_sensors = false;      // controllable, or decided for from outside
  double contact_force_n = 0.0;  // of the hardest contact of the step with what is not ground
  Eigen::Vector3d contact_direction = Eigen::Vector3d::Zero();  // to it, in base_link; zero: none
  std::optional<SensedWheels> wheels;  // of those with sensors that have wheels
};

struct SensedProp {
  std::string name;
  PropKind kind = PropKind::kCrate;
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
  Eigen::Isometry3d map_from_prop = Eigen::Isometry3d::Identity();  // a gate's: of its panel
  bool broken = false;
};

// What moves in a world, after one step of its simulation: all that sensors need of it beside the
// Scene. Sorted as the simulation has it; indices of RayHit are into these lists.
struct SensedWorld {
  std::uint64_t step = 0;
  double time_s = 0.0;
  Atmosphere atmosphere;
  std::vector<SensedAgent> agents;
  std::vector<SensedProp> props;
  std::vector<FallenTree> felled;   // trees that lie or are falling, as they are at this moment
  std::vector<std::uint32_t> gone;  // assets that are no longer there at all
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SENSED_WORLD_H_
