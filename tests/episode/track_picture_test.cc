#include "latticeworld/episode/track_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "generation/test_world.h"

namespace latticeworld {
namespace {

cv::Mat Draw(const EpisodeRecord& record, int width_px = 400) {
  PictureOptions options;
  options.width_px = width_px;
  const auto png = DrawTracks(*MakeTestWorld()->scene, record, options);
  EXPECT_TRUE(png.ok()) << png.status().ToString();
  if (!png.ok()) return cv::Mat();
  return cv::imdecode(std::vector<char>(png->begin(), png->end()), cv::IMREAD_COLOR);
}

// A way from west to east through the middle of the world of 32 m, as robots of team 1 go it.
EpisodeRecord Crossing() {
  EpisodeRecord record;
  AgentTrack& track = record.tracks["robot"];
  track = {"robot", "wheeled robot", 1, true, {}};
  for (int i = -10; i <= 10; ++i) {
    TrackPoint point;
    point.position_m = {static_cast<double>(i), 0.0, 0.0};
    point.continues = i > -10;
    track.points.push_back(point);
  }
  return record;
}

bool IsTeamBlue(const cv::Vec3b& bgr) { return bgr[0] > 140 && bgr[1] < 160 && bgr[2] < 60; }

// Pixels of the team's colour in a column of the picture, at x metres of the world.
int BluesAt(const cv::Mat& picture, double x_m) {
  const int margin = picture.cols / 50;
  const int column = margin + static_cast<int>((x_m + 16.0) / 32.0 * (picture.cols - 2 * margin));
  int count = 0;
  for (int row = margin; row < picture.cols - margin; ++row) {
    count += IsTeamBlue(picture.at<cv::Vec3b>(row, column));
  }
  return count;
}

TEST(TrackPictureTest, AWayIsDrawnWhereItWent) {
  const cv::Mat picture = Draw(Crossing());
  ASSERT_FALSE(picture.empty());
  for (const double x_m : {-8.0, -3.0, 0.0, 5.0}) EXPECT_GT(BluesAt(picture, x_m), 0) << x_m;
  for (const double x_m : {-14.0, 14.0}) EXPECT_EQ(BluesAt(picture, x_m), 0) << x_m;
}

TEST(TrackPictureTest, NoLineLeadsToWhereSomebodyWasPut) {
  EpisodeRecord record = Crossing();
  record.tracks["robot"].points.resize(6);  // to x = -5 m
  TrackPoint put;
  put.position_m = {12.0, 0.0, 0.0};
  record.tracks["robot"].points.push_back(put);
  const cv::Mat picture = Draw(record);
  EXPECT_GT(BluesAt(picture, -8.0), 0);
  EXPECT_EQ(BluesAt(picture, 3.0), 0);
}

TEST(TrackPictureTest, WhatIsFarOutsideDoesNoHarm) {
  EpisodeRecord record = Crossing();
  record.tracks["robot"].points.back().position_m = {1e12, -1e12, 0.0};
  EXPECT_FALSE(Draw(record).empty());
  record.tracks.clear();
  EXPECT_FALSE(Draw(record).empty());
}

TEST(TrackPictureTest, AWidthThatNoPictureHasIsRefused) {
  PictureOptions options;
  options.width_px = 1;
  EXPECT_EQ(DrawTracks(*MakeTestWorld()->scene, Crossing(), options).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
