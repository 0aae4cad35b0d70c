#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_AGENT_GRID_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_AGENT_GRID_H_

#include <cstdint>
#include <map>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/simulation/agents/agent.h"

namespace latticeworld {

// Who is where: agents in square cells, so that a look around costs what is near.
class AgentGrid {
 public:
  AgentGrid() = default;
  // Holds every agent, the dead too, as they are now.
  AgentGrid(double world_size_m, const std::map<AgentId, Agent>& agents) {
    Rebuild(world_size_m, agents);
  }
  // The same in the memory that it has already.
  void Rebuild(double world_size_m, const std::map<AgentId, Agent>& agents);

  // Calls visit(const Agent&) for those whose place is within radius_m of the point, in increasing
  // order of cell, then id. The agents must be those that it was made of, at the same addresses;
  // what they have become since is what is visited, their places are those of then.
  template <typename Visit>
  void ForEachNear(WorldPoint point, double radius_m, Visit&& visit) const;

 private:
  struct Entry {
    WorldPoint place;
    const Agent* agent;
  };
  int CellOf(double coordinate_m) const;

  double half_size_m_ = 0.0;
  double cell_m_ = 16.0;
  int cells_ = 0;                          // a side
  std::vector<std::uint32_t> cell_begin_;  // (cells^2 + 1) offsets into entries_
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> cell_of_;  // by agent, in the order of ids; while it is made
};

template <typename Visit>
void AgentGrid::ForEachNear(WorldPoint point, double radius_m, Visit&& visit) const {
  if (entries_.empty()) return;
  const int x_low = CellOf(point.x_m - radius_m), x_high = CellOf(point.x_m + radius_m);
  const int y_low = CellOf(point.y_m - radius_m), y_high = CellOf(point.y_m + radius_m);
  for (int y = y_low; y <= y_high; ++y) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_);
    for (int x = x_low; x <= x_high; ++x) {
      const std::size_t cell = row + static_cast<std::size_t>(x);
      for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
        const double dx = entries_[i].place.x_m - point.x_m;
        const double dy = entries_[i].place.y_m - point.y_m;
        if (dx * dx + dy * dy <= radius_m * radius_m) visit(*entries_[i].agent);
      }
    }
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_AGENT_GRID_H_
