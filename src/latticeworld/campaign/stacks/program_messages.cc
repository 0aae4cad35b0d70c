#include "latticeworld/campaign/stacks/program_messages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/common/base64.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr double kFastest = 100.0;  // [m/s] and [rad/s]: more is a mistake

Json PoseOf(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d at = pose.translation();
  const Eigen::Quaterniond turn(pose.linear());
  return {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()};
}

// Little-endian float32, x y z a point.
std::string PointsOf(const std::vector<Eigen::Vector3f>& points) {
  std::string bytes;
  bytes.reserve(points.size() * 12);
  for (const Eigen::Vector3f& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      std::uint32_t bits;
      const float value = point[axis];
      std::memcpy(&bits, &value, sizeof(bits));
      for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(bits >> (8 * byte) & 0xFFu);
    }
  }
  return Base64(bytes);
}

// Writes the map in the order of nav_msgs/OccupancyGrid: from the south-west, row by row
// northwards.
Json MapOf(const GridGeometry& geometry, const Grid<std::int8_t>& occupancy) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(occupancy.rows()) * occupancy.cols());
  for (int row = occupancy.rows() - 1; row >= 0; --row) {
    for (int col = 0; col < occupancy.cols(); ++col)
      bytes += static_cast<char>(occupancy(row, col));
  }
  return {{"cols", occupancy.cols()},
          {"rows", occupancy.rows()},
          {"resolution_m", geometry.resolution_m()},
          {"origin_m", {-geometry.half_size_m(), -geometry.half_size_m()}},
          {"costs", Base64(bytes)}};
}

Json NowOf(const StackInput& input, bool scans) {
  Json now = {{"time_s", input.time_s},
              {"pose", PoseOf(input.map_from_base)},
              {"speed_mps", input.speed_mps},
              {"turn_rate_radps", input.yaw_rate_radps},
              {"scans", Json::array()}};
  if (!scans) return now;
  for (const StackScan& scan : input.scans) {
    now["scans"].push_back({{"time_s", scan.time_s},
                            {"planar", scan.planar},
                            {"pose", PoseOf(scan.map_from_sensor)},
                            {"hits", PointsOf(scan.hits_m)},
                            {"misses", PointsOf(scan.misses_m)}});
  }
  return now;
}

std::string LineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Status Unusable(const std::string& line, const std::string& legal) {
  return InvalidArgument("the program answered " + Quote(line) + "; legal is " + legal);
}

std::string WhyOf(const Json& answer) {
  const auto why = answer.find("why");
  return why != answer.end() && why->is_string() ? why->get<std::string>().substr(0, 500)
                                                 : "it says no reason";
}

// Deeper values are left out: objects copy their members, by recursion, as they grow.
Json ParseLine(const std::string& line) {
  constexpr int kMostDepth = 8;
  const auto is_kept = [](int depth, Json::parse_event_t, const Json&) {
    return depth < kMostDepth;
  };
  return Json::parse(line, is_kept, /*allow_exceptions=*/false);
}

}  // namespace

std::string EncodeBegin(const StackTask& task, const StackInput& start, double control_hz) {
  const RobotLimits& limits = task.robot.limits;
  return LineOf(
      {{"say", "begin"},
       {"format", kFormat},
       {"control_hz", control_hz},
       {"robot",
        {{"name", task.robot.name},
         {"species", task.robot.species},
         {"top_speed_mps", std::min(task.robot.top_speed_mps, task.species.top_speed_mps)},
         {"turn_rate_radps", task.species.turn_rate_radps},
         {"radius_m", limits.radius_m},
         {"max_slope_rad", limits.max_slope_rad},
         {"max_step_m", limits.max_step_m},
         {"max_fording_depth_m", limits.max_fording_depth_m}}},
       {"goal",
        {{"x_m", task.task.goal.x_m},
         {"y_m", task.task.goal.y_m},
         {"radius_m", task.task.goal_radius_m}}},
       {"map", MapOf(task.geometry, task.occupancy)},
       {"now", NowOf(start, false)}});
}

std::string EncodeUpdate(const StackInput& input, bool scans) {
  return LineOf({{"say", "update"}, {"now", NowOf(input, scans)}});
}

Status DecodeReady(const std::string& line) {
  const Json answer = ParseLine(line);
  const auto state = answer.is_object() ? answer.find("state") : answer.end();
  if (answer.is_object() && state != answer.end()) {
    if (*state == "ready") return Status();
    if (*state == "failed") return FailedPrecondition(WhyOf(answer));
  }
  return Unusable(line, R"({"state": "ready"} or {"state": "failed", "why": "..."})");
}

Result<StackOutput> DecodeOutput(const std::string& line) {
  const Json answer = ParseLine(line);
  StackOutput output;
  const auto number = [&answer](const char* key, double* value) {
    const auto found = answer.find(key);
    if (found == answer.end() || !found->is_number()) return false;
    *value = found->get<double>();
    return std::abs(*value) <= kFastest;  // not where it is no number
  };
  if (answer.is_object() && answer.contains("state")) {
    const Json& state = answer["state"];
    if (state == "arrived") {
      output.state = StackState::kArrived;
      return output;
    }
    if (state == "failed") {
      output.state = StackState::kFailed;
      output.why = WhyOf(answer);
      return output;
    }
    if (state == "driving" && number("speed_mps", &output.speed_mps) &&
        number("turn_rate_radps", &output.yaw_rate_radps))
      return output;
  }
  return Unusable(
      line, R"({"state": "driving", "speed_mps": V, "turn_rate_radps": W}, numbers from -100 )"
            R"(to 100, {"state": "arrived"}, or {"state": "failed", "why": "..."})");
}

}  // namespace latticeworld
