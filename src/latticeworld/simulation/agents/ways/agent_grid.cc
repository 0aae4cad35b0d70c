#include "latticeworld/simulation/agents/ways/agent_grid.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr double kCell_m = 16.0;    // about as far as most looks around reach
constexpr int kMaxCellsASide = 96;  // a side: large worlds must not cost for being empty

}  // namespace

void AgentGrid::Rebuild(double world_size_m, const std::map<AgentId, Agent>& agents) {
  LW_CHECK(world_size_m > 0.0, "a world has a size");
  half_size_m_ = 0.5 * world_size_m;
  cells_ = std::clamp(static_cast<int>(std::ceil(world_size_m / kCell_m)), 1, kMaxCellsASide);
  cell_m_ = world_size_m / cells_;

  // A counting sort by cell keeps the agents of one cell in the order of their ids.
  cell_begin_.assign(static_cast<std::size_t>(cells_) * cells_ + 1, 0);
  cell_of_.clear();
  for (const auto& [id, agent] : agents) {
    const WorldPoint place = agent.place();
    const auto cell = static_cast<std::uint32_t>(CellOf(place.y_m) * cells_ + CellOf(place.x_m));
    cell_of_.push_back(cell);
    ++cell_begin_[cell];
  }
  for (std::size_t i = 1; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
  entries_.resize(agents.size());
  // Agents are sorted in from the last id to the first: every cell's end walks back to its begin.
  std::size_t i = agents.size();
  for (auto agent = agents.rbegin(); agent != agents.rend(); ++agent)
    entries_[--cell_begin_[cell_of_[--i]]] = {agent->second.place(), &agent->second};
}

int AgentGrid::CellOf(double coordinate_m) const {
  const double cell = std::floor((coordinate_m + half_size_m_) / cell_m_);
  if (!(cell > 0.0)) return 0;  // NaN too
  return static_cast<int>(std::min(cell, cells_ - 1.0));
}

}  // namespace latticeworld
