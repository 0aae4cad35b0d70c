#include "latticeworld_ros/navigator/navigator_goal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

geometry_msgs::PoseStamped GoalAt(double x_m, double y_m, double heading_rad,
                                  const std::string& frame = "map") {
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = frame;
  goal.header.stamp = ros::Time(1e6);  // long after every transform
  goal.pose.position.x = x_m;
  goal.pose.position.y = y_m;
  goal.pose.orientation.z = std::sin(heading_rad / 2.0);
  goal.pose.orientation.w = std::cos(heading_rad / 2.0);
  return goal;
}

// map -> odom -> base_link: at (10, 20), which looks north.
void Fill(tf2_ros::Buffer* buffer) {
  const Eigen::Isometry3d north =
      ToIsometry({10.0, 20.0, 1.0},
                 Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ())));
  const ros::Time stamp(5.0);
  buffer->setTransform(ToTransformStamped(Eigen::Isometry3d::Identity(), stamp, "map", "odom"),
                       "test");
  buffer->setTransform(ToTransformStamped(north, stamp, "odom", "base_link"), "test");
  buffer->setTransform(ToTransformStamped(north, stamp, "moon", "rover"), "test");
}

TEST(NavigatorGoalTest, AGoalInTheMapIsWhatItSays) {
  const tf2_ros::Buffer buffer;
  for (const char* frame : {"map", "/map"}) {
    const auto goal = ReadGoal(GoalAt(3.0, -4.0, 0.5, frame), buffer, "map", "goal");
    ASSERT_TRUE(goal.ok()) << goal.status().ToString();
    EXPECT_DOUBLE_EQ(goal->place.x_m, 3.0);
    EXPECT_DOUBLE_EQ(goal->place.y_m, -4.0);
    EXPECT_NEAR(goal->heading_rad, 0.5, 1e-12);
  }
}

TEST(NavigatorGoalTest, AGoalInAnotherFrameIsTakenToTheMap) {
  tf2_ros::Buffer buffer;
  Fill(&buffer);
  const auto goal = ReadGoal(GoalAt(2.0, 0.0, 0.25, "base_link"), buffer, "map", "goal");
  ASSERT_TRUE(goal.ok()) << goal.status().ToString();
  EXPECT_NEAR(goal->place.x_m, 10.0, 1e-9);
  EXPECT_NEAR(goal->place.y_m, 22.0, 1e-9);
  EXPECT_NEAR(goal->heading_rad, M_PI / 2.0 + 0.25, 1e-9);
}

TEST(NavigatorGoalTest, WhatIsNoGoalIsRefusedWithWhatWasGivenAndWhatIsLegal) {
  tf2_ros::Buffer buffer;
  Fill(&buffer);
  const auto expect_refused = [&](const geometry_msgs::PoseStamped& goal, const char* given,
                                  const char* legal) {
    const Status status = ReadGoal(goal, buffer, "map", "goal").status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << given;
    EXPECT_NE(status.message().find(given), std::string::npos) << status.message();
    EXPECT_NE(status.message().find(legal), std::string::npos) << status.message();
  };
  expect_refused(GoalAt(NAN, 0.0, 0.0), "nan", "finite");
  expect_refused(GoalAt(0.0, INFINITY, 0.0), "inf", "finite");
  geometry_msgs::PoseStamped goal = GoalAt(0.0, 0.0, 0.0);
  goal.pose.orientation.w = 0.0;
  expect_refused(goal, "(0, 0, 0, 0)", "length 1");
  goal.pose.orientation.z = NAN;
  expect_refused(goal, "nan", "length 1");
  goal = GoalAt(0.0, 0.0, 0.0);
  goal.pose.orientation.x = 1.0;
  goal.pose.orientation.w = 0.0;
  expect_refused(goal, "(1, 0, 0, 0)", "upright");
  expect_refused(GoalAt(0.0, 0.0, 0.0, ""), "no frame", "\"map\"");
  expect_refused(GoalAt(0.0, 0.0, 0.0, "mars"), "\"mars\"", "\"map\"");
  expect_refused(GoalAt(0.0, 0.0, 0.0, "rover"), "\"rover\"", "\"map\"");
}

TEST(NavigatorGoalTest, EveryViolationIsNamedAtItsField) {
  tf2_ros::Buffer buffer;
  Fill(&buffer);
  nav_msgs::GetPlan::Request request;
  request.start = GoalAt(NAN, 0.0, 0.0);
  request.goal = GoalAt(0.0, INFINITY, NAN, "mars");
  request.tolerance = -1.0f;
  const Status status = ReadPlanRequest(request, buffer, "map").status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  std::vector<std::string> fields;
  for (const Violation& violation : status.violations()) fields.push_back(violation.pointer);
  EXPECT_EQ(fields, (std::vector<std::string>{"start.pose.position", "goal.pose.position",
                                              "goal.pose.orientation", "goal.header.frame_id",
                                              "tolerance"}))
      << status.ToString();
}

TEST(NavigatorGoalTest, APlanBeginsWhereTheRobotIsUnlessItIsSaid) {
  const tf2_ros::Buffer buffer;
  nav_msgs::GetPlan::Request request;
  request.goal = GoalAt(3.0, -4.0, 0.0);
  request.tolerance = 0.5f;
  auto plan = ReadPlanRequest(request, buffer, "map");
  ASSERT_TRUE(plan.ok()) << plan.status().ToString();
  EXPECT_FALSE(plan->start.has_value());
  EXPECT_DOUBLE_EQ(plan->goal.y_m, -4.0);
  EXPECT_DOUBLE_EQ(plan->tolerance_m, 0.5);
  request.start = GoalAt(1.0, 2.0, 0.0);
  plan = ReadPlanRequest(request, buffer, "map");
  ASSERT_TRUE(plan.ok()) << plan.status().ToString();
  EXPECT_DOUBLE_EQ(plan->start->x_m, 1.0);
}

TEST(NavigatorGoalTest, TransformsOfOtherTimesAreUnavailable) {
  tf2_ros::Buffer buffer;
  Fill(&buffer);
  ros::Time of;
  ASSERT_TRUE(LookUp(buffer, "map", "base_link", ros::Time(5.0), &of).ok());
  EXPECT_EQ(of, ros::Time(5.0));
  EXPECT_EQ(LookUp(buffer, "map", "base_link", ros::Time(9.0)).status().code(),
            StatusCode::kUnavailable);
  EXPECT_EQ(LookUp(buffer, "map", "mars", ros::Time()).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
