// What ground looks like from afar and close by: fields, gardens, lawns, outlines.

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/looks/picture_assets.h"
#include "latticeworld/rendering/ray/picture_light.h"
#include "latticeworld/rendering/ray/ray_picture.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

Scene Covered(SurfaceClass surface, TerrainType type = TerrainType::kPlain) {
  Scene scene = MakeScene(64, 64.0, [](double, double) { return 1.0; });
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (SurfaceClass& cell : terrain->surface) cell = surface;
  scene.terrain = terrain;
  scene.environment.coarse.terrain_type = type;
  return scene;
}

Color MeanAround(const cv::Mat& color, int row, int col, int reach) {
  const cv::Scalar mean =
      cv::mean(color(cv::Rect(col - reach, row - reach, 2 * reach + 1, 2 * reach + 1)));
  return {static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2])};
}

std::uint8_t CropVariant(const std::string& name) {
  const auto& variants = Catalogue::BuiltIn()->season_variants(AssetType::kCrops);
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (variants[i].name == name) return static_cast<std::uint8_t>(i);
  ADD_FAILURE() << name;
  return 0;
}

TEST(GroundLookTest, FieldsAreWhereTheirCropsStandAndNowhereElse) {
  Scene scene = Covered(SurfaceClass::kFarmland);
  const cv::Mat bare = MaterialsOf(scene).color;
  std::vector<Asset> crops;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 22; ++j) {
      Asset crop = MakeRound(AssetKind::kCrop, -28.0f + 2.5f * static_cast<float>(i),
                             -27.0f + 2.5f * static_cast<float>(j), 0.8f, 0.3f);
      crop.season_variant = CropVariant("green");
      crops.push_back(crop);
    }
  }
  const cv::Mat grown = MaterialsOf(WithAssets(scene, crops)).color;
  // Bare soil is brown and even: red over green over blue, no parcels.
  const Color soil = MeanAround(bare, 20, 50, 6);
  for (const int row : {10, 32, 54})
    for (const int col : {10, 32, 54})
      EXPECT_LT(cv::norm(MeanAround(bare, row, col, 5) - soil), 0.06) << row << " " << col;
  EXPECT_GT(soil[2], soil[1]);
  const Color field = MeanAround(grown, 32, 16, 6);  // in the west
  EXPECT_GT(field[1], field[2]);                     // green
  EXPECT_LT(cv::norm(MeanAround(grown, 32, 50, 6) - MeanAround(bare, 32, 50, 6)), 1e-5);
}

TEST(GroundLookTest, BuiltUpGroundIsGreenButInDeserts) {
  const Color village = MeanAround(MaterialsOf(Covered(SurfaceClass::kBuilding)).color, 32, 32, 20);
  const Color oasis = MeanAround(
      MaterialsOf(Covered(SurfaceClass::kBuilding, TerrainType::kDesert)).color, 32, 32, 20);
  EXPECT_GT(village[1], village[2]);
  EXPECT_GT(oasis[2], oasis[1] + 0.02f);
  // Among barren land too.
  Scene town = Covered(SurfaceClass::kBarren, TerrainType::kSuburb);
  auto terrain = std::make_shared<Terrain>(*town.terrain);
  for (int row = 20; row < 44; ++row)
    for (int col = 20; col < 44; ++col) terrain->surface(row, col) = SurfaceClass::kBuilding;
  town.terrain = terrain;
  const Color yard = MeanAround(MaterialsOf(town).color, 32, 32, 8);
  EXPECT_GT(yard[2], yard[1] + 0.02f);
}

TEST(GroundLookTest, TheLawnIsAsDenseAsTheEnvironmentsGrass) {
  const auto tufts = [](double density, TerrainType type) {
    Scene scene = Covered(SurfaceClass::kGrass, type);
    scene.environment.fine_of(AssetType::kGrass).density = density;
    std::vector<Asset> lawn;
    AddLawn(scene, {0.0f, 0.0f, 2.0f}, &lawn);
    return lawn.size();
  };
  EXPECT_EQ(tufts(0.0, TerrainType::kPlain), 0u);
  const std::size_t full = tufts(0.6, TerrainType::kPlain);
  EXPECT_GT(full, 5000u);
  EXPECT_NEAR(static_cast<double>(tufts(0.1, TerrainType::kPlain)), 0.2 * full, 0.03 * full);
  EXPECT_LT(tufts(0.6, TerrainType::kDesert), 0.3 * full);
}

TEST(GroundLookTest, OutlinesOfCartoonsDoNotBlackenMeadows) {
  Scene scene = Covered(SurfaceClass::kGrass);
  scene.environment.coarse.artistic_style = ArtisticStyle::kCartoon;
  const RayCamera camera = RayCamera::Looking({0.0f, 0.0f, 2.7f}, 0.3f, -0.25f, 1.0f, 160, 100);
  const auto dark_share = [&](bool lawn) {
    RayPictureOptions options;
    options.lawn = lawn;
    cv::Mat bgr(100, 160, CV_8UC3);
    EXPECT_TRUE(TracePicture(scene, MaterialsOf(scene), camera, options, Progress(), &bgr).ok());
    cv::Mat dark;
    cv::inRange(bgr, cv::Scalar(0, 0, 0), cv::Scalar(255, 70, 255), dark);
    return cv::countNonZero(dark) / (100.0 * 160.0);
  };
  EXPECT_LT(dark_share(false), 0.02);
  EXPECT_LT(dark_share(true), 0.05);
}

}  // namespace
}  // namespace latticeworld
