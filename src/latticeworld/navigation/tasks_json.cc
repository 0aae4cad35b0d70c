#include "latticeworld/navigation/tasks_json.h"

#include <cstddef>
#include <utility>

#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;

constexpr int kFormat = 2;
constexpr std::size_t kMaxBytes = 64 << 20;
constexpr std::size_t kMaxTasks = 1000;
constexpr double kFarthest_m = 0.5 * kMaxSize_m;

jf::Json Encode(const RobotLimits& robot) {
  return {{"radius_m", robot.radius_m},
          {"max_slope_rad", robot.max_slope_rad},
          {"max_step_m", robot.max_step_m},
          {"max_fording_depth_m", robot.max_fording_depth_m},
          {"clearance_m", robot.clearance_m},
          {"mass_kg", robot.mass_kg},
          {"grip", robot.grip},
          {"on_wheels", robot.on_wheels}};
}

RobotLimits DecodeRobot(const jf::Json& json) {
  jf::ExpectKeys(json, {"radius_m", "max_slope_rad", "max_step_m", "max_fording_depth_m",
                        "clearance_m", "mass_kg", "grip", "on_wheels"});
  RobotLimits robot;
  robot.radius_m = jf::Number(json, "radius_m", 0.0, 10.0);
  robot.max_slope_rad = jf::Number(json, "max_slope_rad", 0.01, 1.5);
  robot.max_step_m = jf::Number(json, "max_step_m", 0.0, 10.0);
  robot.max_fording_depth_m = jf::Number(json, "max_fording_depth_m", 0.0, 10.0);
  robot.clearance_m = jf::Number(json, "clearance_m", 0.0, 100.0);
  robot.mass_kg = jf::Number(json, "mass_kg", 0.0, 1e6);
  robot.grip = jf::Number(json, "grip", 0.05, 10.0);
  robot.on_wheels = jf::Boolean(json, "on_wheels");
  return robot;
}

jf::Json Encode(const NavigationTask& task) {
  jf::Json way = jf::Json::array();
  for (const Eigen::Vector3d& point : task.way.points_m)
    way.push_back({point.x(), point.y(), point.z()});
  return {{"start_x_m", task.start.x_m},
          {"start_y_m", task.start.y_m},
          {"start_heading_rad", task.start_heading_rad},
          {"goal_x_m", task.goal.x_m},
          {"goal_y_m", task.goal.y_m},
          {"goal_radius_m", task.goal_radius_m},
          {"length_m", task.difficulty.length_m},
          {"climb_m", task.difficulty.climb_m},
          {"density", task.difficulty.density},
          {"detour", task.difficulty.detour},
          {"agents", task.difficulty.agents},
          {"way_m", std::move(way)}};
}

NavigationTask DecodeTask(const jf::Json& json) {
  jf::ExpectKeys(
      json, {"start_x_m", "start_y_m", "start_heading_rad", "goal_x_m", "goal_y_m", "goal_radius_m",
             "length_m", "climb_m", "density", "detour", "agents", "way_m"});
  NavigationTask task;
  const auto place = [&](const char* key) {
    return jf::Number(json, key, -kFarthest_m, kFarthest_m);
  };
  task.start = {place("start_x_m"), place("start_y_m")};
  task.start_heading_rad = jf::Number(json, "start_heading_rad");
  task.goal = {place("goal_x_m"), place("goal_y_m")};
  task.goal_radius_m = jf::Number(json, "goal_radius_m", 1e-6, 100.0);
  task.difficulty.length_m = jf::Number(json, "length_m", 0.0);
  task.difficulty.climb_m = jf::Number(json, "climb_m", 0.0);
  task.difficulty.density = jf::Number(json, "density", 0.0, 1.0);
  task.difficulty.detour = jf::Number(json, "detour", 1.0);
  task.difficulty.agents = static_cast<int>(jf::Integer(json, "agents", 0, 1'000'000));
  for (const jf::Json& point : jf::Array(json, "way_m")) {
    const bool legal = point.is_array() && point.size() == 3 && point[0].is_number() &&
                       point[1].is_number() && point[2].is_number();
    if (!legal) jf::Fail("way_m", point, "three numbers a point");
    task.way.points_m.emplace_back(point[0].get<double>(), point[1].get<double>(),
                                   point[2].get<double>());
  }
  if (task.way.points_m.size() < 2) jf::Fail("way_m", json["way_m"], "at least two points");
  task.way.length_m = task.difficulty.length_m;
  task.way.climb_m = task.difficulty.climb_m;
  return task;
}

TaskSet DecodeAll(std::string_view content) {
  if (content.size() > kMaxBytes)
    throw jf::FieldError("is " + std::to_string(content.size()) + " bytes long; at most " +
                         std::to_string(kMaxBytes) + " are legal");
  const jf::Json json = jf::Parse(content);
  jf::ExpectKeys(json, {"format", "world_id", "seed", "robot", "tasks"});
  jf::Integer(json, "format", kFormat, kFormat);
  TaskSet set;
  set.world_id = jf::Text(json, "world_id");
  set.seed = jf::Unsigned(json, "seed");
  set.robot = DecodeRobot(json["robot"]);
  const jf::Json& tasks = jf::Array(json, "tasks");
  if (tasks.size() > kMaxTasks)
    throw jf::FieldError("has " + std::to_string(tasks.size()) + " tasks; at most " +
                         std::to_string(kMaxTasks) + " are legal");
  for (const jf::Json& task : tasks) {
    try {
      set.tasks.push_back(DecodeTask(task));
    } catch (const jf::FieldError& error) {
      throw jf::FieldError("task " + std::to_string(set.tasks.size()) + ": " + error.what());
    }
  }
  return set;
}

}  // namespace

std::string EncodeTasks(const TaskSet& set) {
  jf::Json tasks = jf::Json::array();
  for (const NavigationTask& task : set.tasks) tasks.push_back(Encode(task));
  return jf::Dump({{"format", kFormat},
                   {"world_id", set.world_id},
                   {"seed", set.seed},
                   {"robot", Encode(set.robot)},
                   {"tasks", std::move(tasks)}});
}

Result<TaskSet> DecodeTasks(std::string_view content) {
  try {
    return DecodeAll(content);
  } catch (const jf::FieldError& error) {
    return DataLoss(error.what());
  } catch (const jf::Json::exception& error) {
    return DataLoss(error.what());
  }
}

}  // namespace latticeworld
