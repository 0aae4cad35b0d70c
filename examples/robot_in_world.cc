// A ROS node that drives a robot by its scan: on where there is room, away from what is near.
//
// Usage: rosrun latticeworld robot_in_world [_robot:=robot] [_seconds:=0]
// It ends after so many seconds of the simulation; 0: with Ctrl-C.

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>

namespace {

constexpr double kAside_rad = 1.3;  // what is farther to the side does not count
constexpr double kAhead_rad = 0.4;
constexpr double kNear_m = 2.0;  // the robot turns away from what is nearer ahead

// The nearest return between two directions [m]; 0 is ahead, left is positive.
double RoomBetween(const sensor_msgs::LaserScan& scan, double from_rad, double to_rad) {
  double room_m = scan.range_max;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle_rad = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    if (angle_rad < from_rad || angle_rad > to_rad) continue;
    if (std::isnan(scan.ranges[i])) continue;           // A beam that was lost says nothing.
    room_m = std::min<double>(room_m, scan.ranges[i]);  // Infinity: nothing is in reach.
  }
  return std::max(room_m, 0.0);
}

class Driver {
 public:
  Driver(const std::string& robot, double seconds)
      : seconds_(seconds),
        commands_(node_.advertise<geometry_msgs::Twist>(robot + "/cmd_vel", 1)),
        scans_(node_.subscribe(robot + "/scan", 1, &Driver::OnScan, this)),
        odometry_(node_.subscribe(robot + "/odom", 10, &Driver::OnOdometry, this)) {}

  double driven_m() const { return driven_m_; }

 private:
  void OnScan(const sensor_msgs::LaserScan& scan) {
    if (begin_.isZero()) begin_ = scan.header.stamp;
    // A robot that is told nothing any more stops by itself after half a second.
    if (seconds_ > 0.0 && (scan.header.stamp - begin_).toSec() > seconds_) ros::requestShutdown();

    const double ahead_m = RoomBetween(scan, -kAhead_rad, kAhead_rad);
    const double left_m = RoomBetween(scan, kAhead_rad, kAside_rad);
    const double right_m = RoomBetween(scan, -kAside_rad, -kAhead_rad);
    if (ahead_m > kNear_m) {
      turn_ = 0.0;
    } else if (turn_ == 0.0) {
      turn_ = left_m > right_m ? 1.0 : -1.0;  // It keeps to the side until there is room ahead.
    }
    geometry_msgs::Twist command;
    command.linear.x = std::clamp(0.5 * (ahead_m - 0.8), 0.0, 1.5);
    command.angular.z = turn_;
    commands_.publish(command);
  }

  void OnOdometry(const nav_msgs::Odometry& odometry) {
    const geometry_msgs::Point& at = odometry.pose.pose.position;
    if (last_) driven_m_ += std::hypot(at.x - last_->x, at.y - last_->y);
    last_ = at;
  }

  const double seconds_;
  ros::Time begin_;    // the first scan's
  double turn_ = 0.0;  // [rad/s]
  std::optional<geometry_msgs::Point> last_;
  double driven_m_ = 0.0;
  ros::NodeHandle node_;
  ros::Publisher commands_;
  ros::Subscriber scans_, odometry_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "robot_in_world");
  Driver driver(ros::param::param<std::string>("~robot", "robot"),
                ros::param::param("~seconds", 0.0));
  ros::spin();
  std::cout << "drove " << driver.driven_m() << " m\n";
  return 0;
}
