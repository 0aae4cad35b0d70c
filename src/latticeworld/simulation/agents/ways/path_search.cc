#include "latticeworld/simulation/agents/ways/path_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace latticeworld {
namespace {

// Half the lengths of steps to a side and across a corner, in whole numbers; times the hardships of
// both cells.
constexpr std::int64_t kHalfStep = 5000, kHalfDiagonal = 7071;
// What a way through level open ground costs, times its length; the steepest or wettest ground that
// can be gone costs half as much more.
constexpr std::int64_t kEasy = 508;
constexpr std::int64_t kStep = 2 * kHalfStep * kEasy, kDiagonal = 2 * kHalfDiagonal * kEasy;
constexpr std::size_t kFirstSlots = 1 << 14;

std::int64_t Hardship(std::uint8_t ease) { return kEasy + 255 - ease; }

std::int64_t OctileDistance(CellIndex a, CellIndex b) {
  const std::int64_t rows = std::abs(a.row - b.row), cols = std::abs(a.col - b.col);
  return kStep * std::max(rows, cols) + (kDiagonal - kStep) * std::min(rows, cols);
}

// Finalizer of SplitMix64, to spread neighbouring cells over the table.
std::size_t HashOf(std::uint32_t cell) {
  std::uint64_t x = cell + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<std::size_t>(x ^ (x >> 31));
}

}  // namespace

PathSearch::PathSearch() : slots_(kFirstSlots) {}

bool PathSearch::IsLater(const Open& a, const Open& b) {
  if (a.total != b.total) return a.total > b.total;
  if (a.to_goal != b.to_goal) return a.to_goal > b.to_goal;
  return a.cell > b.cell;
}

std::uint32_t& PathSearch::SlotOf(std::uint32_t cell, bool* taken) {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = HashOf(cell) & mask;; i = (i + 1) & mask) {
    Slot& slot = slots_[i];
    *taken = slot.search == search_;
    if (*taken && nodes_[slot.node].cell != cell) continue;
    slot.search = search_;
    return slot.node;
  }
}

void PathSearch::Grow() {
  slots_.assign(2 * slots_.size(), Slot());
  bool taken = false;
  for (std::uint32_t node = 0; node < nodes_.size(); ++node)
    SlotOf(nodes_[node].cell, &taken) = node;
}

void PathSearch::Reach(std::uint32_t cell, std::uint32_t parent, Cost cost, Cost to_goal) {
  if (2 * (nodes_.size() + 1) > slots_.size()) Grow();
  bool taken = false;
  std::uint32_t& slot = SlotOf(cell, &taken);
  if (!taken) {
    slot = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({cell, parent, cost, to_goal, false});
  } else {
    Node& node = nodes_[slot];
    if (node.closed || cost >= node.cost) return;
    node.parent = parent;
    node.cost = cost;
  }
  open_.push_back({cost + to_goal * greed_percent_ / 100, to_goal, cell, slot});
  std::push_heap(open_.begin(), open_.end(), IsLater);
}

CellPath PathSearch::Find(PathLayer* layer, CellIndex from, CellIndex to, int max_nodes,
                          int greed_percent) {
  CellPath path;
  if (!layer->IsFree(from)) return path;
  if (++search_ == 0) {  // after 2^32 searches, marks of old ones would look like those of this one
    std::fill(slots_.begin(), slots_.end(), Slot());
    search_ = 1;
  }
  greed_percent_ = greed_percent;
  nodes_.clear();
  open_.clear();
  const auto cells = static_cast<std::uint32_t>(layer->cells());
  const auto number = [cells](CellIndex cell) {
    return static_cast<std::uint32_t>(cell.row) * cells + static_cast<std::uint32_t>(cell.col);
  };
  const auto cell_of = [cells](std::uint32_t n) {
    return CellIndex{static_cast<int>(n / cells), static_cast<int>(n % cells)};
  };

  // A* closes the open node with the least cost plus weighted distance to go; `best` is the closed
  // node that is nearest to the goal.
  Reach(number(from), 0, 0, OctileDistance(from, to));
  std::uint32_t best = 0;
  while (!open_.empty() && path.expanded < max_nodes) {
    const std::uint32_t index = open_.front().node;
    std::pop_heap(open_.begin(), open_.end(), IsLater);
    open_.pop_back();
    if (nodes_[index].closed) continue;
    nodes_[index].closed = true;
    ++path.expanded;
    const Node node = nodes_[index];
    const Node& nearest = nodes_[best];
    if (node.to_goal < nearest.to_goal ||
        (node.to_goal == nearest.to_goal && node.cost < nearest.cost))
      best = index;
    const CellIndex here = cell_of(node.cell);
    if (here == to) {
      path.complete = true;
      break;
    }

    // The four sides are reached first; a corner only if both sides beside it are free.
    const Cost hardship = Hardship(layer->Ease(here));
    const auto step_to = [&](int rows, int cols, Cost half_length, std::uint8_t ease) {
      const CellIndex next{here.row + rows, here.col + cols};
      const Cost cost = node.cost + half_length * (hardship + Hardship(ease));
      Reach(number(next), index, cost, OctileDistance(next, to));
    };
    const std::uint8_t north = layer->Ease({here.row - 1, here.col});
    const std::uint8_t south = layer->Ease({here.row + 1, here.col});
    const std::uint8_t west = layer->Ease({here.row, here.col - 1});
    const std::uint8_t east = layer->Ease({here.row, here.col + 1});
    if (north != 0) step_to(-1, 0, kHalfStep, north);
    if (south != 0) step_to(1, 0, kHalfStep, south);
    if (west != 0) step_to(0, -1, kHalfStep, west);
    if (east != 0) step_to(0, 1, kHalfStep, east);
    for (const int rows : {-1, 1}) {
      if ((rows < 0 ? north : south) == 0) continue;
      for (const int cols : {-1, 1}) {
        if ((cols < 0 ? west : east) == 0) continue;
        const std::uint8_t ease = layer->Ease({here.row + rows, here.col + cols});
        if (ease != 0) step_to(rows, cols, kHalfDiagonal, ease);
      }
    }
  }

  // The path is read backward from the best node.
  path.cost = static_cast<double>(nodes_[best].cost) / kStep;
  for (std::uint32_t index = best;; index = nodes_[index].parent) {
    path.cells.push_back(cell_of(nodes_[index].cell));
    if (nodes_[index].parent == index) break;
  }
  std::reverse(path.cells.begin(), path.cells.end());
  return path;
}

}  // namespace latticeworld
