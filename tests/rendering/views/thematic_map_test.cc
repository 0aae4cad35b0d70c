#include "latticeworld/rendering/views/thematic_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <opencv2/core.hpp>

#include "mapping/hand_made_scene.h"
#include "rendering/decode_picture.h"

namespace latticeworld {
namespace {

constexpr int kWidth_px = 300;
constexpr PictureOptions kOptions = {kWidth_px, true};

// Mean BGR over a box around a place, given in shares of the map's side from its north-west corner.
cv::Scalar ColorAt(const cv::Mat& picture, double u, double v) {
  const int margin = kWidth_px / 50, side = kWidth_px - 2 * margin;
  return cv::mean(picture(cv::Rect(margin + static_cast<int>(u * side) - 4,
                                   margin + static_cast<int>(v * side) - 4, 8, 8)));
}

// A roof whose ridge runs from west to east.
Scene Roof() {
  return MakeScene(64, 64.0, [](double, double y_m) { return 20.0 - 0.5 * std::abs(y_m); });
}

TEST(ThematicMapTest, SlopesTowardsTheLightAreLighter) {
  const cv::Mat map = Decode(DrawThematicMap(Roof(), MapTheme::kHillshade, kOptions));
  const cv::Scalar north = ColorAt(map, 0.5, 0.25), south = ColorAt(map, 0.5, 0.75);
  EXPECT_GT(north[0], south[0] + 40.0);
  EXPECT_NEAR(north[0], north[2], 1.0) << "a hillshade is grey";
}

TEST(ThematicMapTest, HighAndLowLandAndWaterDifferInTint) {
  Scene scene = MakeScene(64, 64.0, [](double x_m, double) { return x_m; });
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (int r = 0; r < 64; ++r) {
    for (int c = 0; c < 10; ++c) terrain->water_level_m(r, c) = -20.0f;
  }
  scene.terrain = terrain;
  const cv::Mat map = Decode(DrawThematicMap(scene, MapTheme::kHeight, kOptions));
  const cv::Scalar water = ColorAt(map, 0.07, 0.5), low = ColorAt(map, 0.3, 0.5),
                   high = ColorAt(map, 0.95, 0.5);
  EXPECT_GT(water[0], water[2] + 40.0) << "water is blue";
  EXPECT_GT(low[1], low[2]) << "low land is green";
  EXPECT_GT(high[2], high[1] - 3.0) << "high land is not";
}

TEST(ThematicMapTest, ClassesHaveTheColoursOfTheirVocabulary) {
  Scene scene = Roof();
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  std::string text;
  for (int row = 0; row < kLayoutSize; ++row) text += std::string(kLayoutSize, 'F') + "\n";
  const auto forest = ParseLayout(text, Vocabulary::kWild);
  ASSERT_TRUE(forest.ok());
  terrain->weights = ToWeights(DecodeLayout(*forest, scene.geometry(), DecodeOptions(), 1).masks);
  scene.terrain = terrain;
  const Rgb rgb = FindClass(Vocabulary::kWild, 'F')->color;
  const cv::Scalar color =
      ColorAt(Decode(DrawThematicMap(scene, MapTheme::kClasses, kOptions)), 0.5, 0.5);
  EXPECT_NEAR(color[0], rgb.b, 2.0);
  EXPECT_NEAR(color[1], rgb.g, 2.0);
  EXPECT_NEAR(color[2], rgb.r, 2.0);
}

TEST(ThematicMapTest, ASketchIsBlueInTheValleyAndBlackOnTheRidge) {
  // One valley and one ridge from north to south, both falling to the south.
  const Scene scene = MakeScene(128, 128.0, [](double x_m, double y_m) {
    return 10.0 * std::sin(2.0 * M_PI * x_m / 128.0) + 0.1 * y_m + 20.0;
  });
  const cv::Mat sketch = Decode(DrawThematicMap(scene, MapTheme::kSketch, kOptions));
  ASSERT_EQ(sketch.size(), cv::Size(kWidth_px, kWidth_px));
  const auto rows_with = [&sketch](const cv::Vec3b& color, int col) {
    int rows = 0;
    for (int r = 0; r < sketch.rows; ++r) {
      bool found = false;
      for (int c = col - 10; c <= col + 10; ++c)
        found = found || sketch.at<cv::Vec3b>(r, c) == color;
      rows += found ? 1 : 0;
    }
    return rows;
  };
  const cv::Vec3b blue(255, 0, 0), black(0, 0, 0);
  const int valley = kWidth_px / 4, ridge = 3 * kWidth_px / 4;
  EXPECT_GT(rows_with(blue, valley), 0.7 * kWidth_px);
  EXPECT_GT(rows_with(black, ridge), 0.7 * kWidth_px);
  EXPECT_LT(rows_with(black, valley), 0.3 * kWidth_px);
  EXPECT_LT(rows_with(blue, ridge), 0.3 * kWidth_px);
}

TEST(ThematicMapTest, WidthsOutsideTheLimitsAreRefused) {
  for (const auto& entry : EnumNames(MapTheme{})) {
    const auto png = DrawThematicMap(Roof(), entry.value, {63, true});
    ASSERT_FALSE(png.ok()) << entry.name;
    EXPECT_EQ(png.status().code(), StatusCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace latticeworld
