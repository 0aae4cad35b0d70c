#include "latticeworld_ros/viewer/viewer_layers.h"

#include <ros/master.h>

#include <chrono>
#include <cstddef>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/viewer/server/server_messages.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/viewer/viewer_conversion.h"

namespace latticeworld {
namespace {

constexpr char kCloudType[] = "sensor_msgs/PointCloud2";
constexpr char kScanType[] = "sensor_msgs/LaserScan";
constexpr char kPathType[] = "nav_msgs/Path";
constexpr std::chrono::seconds kLookPeriod(1);  // for topics that come and go
constexpr std::size_t kMostPaths = 16;
constexpr int kMostParents = 8;          // from a sensor's frame to its robot's
constexpr double kPointsPeriod_s = 0.2;  // of wall time
constexpr double kPathPeriod_s = 0.5;

double WallNow_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string PathSlot(const std::string& topic) { return "path:" + topic; }

}  // namespace

ViewerLayers::ViewerLayers(ros::NodeHandle node, ViewerServer* server)
    : node_(std::move(node)), server_(server) {
  static_transforms_ = node_.subscribe<tf2_msgs::TFMessage>(
      "/tf_static", 100,
      [this](const tf2_msgs::TFMessage::ConstPtr& message) { OnStaticTransforms(*message); });
  thread_ = std::thread([this] { Run(); });
}

void ViewerLayers::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void ViewerLayers::SetDemand(const LayerDemand& demand) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    demand_ = demand;
    is_new_ = true;
  }
  changed_.notify_all();
}

void ViewerLayers::SetPoses(std::map<std::string, Eigen::Isometry3d> poses) {
  poses_ = std::move(poses);
  const std::lock_guard<std::mutex> lock(mutex_);
  robots_.clear();
  for (const auto& [name, pose] : poses_) robots_.push_back(name);
}

void ViewerLayers::Run() {
  for (;;) {
    LayerDemand demand;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      const auto due = [this] { return stop_ || is_new_; };
      if (demand_ == LayerDemand()) {
        changed_.wait(lock, due);
      } else {
        changed_.wait_for(lock, kLookPeriod, due);
      }
      if (stop_) break;
      is_new_ = false;
      demand = demand_;
    }
    Listen(demand);
  }
  listened_.clear();
}

std::map<std::string, std::pair<std::string, std::string>> ViewerLayers::WantedTopics(
    const LayerDemand& demand) {
  std::map<std::string, std::pair<std::string, std::string>> wanted;
  if (demand == LayerDemand()) return wanted;
  std::vector<std::string> robots;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const std::string& robot : robots_) {
      if (demand.lidar_robots.count(robot) > 0) robots.push_back(robot);
    }
    if (demand.lidar_robots.count("") > 0 && robots.empty() && !robots_.empty()) {
      robots.push_back(robots_.front());
    }
  }
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return wanted;
  std::size_t paths = 0;
  for (const ros::master::TopicInfo& topic : topics) {
    if (demand.paths && topic.datatype == kPathType && paths++ < kMostPaths) {
      wanted[topic.name] = {kPathType, ""};
    }
  }
  for (const std::string& robot : robots) {
    const std::string below = node_.resolveName(robot) + "/";
    std::string best, best_type;  // a cloud before a scan
    for (const ros::master::TopicInfo& topic : topics) {
      if (!StartsWith(topic.name, below)) continue;
      const bool better = (topic.datatype == kCloudType && best_type != kCloudType) ||
                          (topic.datatype == kScanType && best.empty());
      if (better) best = topic.name, best_type = topic.datatype;
    }
    if (!best.empty()) wanted[best] = {best_type, robot};
  }
  return wanted;
}

void ViewerLayers::Listen(const LayerDemand& demand) {
  const auto wanted = WantedTopics(demand);
  for (auto entry = listened_.begin(); entry != listened_.end();) {
    if (wanted.count(entry->first) > 0) {
      ++entry;
      continue;
    }
    if (entry->second.is_path) {
      server_->Forget(PathSlot(entry->first), PathMessage(entry->first, {}), Audience::kPaths);
    }
    entry = listened_.erase(entry);
  }
  for (const auto& [topic, kind] : wanted) {
    if (listened_.count(topic) > 0) continue;
    const auto& [type, robot] = kind;
    Listened listened;
    listened.robot = robot;
    listened.is_path = type == kPathType;
    if (listened.is_path) {
      listened.subscriber = node_.subscribe<nav_msgs::Path>(
          topic, 1,
          [this, name = topic](const nav_msgs::Path::ConstPtr& path) { OnPath(name, *path); });
    } else if (type == kCloudType) {
      listened.subscriber = node_.subscribe<sensor_msgs::PointCloud2>(
          topic, 1, [this, name = robot](const sensor_msgs::PointCloud2::ConstPtr& cloud) {
            OnPoints(name, *cloud);
          });
    } else {
      listened.subscriber = node_.subscribe<sensor_msgs::LaserScan>(
          topic, 1, [this, name = robot](const sensor_msgs::LaserScan::ConstPtr& scan) {
            OnPoints(name, *scan);
          });
    }
    listened_.emplace(topic, std::move(listened));
  }
}

void ViewerLayers::OnStaticTransforms(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& entry : message.transforms) {
    mountings_[entry.child_frame_id] = {entry.header.frame_id, TransformFrom(entry.transform)};
  }
}

bool ViewerLayers::PoseOf(const std::string& frame, const std::string& robot,
                          Eigen::Isometry3d* pose) const {
  const auto base = poses_.find(robot);
  if (base == poses_.end()) return false;
  const std::string base_frame = robot + "/base_link";
  Eigen::Isometry3d base_from_sensor = Eigen::Isometry3d::Identity();
  std::string name = frame;
  for (int i = 0; i < kMostParents && name != base_frame; ++i) {
    const auto mounting = mountings_.find(name);
    if (mounting == mountings_.end()) return false;
    base_from_sensor = mounting->second.parent_from_child * base_from_sensor;
    name = mounting->second.parent;
  }
  *pose = base->second * base_from_sensor;
  return name == base_frame;
}

template <typename Message>
void ViewerLayers::OnPoints(const std::string& robot, const Message& message) {
  const double now_s = WallNow_s();
  double& last_s = last_wall_s_[robot];
  if (now_s - last_s < kPointsPeriod_s) return;
  Eigen::Isometry3d map_from_sensor;
  if (!PoseOf(message.header.frame_id, robot, &map_from_sensor)) return;
  last_s = now_s;
  server_->ShowPoints(robot,
                      PointsMessage(message.header.stamp.toSec(), map_from_sensor.translation(),
                                    PointsOf(message, map_from_sensor.linear())));
}

void ViewerLayers::OnPath(const std::string& topic, const nav_msgs::Path& path) {
  if (path.header.frame_id != kMapFrame) {
    ROS_WARN_STREAM_ONCE("paths are shown in the frame " << kMapFrame << ", not in "
                                                         << Quote(path.header.frame_id));
    return;
  }
  const double now_s = WallNow_s();
  double& last_s = last_wall_s_[topic];
  // An end is told at once.
  if (now_s - last_s < kPathPeriod_s && !path.poses.empty()) return;
  last_s = now_s;
  server_->Tell(PathSlot(topic), PathMessage(topic, PointsOf(path)), Audience::kPaths);
}

}  // namespace latticeworld
