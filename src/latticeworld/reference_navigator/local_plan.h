#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_LOCAL_PLAN_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_LOCAL_PLAN_H_

#include <optional>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/reference_navigator/navigator.h"
#include "latticeworld/reference_navigator/travel_field.h"

namespace latticeworld {

class ObstacleLayer;

// What is known of the whole way: prices on the map and the field of the goal over them.
struct GlobalPlan {
  GridGeometry geometry;
  Grid<float> prices;
  TravelField field;  // of the goal
  WorldPoint goal;
};

// The way to the goal around what is seen, within a square around the robot: beyond it the global
// plan counts.
class LocalPlan {
 public:
  static constexpr double kCell_m = 0.2;

  // Made anew for every control period: O(cells of the square).
  LocalPlan(const GlobalPlan& global, const ObstacleLayer& seen, const NavigatorOptions& options,
            WorldPoint robot);

  // What the rest of the way costs from there, as the global field counts; infinity: no way.
  double CostAt(WorldPoint point) const;
  // Returns the way from the robot on, at most to the square's edge; empty: there is none.
  const std::vector<WorldPoint>& way() const { return way_; }

 private:
  CellIndex CellOf(WorldPoint point) const;
  WorldPoint CenterOf(CellIndex cell) const;

  int cells_;          // a side of the square
  WorldPoint corner_;  // north-west
  Grid<float> prices_;
  TravelField field_;
  std::vector<WorldPoint> way_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_LOCAL_PLAN_H_
