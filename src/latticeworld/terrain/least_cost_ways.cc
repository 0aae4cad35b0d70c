#include "latticeworld/terrain/least_cost_ways.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/terrain/components.h"

namespace latticeworld::internal {

LeastCostWays::LeastCostWays(const Grid<float>& cost, const std::vector<CellIndex>& sources)
    : from_(cost.rows(), cost.cols(), kNowhere) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kDiagonal = 1.41421356f;
  Grid<float> least(cost.rows(), cost.cols(), kInfinity);
  using Entry = std::pair<float, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const CellIndex source : sources) {
    least[source] = 0.0f;
    from_[source] = kSource;
    queue.push({0.0f, source.row * cost.cols() + source.col});
  }
  while (!queue.empty()) {
    const float reached = queue.top().first;
    const int cell = queue.top().second;
    queue.pop();
    if (reached > least.data()[cell]) continue;
    const int row = cell / cost.cols(), col = cell % cost.cols();
    ForEachNeighbour(cost, row, col, [&](int r, int c) {
      if (cost(r, c) == kInfinity) return;
      const float next = reached + cost(r, c) * (r != row && c != col ? kDiagonal : 1.0f);
      if (next >= least(r, c)) return;
      least(r, c) = next;
      from_(r, c) = cell;
      queue.push({next, r * cost.cols() + c});
    });
  }
}

std::vector<CellIndex> LeastCostWays::WayTo(CellIndex cell) const {
  LW_CHECK(Reaches(cell), "a way leads there");
  std::vector<CellIndex> way = {cell};
  for (std::int32_t from = from_[cell]; from != kSource; from = from_[way.back()]) {
    way.push_back({from / from_.cols(), from % from_.cols()});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace latticeworld::internal
