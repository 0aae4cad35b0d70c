#include "reference_navigator/kinematic_world.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace latticeworld {
namespace {

// How far a ray goes until it meets a disc; none: it passes by.
std::optional<double> Meets(const Disc& disc, double x_m, double y_m, double angle_rad) {
  const double dx = disc.x_m - x_m, dy = disc.y_m - y_m;
  const double along = dx * std::cos(angle_rad) + dy * std::sin(angle_rad);
  const double beside = dx * dx + dy * dy - along * along;
  const double square = disc.radius_m * disc.radius_m;
  if (along <= 0.0 || beside >= square) return std::nullopt;
  return std::max(0.0, along - std::sqrt(square - beside));
}

}  // namespace

KinematicWorld::KinematicWorld(double size_m, const NavigatorRobot& robot)
    : size_m_(size_m), robot_(robot) {}

std::vector<Disc> KinematicWorld::Standing() const {
  std::vector<Disc> all = mapped;
  all.insert(all.end(), unmapped.begin(), unmapped.end());
  const std::vector<Disc> others = moving(time_s_);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

double KinematicWorld::RoomAt(double x_m, double y_m) const {
  double room_m = 1e9;
  for (const Disc& disc : Standing())
    room_m = std::min(room_m,
                      std::hypot(x_m - disc.x_m, y_m - disc.y_m) - disc.radius_m - robot_.radius_m);
  return room_m;
}

CostMap KinematicWorld::Map() const {
  constexpr double kCell_m = 0.5;
  const int cells = static_cast<int>(size_m_ / kCell_m);
  CostMap map{GridGeometry::FromCells(cells, size_m_), Grid<std::int8_t>(cells, cells, 0)};
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const WorldPoint at = map.geometry.CenterOf({row, col});
      bool closed = row == 0 || col == 0 || row == cells - 1 || col == cells - 1;
      for (const Disc& disc : mapped)
        closed = closed || std::hypot(at.x_m - disc.x_m, at.y_m - disc.y_m) <
                               disc.radius_m + robot_.radius_m + 0.5 * kCell_m;
      map.cost(row, col) = closed ? 100 : 0;
    }
  }
  return map;
}

void KinematicWorld::Place(double x_m, double y_m, double heading_rad) {
  x_m_ = x_m;
  y_m_ = y_m;
  heading_rad_ = heading_rad;
}

NavigatorPose KinematicWorld::Pose() const {
  NavigatorPose pose;
  pose.time_s = time_s_;
  pose.map_from_base.translation() << x_m_, y_m_, 0.0;
  pose.map_from_base.linear() =
      Eigen::AngleAxisd(heading_rad_, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.speed_mps = speed_mps_;
  pose.yaw_rate_radps = yaw_rate_radps_;
  return pose;
}

SensorSighting KinematicWorld::Scan() const {
  constexpr double kRange_m = 10.0;
  SensorSighting scan;
  scan.time_s = time_s_;
  scan.planar = true;
  scan.map_from_sensor = Pose().map_from_base;
  scan.map_from_sensor.translation().z() = 0.3;
  const std::vector<Disc> standing = Standing();
  for (int i = 0; i < 360; ++i) {
    const double angle_rad = i * M_PI / 180.0;
    double range_m = kRange_m;
    for (const Disc& disc : standing)
      range_m =
          std::min(range_m, Meets(disc, x_m_, y_m_, angle_rad + heading_rad_).value_or(kRange_m));
    const Eigen::Vector3f end(static_cast<float>(range_m * std::cos(angle_rad)),
                              static_cast<float>(range_m * std::sin(angle_rad)), 0.0f);
    (range_m < kRange_m ? scan.hits_m : scan.misses_m).push_back(end);
  }
  return scan;
}

void KinematicWorld::Drive(const NavigatorOutput& output) {
  constexpr double kStep_s = 0.01;
  const double faster = kStep_s * robot_.max_acceleration_mps2;
  const double turn = kStep_s * robot_.max_yaw_acceleration_radps2;
  for (int i = 0; i < 10; ++i) {
    speed_mps_ += std::clamp(output.speed_mps - speed_mps_, -faster, faster);
    yaw_rate_radps_ += std::clamp(output.yaw_rate_radps - yaw_rate_radps_, -turn, turn);
    if (robot_.min_turn_radius_m > 0.0) {
      const double most = std::abs(speed_mps_) / robot_.min_turn_radius_m;
      yaw_rate_radps_ = std::clamp(yaw_rate_radps_, -most, most);
    }
    x_m_ += kStep_s * speed_mps_ * std::cos(heading_rad_);
    y_m_ += kStep_s * speed_mps_ * std::sin(heading_rad_);
    heading_rad_ += kStep_s * yaw_rate_radps_;
    time_s_ += kStep_s;
    length_m_ += kStep_s * std::abs(speed_mps_);
    most_speed_mps_ = std::max(most_speed_mps_, std::abs(speed_mps_));
    least_room_m_ = std::min(least_room_m_, RoomAt(x_m_, y_m_));
  }
}

NavigatorOutput DriveToTheEnd(Navigator* navigator, KinematicWorld* world, double limit_s) {
  NavigatorOutput output;
  while (world->time_s() < limit_s) {
    navigator->See(world->Scan());
    output = navigator->Update(world->Pose());
    if (output.state == NavigatorState::kArrived || output.state == NavigatorState::kFailed) break;
    world->Drive(output);
  }
  return output;
}

}  // namespace latticeworld
