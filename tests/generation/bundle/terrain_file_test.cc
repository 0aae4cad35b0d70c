#include "latticeworld/generation/bundle/terrain_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "generation/test_world.h"
#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

Result<Terrain> Decode(const std::string& content, const Terrain& original) {
  return DecodeTerrain(content, original.geometry(), original.weights.vocabulary);
}

TEST(TerrainFileTest, GivesBackEveryBit) {
  const auto world = MakeTestWorld();
  const Terrain& terrain = *world->scene->terrain;
  const auto content = EncodeTerrain(terrain);
  ASSERT_TRUE(content.ok());
  const auto decoded = Decode(*content, terrain);
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_EQ(decoded->ground.height_m(), terrain.ground.height_m());
  EXPECT_EQ(std::memcmp(decoded->water_level_m.data(), terrain.water_level_m.data(),
                        4 * terrain.water_level_m.size()),
            0);
  EXPECT_EQ(decoded->surface, terrain.surface);
  ASSERT_EQ(decoded->weights.classes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(decoded->weights.classes[i].letter, terrain.weights.classes[i].letter);
    EXPECT_EQ(decoded->weights.classes[i].weight, terrain.weights.classes[i].weight);
  }
}

TEST(TerrainFileTest, IsRefusedWhereverItIsCut) {
  const auto world = MakeTestWorld();
  const std::string content = *EncodeTerrain(*world->scene->terrain);
  for (std::size_t length = 0; length < content.size(); length += length < 64 ? 1 : 97) {
    const auto decoded = Decode(content.substr(0, length), *world->scene->terrain);
    ASSERT_FALSE(decoded.ok()) << "cut to " << length;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
  }
}

TEST(TerrainFileTest, IsRefusedWhenItGoesOn) {
  const auto world = MakeTestWorld();
  const auto decoded = Decode(*EncodeTerrain(*world->scene->terrain) + "x", *world->scene->terrain);
  ASSERT_FALSE(decoded.ok());
  EXPECT_NE(decoded.status().message().find("after its last grid"), std::string::npos);
}

TEST(TerrainFileTest, IsRefusedWhenAGridUnpacksToLessOrMoreThanTheWorldHas) {
  Terrain terrain;
  const auto geometry = GridGeometry::FromCells(32, 32.0);
  terrain.ground = HeightField(geometry, Grid<float>(32, 32, 1.0f));
  terrain.water_level_m = Grid<float>(32, 32, std::nanf(""));
  terrain.surface = Grid<SurfaceClass>(32, 32, SurfaceClass::kGrass);
  std::string content = *EncodeTerrain(terrain);
  ASSERT_TRUE(DecodeTerrain(content, geometry, Vocabulary::kSuburb).ok());
  for (const int cells : {33, 64}) {
    content[8] = content[12] = static_cast<char>(cells);  // rows and columns
    const auto decoded =
        DecodeTerrain(content, GridGeometry::FromCells(cells, 32.0), Vocabulary::kSuburb);
    ASSERT_FALSE(decoded.ok());
    EXPECT_NE(decoded.status().message().find("elevation does not unpack to"), std::string::npos);
  }
  Terrain larger = terrain;
  const auto large = GridGeometry::FromCells(40, 32.0);
  larger.ground = HeightField(large, Grid<float>(40, 40, 1.0f));
  larger.water_level_m = Grid<float>(40, 40, std::nanf(""));
  larger.surface = Grid<SurfaceClass>(40, 40, SurfaceClass::kGrass);
  content = *EncodeTerrain(larger);
  content[8] = content[12] = 32;
  EXPECT_FALSE(DecodeTerrain(content, geometry, Vocabulary::kSuburb).ok());
}

// Whatever stands in a file, decoding ends in an answer, and in one of the right kind.
TEST(TerrainFileTest, DamagedFilesAreRefusedOrHoldALegalTerrain) {
  const auto world = MakeTestWorld();
  const Terrain& terrain = *world->scene->terrain;
  const std::string content = *EncodeTerrain(terrain);
  RandomStream random(1, "damage");
  for (int i = 0; i < 400; ++i) {
    std::string damaged = content;
    for (int k = random.UniformInt(1, 3); k > 0; --k) {
      const int at = random.UniformInt(0, i % 2 == 0 ? 60 : static_cast<int>(content.size()) - 9);
      if (random.Chance(0.3)) {
        damaged.replace(at, 8, 8, static_cast<char>(random.UniformInt(-1, 1)));
      } else {
        damaged[at] = static_cast<char>(damaged[at] ^ 1 << random.UniformInt(0, 7));
      }
    }
    const auto decoded = Decode(damaged, terrain);
    if (decoded.ok()) {
      for (const float height_m : decoded->ground.height_m()) ASSERT_TRUE(std::isfinite(height_m));
    } else {
      ASSERT_EQ(decoded.status().code(), StatusCode::kDataLoss) << i;
    }
  }
}

TEST(TerrainFileTest, IsRefusedForAnotherGeometry) {
  const auto world = MakeTestWorld();
  const auto decoded = DecodeTerrain(*EncodeTerrain(*world->scene->terrain),
                                     *GridGeometry::Create(64.0, 0.5), Vocabulary::kSuburb);
  ASSERT_FALSE(decoded.ok());
  EXPECT_NE(decoded.status().message().find("64 x 64"), std::string::npos);
  EXPECT_NE(decoded.status().message().find("128 x 128"), std::string::npos);
}

TEST(TerrainFileTest, IsRefusedForALetterThatTheVocabularyHasNot) {
  const auto world = MakeTestWorld();  // G is of suburb only
  const auto decoded = DecodeTerrain(*EncodeTerrain(*world->scene->terrain),
                                     world->scene->geometry(), Vocabulary::kWild);
  ASSERT_FALSE(decoded.ok());
  EXPECT_NE(decoded.status().message().find("FGW"), std::string::npos);
}

TEST(TerrainFileTest, RefusesValuesThatNoTerrainHas) {
  const auto world = MakeTestWorld();
  const auto expect_refused = [&](const char* what, auto&& change) {
    Terrain terrain = *world->scene->terrain;
    change(&terrain);
    const auto decoded = Decode(*EncodeTerrain(terrain), terrain);
    ASSERT_FALSE(decoded.ok()) << what;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    EXPECT_NE(decoded.status().message().find(what), std::string::npos)
        << decoded.status().message();
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto set_height = [](Terrain* terrain, float height) {
    Grid<float> height_m = terrain->ground.height_m();
    height_m(5, 5) = height;
    terrain->ground = HeightField(terrain->geometry(), height_m);
  };
  expect_refused("elevation", [&](Terrain* terrain) { set_height(terrain, std::nanf("")); });
  expect_refused("elevation", [&](Terrain* terrain) { set_height(terrain, kInfinity); });
  expect_refused("water level", [](Terrain* terrain) { terrain->water_level_m(0, 0) = kInfinity; });
  expect_refused("surface class",
                 [](Terrain* terrain) { terrain->surface(2, 2) = static_cast<SurfaceClass>(9); });
}

}  // namespace
}  // namespace latticeworld
