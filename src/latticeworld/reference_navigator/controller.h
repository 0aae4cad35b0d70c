#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_CONTROLLER_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_CONTROLLER_H_

#include <optional>

#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {

class LocalPlan;
struct GlobalPlan;
class ObstacleLayer;

struct DriveCommand {
  double speed_mps = 0.0;
  double yaw_rate_radps = 0.0;
};

// Says where a robot is in plan and how it moves.
struct PlanarState {
  WorldPoint at;
  double heading_rad = 0.0;
  double speed_mps = 0.0;
  double yaw_rate_radps = 0.0;
};

// The best of the arcs that the robot's accelerations let it begin within `period_s` (the dynamic
// window approach: Fox, Burgard and Thrun 1997), judged by what the rest of the way costs from
// where the arc ends, by whether it points along the way there, and by the room beside it. None:
// every arc would touch something.
std::optional<DriveCommand> ChooseArc(const PlanarState& state, const LocalPlan& plan,
                                      const ObstacleLayer& seen, const GlobalPlan& global,
                                      const NavigatorOptions& options, double period_s,
                                      double top_speed_mps);

// Speeds towards others within what accelerations allow in a period.
DriveCommand Approach(const DriveCommand& from, const DriveCommand& to, const NavigatorRobot& robot,
                      double period_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_CONTROLLER_H_
