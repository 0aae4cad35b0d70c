#include "latticeworld/navigation/tasks_json.h"

#include <gtest/gtest.h>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TaskSet SomeTasks() {
  TestScene land;
  land.height_m = Hills(1.0, 25.0);
  for (int i = 0; i < 12; ++i) land.AddTree(4.0 * i - 24.0, 3.0 * (i % 4));
  TaskWishes wishes;
  wishes.count = 3;
  wishes.seed = 11;
  TaskSet set;
  set.world_id = "world-1";
  set.seed = wishes.seed;
  set.robot = wishes.robot;
  set.tasks = SampleTasks(*land.Build(), wishes, Progress()).value();
  return set;
}

TEST(TasksJson, ReadsBackWhatItWrote) {
  const TaskSet set = SomeTasks();
  const std::string text = EncodeTasks(set);
  const TaskSet read = DecodeTasks(text).value();
  EXPECT_EQ(EncodeTasks(read), text);
  ASSERT_EQ(read.tasks.size(), set.tasks.size());
  for (std::size_t i = 0; i < set.tasks.size(); ++i) {
    EXPECT_EQ(read.tasks[i].goal.x_m, set.tasks[i].goal.x_m);
    EXPECT_EQ(read.tasks[i].way.length_m, set.tasks[i].way.length_m);
    EXPECT_EQ(read.tasks[i].way.points_m, set.tasks[i].way.points_m);
  }
}

TEST(TasksJson, SaysWhatIsWrongAndWhere) {
  const std::string text = EncodeTasks(SomeTasks());
  const auto said = [](std::string changed) {
    const Status status = DecodeTasks(changed).status();
    EXPECT_EQ(status.code(), StatusCode::kDataLoss);
    return status.message();
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.rfind(from);
    EXPECT_NE(at, std::string::npos);
    return changed.replace(at, from.size(), to);
  };
  EXPECT_EQ(said(with("\"goal_x_m\"", "\"gaol_x_m\"")), "task 2: the key goal_x_m is missing");
  EXPECT_NE(said(with("\"goal_radius_m\": 0.5", "\"goal_radius_m\": -1"))
                .find("task 2: goal_radius_m is -1, not a number from"),
            std::string::npos);
  EXPECT_NE(said(with("\"format\": 2", "\"format\": 3")).find("format is 3"), std::string::npos);
  EXPECT_FALSE(said("{").empty());
  EXPECT_FALSE(said(text.substr(0, text.size() / 2)).empty());
  EXPECT_FALSE(said("[]").empty());
}

}  // namespace
}  // namespace latticeworld
