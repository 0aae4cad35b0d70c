#include "latticeworld/language/remote/relief_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace latticeworld {
namespace {

cv::Mat Decoded(const Grid<float>& height_m) {
  const auto png = ReliefPicture(height_m);
  EXPECT_TRUE(png.ok()) << png.status().ToString();
  const std::vector<unsigned char> bytes(png->begin(), png->end());
  return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
}

TEST(ReliefPictureTest, GoesFromBlackAtTheLowestToWhiteAtTheHighest) {
  Grid<float> height_m(33, 65);
  for (int row = 0; row < 33; ++row) {
    for (int col = 0; col < 65; ++col) height_m(row, col) = -20.0f + 3.0f * static_cast<float>(row);
  }
  const cv::Mat picture = Decoded(height_m);
  ASSERT_EQ(picture.type(), CV_8UC1);
  ASSERT_EQ(picture.rows, 33);
  ASSERT_EQ(picture.cols, 65);
  EXPECT_EQ(picture.at<unsigned char>(0, 10), 0);
  EXPECT_EQ(picture.at<unsigned char>(32, 60), 255);
  EXPECT_NEAR(picture.at<unsigned char>(16, 0), 128, 1);
}

TEST(ReliefPictureTest, IsNeverLongerThanModelsLookAt) {
  const cv::Mat picture = Decoded(Grid<float>(1024, 100, 5.0f));
  EXPECT_EQ(picture.rows, kMaxReliefPictureSide);
  EXPECT_EQ(picture.cols, 50);
  EXPECT_EQ(picture.at<unsigned char>(7, 7), 0);  // flat land has no highest ground
}

}  // namespace
}  // namespace latticeworld
