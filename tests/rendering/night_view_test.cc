#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/looks/picture_assets.h"
#include "latticeworld/rendering/ray/lamp_lights.h"
#include "latticeworld/rendering/ray/ray_picture.h"
#include "latticeworld/scene/asset_physics.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr int kWidth_px = 180, kHeight_px = 120;

std::uint8_t ModelNamed(const std::string& name) {
  const auto& models = Catalogue::BuiltIn()->models();
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].name == name) return static_cast<std::uint8_t>(i);
  }
  ADD_FAILURE() << name;
  return 0;
}

Asset MakeModel(const std::string& name, float x_m, float y_m, float height_m, float half_m) {
  Asset asset = MakeBuilding(x_m, y_m, height_m, half_m, half_m, 0.0f);
  asset.model = ModelNamed(name);
  return asset;
}

// A house and trees on a plain, under that sky.
Scene Village(TimeOfDay time, Weather weather) {
  Scene scene = MakeScene(64, 64.0, [](double, double) { return 1.0; });
  scene.environment.coarse.time_of_day = time;
  scene.environment.coarse.weather = weather;
  scene.atmosphere = DeriveAtmosphere(scene.environment.coarse, 0.0, 0.0);
  return WithAssets(
      scene, {MakeModel("detached house", 12.0f, 3.0f, 7.0f, 4.0f),
              MakeTree(14.0f, -7.0f, 8.0f, 2.5f, 0.2f), MakeTree(22.0f, 12.0f, 9.0f, 2.5f, 0.2f)});
}

cv::Mat Picture(const Scene& scene, const RayCamera& camera) {
  cv::Mat bgr(kHeight_px, kWidth_px, CV_8UC3, cv::Scalar(0, 0, 0));
  const Status status =
      TracePicture(scene, MaterialsOf(scene), camera, RayPictureOptions(), Progress(), &bgr);
  EXPECT_TRUE(status.ok()) << status.ToString();
  return bgr;
}

RayCamera FromTheWest() {
  return RayCamera::Looking({-12.0f, 0.0f, 3.5f}, 0.0f, -0.06f, 1.0f, kWidth_px, kHeight_px);
}

// Without sky.
RayCamera DownFromTheWest() {
  return RayCamera::Looking({-2.0f, 0.0f, 12.0f}, 0.0f, -0.7f, 0.9f, kWidth_px, kHeight_px);
}

// Mean of the standard deviations of brightness in tiles, of 255.
double LocalContrast(const cv::Mat& grey) {
  constexpr int kTile_px = 20;
  double sum = 0.0;
  int tiles = 0;
  for (int y = 0; y + kTile_px <= grey.rows; y += kTile_px) {
    for (int x = 0; x + kTile_px <= grey.cols; x += kTile_px) {
      cv::Scalar mean, deviation;
      cv::meanStdDev(grey(cv::Rect(x, y, kTile_px, kTile_px)), mean, deviation);
      sum += deviation[0];
      ++tiles;
    }
  }
  return sum / tiles;
}

TEST(NightViewTest, ShapesAreSeenByDayAndNightInSunshineAndRain) {
  for (const TimeOfDay time : {TimeOfDay::kNoon, TimeOfDay::kDusk, TimeOfDay::kNight}) {
    for (const Weather weather : {Weather::kSunny, Weather::kRain, Weather::kFog}) {
      SCOPED_TRACE(std::string(NameOf(time)) + " " + std::string(NameOf(weather)));
      for (const RayCamera& camera : {FromTheWest(), DownFromTheWest()}) {
        cv::Mat grey;
        cv::cvtColor(Picture(Village(time, weather), camera), grey, cv::COLOR_BGR2GRAY);
        const double mean = cv::mean(grey)[0];
        EXPECT_GT(mean, 42.0);
        EXPECT_LT(mean, 220.0);
        EXPECT_GT(LocalContrast(grey), weather == Weather::kFog ? 3.0 : 5.0);
      }
    }
  }
}

TEST(NightViewTest, WhatIsBrightEnoughIsDrawnAsItWas) {
  // The exposure grows where a picture would be dark, never where it would be bright.
  const auto mean = [](TimeOfDay time) {
    return cv::mean(Picture(Village(time, Weather::kSunny), FromTheWest()));
  };
  const cv::Scalar noon = mean(TimeOfDay::kNoon), night = mean(TimeOfDay::kNight);
  EXPECT_GT(noon[1], 1.4 * night[1]);
}

TEST(NightViewTest, LampsThrowLightOnTheGroundBelowThemAtNightOnly) {
  Scene scene = Village(TimeOfDay::kNight, Weather::kSunny);
  scene = WithAssets(scene, {MakeModel("lamp", 5.0f, 0.0f, 4.2f, 0.22f)});
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const LampLights lit(scene, true), dark(scene, false);
  const float below = Brightness(lit.At({5.0f, 1.0f, 1.0f}, up));
  EXPECT_GT(below, 0.2f);
  EXPECT_LT(Brightness(lit.At({5.0f, 9.0f, 1.0f}, up)), 0.3f * below);
  EXPECT_EQ(Brightness(lit.At({5.0f, 40.0f, 1.0f}, up)), 0.0f);
  EXPECT_EQ(Brightness(dark.At({5.0f, 1.0f, 1.0f}, up)), 0.0f);
}

TEST(NightViewTest, AWellsWaterIsNoLitWindow) {
  Scene scene = Village(TimeOfDay::kNight, Weather::kSunny);
  const RayCamera below_roofs = RayCamera::Looking(
      {0.0f, -10.0f, 6.0f}, static_cast<float>(M_PI / 2.0), -0.45f, 1.0f, kWidth_px, kHeight_px);
  std::vector<Asset> wells;
  for (int i = 0; i < 6; ++i) {
    wells.push_back(MakeModel("well", 2.0f * static_cast<float>(i) - 5.0f, 0.0f, 2.4f, 0.9f));
  }
  const cv::Mat bgr = Picture(WithAssets(scene, wells), below_roofs);
  for (const Asset& well : wells) {
    // Lamplight is warm, moonlight on water is not.
    constexpr float kWater_m = 1.88f;
    const Eigen::Vector2f at = below_roofs.Project({well.x_m, well.y_m, kWater_m});
    const auto& pixel = bgr.at<cv::Vec3b>(static_cast<int>(at.y()), static_cast<int>(at.x()));
    EXPECT_LT(pixel[2] - pixel[0], 25) << well.x_m;
  }
}

TEST(NightViewTest, HousesOfCyberpunkTowerInPicturesOverTheSameBodies) {
  Scene scene = Village(TimeOfDay::kNoon, Weather::kSunny);
  scene.assets.push_back(MakeModel("bench", 0.0f, 9.0f, 0.85f, 0.9f));
  const std::vector<Asset> natural = DrawnAssets(scene, 0.0f);
  const CollisionPrimitive before = PhysicsOf(*scene.catalogue, scene.assets[0]).collision;
  scene.environment.coarse.artistic_style = ArtisticStyle::kCyberpunk;
  const std::vector<Asset> neon = DrawnAssets(scene, 0.0f);
  ASSERT_EQ(neon.size(), natural.size());
  EXPECT_GE(neon[0].height_m, 1.4f * natural[0].height_m);
  EXPECT_EQ(neon[0].half_length_m, natural[0].half_length_m);  // on the ground that it has
  EXPECT_NE(neon[0].model, natural[0].model);
  EXPECT_EQ(neon.back().height_m, natural.back().height_m);  // a bench stays one
  const CollisionPrimitive after = PhysicsOf(*scene.catalogue, scene.assets[0]).collision;
  EXPECT_EQ(after.half_length_m, before.half_length_m);
  EXPECT_EQ(after.height_m, before.height_m);
}

}  // namespace
}  // namespace latticeworld
