#ifndef LATTICEWORLD_SIMULATION_WORLD_STATE_H_
#define LATTICEWORLD_SIMULATION_WORLD_STATE_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/scene/atmosphere.h"

namespace latticeworld {

enum class Behaviour : std::uint8_t {
  kIdle,
  kPatrol,
  kGraze,
  kSwim,
  kSoar,
  kPursue,
  kAttack,
  kControlled,
  kDead
};
constexpr std::array<EnumName<Behaviour>, 9> EnumNames(Behaviour) {
  return {{{Behaviour::kIdle, "idle"},
           {Behaviour::kPatrol, "patrol"},
           {Behaviour::kGraze, "graze"},
           {Behaviour::kSwim, "swim"},
           {Behaviour::kSoar, "soar"},
           {Behaviour::kPursue, "pursue"},
           {Behaviour::kAttack, "attack"},
           {Behaviour::kControlled, "controlled"},
           {Behaviour::kDead, "dead"}}};
}

struct AgentSnapshot {
  std::string name;
  AgentCategory category = AgentCategory::kSheep;
  int team = 0;
  bool controllable = false;
  Behaviour behaviour = Behaviour::kIdle;
  double health = 1.0;  // [0, 1]
  // map_from_base: base_link stands at the body's lowest point at rest, x forward, z up.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d linear_velocity_mps = Eigen::Vector3d::Zero();     // in base_link
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();  // in base_link
};

enum class EventKind : std::uint8_t {
  kSpawned,
  kRemoved,
  kPursued,
  kAttacked,
  kHit,
  kDied,
  kCollided,
  kLeftWorld,
  kWeatherChanged
};
constexpr std::array<EnumName<EventKind>, 9> EnumNames(EventKind) {
  return {{{EventKind::kSpawned, "spawned"},
           {EventKind::kRemoved, "removed"},
           {EventKind::kPursued, "pursued"},
           {EventKind::kAttacked, "attacked"},
           {EventKind::kHit, "hit"},
           {EventKind::kDied, "died"},
           {EventKind::kCollided, "collided"},
           {EventKind::kLeftWorld, "left_world"},
           {EventKind::kWeatherChanged, "weather_changed"}}};
}

struct Event {
  std::uint64_t step = 0;
  EventKind kind = EventKind::kSpawned;
  std::string agent;  // who; empty: the world
  // With or against whom or what; may be empty. kWeatherChanged: "rain begins" when the weather
  // begins to move there, "rain" once it is there.
  std::string other;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
};

// What changes while a world is simulated, after one step. Immutable once handed out.
struct WorldState {
  std::uint64_t step = 0;          // since the simulator was made; never falls, resets included
  double time_s = 0.0;             // step * fixed step
  std::uint64_t episode_step = 0;  // since the last reset
  double episode_time_s = 0.0;
  int contacts = 0;  // of the last step
  Atmosphere atmosphere;
  double weather_change_s = 0.0;      // until the weather stops moving; 0: it does not move
  std::vector<AgentSnapshot> agents;  // sorted by name
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_WORLD_STATE_H_
