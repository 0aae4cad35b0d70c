#include "latticeworld/generation/bundle/raster_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "generation/test_world.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {
namespace {

cv::Mat Decode(const std::string& png) {
  return cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
}

TEST(RasterFilesTest, HeightsReadBackAsAHeightMapWithinHalfAStep) {
  const auto world = MakeTestWorld();
  const Grid<float>& height_m = world->scene->terrain->ground.height_m();
  const auto encoded = EncodeHeights(height_m);
  ASSERT_TRUE(encoded.ok());
  const auto relief = ReadHeightMap(encoded->png, {encoded->scale_m, encoded->offset_m});
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  ASSERT_EQ(relief->height_m.rows(), height_m.rows());
  for (int row = 0; row < height_m.rows(); ++row) {
    for (int col = 0; col < height_m.cols(); ++col) {
      ASSERT_NEAR(relief->height_m(row, col), height_m(row, col), 0.51 * encoded->scale_m / 65535)
          << "row " << row << ", column " << col;
    }
  }
}

TEST(RasterFilesTest, FlatGroundIsBlackAtItsHeight) {
  const auto encoded = EncodeHeights(Grid<float>(40, 40, 7.5f));
  ASSERT_TRUE(encoded.ok());
  EXPECT_EQ(encoded->scale_m, 0.0);
  EXPECT_EQ(encoded->offset_m, 7.5);
  EXPECT_EQ(cv::countNonZero(Decode(encoded->png)), 0);
}

TEST(RasterFilesTest, WaterIsDryOrItsDepth) {
  constexpr float kDry = std::numeric_limits<float>::quiet_NaN();
  Terrain terrain;
  const GridGeometry geometry = GridGeometry::FromCells(2, 1.0);
  Grid<float> height_m(2, 2, 1.0f);
  height_m(1, 1) = 0.0f;
  terrain.ground = HeightField(geometry, height_m);
  terrain.water_level_m = Grid<float>(2, 2, kDry);
  terrain.water_level_m(0, 1) = 0.5f;  // a shore cell above the level: wet, no depth
  terrain.water_level_m(1, 0) = 2.0f;  // 1 m deep
  terrain.water_level_m(1, 1) = 2.0f;  // 2 m deep
  const auto encoded = EncodeWaterDepths(terrain);
  ASSERT_TRUE(encoded.ok());
  EXPECT_EQ(encoded->scale_m, 2.0);
  const cv::Mat pixels = Decode(encoded->png);
  ASSERT_EQ(pixels.type(), CV_16UC1);
  EXPECT_EQ(pixels.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(pixels.at<std::uint16_t>(0, 1), 1);
  EXPECT_EQ(pixels.at<std::uint16_t>(1, 0), 32768);
  EXPECT_EQ(pixels.at<std::uint16_t>(1, 1), 65535);
}

TEST(RasterFilesTest, WeightsAreEightBit) {
  Grid<float> weight(1, 3);
  weight(0, 1) = 0.5f;
  weight(0, 2) = 1.0f;
  const auto png = EncodeWeights(weight);
  ASSERT_TRUE(png.ok());
  const cv::Mat pixels = Decode(*png);
  ASSERT_EQ(pixels.type(), CV_8UC1);
  EXPECT_EQ(pixels.at<std::uint8_t>(0, 0), 0);
  EXPECT_EQ(pixels.at<std::uint8_t>(0, 1), 128);
  EXPECT_EQ(pixels.at<std::uint8_t>(0, 2), 255);
}

}  // namespace
}  // namespace latticeworld
