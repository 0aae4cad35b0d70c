#include "latticeworld/relief/sketch/cheapest_ways.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace latticeworld::internal {
namespace {

struct Step {
  int row;
  int col;
  float half_length;  // [cells]
};
constexpr Step kSteps[8] = {{-1, -1, 0.70710678f}, {-1, 0, 0.5f},      {-1, 1, 0.70710678f},
                            {0, -1, 0.5f},         {0, 1, 0.5f},       {1, -1, 0.70710678f},
                            {1, 0, 0.5f},          {1, 1, 0.70710678f}};

// Cells by what they cost, in a ring of one list for each cost from the cheapest on (Dial 1969,
// "Algorithm 360: shortest-path forest with topological ordering").
class CostQueue {
 public:
  // span: no two costs in the queue ever lie that far apart.
  explicit CostQueue(std::int32_t span) : newest_(span, kNone) {}

  void Push(std::int32_t cost, std::int32_t cell) {
    std::int32_t& newest = List(cost);
    entries_.push_back({cell, newest});
    newest = static_cast<std::int32_t>(entries_.size()) - 1;
    ++waiting_;
  }
  // Takes out the cheapest; false when there is none.
  bool Pop(std::int32_t* cost, std::int32_t* cell) {
    if (waiting_ == 0) return false;
    while (List(cheapest_) == kNone) ++cheapest_;
    std::int32_t& newest = List(cheapest_);
    *cost = cheapest_;
    *cell = entries_[newest].cell;
    newest = entries_[newest].next;
    --waiting_;
    return true;
  }

 private:
  static constexpr std::int32_t kNone = -1;
  struct Entry {
    std::int32_t cell;
    std::int32_t next;  // of the same cost
  };

  std::int32_t& List(std::int32_t cost) {
    return newest_[cost % static_cast<std::int32_t>(newest_.size())];
  }

  std::vector<std::int32_t> newest_;
  std::vector<Entry> entries_;
  std::int32_t cheapest_ = 0;
  std::size_t waiting_ = 0;
};

}  // namespace

Ways CheapestWays(const Grid<std::int32_t>& cost, const Grid<std::int32_t>& part,
                  const std::vector<std::int32_t>& start) {
  const int cols = cost.cols();
  // A step costs at most one and a half times the dearest cell.
  std::int32_t span = 2 * *std::max_element(cost.begin(), cost.end()) + 2;
  for (const std::int32_t price : start) {
    if (price != kNever) span = std::max(span, price + 1);
  }
  CostQueue queue(span);
  Ways ways;
  ways.receiver.resize(cost.size());
  ways.order.reserve(cost.size());
  // What the cheapest way known so far costs. Ways into a part from outside wait in the queue with
  // their price: the first that comes out is the part's, and only then do its cells get a total.
  std::vector<std::int32_t> total = start;
  for (std::size_t i = 0; i < total.size(); ++i) {
    ways.receiver[i] = static_cast<std::int32_t>(i);
    if (total[i] != kNever) queue.Push(total[i], static_cast<std::int32_t>(i));
  }
  std::vector<std::int32_t> outside(cost.size(), kNever);
  std::vector<unsigned char> left(
      static_cast<std::size_t>(*std::max_element(part.begin(), part.end())) + 1, 0);
  std::vector<unsigned char> settled(cost.size(), 0);
  std::int32_t reached = 0;
  std::int32_t cell = 0;
  while (queue.Pop(&reached, &cell)) {
    const std::int32_t here = part.data()[cell];
    const bool first_of_part = here != 0 && left[here] == 0;
    if (settled[cell] != 0 || (!first_of_part && reached != total[cell])) continue;
    settled[cell] = 1;
    left[here] = here != 0;
    ways.order.push_back(cell);
    const int row = cell / cols;
    const int col = cell % cols;
    for (const Step& step : kSteps) {
      const CellIndex next{row + step.row, col + step.col};
      if (!cost.Contains(next)) continue;
      const std::int32_t index = next.row * cols + next.col;
      if (settled[index] != 0) continue;
      const std::int32_t there = part[next];
      const bool enters = there != 0 && there != here;
      if (enters && left[there] != 0) continue;
      const auto both = static_cast<float>(cost[next] + cost.data()[cell]);
      const std::int32_t price = reached + static_cast<std::int32_t>(step.half_length * both);
      std::int32_t& known = enters ? outside[index] : total[index];
      // A source inside a part that has not been reached yet may start more cheaply by itself.
      if (price >= known || (enters && price >= total[index])) continue;
      known = price;
      ways.receiver[index] = cell;
      queue.Push(price, index);
    }
  }
  return ways;
}

}  // namespace latticeworld::internal
