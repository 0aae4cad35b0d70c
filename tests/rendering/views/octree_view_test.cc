#include "latticeworld/rendering/views/octree_view.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "mapping/hand_made_scene.h"
#include "rendering/decode_picture.h"

namespace latticeworld {
namespace {

constexpr PictureOptions kOptions = {300, true};

Scene Meadow() {
  return MakeScene(64, 64.0, [](double, double) { return 1.0; });
}

// How many pixels differ, and where on average [px].
struct Change {
  int pixels = 0;
  cv::Point2d center;
};
Change ChangeBetween(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference, mask;
  cv::absdiff(a, b, difference);
  cv::cvtColor(difference, mask, cv::COLOR_BGR2GRAY);
  mask = mask > 8;
  const cv::Moments moments = cv::moments(mask, true);
  return {cv::countNonZero(mask), {moments.m10 / moments.m00, moments.m01 / moments.m00}};
}

TEST(OctreeViewTest, HousesStandWhereTheyAreAndEastIsToTheRight) {
  const auto with = [](float x_m, float y_m) {
    return Decode(DrawOctree(WithAssets(Meadow(), {MakeBuilding(x_m, y_m, 8.0f, 4.0f, 4.0f, 0.0f)}),
                             kOptions, Progress()));
  };
  const cv::Mat middle = with(0.0f, 0.0f);
  const Change east = ChangeBetween(middle, with(20.0f, 0.0f));
  const Change west = ChangeBetween(middle, with(-20.0f, 0.0f));
  const Change north = ChangeBetween(middle, with(0.0f, 20.0f));
  const Change south = ChangeBetween(middle, with(0.0f, -20.0f));
  EXPECT_GT(east.pixels, 100);
  EXPECT_GT(east.center.x, west.center.x + 20.0);
  EXPECT_LT(north.center.y, south.center.y - 8.0);
}

TEST(OctreeViewTest, LowVoxelsAreBlueAndHighOnesRed) {
  const Scene ramp = MakeScene(64, 64.0, [](double, double y_m) { return 0.5 * y_m; });
  const cv::Mat picture = Decode(DrawOctree(ramp, kOptions, Progress()));
  cv::Mat high, low;
  cv::inRange(picture, cv::Scalar(0, 0, 180), cv::Scalar(60, 60, 255), high);
  cv::inRange(picture, cv::Scalar(180, 0, 0), cv::Scalar(255, 60, 60), low);
  const cv::Moments red = cv::moments(high, true), blue = cv::moments(low, true);
  ASSERT_GT(red.m00, 50.0);
  ASSERT_GT(blue.m00, 50.0);
  EXPECT_LT(red.m01 / red.m00, blue.m01 / blue.m00) << "the high north lies above the low south";
}

TEST(OctreeViewTest, ACancelIsHeard) {
  Progress progress;
  progress.Cancel();
  const auto png = DrawOctree(Meadow(), kOptions, progress);
  ASSERT_FALSE(png.ok());
  EXPECT_EQ(png.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
