#include "latticeworld/navigation/task_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "generation/test_world.h"

namespace latticeworld {
namespace {

cv::Mat Draw(const std::vector<NavigationTask>& tasks, int width_px = 400) {
  PictureOptions options;
  options.width_px = width_px;
  const auto png = DrawTasks(*MakeTestWorld()->scene, tasks, options);
  EXPECT_TRUE(png.ok()) << png.status().ToString();
  if (!png.ok()) return cv::Mat();
  return cv::imdecode(std::vector<char>(png->begin(), png->end()), cv::IMREAD_COLOR);
}

// From west to east in the world of 32 m.
NavigationTask Crossing(double y_m) {
  NavigationTask task;
  task.start = {-10.0, y_m};
  task.goal = {10.0, y_m};
  task.way.points_m = {{-10.0, y_m, 0.0}, {10.0, y_m, 0.0}};
  return task;
}

// Pixels that differ within `radius_m` of a place.
int DifferencesAt(const cv::Mat& a, const cv::Mat& b, double x_m, double y_m, double radius_m) {
  const int margin = a.cols / 50;
  const double px_per_m = (a.cols - 2 * margin) / 32.0;
  const int column = margin + static_cast<int>((x_m + 16.0) * px_per_m);
  const int row = margin + static_cast<int>((16.0 - y_m) * px_per_m);
  const int reach = static_cast<int>(radius_m * px_per_m);
  int count = 0;
  for (int r = row - reach; r <= row + reach; ++r) {
    for (int c = column - reach; c <= column + reach; ++c) {
      count += a.at<cv::Vec3b>(r, c) != b.at<cv::Vec3b>(r, c);
    }
  }
  return count;
}

TEST(TaskPictureTest, AWayIsDrawnWhereItGoesAndNowhereElse) {
  const cv::Mat empty = Draw({}), picture = Draw({Crossing(4.0)});
  for (const double x_m : {-10.0, -5.0, 0.0, 5.0, 10.0})
    EXPECT_GT(DifferencesAt(empty, picture, x_m, 4.0, 0.3), 0) << x_m;
  for (const double x_m : {-14.0, 14.0})
    EXPECT_EQ(DifferencesAt(empty, picture, x_m, 4.0, 1.0), 0) << x_m;
  for (const double y_m : {-8.0, 0.0, 8.0})
    EXPECT_EQ(DifferencesAt(empty, picture, 0.0, y_m, 1.0), 0) << y_m;
}

TEST(TaskPictureTest, GoalsTellTheirNumbers) {
  // The same places, told in another order: other numbers and colours at the goals.
  const cv::Mat one = Draw({Crossing(4.0), Crossing(-4.0)});
  const cv::Mat other = Draw({Crossing(-4.0), Crossing(4.0)});
  EXPECT_GT(DifferencesAt(one, other, 10.0, 4.0, 1.0), 20);
  EXPECT_GT(DifferencesAt(one, other, 10.0, -4.0, 1.0), 20);
}

TEST(TaskPictureTest, WhatLiesOutsideDoesNoHarm) {
  NavigationTask far = Crossing(1e12);
  EXPECT_FALSE(Draw({far}).empty());
  EXPECT_FALSE(Draw({Crossing(0.0)}, 64).empty());  // too small for letters
}

TEST(TaskPictureTest, AWidthThatNoPictureHasIsRefused) {
  PictureOptions options;
  options.width_px = 1;
  EXPECT_EQ(DrawTasks(*MakeTestWorld()->scene, {}, options).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
