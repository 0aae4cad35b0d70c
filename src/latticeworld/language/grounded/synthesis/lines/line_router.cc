#include "latticeworld/language/grounded/synthesis/lines/line_router.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <queue>
#include <tuple>

namespace latticeworld {
namespace {

constexpr float kUphill = 60.0f;  // cost of climbing the whole relief

bool Touch(CellIndex a, CellIndex b) {
  return std::abs(a.row - b.row) <= 1 && std::abs(a.col - b.col) <= 1;
}

// The cheapest way (Dijkstra 1959) from `from` to any cell of `to`, both included.
std::vector<CellIndex> Leg(const RouteOptions& options, const LayoutMask& from,
                           const LayoutMask& to) {
  using Entry = std::tuple<float, int>;
  // The search begins at all cells of `from` at once.
  std::array<float, kCellCount> best;
  std::array<int, kCellCount> parent;
  best.fill(1e9f);
  parent.fill(-1);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  for (int id = 0; id < kCellCount; ++id) {
    if (!from.Contains(CellOf(id))) continue;
    best[static_cast<std::size_t>(id)] = 0.0f;
    open.push({0.0f, id});
  }
  while (!open.empty()) {
    const auto [cost, here] = open.top();
    open.pop();
    if (cost > best[static_cast<std::size_t>(here)]) continue;
    const CellIndex cell = CellOf(here);
    // The first cell of `to` that is taken out is the cheapest to reach.
    if (to.Contains(cell)) {
      std::vector<CellIndex> path;
      for (int id = here; id >= 0; id = parent[static_cast<std::size_t>(id)]) {
        path.push_back(CellOf(id));
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (int i = 0; i < 8; ++i) {
      const CellIndex next{cell.row + kNeighbours8[i][0], cell.col + kNeighbours8[i][1]};
      if (!IsInside(next)) continue;
      // Steps cost by the cell that they lead to, and uphill more.
      float step = options.cost[next] * (i < 4 ? 1.0f : 1.41f);
      if (options.height != nullptr) {
        step += kUphill * std::max(0.0f, (*options.height)[next] - (*options.height)[cell]);
      }
      const auto id = static_cast<std::size_t>(IdOf(next));
      if (cost + step >= best[id]) continue;
      best[id] = cost + step;
      parent[id] = here;
      open.push({best[id], IdOf(next)});
    }
  }
  return {};
}

float StepCost(const RouteOptions& options, CellIndex from, CellIndex to) {
  if (options.height == nullptr) return options.cost[to];
  return options.cost[to] +
         kUphill * std::max(0.0f, (*options.height)[to] - (*options.height)[from]);
}

float CostOf(const std::vector<CellIndex>& path, const RouteOptions& options) {
  float sum = 0.0f;
  for (std::size_t i = 1; i < path.size(); ++i) sum += StepCost(options, path[i - 1], path[i]);
  return sum;
}

std::vector<CellIndex> Rounded(const std::vector<CellIndex>& path, int half_width) {
  const int size = static_cast<int>(path.size());
  std::vector<CellIndex> rounded = {path.front()};
  for (int i = 1; i < size; ++i) {
    const int half = std::min({half_width, i, size - 1 - i});
    Spot mean;
    for (int k = i - half; k <= i + half; ++k) {
      mean.row += path[static_cast<std::size_t>(k)].row;
      mean.col += path[static_cast<std::size_t>(k)].col;
    }
    const double count = 2.0 * half + 1.0;
    const std::vector<CellIndex> step =
        StraightCells(rounded.back(), NearestCell({mean.row / count, mean.col / count}));
    rounded.insert(rounded.end(), step.begin() + 1, step.end());
  }
  return Thinned(rounded, 6);
}

// A smooth curve through the cells (Catmull and Rom 1974), rasterized.
std::vector<CellIndex> Curve(const std::vector<CellIndex>& knots) {
  const auto knot = [&](int i) {
    const int inside = std::clamp(i, 0, static_cast<int>(knots.size()) - 1);
    const CellIndex cell = knots[static_cast<std::size_t>(inside)];
    return Spot{static_cast<double>(cell.row), static_cast<double>(cell.col)};
  };
  constexpr int kSamples = 8;
  std::vector<CellIndex> curve = {knots.front()};
  for (int i = 0; i + 1 < static_cast<int>(knots.size()); ++i) {
    const Spot a = knot(i - 1), b = knot(i), c = knot(i + 1), d = knot(i + 2);
    for (int sample = 1; sample <= kSamples; ++sample) {
      const double t = static_cast<double>(sample) / kSamples;
      const auto at = [t](double p0, double p1, double p2, double p3) {
        return 0.5 * (2.0 * p1 + t * (p2 - p0 +
                                      t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 +
                                           t * (3.0 * (p1 - p2) + p3 - p0))));
      };
      const CellIndex cell =
          NearestCell({at(a.row, b.row, c.row, d.row), at(a.col, b.col, c.col, d.col)});
      const std::vector<CellIndex> step = StraightCells(curve.back(), cell);
      curve.insert(curve.end(), step.begin() + 1, step.end());
    }
  }
  return Thinned(curve, 6);
}

}  // namespace

std::vector<CellIndex> StraightCells(CellIndex from, CellIndex to) {
  std::vector<CellIndex> cells;
  const int steps = std::max(std::abs(to.row - from.row), std::abs(to.col - from.col));
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
    cells.push_back(
        NearestCell({from.row + t * (to.row - from.row), from.col + t * (to.col - from.col)}));
  }
  return cells;
}

std::vector<CellIndex> Thinned(const std::vector<CellIndex>& path, int reach) {
  std::vector<CellIndex> thin;
  const int size = static_cast<int>(path.size());
  for (int i = 0; i < size;) {
    thin.push_back(path[static_cast<std::size_t>(i)]);
    int next = i + 1;
    for (int k = std::min(size - 1, i + reach); k > i + 1; --k) {
      if (Touch(path[static_cast<std::size_t>(i)], path[static_cast<std::size_t>(k)])) {
        next = k;
        break;
      }
    }
    i = next;
  }
  return thin;
}

std::vector<CellIndex> Route(const RouteOptions& options) {
  std::vector<CellIndex> path;
  std::vector<CellIndex> knots;
  LayoutMask from = options.stops.front();
  for (std::size_t i = 1; i < options.stops.size(); ++i) {
    const std::vector<CellIndex> leg = Leg(options, from, options.stops[i]);
    if (leg.empty()) return {};
    if (knots.empty()) knots.push_back(leg.front());
    if (leg.back() != knots.back()) knots.push_back(leg.back());
    path.insert(path.end(), leg.begin() + (path.empty() ? 0 : 1), leg.end());
    from = LayoutMask();
    from.Add(path.back());
  }
  path = Thinned(path, 8);
  if (knots.size() > 2) {
    std::vector<CellIndex> curve = Curve(knots);
    if (CostOf(curve, options) <= 1.35f * CostOf(path, options) + 2.0f) return curve;
  }
  for (int half_width = 2; half_width >= 1; --half_width) {
    std::vector<CellIndex> rounded = Rounded(path, half_width);
    if (CostOf(rounded, options) > 1.1f * CostOf(path, options) + 1.0f) continue;
    return rounded;
  }
  return path;
}

}  // namespace latticeworld
