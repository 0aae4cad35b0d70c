#include "latticeworld_ros/navigator/navigator_input.h"

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr int kSlices = 8;               // of a sweep, each with a pose of its own
constexpr double kLongestSweep_s = 1.0;  // what says that it took longer is not believed
// A map's middle may lie this far from the frame's origin [cells].
constexpr double kOffCentre_cells = 0.01;

// Poses of a sensor over a sweep, seen from its pose at the sweep's end.
class SweepPoses {
 public:
  static Result<SweepPoses> Create(ros::Time begin, ros::Time end, const SensorPoseAt& pose_at) {
    const auto at_end = pose_at(end);
    if (!at_end) return Unavailable("it is not known where the sensor was when its sweep ended");
    SweepPoses poses;
    poses.map_from_end_ = *at_end;
    poses.duration_s_ = (end - begin).toSec();
    if (poses.duration_s_ <= 0.0) return poses;
    for (int i = 0; i < kSlices; ++i) {
      const auto at = pose_at(begin + ros::Duration((i + 0.5) / kSlices * poses.duration_s_));
      if (!at) return Unavailable("it is not known where the sensor was during its sweep");
      poses.end_from_slice_[static_cast<std::size_t>(i)] = (at_end->inverse() * *at).cast<float>();
    }
    return poses;
  }

  const Eigen::Isometry3d& map_from_end() const { return map_from_end_; }

  // after_begin_s: when the point was met, told in the sensor's frame of that moment.
  Eigen::Vector3f AtEnd(const Eigen::Vector3f& point_m, double after_begin_s) const {
    if (duration_s_ <= 0.0) return point_m;
    const int slice = static_cast<int>(kSlices * std::clamp(after_begin_s / duration_s_, 0.0, 1.0));
    return end_from_slice_[static_cast<std::size_t>(std::min(slice, kSlices - 1))] * point_m;
  }

 private:
  Eigen::Isometry3d map_from_end_;
  double duration_s_ = 0.0;
  std::array<Eigen::Isometry3f, kSlices> end_from_slice_;
};

// Seconds from a scan's first beam to its last.
double DurationOf(const sensor_msgs::LaserScan& scan) {
  const double all_s = static_cast<double>(scan.time_increment) *
                       static_cast<double>(scan.ranges.empty() ? 0 : scan.ranges.size() - 1);
  return all_s > 0.0 && all_s <= kLongestSweep_s ? all_s : 0.0;
}

ros::Time Later(ros::Time time, double seconds) {
  // The sum may be no legal time.
  try {
    return time + ros::Duration(seconds);
  } catch (const std::runtime_error&) {
    return time;
  }
}

// The offset of a float32 field; nullopt: there is none.
std::optional<std::size_t> OffsetOf(const sensor_msgs::PointCloud2& cloud, const char* name) {
  for (const sensor_msgs::PointField& field : cloud.fields) {
    if (field.name != name) continue;
    const bool fits = field.datatype == sensor_msgs::PointField::FLOAT32 &&
                      static_cast<std::uint64_t>(field.offset) + sizeof(float) <= cloud.point_step;
    return fits ? std::optional<std::size_t>(field.offset) : std::nullopt;
  }
  return std::nullopt;
}

float FloatAt(const std::uint8_t* from) {
  float value;
  std::memcpy(&value, from, sizeof(value));
  return value;
}

// Says where in a cloud's bytes its points are, row after row.
struct CloudLayout {
  std::size_t x, y, z;
  std::optional<std::size_t> time;

  template <typename Visit>
  void ForEach(const sensor_msgs::PointCloud2& cloud, const Visit& visit) const {
    if (cloud.width == 0) return;  // however many rows: there may be four thousand million
    for (std::size_t row = 0; row < cloud.height; ++row) {
      const std::uint8_t* point = cloud.data.data() + row * cloud.row_step;
      for (std::size_t col = 0; col < cloud.width; ++col, point += cloud.point_step) visit(point);
    }
  }
};

Result<CloudLayout> LayoutOf(const sensor_msgs::PointCloud2& cloud) {
  const auto x = OffsetOf(cloud, "x"), y = OffsetOf(cloud, "y"), z = OffsetOf(cloud, "z");
  if (!x || !y || !z)
    return InvalidArgument("the cloud lacks a float32 field of x, y and z within its points");
  constexpr bool kBig = boost::endian::order::native == boost::endian::order::big;
  if (static_cast<bool>(cloud.is_bigendian) != kBig)
    return InvalidArgument("the cloud's numbers are of another byte order than this machine's");
  const std::uint64_t row = static_cast<std::uint64_t>(cloud.width) * cloud.point_step;
  const std::uint64_t needed =
      cloud.height == 0 ? 0 : static_cast<std::uint64_t>(cloud.height - 1) * cloud.row_step + row;
  if ((cloud.height > 1 && row > cloud.row_step) || needed > cloud.data.size()) {
    return InvalidArgument("the cloud has " + std::to_string(cloud.data.size()) +
                           " bytes, and its shape asks for " + std::to_string(needed));
  }
  return CloudLayout{*x, *y, *z, OffsetOf(cloud, "time")};
}

// Returns when the first and the last point were met [s from the stamp]; both 0 if that is not
// told.
std::pair<double, double> SpanOf(const sensor_msgs::PointCloud2& cloud, const CloudLayout& layout) {
  if (!layout.time) return {0.0, 0.0};
  float first = 0.0f, last = 0.0f;
  bool any = false, legal = true;
  layout.ForEach(cloud, [&](const std::uint8_t* point) {
    const float time = FloatAt(point + *layout.time);
    legal = legal && std::isfinite(time);
    first = any ? std::min(first, time) : time;
    last = any ? std::max(last, time) : time;
    any = true;
  });
  legal = legal && std::abs(first) <= kLongestSweep_s && std::abs(last) <= kLongestSweep_s;
  return legal ? std::pair<double, double>(first, last) : std::pair(0.0, 0.0);
}

}  // namespace

Result<CostMap> ToCostMap(const nav_msgs::OccupancyGrid& map) {
  const auto& info = map.info;
  const std::string given = std::to_string(info.width) + " x " + std::to_string(info.height) +
                            " cells of " + FormatDouble(info.resolution) + " m";
  if (info.width != info.height)
    return InvalidArgument("the map has " + given + "; legal are square maps");
  if (static_cast<std::uint64_t>(info.width) * info.height != map.data.size()) {
    return InvalidArgument("the map has " + given + ", and " + std::to_string(map.data.size()) +
                           " values; legal is one a cell");
  }
  CostMap result;
  const double resolution_m = info.resolution, cells = info.width;
  LW_ASSIGN_OR_RETURN(result.geometry, GridGeometry::Create(resolution_m * cells, resolution_m));
  if (static_cast<std::uint32_t>(result.geometry.cols()) != info.width)
    return InvalidArgument("the map has " + given + ", whose size is no number of cells");
  const auto& origin = info.origin;
  // Sums, for a NaN has to be seen, and std::max may leave it out.
  const double off_m = std::abs(origin.position.x + 0.5 * resolution_m * cells) +
                       std::abs(origin.position.y + 0.5 * resolution_m * cells);
  const double turned = std::abs(origin.orientation.x) + std::abs(origin.orientation.y) +
                        std::abs(origin.orientation.z);
  if (!(off_m <= kOffCentre_cells * resolution_m) || !(turned <= 1e-6)) {
    return InvalidArgument(
        "the map's lower left corner lies at " + FormatDouble(origin.position.x) + ", " +
        FormatDouble(origin.position.y) + " m" + (turned <= 1e-6 ? "" : ", turned") +
        "; legal are maps whose middle is the origin of their frame, north up");
  }
  const int side = result.geometry.rows();
  result.cost = Grid<std::int8_t>(side, side);
  for (int row = 0; row < side; ++row) {
    const auto* from =
        map.data.data() + static_cast<std::size_t>(side - 1 - row) * static_cast<std::size_t>(side);
    for (int col = 0; col < side; ++col) {
      const std::int8_t value = from[col];
      if (value < -1 || value > 100) {
        return InvalidArgument("the map has a cell of " + std::to_string(value) +
                               "; legal are -1 and 0 to 100");
      }
      result.cost(row, col) = value;
    }
  }
  return result;
}

Result<SensorSighting> ToSighting(const sensor_msgs::LaserScan& scan, double range_m,
                                  const SensorPoseAt& pose_at) {
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment)) {
    return InvalidArgument("the scan's angles begin at " + FormatDouble(scan.angle_min) +
                           " rad with steps of " + FormatDouble(scan.angle_increment) +
                           " rad; legal are finite ones");
  }
  const double duration_s = DurationOf(scan);
  const ros::Time end = Later(scan.header.stamp, duration_s);
  LW_ASSIGN_OR_RETURN(const SweepPoses poses, SweepPoses::Create(scan.header.stamp, end, pose_at));
  SensorSighting sighting;
  sighting.time_s = end.toSec();
  sighting.map_from_sensor = poses.map_from_end();
  sighting.planar = true;
  const double reach_m = std::min<double>(
      range_m, std::isfinite(scan.range_max) && scan.range_max > 0 ? scan.range_max : range_m);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    // Too near, or no reading: it says nothing. Infinity: the ray met nothing (REP 117).
    if (std::isnan(range) || range < scan.range_min || range <= 0.0) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const double length = std::min(range, reach_m);
    const Eigen::Vector3f end_m(static_cast<float>(length * std::cos(angle)),
                                static_cast<float>(length * std::sin(angle)), 0.0f);
    const double after_s = duration_s * static_cast<double>(i) /
                           static_cast<double>(std::max<std::size_t>(1, scan.ranges.size() - 1));
    const bool hit = range < reach_m;
    (hit ? sighting.hits_m : sighting.misses_m).push_back(poses.AtEnd(end_m, after_s));
  }
  return sighting;
}

Result<SensorSighting> ToSighting(const sensor_msgs::PointCloud2& cloud, double range_m,
                                  const SensorPoseAt& pose_at) {
  LW_ASSIGN_OR_RETURN(const CloudLayout layout, LayoutOf(cloud));
  const std::pair<double, double> span_s = SpanOf(cloud, layout);
  const ros::Time end = Later(cloud.header.stamp, span_s.second);
  LW_ASSIGN_OR_RETURN(const SweepPoses poses,
                      SweepPoses::Create(Later(cloud.header.stamp, span_s.first), end, pose_at));
  SensorSighting sighting;
  sighting.time_s = end.toSec();
  sighting.map_from_sensor = poses.map_from_end();
  const auto reach_m = static_cast<float>(range_m);
  layout.ForEach(cloud, [&](const std::uint8_t* point) {
    const Eigen::Vector3f at_m(FloatAt(point + layout.x), FloatAt(point + layout.y),
                               FloatAt(point + layout.z));
    if (!(at_m.squaredNorm() <= reach_m * reach_m)) return;  // NaN too
    const double after_s = layout.time ? FloatAt(point + *layout.time) - span_s.first : 0.0;
    sighting.hits_m.push_back(poses.AtEnd(at_m, after_s));
  });
  return sighting;
}

}  // namespace latticeworld
