// What world_viewer and the navigator hear from anybody: serialized messages through their
// conversions.

#include "fuzz/support/ros_message.h"
#include "latticeworld_ros/navigator/navigator_goal.h"
#include "latticeworld_ros/navigator/navigator_input.h"
#include "latticeworld_ros/viewer/viewer_conversion.h"

namespace {

using namespace latticeworld;
namespace msgs = latticeworld_msgs;
using fuzz::WithMessage;

void ReadForViewer(std::size_t choice, std::string_view bytes) {
  switch (choice) {
    case 0:
      WithMessage<msgs::AgentStates>(bytes, [](const auto& message) { (void)Streamed(message); });
      break;
    case 1:
      WithMessage<msgs::ElementStates>(bytes, [](const auto& message) { (void)Streamed(message); });
      break;
    case 2:
      WithMessage<msgs::Weather>(bytes, [](const auto& message) { (void)ToAtmosphere(message); });
      break;
    case 3:
      WithMessage<msgs::SceneChanges>(bytes, [](const auto& message) { (void)FelledOf(message); });
      break;
    case 4:
      WithMessage<visualization_msgs::MarkerArray>(bytes, [](const auto& message) {
        std::vector<LyingTree> trees(1);
        UpdateFalling(message, &trees);
      });
      break;
    case 5:
      WithMessage<diagnostic_msgs::DiagnosticArray>(
          bytes, [](const auto& message) { (void)ReportOf(message); });
      break;
    default:
      WithMessage<nav_msgs::Path>(bytes, [](const auto& message) { (void)PointsOf(message); });
  }
}

// The sensor moves by a metre in a second, and was nowhere before the beginning of time.
std::optional<Eigen::Isometry3d> SensorPose(ros::Time time) {
  if (time.isZero()) return std::nullopt;
  return Eigen::Isometry3d(Eigen::Translation3d(time.toSec(), 0.0, 0.0));
}

void ReadForNavigator(std::size_t choice, std::string_view bytes) {
  constexpr double kRange_m = 20.0;
  const Eigen::Matrix3d level = Eigen::Matrix3d::Identity();
  switch (choice) {
    case 0:
      WithMessage<nav_msgs::OccupancyGrid>(bytes,
                                           [](const auto& message) { (void)ToCostMap(message); });
      break;
    case 1:
      WithMessage<sensor_msgs::LaserScan>(bytes, [&](const auto& message) {
        (void)ToSighting(message, kRange_m, SensorPose);
        (void)PointsOf(message, level);
      });
      break;
    case 2:
      WithMessage<sensor_msgs::PointCloud2>(bytes, [&](const auto& message) {
        (void)ToSighting(message, kRange_m, SensorPose);
        (void)PointsOf(message, level);
      });
      break;
    default:
      WithMessage<geometry_msgs::PoseStamped>(bytes, [](const auto& message) {
        static const tf2_ros::Buffer buffer;
        (void)ReadGoal(message, buffer, "map", "goal");
      });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kOfViewer = 7, kOfNavigator = 4;
  std::string_view bytes = fuzz::TextOf(data, size);
  const std::size_t choice = fuzz::TakeChoice(&bytes, kOfViewer + kOfNavigator);
  if (choice < kOfViewer) {
    ReadForViewer(choice, bytes);
  } else {
    ReadForNavigator(choice - kOfViewer, bytes);
  }
  return 0;
}
