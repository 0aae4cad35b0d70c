#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_GLOBAL_ROUTE_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_GLOBAL_ROUTE_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/reference_navigator/local_plan.h"
#include "latticeworld/reference_navigator/navigator.h"
#include "latticeworld/reference_navigator/travel_field.h"

namespace latticeworld {

class ObstacleLayer;

// "(1.25, -3)", to a centimetre.
std::string Shown(WorldPoint point);

// The map, the goal on it, and what the way there costs from every cell, with what was seen to be
// closed since the goal was set.
class GlobalRoute {
 public:
  explicit GlobalRoute(const NavigatorOptions& options) : options_(options) {}

  // A goal there is stays; PlanAnew is to follow. A grid that is not of the geometry's size is a
  // bug of the caller.
  void SetMap(CostMap map);
  bool has_map() const { return has_map_; }
  const CostMap& map() const { return map_; }
  const GlobalPlan& plan() const { return plan_; }
  WorldPoint goal() const { return plan_.goal; }

  // Errors, which leave the goal before as it is: OUT_OF_RANGE, FAILED_PRECONDITION, NOT_FOUND as
  // Navigator::SetGoal has them. Points are finite.
  Status SetGoal(WorldPoint goal, WorldPoint here);
  // Closes what is seen to be closed around the robot, opens again what is seen to be open, and
  // plans with that.
  void PlanAnew(WorldPoint here, const ObstacleLayer& seen);
  // Tries the map as it is once more.
  void OpenAgain();

  // Whether the map has the place open; false outside.
  bool IsOpenOnMap(WorldPoint place) const;
  // What the way costs from a place, or from the nearest open one where it stands too near
  // something; infinity: none.
  double CostFrom(WorldPoint here) const;
  // Returns the way to the goal from a place that has one, both included.
  std::vector<WorldPoint> WayFrom(WorldPoint here) const;
  // Plans as Navigator::Plan does; points are finite.
  Result<std::vector<WorldPoint>> Plan(WorldPoint start, WorldPoint goal, double tolerance_m) const;

 private:
  Status CheckInside(WorldPoint point, const char* what) const;
  Status CheckOpen(WorldPoint point, const char* what) const;
  Status CheckReached(const TravelField& field, WorldPoint here, WorldPoint goal) const;
  std::optional<CellIndex> NearestOpen(WorldPoint point, double within_m) const;
  TravelField FieldOf(WorldPoint goal, const Grid<float>& prices) const;
  float CostFrom(const TravelField& field, WorldPoint here) const;
  std::vector<WorldPoint> WayOver(const TravelField& field, const Grid<float>& prices,
                                  WorldPoint start, WorldPoint goal) const;

  NavigatorOptions options_;
  bool has_map_ = false;
  CostMap map_;
  Grid<float> map_prices_;
  GlobalPlan plan_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_GLOBAL_ROUTE_H_
