#include "latticeworld/simulation/agents/minds/herd.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/minds/nearest_few.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"

namespace latticeworld {
namespace {

constexpr double kHerd_m = 40.0;
// An animal keeps this much room to itself beside its own and the other's radius: what it grazes
// next.
constexpr double kOwnRoom_m = 1.5;
// Animals of a flock look at their nearest few, however dense it is (Ballerini et al. 2008,
// Interaction ruling animal collective behavior depends on topological rather than metric
// distance, PNAS 105: six to seven).
constexpr std::size_t kNeighbours = 7;
// Cohesion begins at this distance from the middle of the neighbours and is whole at the other.
constexpr double kContent_m = 5.0, kAstray_m = 15.0;

bool IsOfItsHerd(const Agent& agent, const Agent& other) {
  return other.id != agent.id && other.species == agent.species && other.alive();
}

Eigen::Vector2d PlaceOf(const Agent& agent) { return agent.motion.position_m.head<2>(); }

// Adds as much of the wish as the length of 1 leaves room for.
void Grant(const Eigen::Vector2d& wish, double* left, Eigen::Vector2d* sum) {
  const double length = wish.norm();
  if (length <= 0.0 || *left <= 0.0) return;
  const double granted = std::min(length, *left);
  *sum += granted / length * wish;
  *left -= granted;
}

}  // namespace

Eigen::Vector2d Flocking(const Agent& agent, const Surroundings& world) {
  NearestFew<kNeighbours> nearest;
  const Eigen::Vector2d here = PlaceOf(agent);
  world.near->ForEachNear(agent.place(), kHerd_m, [&](const Agent& other) {
    if (IsOfItsHerd(agent, other)) nearest.Offer(other, (PlaceOf(other) - here).norm());
  });
  if (nearest.empty()) return Eigen::Vector2d::Zero();

  const double room_m = 2.0 * agent.species->radius_m + kOwnRoom_m;
  Eigen::Vector2d apart = Eigen::Vector2d::Zero(), middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();
  for (const auto& [distance_m, other] : nearest) {
    const Eigen::Vector2d off_m = here - PlaceOf(*other);
    // Two in one place part along x, by who came first.
    const Eigen::Vector2d away = distance_m > 1e-6
                                     ? Eigen::Vector2d(off_m / distance_m)
                                     : Eigen::Vector2d(agent.id < other->id ? -1.0 : 1.0, 0.0);
    apart += std::max(0.0, 1.0 - distance_m / room_m) * away;
    middle += PlaceOf(*other);
    velocity_mps += other->motion.linear_velocity_mps.head<2>();
  }
  const double of_count = 1.0 / static_cast<double>(nearest.size());
  middle *= of_count;
  velocity_mps *= of_count;

  double left = 1.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Grant(apart, &left, &sum);
  Grant(0.5 / std::max(0.1, agent.species->cruise_mps) * velocity_mps, &left, &sum);
  const Eigen::Vector2d to_middle_m = middle - here;
  const double far_m = to_middle_m.norm();
  if (far_m > kContent_m) {
    const double urgency = std::min(1.0, (far_m - kContent_m) / (kAstray_m - kContent_m));
    Grant(urgency / far_m * to_middle_m, &left, &sum);
  }
  return sum;
}

}  // namespace latticeworld
