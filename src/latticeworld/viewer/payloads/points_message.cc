#include "latticeworld/viewer/payloads/points_message.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/viewer/payloads/little_endian.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostPoints = 4096;
constexpr std::uint8_t kPointsKind = 3;
constexpr float kFinestStep_m = 0.005f;
constexpr float kMostSteps = 32767.0f;

}  // namespace

std::string PointsMessage(double time_s, const Eigen::Vector3d& sensor_m,
                          const std::vector<ViewerPoint>& points) {
  std::vector<const ViewerPoint*> finite;
  for (const ViewerPoint& point : points) {
    if (point.from_sensor_m.allFinite()) finite.push_back(&point);
  }
  const std::size_t stride = (finite.size() + kMostPoints - 1) / kMostPoints;
  float farthest_m = 0.0f;
  std::vector<const ViewerPoint*> taken;
  for (std::size_t i = 0; i < finite.size(); i += stride) {
    taken.push_back(finite[i]);
    farthest_m = std::max(farthest_m, finite[i]->from_sensor_m.cwiseAbs().maxCoeff());
  }
  const float step_m = std::max(kFinestStep_m, farthest_m / kMostSteps);
  std::string bytes;
  AppendLittleEndian(kPointsKind, &bytes);
  AppendLittleEndian(std::uint8_t{0}, &bytes);
  AppendLittleEndian(static_cast<std::uint16_t>(taken.size()), &bytes);
  AppendLittleEndian(step_m, &bytes);
  AppendLittleEndian(time_s, &bytes);
  for (int i = 0; i < 3; ++i) AppendLittleEndian(static_cast<float>(sensor_m[i]), &bytes);
  for (const ViewerPoint* point : taken) {
    for (int i = 0; i < 3; ++i) {
      const float steps = std::clamp(point->from_sensor_m[i] / step_m, -kMostSteps, kMostSteps);
      AppendLittleEndian(static_cast<std::int16_t>(std::lround(steps)), &bytes);
    }
    AppendLittleEndian(point->intensity, &bytes);
  }
  return bytes;
}

}  // namespace latticeworld
