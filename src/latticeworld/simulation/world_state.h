#ifndef LATTICEWORLD_SIMULATION_WORLD_STATE_H_
#define LATTICEWORLD_SIMULATION_WORLD_STATE_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

// What an agent is doing.
enum class Behaviour : std::uint8_t {
  kIdle,
  kWander,
  kPatrol,
  kGraze,
  kSwim,
  kSoar,
  kFlee,
  kGuard,
  kPursue,
  kSearch,
  kAmbush,
  kEncircle,
  kAttack,
  kRetreat,
  kControlled,
  kFallen,
  kDead
};
constexpr std::array<EnumName<Behaviour>, 17> EnumNames(Behaviour) {
  return {{{Behaviour::kIdle, "idle"},
           {Behaviour::kWander, "wander"},
           {Behaviour::kPatrol, "patrol"},
           {Behaviour::kGraze, "graze"},
           {Behaviour::kSwim, "swim"},
           {Behaviour::kSoar, "soar"},
           {Behaviour::kFlee, "flee"},
           {Behaviour::kGuard, "guard"},
           {Behaviour::kPursue, "pursue"},
           {Behaviour::kSearch, "search"},
           {Behaviour::kAmbush, "ambush"},
           {Behaviour::kEncircle, "encircle"},
           {Behaviour::kAttack, "attack"},
           {Behaviour::kRetreat, "retreat"},
           {Behaviour::kControlled, "controlled"},
           {Behaviour::kFallen, "fallen"},
           {Behaviour::kDead, "dead"}}};
}

struct JointSnapshot {
  std::string name;  // "front_left_wheel", "rear_right_knee"
  double angle_rad = 0.0;
  double rate_radps = 0.0;
  double effort_nm = 0.0;
};

struct AgentSnapshot {
  std::string name;
  AgentCategory category = AgentCategory::kSheep;
  std::string species;
  std::string policy;  // empty: it has none
  int team = 0;
  bool controllable = false;
  Behaviour behaviour = Behaviour::kIdle;
  double health = 1.0;  // [0, 1]
  // map_from_base: base_link stands at the body's lowest point at rest, x forward, z up.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d linear_velocity_mps = Eigen::Vector3d::Zero();     // in base_link
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();  // in base_link
  // The force of the hardest bump of the last step with what it does not stand on; only for agents
  // that obey commands.
  double contact_force_n = 0.0;
  Eigen::Vector3d contact_direction = Eigen::Vector3d::Zero();  // to it, in base_link; zero: none
  std::vector<JointSnapshot> joints;  // wheels and steering, or legs; of controllable agents alone
};

struct PropSnapshot {
  std::string name;
  PropKind kind = PropKind::kCrate;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // map_from_prop
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
  double opening_rad = 0.0;  // gates: 0 is closed
  bool broken = false;       // bridges, posts: it gave way
};

// A tree that fell or is falling.
struct FelledTree {
  FallenTree tree;  // as it is now
  bool at_rest = false;
};

enum class EventKind : std::uint8_t {
  kSpawned,
  kRemoved,
  kRespawned,
  kPursued,
  kAttacked,
  kHit,
  kKnockedOver,
  kDied,
  kDrowned,
  kCollided,
  kFelledTree,
  kTreeCameToRest,
  kBroke,
  kOpened,
  kClosed,
  kSlowed,
  kFrozen,
  kLeftWorld,
  kWeatherChanged
};
constexpr std::array<EnumName<EventKind>, 19> EnumNames(EventKind) {
  return {{{EventKind::kSpawned, "spawned"},
           {EventKind::kRemoved, "removed"},
           {EventKind::kRespawned, "respawned"},
           {EventKind::kPursued, "pursued"},
           {EventKind::kAttacked, "attacked"},
           {EventKind::kHit, "hit"},
           {EventKind::kKnockedOver, "knocked_over"},
           {EventKind::kDied, "died"},
           {EventKind::kDrowned, "drowned"},
           {EventKind::kCollided, "collided"},
           {EventKind::kFelledTree, "felled_tree"},
           {EventKind::kTreeCameToRest, "tree_came_to_rest"},
           {EventKind::kBroke, "broke"},
           {EventKind::kOpened, "opened"},
           {EventKind::kClosed, "closed"},
           {EventKind::kSlowed, "slowed"},
           {EventKind::kFrozen, "frozen"},
           {EventKind::kLeftWorld, "left_world"},
           {EventKind::kWeatherChanged, "weather_changed"}}};
}

struct Event {
  std::uint64_t step = 0;
  EventKind kind = EventKind::kSpawned;
  std::string agent;  // who: an agent or a prop; empty: the world
  // The agent, prop or thing with or against which it happened; may be empty. kWeatherChanged:
  // "rain begins" when the weather begins to move there, "rain" once it is there. kFelledTree,
  // kTreeCameToRest: "tree_<asset>".
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
  std::vector<PropSnapshot> props;    // sorted by name
  std::vector<FelledTree> felled;     // by asset
  // The props as maps show them; null: where the scene has them.
  std::shared_ptr<const StandingProps> standing;
  // What maps show of what weather made of the ground; none: what the scene has.
  std::optional<GroundState> map_ground;
  // Grows whenever what maps show has changed: a tree has come to rest, or one that lies has moved
  // or left the world; a prop came, went or broke, was opened or closed, or stands still more
  // than half a cell from where it was on maps; weather has changed how steep bodies climb on some
  // surface by more than 0.02 rad, or has come to its end with another ground than maps show.
  std::uint64_t map_version = 0;
};
// What maps and ray scenes made now should show: trees at rest where they lie, and none of those
// that still fall; props where they stood still last.
SceneChanges ChangesOf(const WorldState& state);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_WORLD_STATE_H_
