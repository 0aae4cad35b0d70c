#include "latticeworld/viewer/payloads/world_payloads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "generation/test_world.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld/viewer/payloads/world_assets.h"
#include "latticeworld/viewer/payloads/world_grids.h"

namespace latticeworld {
namespace {

using nlohmann::json;

std::uint16_t Uint16At(const std::string& bytes, std::size_t index) {
  return static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[2 * index]) |
                                    static_cast<unsigned char>(bytes[2 * index + 1]) << 8);
}

template <typename T>
T ValueAt(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

TEST(WorldGridsTest, VerticesAreTheGroundAndWatersTheWater) {
  const auto world = MakeTestWorld();
  const Terrain& terrain = *world->scene->terrain;
  const HeightGrid grid = MakeHeightGrid(terrain);
  ASSERT_EQ(grid.rows, 64);
  ASSERT_EQ(grid.heights.size(), 2u * 64 * 64);
  int wet = 0;
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) {
      const std::size_t index = static_cast<std::size_t>(row) * 64 + col;
      const double height_m = grid.low_m + Uint16At(grid.heights, index) * grid.step_m;
      EXPECT_NEAR(height_m, terrain.ground.height_m()(row, col), grid.step_m);
      const float level_m = terrain.water_level_m(row, col);
      const int water = Uint16At(grid.waters, index);
      if (!std::isnan(level_m)) {
        ++wet;
        EXPECT_NEAR(grid.low_m + (water - 1) * grid.step_m, level_m, grid.step_m);
      } else if (water != 0) {  // carried ashore: below the land
        EXPECT_LE(grid.low_m + (water - 1) * grid.step_m, height_m + grid.step_m);
      }
    }
  }
  EXPECT_GT(wet, 100);
  const WorldPoint corner = terrain.geometry().CenterOf({0, 0});
  EXPECT_EQ(grid.west_m, corner.x_m);
  EXPECT_EQ(grid.north_m, corner.y_m);
  EXPECT_EQ(grid.spacing_m, 0.5);
}

TEST(WorldGridsTest, LargeGroundsAreThinnedAndStillTheGround) {
  const auto world = MakeTestWorld();
  Terrain terrain = *world->scene->terrain;
  const GridGeometry geometry = GridGeometry::FromCells(1600, 800.0);
  Grid<float> height_m(1600, 1600);
  for (int row = 0; row < 1600; ++row) {
    for (int col = 0; col < 1600; ++col) height_m(row, col) = 0.02f * row - 0.01f * col;
  }
  terrain.ground = HeightField(geometry, height_m);
  terrain.water_level_m = Grid<float>(1600, 1600, std::nanf(""));
  terrain.surface = Grid<SurfaceClass>(1600, 1600, SurfaceClass::kRock);
  terrain.weights.classes.resize(1);
  terrain.weights.classes[0].weight = WeightGrid(Grid<float>(1600, 1600, 1.0f));
  const HeightGrid grid = MakeHeightGrid(terrain);
  EXPECT_EQ(grid.rows, kMostVertices);
  EXPECT_NEAR(grid.west_m + grid.spacing_m * (grid.cols - 1), 399.75, 1e-9);
  for (const int index : {0, 777, 1024}) {
    const WorldPoint point = {grid.west_m + index * grid.spacing_m, grid.north_m};
    EXPECT_NEAR(grid.low_m + Uint16At(grid.heights, index) * grid.step_m,
                terrain.ground.HeightAt(point), grid.step_m);
  }
  const TextureGrid texture = MakeTextureGrid(terrain);
  EXPECT_EQ(texture.rows, kMostTexels);
  EXPECT_EQ(texture.weights, std::string(1024 * 1024, '\xff'));
}

TEST(WorldGridsTest, WeightsSumToOneAndSurfacesAreTheTerrains) {
  const auto world = MakeTestWorld();
  const Terrain& terrain = *world->scene->terrain;
  const TextureGrid texture = MakeTextureGrid(terrain);
  const std::size_t plane = 64 * 64;
  ASSERT_EQ(texture.weights.size(), plane * texture.letters.size());
  for (std::size_t texel = 0; texel < plane; ++texel) {
    int sum = 0;
    for (std::size_t i = 0; i < texture.letters.size(); ++i) {
      sum += static_cast<unsigned char>(texture.weights[i * plane + texel]);
    }
    EXPECT_EQ(sum, 255);
  }
  EXPECT_EQ(texture.surfaces[63 * 64 + 63], static_cast<char>(SurfaceClass::kWaterBed));
  EXPECT_EQ(texture.surfaces[0], static_cast<char>(SurfaceClass::kGrass));
}

TEST(WorldAssetsTest, EveryAssetStandsInItsGroupOnce) {
  const auto world = MakeTestWorld();
  const AssetTable table = MakeAssetTable(*world->scene);
  ASSERT_EQ(table.bytes.size(), world->scene->assets.size() * kAssetBytes);
  std::set<std::uint32_t> numbers;
  std::size_t next = 0;
  for (const AssetGroup& group : table.groups) {
    EXPECT_EQ(group.first, next);
    next += group.count;
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      const std::size_t at = i * kAssetBytes;
      const auto number = ValueAt<std::uint32_t>(table.bytes, at + 12);
      EXPECT_TRUE(numbers.insert(number).second);
      const Asset& asset = world->scene->assets.at(number);
      EXPECT_EQ(asset.kind, group.kind);
      EXPECT_EQ(ValueAt<float>(table.bytes, at), asset.x_m);
      EXPECT_EQ(ValueAt<float>(table.bytes, at + 4), asset.y_m);
      EXPECT_EQ(ValueAt<float>(table.bytes, at + 8), asset.z_m);
      const double yaw = ValueAt<std::uint16_t>(table.bytes, at + 16) * (2.0 * M_PI / 65536.0);
      EXPECT_NEAR(std::remainder(yaw - asset.yaw_rad, 2.0 * M_PI), 0.0, 1e-4);
      EXPECT_NEAR(ValueAt<std::uint16_t>(table.bytes, at + 18), 100.0f * asset.half_length_m, 0.51);
      EXPECT_NEAR(ValueAt<std::uint16_t>(table.bytes, at + 22), 100.0f * asset.height_m, 0.51);
    }
  }
  EXPECT_EQ(next, world->scene->assets.size());
}

class WorldPayloadsTest : public ::testing::Test {
 protected:
  static std::shared_ptr<const WorldPayloads> Make(const World& world, bool moves = true) {
    auto made = MakeWorldPayloads(world, *SpeciesCatalogue::BuiltIn(), moves, Progress());
    EXPECT_TRUE(made.ok()) << made.status().ToString();
    return *std::move(made);
  }
};

TEST_F(WorldPayloadsTest, TheDescriptionNamesEveryPayloadAndItsLength) {
  const auto world = MakeTestWorld();
  const auto payloads = Make(*world);
  const json description = json::parse(payloads->description.bytes);
  EXPECT_EQ(description.at("id"), world->id);
  EXPECT_EQ(description.at("key"), payloads->key);
  EXPECT_EQ(description.at("request").at("seed"), "18446744073709551557");
  EXPECT_EQ(description.at("layout").size(), 32u);
  EXPECT_EQ(description.at("environment").at("coarse").at("season"), "autumn");
  EXPECT_EQ(description.at("atmosphere").at("weather"), "rain");
  EXPECT_EQ(description.at("behaviours").size(), 17u);
  EXPECT_EQ(description.at("payloads").size(), payloads->files.size());
  for (const char* name : {"height", "water", "weights", "surface", "assets", "ground", "map",
                           "relief", "layout", "models"}) {
    ASSERT_TRUE(description.at("payloads").contains(name)) << name;
    const json& payload = description.at("payloads").at(name);
    const auto file = payloads->files.find(payload.at("url").get<std::string>());
    ASSERT_NE(file, payloads->files.end()) << name;
    EXPECT_EQ(payload.at("bytes"), file->second.bytes.size());
  }
}

TEST_F(WorldPayloadsTest, TheGroundIsAPictureOfItsCells) {
  const auto payloads = Make(*MakeTestWorld());
  const std::string& jpeg =
      payloads->files.at("/api/worlds/" + payloads->key + "/ground.jpg").bytes;
  const cv::Mat picture =
      cv::imdecode(std::vector<unsigned char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
  EXPECT_EQ(picture.cols, 64);
  EXPECT_EQ(picture.rows, 64);
  EXPECT_GT(cv::mean(picture)[1], 20.0);
}

TEST_F(WorldPayloadsTest, TheKeyIsTheContents) {
  const auto world = MakeTestWorld();
  EXPECT_EQ(Make(*world)->key, Make(*world)->key);
  EXPECT_EQ(Make(*world)->description.bytes, Make(*world)->description.bytes);
  EXPECT_NE(Make(*world)->key, Make(*world, /*moves=*/false)->key);
}

TEST_F(WorldPayloadsTest, CanBeCancelled) {
  Progress progress;
  progress.Cancel();
  const auto made =
      MakeWorldPayloads(*MakeTestWorld(), *SpeciesCatalogue::BuiltIn(), true, progress);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
