#include "latticeworld/reference_navigator/travel_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace latticeworld {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kRowStep[8] = {-1, 1, 0, 0, -1, -1, 1, 1};
constexpr int kColStep[8] = {0, 0, -1, 1, -1, 1, -1, 1};
constexpr float kDiagonal = 1.41421356f;

bool IsOpen(const Grid<float>& prices, int row, int col) {
  return prices.Contains({row, col}) && prices(row, col) != kClosedCell;
}

// Whether one can step from a cell to its neighbour `k`.
bool MayStep(const Grid<float>& prices, CellIndex from, int k) {
  const int row = from.row + kRowStep[k], col = from.col + kColStep[k];
  if (!IsOpen(prices, row, col)) return false;
  return k < 4 || (IsOpen(prices, from.row, col) && IsOpen(prices, row, from.col));
}

// Cells by what they cost, in buckets of half a cell's width: whatever leaves a bucket can only
// come into the same or a later one.
class BucketQueue {
 public:
  explicit BucketQueue(double resolution_m) : inverse_(2.0 / resolution_m) {}
  void Push(float cost_m, std::uint32_t cell) {
    const auto bucket = static_cast<std::size_t>(cost_m * inverse_);
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 64);
    buckets_[bucket].push_back({cost_m, cell});
  }
  struct Entry {
    float cost_m;
    std::uint32_t cell;
  };
  // False: it is empty.
  bool Pop(Entry* entry) {
    while (at_ < buckets_.size() && buckets_[at_].empty()) ++at_;
    if (at_ == buckets_.size()) return false;
    *entry = buckets_[at_].back();
    buckets_[at_].pop_back();
    return true;
  }

 private:
  double inverse_;
  std::vector<std::vector<Entry>> buckets_;
  std::size_t at_ = 0;
};

}  // namespace

TravelField SpreadFrom(const std::vector<TravelSeed>& seeds, const Grid<float>& prices,
                       double resolution_m, const CellIndex* enough) {
  const int rows = prices.rows(), cols = prices.cols();
  // The grid has a closed cell all round, so that no neighbour is outside.
  const int width = cols + 2;
  const auto place = [width](CellIndex cell) {
    return static_cast<std::uint32_t>((cell.row + 1) * width + cell.col + 1);
  };
  std::vector<float> price(static_cast<std::size_t>(width) * (rows + 2), kClosedCell);
  std::vector<float> cost(price.size(), kInfinity);
  for (int row = 0; row < rows; ++row) {
    std::copy_n(prices.data() + static_cast<std::size_t>(row) * cols, cols,
                price.begin() + place({row, 0}));
  }

  // Costs spread from the seeds, the least first (Dijkstra 1959).
  BucketQueue queue(resolution_m);
  for (const TravelSeed& seed : seeds) {
    if (!prices.Contains(seed.cell) || prices[seed.cell] == kClosedCell) continue;
    float& known = cost[place(seed.cell)];
    if (!(seed.cost_m < known)) continue;
    known = seed.cost_m;
    queue.Push(seed.cost_m, place(seed.cell));
  }
  const auto half = static_cast<float>(0.5 * resolution_m);
  float limit = kInfinity;
  for (BucketQueue::Entry entry; queue.Pop(&entry);) {
    const std::uint32_t at = entry.cell;
    if (entry.cost_m > cost[at]) continue;  // it was reached for less
    if (entry.cost_m > limit) break;
    // Its way down may lead over cells of the same bucket that are not settled yet.
    if (enough != nullptr && at == place(*enough)) limit = entry.cost_m + 2.0f * half;
    // A step costs half of each cell's price for its length; diagonals need both sides open.
    const auto step = [&](std::uint32_t next, float length) {
      const float cost_m = entry.cost_m + length * half * (price[at] + price[next]);
      if (!(cost_m < cost[next])) return;
      cost[next] = cost_m;
      queue.Push(cost_m, next);
    };
    const auto open = [&](std::uint32_t next) { return price[next] != kClosedCell; };
    const std::uint32_t north = at - width, south = at + width, west = at - 1, east = at + 1;
    const bool n = open(north), s = open(south), w = open(west), e = open(east);
    if (n) step(north, 1.0f);
    if (s) step(south, 1.0f);
    if (w) step(west, 1.0f);
    if (e) step(east, 1.0f);
    if (n && w && open(north - 1)) step(north - 1, kDiagonal);
    if (n && e && open(north + 1)) step(north + 1, kDiagonal);
    if (s && w && open(south - 1)) step(south - 1, kDiagonal);
    if (s && e && open(south + 1)) step(south + 1, kDiagonal);
  }

  // The field is cut out of the grid again.
  TravelField field;
  field.resolution_m = resolution_m;
  field.cost_m = Grid<float>(rows, cols);
  for (int row = 0; row < rows; ++row) {
    std::copy_n(cost.begin() + place({row, 0}), cols,
                field.cost_m.data() + static_cast<std::size_t>(row) * cols);
  }
  return field;
}

std::vector<CellIndex> Descend(const TravelField& field, const Grid<float>& prices,
                               CellIndex start) {
  std::vector<CellIndex> way;
  if (!field.cost_m.Contains(start) || !std::isfinite(field.cost_m[start])) return way;
  way.push_back(start);
  for (;;) {
    const CellIndex at = way.back();
    CellIndex best = at;
    float steepest = 0.0f;
    for (int k = 0; k < 8; ++k) {
      if (!MayStep(prices, at, k)) continue;
      const CellIndex next{at.row + kRowStep[k], at.col + kColStep[k]};
      const float fall = (field.cost_m[at] - field.cost_m[next]) / (k < 4 ? 1.0f : kDiagonal);
      if (!(fall > steepest)) continue;
      steepest = fall;
      best = next;
    }
    if (best == at) return way;
    way.push_back(best);
  }
}

bool IsStraightOpen(const Grid<float>& prices, CellIndex from, CellIndex to, float limit) {
  // Every cell that the line touches, with both at a corner that it passes through.
  const int rows = std::abs(to.row - from.row), cols = std::abs(to.col - from.col);
  const int row_step = to.row > from.row ? 1 : -1, col_step = to.col > from.col ? 1 : -1;
  int error = cols - rows;
  const auto fits = [&](CellIndex cell) {
    const float price = prices[cell];
    return price != kClosedCell && price <= limit;
  };
  CellIndex at = from;
  if (!fits(at)) return false;
  for (int left = rows + cols; left > 0;) {
    if (error == 0 && left >= 2) {
      if (!fits({at.row + row_step, at.col}) || !fits({at.row, at.col + col_step})) return false;
      at.row += row_step;
      at.col += col_step;
      error += 2 * (cols - rows);
      left -= 2;
    } else if (error > 0) {
      at.col += col_step;
      error -= 2 * rows;
      --left;
    } else {
      at.row += row_step;
      error += 2 * cols;
      --left;
    }
    if (!fits(at)) return false;
  }
  return true;
}

std::vector<CellIndex> PulledStraight(const std::vector<CellIndex>& way,
                                      const Grid<float>& prices) {
  if (way.size() < 3) return way;
  std::vector<CellIndex> corners = {way.front()};
  std::size_t from = 0;
  while (from + 1 < way.size()) {
    std::size_t to = from + 1;
    float limit = std::max(prices[way[from]], prices[way[to]]);
    for (std::size_t next = from + 2; next < way.size(); ++next) {
      limit = std::max(limit, prices[way[next]]);
      if (!IsStraightOpen(prices, way[from], way[next], limit)) {
        // Farther corners may be seen again, but a way that winds is not searched to its end.
        if (next - to > 40) break;
        continue;
      }
      to = next;
    }
    corners.push_back(way[to]);
    from = to;
  }
  return corners;
}

}  // namespace latticeworld
