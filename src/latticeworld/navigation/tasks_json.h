#ifndef LATTICEWORLD_NAVIGATION_TASKS_JSON_H_
#define LATTICEWORLD_NAVIGATION_TASKS_JSON_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/navigation/tasks.h"

namespace latticeworld {

// Tasks as a file keeps them, with the world and the robot that they are for.
struct TaskSet {
  std::string world_id;
  std::uint64_t seed = 0;
  RobotLimits robot;
  std::vector<NavigationTask> tasks;
};

// An object with a key for each field; numbers read back as they were.
std::string EncodeTasks(const TaskSet& set);

// Errors: DATA_LOSS naming the task (counted from 0) and what is wrong: keys, types, numbers out of
// range, another format. Whether the ways are free is for who knows the world to check.
Result<TaskSet> DecodeTasks(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_TASKS_JSON_H_
