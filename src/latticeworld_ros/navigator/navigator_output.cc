#include "latticeworld_ros/navigator/navigator_output.h"

#include <cmath>

#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {

geometry_msgs::Pose UprightPose(WorldPoint place, double z_m, double heading_rad) {
  return ToPose(
      ToIsometry({place.x_m, place.y_m, z_m},
                 Eigen::Quaterniond(Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()))));
}

nav_msgs::Path ToPath(const std::vector<WorldPoint>& way, double z_m,
                      const std_msgs::Header& header) {
  nav_msgs::Path path;
  path.header = header;
  path.poses.reserve(way.size());
  double heading_rad = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i + 1 < way.size())
      heading_rad = std::atan2(way[i + 1].y_m - way[i].y_m, way[i + 1].x_m - way[i].x_m);
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose = UprightPose(way[i], z_m, heading_rad);
    path.poses.push_back(pose);
  }
  return path;
}

}  // namespace latticeworld
