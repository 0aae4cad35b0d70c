#include "latticeworld/reference_navigator/local_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/reference_navigator/obstacle_layer.h"

namespace latticeworld {
namespace {

constexpr float kEscape = 20.0f;    // price of cells that the robot is in and should not be in
constexpr double kComfort_m = 0.4;  // beyond the radius, where nearness to what is seen ends

// Cells of the square's side: within the window of what is seen, and no more than a period allows.
int CellsOf(const NavigatorOptions& options) {
  const int within = static_cast<int>(options.local_size_m / LocalPlan::kCell_m + 1e-6) - 8;
  return std::min(within, 120);
}

}  // namespace

CellIndex LocalPlan::CellOf(WorldPoint point) const {
  return {static_cast<int>(std::floor((corner_.y_m - point.y_m) / kCell_m)),
          static_cast<int>(std::floor((point.x_m - corner_.x_m) / kCell_m))};
}

WorldPoint LocalPlan::CenterOf(CellIndex cell) const {
  return {corner_.x_m + (cell.col + 0.5) * kCell_m, corner_.y_m - (cell.row + 0.5) * kCell_m};
}

LocalPlan::LocalPlan(const GlobalPlan& global, const ObstacleLayer& seen,
                     const NavigatorOptions& options, WorldPoint robot)
    : cells_(CellsOf(options)),
      corner_{robot.x_m - 0.5 * cells_ * kCell_m, robot.y_m + 0.5 * cells_ * kCell_m},
      prices_(cells_, cells_, kClosedCell) {
  // Prices are the global ones, more near what is seen; closed cells around the robot only cost
  // much, so that it can escape.
  const double room_m = options.robot.radius_m + options.margin_m;
  const double escape_m = options.robot.radius_m + kCell_m;
  for (int row = 0; row < cells_; ++row) {
    for (int col = 0; col < cells_; ++col) {
      const WorldPoint at = CenterOf({row, col});
      if (!global.geometry.Contains(at)) continue;
      float price = global.prices[global.geometry.CellAt(at)];
      const double distance_m = seen.DistanceAt(at);
      const bool closed = price == kClosedCell || distance_m < room_m;
      if (closed) {
        if (std::hypot(at.x_m - robot.x_m, at.y_m - robot.y_m) > escape_m) continue;
        price = kEscape;
      } else if (distance_m < room_m + kComfort_m) {
        price += static_cast<float>(2.0 * (1.0 - (distance_m - room_m) / kComfort_m));
      }
      prices_(row, col) = price;
    }
  }
  // The window's border has the costs of the global way, and the goal costs nothing.
  std::vector<TravelSeed> seeds;
  const auto seed = [&](CellIndex cell) {
    const WorldPoint at = CenterOf(cell);
    if (!global.geometry.Contains(at)) return;
    const float cost_m = global.field.cost_m[global.geometry.CellAt(at)];
    if (std::isfinite(cost_m)) seeds.push_back({cell, cost_m});
  };
  for (int i = 0; i < cells_; ++i) {
    seed({0, i});
    seed({cells_ - 1, i});
    seed({i, 0});
    seed({i, cells_ - 1});
  }
  const CellIndex goal = CellOf(global.goal);
  if (prices_.Contains(goal)) seeds.push_back({goal, 0.0f});
  // The way follows falling costs from the robot, pulled straight.
  const CellIndex here = CellOf(robot);
  field_ = SpreadFrom(seeds, prices_, kCell_m);
  std::vector<CellIndex> cells = Descend(field_, prices_, here);
  for (const CellIndex cell : PulledStraight(cells, prices_)) way_.push_back(CenterOf(cell));
  if (!way_.empty()) way_.front() = robot;
  if (!cells.empty() && cells.back() == goal) way_.back() = global.goal;
}

double LocalPlan::CostAt(WorldPoint point) const {
  // The cost is interpolated between those of the four centres around that have a way.
  const double row = (corner_.y_m - point.y_m) / kCell_m - 0.5;
  const double col = (point.x_m - corner_.x_m) / kCell_m - 0.5;
  const int r0 = static_cast<int>(std::floor(row)), c0 = static_cast<int>(std::floor(col));
  double sum = 0.0, weights = 0.0;
  for (int r = r0; r <= r0 + 1; ++r) {
    for (int c = c0; c <= c0 + 1; ++c) {
      if (!field_.cost_m.Contains({r, c}) || !std::isfinite(field_.cost_m(r, c))) continue;
      const double weight = (1.0 - std::abs(row - r)) * (1.0 - std::abs(col - c));
      sum += weight * field_.cost_m(r, c);
      weights += weight;
    }
  }
  return weights > 0.2 ? sum / weights : std::numeric_limits<double>::infinity();
}

}  // namespace latticeworld
