#ifndef LATTICEWORLD_SIMULATION_AGENTS_AGENT_H_
#define LATTICEWORLD_SIMULATION_AGENTS_AGENT_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

using AgentId = std::uint32_t;  // counts up within an episode; 0 is nobody

// Where an agent's legs, wings or fins are told to take it.
struct Steering {
  double heading_rad = 0.0;
  double speed_mps = 0.0;            // 0: stands, and keeps its heading
  std::optional<double> base_z_m{};  // wings and fins: wanted height of base_link, map frame
  std::optional<WorldPoint> hold{};  // wings and fins: keeps to this place, against wind and drift
};

// What an agent has in mind from one thought to the next. Times are episode steps.
struct Mind {
  explicit Mind(RandomStream own_random) : random(own_random) {}

  RandomStream random;
  WorldPoint home;
  double home_z_m = 0.0;
  std::vector<WorldPoint> route;  // patrol, in a loop
  std::size_t next_place = 0;
  std::optional<WorldPoint> goal{};
  std::uint64_t goal_until = 0;   // gives the goal up then
  std::uint64_t pause_until = 0;  // stands until then
  int turn_side = 1;              // side on which it last went around something
  AgentId target = 0;
  WorldPoint target_seen_at;
  std::uint64_t target_seen_step = 0;
  std::uint64_t next_blow = 0;
  Steering steering;
};

struct Agent {
  Agent(AgentId own_id, RandomStream random) : id(own_id), mind(random) {}

  AgentId id;
  std::string name;
  AgentCategory category = AgentCategory::kSheep;
  AgentState state = AgentState::kIdle;
  int team = 0;
  bool controllable = false;
  BodyId body = 0;
  double radius_m = 0.0;
  double hit_points = 1.0;
  Behaviour behaviour = Behaviour::kIdle;
  Mind mind;
  std::optional<VelocityCommand> command{};  // clamped to the species' limits
  std::uint64_t command_until = 0;           // episode step
  VelocityCommand driven;                    // what the locomotion has ramped up to
  BodyMotion motion;                         // after the last step
  std::uint64_t next_collision = 0;          // collisions before this step are not told again

  bool alive() const { return hit_points > 0.0; }
  WorldPoint place() const { return {motion.position_m.x(), motion.position_m.y()}; }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_AGENT_H_
