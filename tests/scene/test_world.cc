#include "scene/test_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string_view>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/terrain/cover.h"

namespace latticeworld {

std::shared_ptr<const Terrain> MakeTerrain(const TestGround& ground) {
  const GridGeometry geometry = GridGeometry::FromCells(ground.cells, ground.size_m);
  auto terrain = std::make_shared<Terrain>();
  Grid<float> height_m(ground.cells, ground.cells);
  terrain->water_level_m = Grid<float>(ground.cells, ground.cells, NAN);
  terrain->surface = Grid<SurfaceClass>(ground.cells, ground.cells);
  terrain->weights.vocabulary = ground.vocabulary;
  for (const char letter : std::string_view("ABDFGRSW")) {
    Grid<float> weight(ground.cells, ground.cells, 0.0f);
    bool occurs = false;
    for (int row = 0; row < ground.cells; ++row) {
      for (int col = 0; col < ground.cells; ++col) {
        if (ground.letter_at(geometry.CenterOf({row, col})) != letter) continue;
        weight(row, col) = 1.0f;
        occurs = true;
        terrain->surface(row, col) = internal::SurfaceOf(ground.vocabulary, letter);
      }
    }
    if (occurs) terrain->weights.classes.push_back({letter, std::move(weight)});
  }
  for (int row = 0; row < ground.cells; ++row) {
    for (int col = 0; col < ground.cells; ++col) {
      const WorldPoint centre = geometry.CenterOf({row, col});
      height_m(row, col) = static_cast<float>(ground.height_at_m(centre));
      terrain->water_level_m(row, col) = static_cast<float>(ground.water_at_m(centre));
    }
  }
  terrain->ground = HeightField(geometry, std::move(height_m));
  return terrain;
}

std::shared_ptr<const Terrain> MakePatchwork(Vocabulary vocabulary, std::uint64_t seed) {
  const std::string_view letters = vocabulary == Vocabulary::kSuburb ? "ABDFGRWBB" : "BFRSWFB";
  const auto letter_at = [letters, seed](WorldPoint point) {
    const auto patch_x = static_cast<std::int64_t>(std::floor(point.x_m / 32.0));
    const auto patch_y = static_cast<std::int64_t>(std::floor(point.y_m / 32.0));
    const double draw = HashToUnit(seed, patch_x, patch_y);
    return letters[static_cast<std::size_t>(draw * static_cast<double>(letters.size()))];
  };
  TestGround ground;
  ground.vocabulary = vocabulary;
  ground.letter_at = letter_at;
  const double phase = static_cast<double>(seed);
  ground.height_at_m = [letter_at, phase](WorldPoint point) {
    if (letter_at(point) == 'W') return -1.5;
    return 6.0 + 5.0 * std::sin(0.05 * point.x_m + phase) * std::cos(0.06 * point.y_m - phase);
  };
  ground.water_at_m = [letter_at](WorldPoint point) {
    return letter_at(point) == 'W' ? 2.0 : double{NAN};
  };
  return MakeTerrain(ground);
}

EnvironmentConfig MakeEnvironment(double density) {
  EnvironmentConfig environment;
  for (int type = 0; type < kAssetTypeCount; ++type) {
    const AssetTypeValues& values = ValuesOf(static_cast<AssetType>(type));
    environment.fine[type].season_variant = values.season_variants.front();
    environment.fine[type].material = values.materials.front();
    environment.fine[type].density = density;
  }
  return environment;
}

SceneRequest MakeRequest(std::shared_ptr<const Terrain> terrain,
                         const EnvironmentConfig& environment, std::uint64_t seed) {
  SceneRequest request;
  request.terrain = std::move(terrain);
  request.environment = environment;
  request.seed = seed;
  return request;
}

SceneAnswer Build(std::shared_ptr<const Terrain> terrain, const EnvironmentConfig& environment,
                  std::uint64_t seed) {
  const Progress progress;
  Result<SceneAnswer> answer =
      BuildScene(MakeRequest(std::move(terrain), environment, seed), progress);
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  return std::move(answer).value();
}

std::shared_ptr<const Terrain> MakeUniform(Vocabulary vocabulary, char letter, double size_m) {
  TestGround ground;
  ground.vocabulary = vocabulary;
  ground.size_m = size_m;
  ground.letter_at = [letter](WorldPoint) { return letter; };
  return MakeTerrain(ground);
}

std::vector<Asset> OfKind(const Scene& scene, AssetKind kind) {
  std::vector<Asset> assets;
  std::copy_if(scene.assets.begin(), scene.assets.end(), std::back_inserter(assets),
               [kind](const Asset& asset) { return asset.kind == kind; });
  return assets;
}

bool SameBytes(const std::vector<Asset>& a, const std::vector<Asset>& b) {
  static_assert(sizeof(Asset) == 40, "no padding, so that bytes can be compared");
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Asset)) == 0);
}

int CountOf(const Scene& scene, AssetKind kind) {
  return static_cast<int>(std::count_if(scene.assets.begin(), scene.assets.end(),
                                        [kind](const Asset& asset) { return asset.kind == kind; }));
}

}  // namespace latticeworld
