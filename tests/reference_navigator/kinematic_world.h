#ifndef LATTICEWORLD_TESTS_REFERENCE_NAVIGATOR_KINEMATIC_WORLD_H_
#define LATTICEWORLD_TESTS_REFERENCE_NAVIGATOR_KINEMATIC_WORLD_H_

#include <functional>
#include <vector>

#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {

// A column that stands in a flat world.
struct Disc {
  double x_m, y_m, radius_m;
};

// A flat square world of discs, some of them on the map, and a robot in it that moves as it is told
// within its accelerations.
class KinematicWorld {
 public:
  KinematicWorld(double size_m, const NavigatorRobot& robot);

  std::vector<Disc> mapped, unmapped;
  std::function<std::vector<Disc>(double time_s)> moving = [](double) {
    return std::vector<Disc>();
  };

  // Cells of half a metre, closed where the robot's centre cannot be for mapped discs and the edge.
  CostMap Map() const;
  // Distance [m] from the robot's rim to the nearest disc.
  double RoomAt(double x_m, double y_m) const;

  void Place(double x_m, double y_m, double heading_rad);
  NavigatorPose Pose() const;
  // A level scan of 360 rays up to 10 m, 0.3 m above the ground.
  SensorSighting Scan() const;
  // Drives for a tenth of a second.
  void Drive(const NavigatorOutput& output);

  double time_s() const { return time_s_; }
  double x_m() const { return x_m_; }
  double y_m() const { return y_m_; }
  double length_m() const { return length_m_; }
  double least_room_m() const { return least_room_m_; }
  double most_speed_mps() const { return most_speed_mps_; }

 private:
  std::vector<Disc> Standing() const;

  double size_m_;
  NavigatorRobot robot_;
  double time_s_ = 0.0, x_m_ = 0.0, y_m_ = 0.0, heading_rad_ = 0.0;
  double speed_mps_ = 0.0, yaw_rate_radps_ = 0.0;
  double length_m_ = 0.0, least_room_m_ = 1e9, most_speed_mps_ = 0.0;
};

// Drives until the navigator arrives or fails, or the limit is reached; the last output.
NavigatorOutput DriveToTheEnd(Navigator* navigator, KinematicWorld* world, double limit_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_REFERENCE_NAVIGATOR_KINEMATIC_WORLD_H_
