#include "latticeworld/language/grounded/course_router.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <queue>
#include <tuple>
#include <vector>

#include "latticeworld/language/grounded/smooth_field.h"

namespace latticeworld {
namespace {

constexpr int kSize = kLayoutSize;

// A cell of the region, on the map's edge where the region has one and is an end of the course.
CellIndex CellIn(Region region, bool at_edge, RandomStream* random) {
  const Heading heading = HeadingOf(region);
  const auto coordinate = [&](int side, int low_share, int high_share) {
    if (side < 0) return random->UniformInt(low_share, high_share);
    if (side > 0) return kSize - 1 - random->UniformInt(low_share, high_share);
    return random->UniformInt(13, 18);
  };
  CellIndex cell{coordinate(heading.south, 2, 8), coordinate(heading.east, 2, 8)};
  if (!at_edge) return cell;
  const bool corner = heading.south != 0 && heading.east != 0;
  const bool on_row = corner ? random->Chance(0.5) : heading.south != 0;
  if (on_row && heading.south != 0) cell.row = heading.south < 0 ? 0 : kSize - 1;
  if (!on_row && heading.east != 0) cell.col = heading.east < 0 ? 0 : kSize - 1;
  return cell;
}

class Router {
 public:
  Router(const CourseWish& wish, Grid<float> noise, const Canvas& canvas)
      : wish_(wish), noise_(std::move(noise)), canvas_(canvas) {}

  // Appends the way from `from` to `to`, without `from`. False when there is none.
  bool Append(CellIndex from, CellIndex to, std::vector<CellIndex>* path) {
    using Entry = std::tuple<double, int>;
    std::vector<double> cost(kSize * kSize, 1e18);
    std::vector<int> parent(kSize * kSize, -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
    cost[Id(from)] = 0.0;
    open.push({0.0, Id(from)});
    while (!open.empty()) {
      const auto [here_cost, here] = open.top();
      open.pop();
      if (here_cost > cost[here]) continue;
      if (here == Id(to)) break;
      for (int i = 0; i < 8; ++i) {
        const CellIndex cell{here / kSize, here % kSize};
        const CellIndex next{cell.row + kNeighbours8[i][0], cell.col + kNeighbours8[i][1]};
        if (!canvas_.Contains(next)) continue;
        const double step = i < 4 ? SideStep(cell, next) : CornerStep(cell, next);
        if (step < 0.0 || here_cost + step >= cost[Id(next)]) continue;
        cost[Id(next)] = here_cost + step;
        parent[Id(next)] = here;
        open.push({cost[Id(next)], Id(next)});
      }
    }
    if (parent[Id(to)] < 0 && from != to) return false;
    const std::size_t start = path->size();
    for (int id = Id(to); id != Id(from); id = parent[id]) {
      path->push_back({id / kSize, id % kSize});
    }
    std::reverse(path->begin() + static_cast<std::ptrdiff_t>(start), path->end());
    return true;
  }

  bool IsOther(CellIndex cell) const {
    return canvas_.locked(cell) && canvas_.at(cell) != wish_.letter;
  }

 private:
  static int Id(CellIndex cell) { return cell.row * kSize + cell.col; }

  double CellCost(CellIndex cell) const {
    double cost = 1.0 + 3.0 * wish_.meander * noise_[cell];
    cost += 6.0 * canvas_.Aversion(wish_.letter, cell);
    const bool border =
        cell.row == 0 || cell.col == 0 || cell.row == kSize - 1 || cell.col == kSize - 1;
    if (border && !wish_.hugs_edge) cost += 4.0;
    if (canvas_.IsForbidden(wish_.letter, cell)) cost += 200.0;
    return cost;
  }

  // A corner of another course: two of its cells meet the cell at a right angle, none opposite.
  bool IsOthersCorner(CellIndex cell) const {
    const auto other = [&](int row, int col) {
      const CellIndex next{cell.row + row, cell.col + col};
      return canvas_.Contains(next) && IsOther(next);
    };
    const int vertical = other(-1, 0) + other(1, 0);
    const int horizontal = other(0, -1) + other(0, 1);
    return IsOther(cell) && vertical == 1 && horizontal == 1;
  }

  // Cost of a step to a cell that shares a side; negative where it is not allowed. Into and out of
  // another course's corner only from its outer sides.
  double SideStep(CellIndex cell, CellIndex next) const {
    if (IsOther(cell) && IsOther(next)) return -1.0;
    if (IsOther(next)) return IsOthersCorner(next) ? 8.0 : -1.0;
    return CellCost(next);
  }

  // A diagonal step crosses another course between its corner and the cell within the corner.
  double CornerStep(CellIndex cell, CellIndex next) const {
    if (!IsOther({cell.row, next.col}) || !IsOther({next.row, cell.col})) return -1.0;
    if (IsOther(next)) return !IsOther(cell) && IsOthersCorner(next) ? 8.0 : -1.0;
    if (IsOther(cell)) return IsOthersCorner(cell) ? CellCost(next) : -1.0;
    return 8.0;
  }

  const CourseWish& wish_;
  Grid<float> noise_;
  const Canvas& canvas_;
};

// The nearest cell to `cell` that no other course holds, row-major among equals.
CellIndex NearestOpen(const Router& router, CellIndex cell) {
  CellIndex best = cell;
  int best_distance = 1 << 20;
  for (int row = 0; row < kSize; ++row) {
    for (int col = 0; col < kSize; ++col) {
      const int distance = std::abs(row - cell.row) + std::abs(col - cell.col);
      if (distance < best_distance && !router.IsOther({row, col})) {
        best = {row, col};
        best_distance = distance;
      }
    }
  }
  return best;
}

// Stops between the ends of a leg, off the straight line to one side and the other by turns.
void AddBends(CellIndex to, double meander, RandomStream* random, std::vector<CellIndex>* stops) {
  const CellIndex from = stops->back();
  const double rows = to.row - from.row;
  const double cols = to.col - from.col;
  const double length = std::hypot(rows, cols);
  const int bends = static_cast<int>(length / (meander > 1.5 ? 6.0 : 9.0));
  double side = random->Chance(0.5) ? 1.0 : -1.0;
  for (int i = 1; i <= bends; ++i) {
    const double along = (i + random->Uniform(-0.2, 0.2)) / (bends + 1);
    const double off = side * meander * random->Uniform(0.8, 1.8);
    side = -side;
    const auto inside = [](double value) {
      return std::clamp(static_cast<int>(std::lround(value)), 1, kSize - 2);
    };
    stops->push_back({inside(from.row + along * rows - off * cols / length),
                      inside(from.col + along * cols + off * rows / length)});
  }
  stops->push_back(to);
}

void Widen(const std::vector<CellIndex>& path, char letter, int piece, Canvas* canvas) {
  for (const CellIndex cell : path) {
    for (const auto& step : {std::pair{0, 1}, std::pair{1, 0}}) {
      const CellIndex next{cell.row + step.first, cell.col + step.second};
      if (canvas->Contains(next) && !canvas->locked(next) && !canvas->IsForbidden(letter, next)) {
        canvas->Paint(next, letter, piece);
      }
    }
  }
}

}  // namespace

bool DrawCourse(const CourseWish& wish, RandomStream* random, Canvas* canvas) {
  Router router(wish, SmoothField(random->NextBits(), 5.0), *canvas);
  std::vector<CellIndex> stops;
  stops.push_back(CellIn(wish.from, true, random));
  const double meander = wish.hugs_edge ? 0.0 : wish.meander;
  for (const Region region : wish.through) {
    AddBends(CellIn(region, wish.hugs_edge, random), meander, random, &stops);
  }
  AddBends(CellIn(wish.to, true, random), meander, random, &stops);
  for (CellIndex& stop : stops) stop = NearestOpen(router, stop);

  std::vector<CellIndex> path = {stops.front()};
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (!router.Append(stops[i - 1], stops[i], &path)) return false;
  }
  const int piece = canvas->NewPiece();
  for (const CellIndex cell : path) {
    canvas->Paint(cell, wish.letter, piece);
    canvas->Lock(cell);
  }
  if (wish.wide) Widen(path, wish.letter, piece, canvas);
  return true;
}

}  // namespace latticeworld
