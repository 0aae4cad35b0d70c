#include "latticeworld/scene/settlements/street_fronts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

constexpr double kPointSpacing_m = 1.0;
constexpr double kSmoothing_m = 4.0;  // half the width of the mean that takes the steps out
constexpr double kIntoLand_m = 5.0;   // where the land beside an edge is looked at
constexpr double kTangent_m = 3.0;    // half the stretch that a direction is taken from

// Directions along the sides of cells: east, south, west, north.
constexpr int kRowStep[4] = {0, 1, 0, -1};
constexpr int kColStep[4] = {1, 0, -1, 0};

// Paved ground on cells of about a metre.
class PavedCells {
 public:
  explicit PavedCells(const Terrain& terrain)
      : terrain_(terrain),
        stride_(std::max(1, static_cast<int>(kPointSpacing_m / terrain.geometry().resolution_m()))),
        cells_(terrain.geometry().rows() / stride_) {}

  int cells() const { return cells_; }
  bool IsPaved(int row, int col) const {
    if (row < 0 || row >= cells_ || col < 0 || col >= cells_) return false;
    return terrain_.surface(row * stride_ + stride_ / 2, col * stride_ + stride_ / 2) ==
           SurfaceClass::kRoad;
  }
  // A corner between cells: (0, 0) is the north-west corner of the world.
  WorldPoint Corner(double row, double col) const {
    const double cell_m = stride_ * terrain_.geometry().resolution_m();
    const double half_m = terrain_.geometry().half_size_m();
    return {col * cell_m - half_m, half_m - row * cell_m};
  }
  double cell_m() const { return stride_ * terrain_.geometry().resolution_m(); }

 private:
  const Terrain& terrain_;
  int stride_;
  int cells_;  // a side
};

// Follows the edges of paved ground with the paving on the right: the outline of each piece and of
// each block, closed.
class EdgeTracer {
 public:
  explicit EdgeTracer(const PavedCells& paved)
      : paved_(paved), visited_(std::size_t(paved.cells() + 1) * (paved.cells() + 1) * 4, false) {}

  template <typename Visit>
  void ForEachOutline(Visit&& visit) {
    for (int row = 0; row < paved_.cells(); ++row) {
      for (int col = 0; col < paved_.cells(); ++col) {
        // Every outline has a side with paving south of it and none north of it.
        if (!paved_.IsPaved(row, col) || paved_.IsPaved(row - 1, col)) continue;
        if (visited_[EdgeOf(row, col, 0)]) continue;
        visit(Trace(row, col));
      }
    }
  }

 private:
  std::size_t EdgeOf(int row, int col, int direction) const {
    return (static_cast<std::size_t>(row) * (paved_.cells() + 1) + col) * 4 + direction;
  }

  // The cell on the right or left of the side that leaves a corner in a direction.
  bool IsPavedBeside(int row, int col, int direction, bool right) const {
    const int r = direction == 0   ? row - (right ? 0 : 1)
                  : direction == 1 ? row
                  : direction == 2 ? row - (right ? 1 : 0)
                                   : row - 1;
    const int c = direction == 0   ? col
                  : direction == 1 ? col - (right ? 1 : 0)
                  : direction == 2 ? col - 1
                                   : col - (right ? 0 : 1);
    return paved_.IsPaved(r, c);
  }

  std::vector<WorldPoint> Trace(int row, int col) {
    std::vector<WorldPoint> outline;
    int direction = 0;
    while (!visited_[EdgeOf(row, col, direction)]) {
      visited_[EdgeOf(row, col, direction)] = true;
      outline.push_back(
          paved_.Corner(row + 0.5 * kRowStep[direction], col + 0.5 * kColStep[direction]));
      row += kRowStep[direction];
      col += kColStep[direction];
      // Left first, so that cells that touch with their corners are one piece.
      for (const int turn : {3, 0, 1, 2}) {
        const int next = (direction + turn) % 4;
        if (!IsPavedBeside(row, col, next, true) || IsPavedBeside(row, col, next, false)) continue;
        direction = next;
        break;
      }
    }
    return outline;
  }

  const PavedCells& paved_;
  std::vector<bool> visited_;  // of each side of a cell, by the corner that it leaves
};

double LengthOf(const std::vector<WorldPoint>& line) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length_m += std::hypot(line[i].x_m - line[i - 1].x_m, line[i].y_m - line[i - 1].y_m);
  }
  return length_m;
}

// A closed line without the steps of its cells: two moving means.
std::vector<WorldPoint> Smoothed(std::vector<WorldPoint> line, int half_points) {
  const int count = static_cast<int>(line.size());
  const int half = std::min(half_points, (count - 1) / 2);
  for (int round = 0; round < 2; ++round) {
    std::vector<WorldPoint> means(line.size());
    WorldPoint sum;
    for (int k = -half; k <= half; ++k) {
      sum.x_m += line[(k + count) % count].x_m;
      sum.y_m += line[(k + count) % count].y_m;
    }
    for (int i = 0; i < count; ++i) {
      means[i] = {sum.x_m / (2 * half + 1), sum.y_m / (2 * half + 1)};
      const WorldPoint in = line[(i + half + 1) % count], out = line[(i - half + count) % count];
      sum.x_m += in.x_m - out.x_m;
      sum.y_m += in.y_m - out.y_m;
    }
    line = std::move(means);
  }
  return line;
}

}  // namespace

StreetFront::Place StreetFront::At(double along_m) const {
  const auto point_at = [this](double place) {
    place = std::clamp(place, 0.0, line.size() - 1.001);
    const std::size_t i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    return WorldPoint{line[i].x_m + t * (line[i + 1].x_m - line[i].x_m),
                      line[i].y_m + t * (line[i + 1].y_m - line[i].y_m)};
  };
  // Points are evenly spaced.
  const double per_m = (line.size() - 1.0) / length_m;
  const WorldPoint before = point_at((along_m - kTangent_m) * per_m);
  const WorldPoint after = point_at((along_m + kTangent_m) * per_m);
  return {point_at(along_m * per_m), std::atan2(after.y_m - before.y_m, after.x_m - before.x_m)};
}

std::vector<StreetFront> StreetFrontsOf(const Terrain& terrain) {
  std::vector<StreetFront> fronts;
  const WeightGrid* weight = terrain.weights.Find(suburb_letter::kBuilding);
  if (weight == nullptr) return fronts;
  const PavedCells paved(terrain);
  const GridGeometry& geometry = terrain.geometry();
  const int half_points = std::max(1, static_cast<int>(0.5 * kSmoothing_m / paved.cell_m()));
  EdgeTracer(paved).ForEachOutline([&](const std::vector<WorldPoint>& outline) {
    if (outline.size() * paved.cell_m() < kLeastFront_m) return;
    const std::vector<WorldPoint> line = Smoothed(outline, half_points);
    const std::size_t count = line.size();
    std::vector<bool> built(count);
    for (std::size_t i = 0; i < count; ++i) {
      const WorldPoint before = line[(i + count - 1) % count], after = line[(i + 1) % count];
      const double length_m =
          std::max(std::hypot(after.x_m - before.x_m, after.y_m - before.y_m), 1e-9);
      const WorldPoint land = {line[i].x_m - kIntoLand_m * (after.y_m - before.y_m) / length_m,
                               line[i].y_m + kIntoLand_m * (after.x_m - before.x_m) / length_m};
      built[i] = geometry.Contains(land) && (*weight)[geometry.CellAt(land)] >= 0.5f;
    }
    // Runs of built-up points, beginning after a gap where there is one.
    const std::size_t start =
        static_cast<std::size_t>(std::find(built.begin(), built.end(), false) - built.begin()) %
        count;
    StreetFront front;
    const auto finish = [&]() {
      front.length_m = LengthOf(front.line);
      if (front.line.size() >= 3 && front.length_m >= kLeastFront_m) {
        fronts.push_back(std::move(front));
      }
      front = StreetFront();
    };
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = (start + k) % count;
      if (!built[i]) {
        finish();
        continue;
      }
      front.line.push_back(line[i]);
    }
    finish();
  });
  return fronts;
}

}  // namespace latticeworld
