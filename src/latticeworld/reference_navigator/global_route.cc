#include "latticeworld/reference_navigator/global_route.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/reference_navigator/map_prices.h"
#include "latticeworld/reference_navigator/obstacle_layer.h"

namespace latticeworld {

std::string Shown(WorldPoint point) {
  return "(" + FormatDouble(std::round(point.x_m * 100) / 100) + ", " +
         FormatDouble(std::round(point.y_m * 100) / 100) + ")";
}

void GlobalRoute::SetMap(CostMap map) {
  LW_CHECK(map.cost.rows() == map.geometry.rows() && map.cost.cols() == map.geometry.cols(),
           "a cost map has as many cells as its geometry");
  map_ = std::move(map);
  has_map_ = true;
  map_prices_ = MapPrices(map_, options_);
  plan_.geometry = map_.geometry;
  plan_.prices = map_prices_;
}

Status GlobalRoute::SetGoal(WorldPoint goal, WorldPoint here) {
  LW_RETURN_IF_ERROR(CheckOpen(goal, "the goal"));
  TravelField field = FieldOf(goal, map_prices_);
  LW_RETURN_IF_ERROR(CheckReached(field, here, goal));
  plan_.prices = map_prices_;
  plan_.field = std::move(field);
  plan_.goal = goal;
  return Status();
}

void GlobalRoute::PlanAnew(WorldPoint here, const ObstacleLayer& seen) {
  const double reach_m = seen.reach_m();
  const double room_m = options_.robot.radius_m;
  const CellIndex first = map_.geometry.CellAt({here.x_m - reach_m, here.y_m + reach_m});
  const CellIndex last = map_.geometry.CellAt({here.x_m + reach_m, here.y_m - reach_m});
  for (int row = first.row; row <= last.row; ++row) {
    for (int col = first.col; col <= last.col; ++col) {
      const bool is_closed = seen.DistanceAt(map_.geometry.CenterOf({row, col})) < room_m;
      plan_.prices(row, col) = is_closed ? kClosedCell : map_prices_(row, col);
    }
  }
  const CellIndex goal = map_.geometry.CellAt(plan_.goal);
  plan_.prices[goal] = map_prices_[goal];
  plan_.field = FieldOf(plan_.goal, plan_.prices);
}

void GlobalRoute::OpenAgain() {
  plan_.prices = map_prices_;
  plan_.field = FieldOf(plan_.goal, plan_.prices);
}

bool GlobalRoute::IsOpenOnMap(WorldPoint place) const {
  return map_.geometry.Contains(place) && map_prices_[map_.geometry.CellAt(place)] != kClosedCell;
}

double GlobalRoute::CostFrom(WorldPoint here) const { return CostFrom(plan_.field, here); }

std::vector<WorldPoint> GlobalRoute::WayFrom(WorldPoint here) const {
  return WayOver(plan_.field, plan_.prices, here, plan_.goal);
}

Result<std::vector<WorldPoint>> GlobalRoute::Plan(WorldPoint start, WorldPoint goal,
                                                  double tolerance_m) const {
  LW_RETURN_IF_ERROR(CheckInside(start, "the start"));
  Status open = CheckOpen(goal, "the goal");
  if (open.code() == StatusCode::kFailedPrecondition && has_map_) {
    const std::optional<CellIndex> near = NearestOpen(goal, tolerance_m);
    if (near) {
      goal = map_.geometry.CenterOf(*near);
      open = Status();
    }
  }
  LW_RETURN_IF_ERROR(open);
  const TravelField field = FieldOf(goal, plan_.prices);
  LW_RETURN_IF_ERROR(CheckReached(field, start, goal));
  return WayOver(field, plan_.prices, start, goal);
}

Status GlobalRoute::CheckInside(WorldPoint point, const char* what) const {
  if (!has_map_) return FailedPrecondition("there is no map yet");
  if (map_.geometry.Contains(point)) return Status();
  const std::string half = FormatDouble(map_.geometry.half_size_m());
  return Status(StatusCode::kOutOfRange, std::string(what) + " " + Shown(point) +
                                             " is outside the map, which reaches from -" + half +
                                             " to " + half + " m in x and y");
}

Status GlobalRoute::CheckOpen(WorldPoint point, const char* what) const {
  LW_RETURN_IF_ERROR(CheckInside(point, what));
  if (map_prices_[map_.geometry.CellAt(point)] != kClosedCell) return Status();
  std::string text = std::string(what) + " " + Shown(point) +
                     " is where the map says that the robot cannot be (water, a wall, an "
                     "obstacle or ground too steep)";
  if (const std::optional<CellIndex> near = NearestOpen(point, 20.0))
    text += "; the nearest free place is " + Shown(map_.geometry.CenterOf(*near));
  return FailedPrecondition(text);
}

std::optional<CellIndex> GlobalRoute::NearestOpen(WorldPoint point, double within_m) const {
  const CellIndex middle = map_.geometry.CellAt(point);
  const int reach = static_cast<int>(within_m / map_.geometry.resolution_m()) + 1;
  std::optional<CellIndex> best;
  double nearest_m = within_m;
  for (int row = middle.row - reach; row <= middle.row + reach; ++row) {
    for (int col = middle.col - reach; col <= middle.col + reach; ++col) {
      if (!map_prices_.Contains({row, col}) || map_prices_(row, col) == kClosedCell) continue;
      const WorldPoint at = map_.geometry.CenterOf({row, col});
      const double far_m = std::hypot(at.x_m - point.x_m, at.y_m - point.y_m);
      if (far_m > nearest_m) continue;
      nearest_m = far_m;
      best = CellIndex{row, col};
    }
  }
  return best;
}

TravelField GlobalRoute::FieldOf(WorldPoint goal, const Grid<float>& prices) const {
  return SpreadFrom({{map_.geometry.CellAt(goal), 0.0f}}, prices, map_.geometry.resolution_m());
}

float GlobalRoute::CostFrom(const TravelField& field, WorldPoint here) const {
  const float cost_m = field.cost_m[map_.geometry.CellAt(here)];
  if (std::isfinite(cost_m)) return cost_m;
  const std::optional<CellIndex> near = NearestOpen(here, 1.5 + options_.robot.radius_m);
  return near ? field.cost_m[*near] : cost_m;
}

Status GlobalRoute::CheckReached(const TravelField& field, WorldPoint here, WorldPoint goal) const {
  if (map_.geometry.Contains(here) && std::isfinite(CostFrom(field, here))) return Status();
  return NotFound("there is no way from " + Shown(here) + " to " + Shown(goal) +
                  " on the map for a robot of these limits");
}

std::vector<WorldPoint> GlobalRoute::WayOver(const TravelField& field, const Grid<float>& prices,
                                             WorldPoint start, WorldPoint goal) const {
  CellIndex first = map_.geometry.CellAt(start);
  if (!std::isfinite(field.cost_m[first]))
    first = NearestOpen(start, 1.5 + options_.robot.radius_m).value_or(first);
  std::vector<WorldPoint> way = {start};
  const std::vector<CellIndex> cells = PulledStraight(Descend(field, prices, first), prices);
  for (std::size_t i = 1; i + 1 < cells.size(); ++i)
    way.push_back(map_.geometry.CenterOf(cells[i]));
  way.push_back(goal);
  return way;
}

}  // namespace latticeworld
