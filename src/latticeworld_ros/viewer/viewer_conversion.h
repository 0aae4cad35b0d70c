#ifndef LATTICEWORLD_ROS_VIEWER_VIEWER_CONVERSION_H_
#define LATTICEWORLD_ROS_VIEWER_VIEWER_CONVERSION_H_

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/viewer/payloads/points_message.h"
#include "latticeworld/viewer/viewer_feed.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// What world_server and robots publish, as the viewer's stream has it. Messages may come from
// anybody: nothing in them is trusted.

// These convert at most 65535 agents or props.
StreamedState<AgentRow> Streamed(const latticeworld_msgs::AgentStates& message);
StreamedState<PropRow> Streamed(const latticeworld_msgs::ElementStates& message);
Atmosphere ToAtmosphere(const latticeworld_msgs::Weather& message);
std::vector<LyingTree> FelledOf(const latticeworld_msgs::SceneChanges& message);
// Puts falling trees where markers of agents/markers show them.
void UpdateFalling(const visualization_msgs::MarkerArray& markers, std::vector<LyingTree>* trees);

// What the diagnostics of world_server say of its simulation.
struct SimulationReport {
  bool has_world = false;
  bool paused = false;
  double real_time_factor = 0.0;
  double speed = 0.0;  // asked for
};
// nullopt: they are of something else.
std::optional<SimulationReport> ReportOf(const diagnostic_msgs::DiagnosticArray& message);

Eigen::Isometry3d PoseFrom(const geometry_msgs::Pose& pose);
Eigen::Isometry3d TransformFrom(const geometry_msgs::Transform& transform);

// Points from the sensor along the axes of the map; what is no reading is left out. At most a few
// times as many as a message to clients holds. Empty: the message is not well formed.
std::vector<ViewerPoint> PointsOf(const sensor_msgs::PointCloud2& cloud,
                                  const Eigen::Matrix3d& map_from_sensor);
std::vector<ViewerPoint> PointsOf(const sensor_msgs::LaserScan& scan,
                                  const Eigen::Matrix3d& map_from_sensor);

// Returns at most 500 points, the first and the last among them; those that are not finite are left
// out.
std::vector<Eigen::Vector3d> PointsOf(const nav_msgs::Path& path);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_VIEWER_CONVERSION_H_
