#include "latticeworld/rendering/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "mapping/hand_made_scene.h"
#include "rendering/decode_picture.h"

namespace latticeworld {
namespace {

constexpr int kWidth_px = 300;
// Coarse shapes and plain light, which are quick; the rays themselves: ray_picture_test.
constexpr PictureOptions kOptions = {kWidth_px, true, 3, true};
constexpr PictureOptions kUnmarked = {kWidth_px, false, 3, true};

Scene Meadow() {
  return MakeScene(64, 64.0, [](double, double) { return 1.0; });
}

Scene WithSurface(Scene scene, SurfaceClass surface) {
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (SurfaceClass& cell : terrain->surface) cell = surface;
  scene.terrain = terrain;
  return scene;
}

// Mean BGR over a box around a place, given in shares of the map's side from its north-west corner.
cv::Scalar TopColorAt(const cv::Mat& picture, double u, double v) {
  const int margin = kWidth_px / 50, side = kWidth_px - 2 * margin;
  const cv::Rect box(margin + static_cast<int>(u * side) - 4,
                     margin + static_cast<int>(v * side) - 4, 8, 8);
  return cv::mean(picture(box));
}

double Difference(const cv::Scalar& a, const cv::Scalar& b) { return cv::norm(a - b); }

TEST(PictureTest, ViewsAreColourPngsOfTheWidthAndStandSideBySide) {
  const cv::Mat top = Decode(DrawTopView(Meadow(), kOptions));
  const cv::Mat oblique = Decode(DrawObliqueView(Meadow(), kOptions));
  const cv::Mat both = Decode(DrawWorld(Meadow(), kOptions));
  EXPECT_EQ(top.cols, kWidth_px);
  EXPECT_EQ(oblique.size(), top.size());
  EXPECT_EQ(top.channels(), 3);
  EXPECT_EQ(both.rows, top.rows);
  EXPECT_GT(both.cols, 2 * kWidth_px - kWidth_px / 20);
  EXPECT_LE(both.cols, 2 * kWidth_px);
}

TEST(PictureTest, TheSameSceneGivesTheSameBytes) {
  EXPECT_EQ(*DrawWorld(Meadow(), kOptions), *DrawWorld(Meadow(), kOptions));
}

TEST(PictureTest, WidthsOutsideTheLimitsAreRefusedByEveryView) {
  for (const int width_px : {-1, 0, 63, 4097}) {
    const PictureOptions options = {width_px, true};
    for (const auto draw : {DrawTopView, DrawObliqueView, DrawWorld}) {
      const auto png = draw(Meadow(), options);
      ASSERT_FALSE(png.ok());
      EXPECT_EQ(png.status().code(), StatusCode::kInvalidArgument);
      EXPECT_NE(png.status().message().find(std::to_string(width_px)), std::string::npos);
    }
  }
  EXPECT_EQ(Decode(DrawWorld(Meadow(), {64, true})).rows,
            Decode(DrawTopView(Meadow(), {64, true})).rows);
}

TEST(PictureTest, NorthIsUpAndEastIsRight) {
  // Houses fill the north-east of the map; nothing else changes.
  const cv::Mat without = Decode(DrawTopView(Meadow(), kOptions));
  const cv::Mat with = Decode(DrawTopView(
      WithAssets(Meadow(), {MakeBuilding(14.0f, 12.0f, 5.0f, 6.0f, 5.0f, 0.0f)}), kOptions));
  const auto change = [&](double u, double v) {
    return Difference(TopColorAt(without, u, v), TopColorAt(with, u, v));
  };
  EXPECT_GT(change(0.5 + 14.0 / 64.0, 0.5 - 12.0 / 64.0), 30.0);
  EXPECT_LT(change(0.25, 0.25), 2.0);
  EXPECT_LT(change(0.25, 0.75), 2.0);
  EXPECT_LT(change(0.75, 0.75), 2.0);
}

TEST(PictureTest, WaterIsBlueGrassGreenAndSnowWhite) {
  const cv::Scalar grass = TopColorAt(Decode(DrawTopView(Meadow(), kOptions)), 0.4, 0.6);
  EXPECT_GT(grass[1], grass[0] + 20.0);
  EXPECT_GT(grass[1], grass[2]);
  const cv::Scalar water =
      TopColorAt(Decode(DrawTopView(WithWater(Meadow(), 3.0f), kOptions)), 0.4, 0.6);
  EXPECT_GT(water[0], water[1]);
  EXPECT_GT(water[0], water[2] + 40.0);
  const cv::Scalar snow = TopColorAt(
      Decode(DrawTopView(WithSurface(Meadow(), SurfaceClass::kSnow), kOptions)), 0.4, 0.6);
  for (int channel = 0; channel < 3; ++channel) EXPECT_GT(snow[channel], 215.0);
}

TEST(PictureTest, SlopesThatFaceTheNorthWestAreLighter) {
  const Scene ridge =
      MakeScene(64, 64.0, [](double x_m, double y_m) { return 12.0 - 0.35 * std::abs(x_m - y_m); });
  const cv::Mat picture = Decode(DrawTopView(ridge, kOptions));
  // The ridge runs from south-west to north-east.
  EXPECT_GT(cv::sum(TopColorAt(picture, 0.35, 0.35))[0],
            cv::sum(TopColorAt(picture, 0.65, 0.65))[0] + 40.0);
}

TEST(PictureTest, EverySeasonAndWeatherLooksDifferentFromTheSouth) {
  Scene scene = Meadow();
  std::vector<std::string> pictures;
  for (const auto& weather : EnumNames(Weather{})) {
    scene.atmosphere.weather = weather.value;
    pictures.push_back(*DrawObliqueView(scene, kOptions));
  }
  scene.atmosphere.weather = Weather::kSunny;
  for (const auto& season : EnumNames(Season{})) {
    scene.environment.coarse.season = season.value;
    scene.environment.coarse.time_of_day = TimeOfDay::kDusk;
    pictures.push_back(*DrawObliqueView(scene, kOptions));
  }
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " " << j;
}

TEST(PictureTest, EveryStyleHasItsOwnPaletteInBothViews) {
  std::vector<cv::Mat> tops, obliques;
  for (const auto& style : EnumNames(ArtisticStyle{})) {
    Scene scene = WithAssets(Meadow(), {MakeTree(-12.0f, 8.0f, 9.0f, 3.0f, 0.3f),
                                        MakeBuilding(10.0f, 6.0f, 6.0f, 5.0f, 4.0f, 0.3f)});
    scene.environment.coarse.artistic_style = style.value;
    tops.push_back(Decode(DrawTopView(scene, kOptions)));
    obliques.push_back(Decode(DrawObliqueView(scene, kOptions)));
  }
  const cv::Rect grass(100, 180, 40, 40);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const auto* views : {&tops, &obliques})
        EXPECT_GT(Difference(cv::mean((*views)[i](grass)), cv::mean((*views)[j](grass))), 15.0)
            << i << " " << j;
    }
  }
}

TEST(PictureTest, StylesChangeColoursAndProportionsButNotWhereThingsAre) {
  // What a house changes in a picture stands in the same place in every style.
  std::vector<cv::Rect> places;
  for (const auto& style : EnumNames(ArtisticStyle{})) {
    Scene scene = Meadow();
    scene.environment.coarse.artistic_style = style.value;
    scene.environment.coarse.weather = Weather::kFog;
    scene.atmosphere.weather = Weather::kFog;
    const cv::Mat without = Decode(DrawObliqueView(scene, kOptions));
    const cv::Mat with = Decode(DrawObliqueView(
        WithAssets(scene, {MakeBuilding(4.0f, 0.0f, 6.0f, 5.0f, 4.0f, 0.0f)}), kOptions));
    cv::Rect place;
    for (int y = 0; y < with.rows; ++y)
      for (int x = 0; x < with.cols; ++x)
        if (cv::norm(with.at<cv::Vec3b>(y, x), without.at<cv::Vec3b>(y, x)) > 10.0)
          place |= cv::Rect(x, y, 1, 1);
    places.push_back(place);
  }
  for (const cv::Rect& place : places) {
    EXPECT_GT(place.area(), 400);
    EXPECT_NEAR(place.x, places[0].x, 4);
    EXPECT_NEAR(place.width, places[0].width, 8);
    EXPECT_NEAR(place.br().y, places[0].br().y, 4);
  }
}

TEST(PictureTest, VillageGroundIsGardenAndARoadThroughItStandsOut) {
  Scene scene = WithSurface(Meadow(), SurfaceClass::kBuilding);
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (int row = 28; row < 36; ++row)
    for (int col = 0; col < 64; ++col) terrain->surface(row, col) = SurfaceClass::kRoad;
  scene.terrain = terrain;
  const cv::Mat picture = Decode(DrawTopView(scene, kOptions));
  const cv::Scalar road = TopColorAt(picture, 0.5, 0.5);
  EXPECT_LT(std::abs(road[1] - road[2]), 8.0);  // grey
  cv::Scalar village;
  for (const double u : {0.2, 0.4, 0.6, 0.8})
    for (const double v : {0.1, 0.25, 0.75, 0.9}) village += TopColorAt(picture, u, v) / 16.0;
  EXPECT_GT(village[1], village[0] + 25.0);
  EXPECT_GT(village[1], village[2]);
  EXPECT_GT(Difference(road, village), 40.0);
}

TEST(PictureTest, ThickAirLeavesTheNearHalfReadable) {
  // Contrast between a dark road and snow, near and in the middle, in the thickest air.
  Scene scene = WithSurface(Meadow(), SurfaceClass::kSnow);
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (int row = 0; row < 64; ++row)
    for (int col = 28; col < 36; ++col) terrain->surface(row, col) = SurfaceClass::kRoad;
  scene.terrain = terrain;
  scene.environment.coarse.time_of_day = TimeOfDay::kDusk;
  const auto contrast = [&](double visibility_m, Weather weather, int y) {
    scene.atmosphere.weather = weather;
    scene.atmosphere.visibility_m = visibility_m;
    const cv::Mat picture = Decode(DrawObliqueView(scene, kUnmarked));
    return Difference(cv::mean(picture(cv::Rect(145, y, 10, 6))),
                      cv::mean(picture(cv::Rect(90, y, 10, 6))));
  };
  for (const int y : {160, 200, 240})
    EXPECT_GT(contrast(10.0, Weather::kFog, y), 0.45 * contrast(1e5, Weather::kSunny, y)) << y;
}

TEST(PictureTest, FlyersAreMarkedAtTheirHeight) {
  const auto top_of_mark = [](double height_m) {
    Scene scene = Meadow();
    const cv::Mat empty = Decode(DrawObliqueView(scene, kUnmarked));
    AgentStart eagle;
    eagle.category = AgentCategory::kEagle;
    eagle.position = {0.0, -20.0};
    eagle.height_above_ground_m = height_m;
    scene.agents.push_back(eagle);
    const cv::Mat marked = Decode(DrawObliqueView(scene, kOptions));
    for (int y = 0; y < kWidth_px - 6; ++y)
      if (cv::norm(marked.row(y).colRange(7, 293), empty.row(y).colRange(7, 293), cv::NORM_INF) >
          60.0)
        return y;
    return -1;
  };
  const int low = top_of_mark(9.0), high = top_of_mark(18.0);
  ASSERT_GT(high, 0);
  // 64 m take up to 0.95 of the picture's width.
  const double px_per_m = 0.95 * 288.0 / 64.0;
  EXPECT_NEAR(low - high, 9.0 * px_per_m, 0.12 * 9.0 * px_per_m);
}

TEST(PictureTest, CompressionOutsideTheLimitsIsRefusedTogetherWithTheWidth) {
  const auto png = DrawWorld(Meadow(), {10, true, 11});
  ASSERT_FALSE(png.ok());
  EXPECT_NE(png.status().message().find("10"), std::string::npos);
  EXPECT_NE(png.status().message().find("11"), std::string::npos);
  EXPECT_LT(DrawTopView(Meadow(), {kWidth_px, true, 9})->size(),
            DrawTopView(Meadow(), {kWidth_px, true, 1})->size());
}

TEST(PictureTest, AHillHidesWhatStandsBehindIt) {
  // A wall of land across the south half; a house behind it, then the same house on its top.
  const auto picture_with = [](float y_m, bool house) {
    Scene scene =
        MakeScene(64, 64.0, [](double, double y) { return y < -8.0 && y > -14.0 ? 40.0 : 0.0; });
    if (house) scene = WithAssets(scene, {MakeBuilding(0.0f, y_m, 4.0f, 3.0f, 2.0f, 0.0f)});
    // Without sun no shadow gives the house away.
    scene.atmosphere.weather = Weather::kFog;
    scene.atmosphere.sun_direction = -Eigen::Vector3d::UnitY();
    return Decode(DrawObliqueView(scene, kUnmarked));
  };
  const cv::Mat empty = picture_with(0.0f, false);
  EXPECT_LT(cv::norm(empty, picture_with(-3.0f, true), cv::NORM_INF), 40.0);
  EXPECT_GT(cv::norm(empty, picture_with(-11.0f, true), cv::NORM_INF), 60.0);
}

TEST(PictureTest, AgentsAreMarkedOnlyWhenAsked) {
  Scene scene = Meadow();
  const cv::Mat empty = Decode(DrawTopView(scene, kOptions));
  AgentStart robot;
  robot.category = AgentCategory::kWheeledRobot;
  robot.position = {-16.0, -16.0};
  scene.agents.push_back(robot);
  const cv::Mat marked = Decode(DrawTopView(scene, kOptions));
  const cv::Mat unmarked = Decode(DrawTopView(scene, kUnmarked));
  EXPECT_GT(Difference(TopColorAt(empty, 0.25, 0.75), TopColorAt(marked, 0.25, 0.75)), 20.0);
  EXPECT_LT(Difference(TopColorAt(empty, 0.25, 0.75), TopColorAt(unmarked, 0.25, 0.75)), 1.0);
}

TEST(PictureTest, ExtremeWorldsAreDrawn) {
  // The smallest and a steep one; things beyond the edge; a sun below the horizon.
  Scene scene = MakeScene(32, 16.0, [](double x_m, double) { return 500.0 * x_m; });
  scene = WithAssets(scene, {MakeTree(8.0f, 8.0f, 30.0f, 6.0f, 1.0f),
                             MakeBuilding(-8.0f, -8.0f, 90.0f, 9.0f, 9.0f, 1.0f),
                             MakeRound(AssetKind::kStone, 0.0f, 0.0f, 0.0f, 0.0f)});
  scene.atmosphere.sun_direction = -Eigen::Vector3d::UnitZ();
  scene.atmosphere.visibility_m = 0.0;
  scene.atmosphere.snow_depth_m = 5.0;
  scene.environment.coarse.time_of_day = TimeOfDay::kNight;
  AgentStart eagle;
  eagle.category = AgentCategory::kEagle;
  eagle.position = {8.0, 8.0};
  eagle.height_above_ground_m = 400.0;
  scene.agents.push_back(eagle);
  for (const int width_px : {64, 100, 301})
    EXPECT_FALSE(Decode(DrawWorld(scene, {width_px, true})).empty());
}

}  // namespace
}  // namespace latticeworld
