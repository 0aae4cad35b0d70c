#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_MIND_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_MIND_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

using AgentId = std::uint32_t;  // counts up within an episode; 0 is nobody

// What an agent's thoughts want of its body until the next one.
struct Steering {
  double heading_rad = 0.0;
  // 0: stands, and keeps its heading; below 0: backs up while it turns to the heading.
  double speed_mps = 0.0;
  std::optional<double> base_z_m{};  // flyers, swimmers: wanted height of base_link, map frame
  std::optional<WorldPoint>
      hold{};          // flyers, swimmers: keeps to this place, against wind and drift
  AgentId strike = 0;  // blow to be struck; 0: none
};

// What it remembers of another agent.
struct Sighting {
  AgentId who = 0;
  int team = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();    // when last perceived
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  // then; zero when only heard
  std::uint64_t step = 0;                                  // episode step when last perceived
  bool seen_now = false;                                   // in the last look
  bool only_heard = false;                                 // the last time
};

// A way that path finding found.
struct PathPlan {
  std::vector<WorldPoint> points;  // corners still to be passed, the goal last; empty: no plan
  WorldPoint goal;                 // asked for; points end at the nearest place that can be reached
  bool complete = false;           // ends at the goal
  std::uint64_t made_at = 0;       // episode step
  std::uint64_t map_version = 0;   // of WorldState

  // How it gets on along it.
  double nearest_m = 0.0;            // that it has been to its next corner
  std::uint64_t nearest_at = 0;      // episode step; when that was
  std::uint64_t followed_at = 0;     // episode step
  std::uint64_t sidestep_until = 0;  // episode step; stuck: tries its luck to one side until then
};

// The search for a hiding place, spread over thoughts.
struct AmbushPlan {
  std::vector<WorldPoint> watched;  // where others may pass; empty: not begun
  int tries = 0;                    // places that it has looked at
  int fewest = 0;                   // of the watched places, that see the best one
  std::optional<WorldPoint> best{};
};

// What an agent has in mind from one thought to the next. Times are episode steps. Plain data: the
// pieces that behaviours are composed of keep what they remember here and nowhere else.
struct Mind {
  explicit Mind(RandomStream own_random) : random(own_random) {}

  RandomStream random;
  WorldPoint home;
  double home_z_m = 0.0;
  std::vector<Sighting> memory;   // by who
  std::vector<WorldPoint> route;  // patrol, in a loop
  std::size_t next_place = 0;
  std::optional<WorldPoint> goal{};
  std::uint64_t goal_until = 0;   // gives the goal up then
  std::uint64_t pause_until = 0;  // stands until then
  PathPlan path;
  int turn_side = 1;  // side on which it last went around something
  AgentId target = 0;
  AgentId hit_by = 0;                // who struck it last
  std::uint64_t hit_at = 0;          // when; 0: never
  std::uint64_t alarmed_until = 0;   // flees or retreats until then
  std::uint64_t searched_until = 0;  // searches the last seen place until then
  std::uint64_t closes_at = 0;       // encirclement: goes in then; 0: has not begun
  AmbushPlan ambush;
  std::optional<WorldPoint> hide{};  // ambush: where it waits; none: it is still looking for it
  Steering steering;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_MIND_H_
