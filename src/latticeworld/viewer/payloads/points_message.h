#ifndef LATTICEWORLD_VIEWER_PAYLOADS_POINTS_MESSAGE_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_POINTS_MESSAGE_H_

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace latticeworld {

struct ViewerPoint {
  Eigen::Vector3f from_sensor_m = Eigen::Vector3f::Zero();  // map axes
  std::uint8_t intensity = 0;
};

// Returns a message of points: docs/viewer.md. If there are more than 4096 points, every n-th is
// taken; points that are not finite are left out.
std::string PointsMessage(double time_s, const Eigen::Vector3d& sensor_m,
                          const std::vector<ViewerPoint>& points);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_POINTS_MESSAGE_H_
