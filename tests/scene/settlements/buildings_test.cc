#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/road_finder.h"
#include "latticeworld/scene/settlements/settlement_map.h"
#include "latticeworld/scene/settlements/settlement_rules.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 20;
constexpr double kDegree = M_PI / 180.0;

double AngleBetween(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * M_PI));
}

const std::string& ModelName(const Scene& scene, const Asset& asset) {
  return scene.catalogue->models()[asset.model].name;
}

void PaintDisc(char letter, double row, double col, double radius, SymbolicLayout* layout) {
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      if (std::hypot(r - row, c - col) <= radius) layout->cells(r, c) = letter;
    }
  }
}

// A village on a road, a city with roads, farms among fields, a town at a river, or a village on a
// hillside, by the seed.
enum class Place { kVillage, kCity, kFarms, kRiverside, kHillside };
Place PlaceOf(int seed) { return static_cast<Place>(seed % 5); }

std::shared_ptr<const Terrain> Country(int seed) {
  RandomStream random(seed, "buildings_test");
  SymbolicLayout layout;
  layout.vocabulary = Vocabulary::kSuburb;
  layout.cells = Grid<char>(kLayoutSize, kLayoutSize, 'G');
  double size_m = 512.0;
  Relief relief;
  const Relief* given = nullptr;
  switch (PlaceOf(seed)) {
    case Place::kVillage:
      PaintDisc('B', 16, random.Uniform(12, 20), random.Uniform(2.0, 4.0), &layout);
      for (int c = 0; c < kLayoutSize; ++c) layout.cells(16, c) = 'R';
      break;
    case Place::kCity:
      PaintDisc('B', 16, 16, random.Uniform(13.0, 15.5), &layout);
      for (int c = 0; c < kLayoutSize; ++c) {
        layout.cells(14 + static_cast<int>(2.0 * std::sin(c / 6.0)), c) = 'R';
      }
      break;
    case Place::kFarms:
      for (char& cell : layout.cells) cell = 'A';
      for (int i = 0; i < 6; ++i) {
        PaintDisc('B', random.Uniform(3, 29), random.Uniform(3, 29), random.Uniform(1.0, 2.2),
                  &layout);
      }
      for (int c = 0; c < kLayoutSize; ++c) layout.cells(9, c) = 'R';
      break;
    case Place::kRiverside:
      PaintDisc('B', 16, 15, random.Uniform(5.0, 7.0), &layout);
      for (int r = 0; r < kLayoutSize; ++r) {
        const int c = 16 + static_cast<int>(std::lround(3.0 * std::sin(r / 5.0)));
        layout.cells(r, c) = layout.cells(r, c + 1) = 'W';
      }
      for (int c = 0; c < kLayoutSize; ++c) layout.cells(20, c) = 'R';
      break;
    case Place::kHillside: {
      PaintDisc('B', 16, 16, 4.0, &layout);
      Grid<float> height_m(65, 65);
      for (int r = 0; r < 65; ++r) {
        for (int c = 0; c < 65; ++c) {
          height_m(r, c) = static_cast<float>(0.9 * r + 6.0 * std::sin(0.12 * c));
        }
      }
      relief = MakeRelief(std::move(height_m));
      given = &relief;
      break;
    }
  }
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(256, size_m);
  request.layout = &layout;
  request.relief = given;
  request.seed = static_cast<std::uint64_t>(seed);
  return std::make_shared<const Terrain>(BuildTerrain(request, Progress()).value());
}

// The same countries for all tests: a terrain takes its time.
class BuildingsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    answers_ = new std::vector<SceneAnswer>();
    for (int seed = 0; seed < kSeeds; ++seed) {
      answers_->push_back(Build(Country(seed), MakeEnvironment(seed % 2 == 0 ? 0.5 : 1.0), seed));
    }
  }
  static void TearDownTestSuite() {
    delete answers_;
    answers_ = nullptr;
  }
  static const SceneAnswer& AnswerOf(int seed) { return (*answers_)[seed]; }
  static const Scene& SceneOf(int seed) { return *(*answers_)[seed].scene; }

 private:
  static std::vector<SceneAnswer>* answers_;
};
std::vector<SceneAnswer>* BuildingsTest::answers_ = nullptr;

TEST_F(BuildingsTest, WallsKeepTheirDistanceAndTerracesTouch) {
  int touching = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Scene& scene = SceneOf(seed);
    const std::vector<Asset> buildings = OfKind(scene, AssetKind::kBuilding);
    ASSERT_GT(buildings.size(), 3u) << "seed " << seed;
    for (std::size_t i = 0; i < buildings.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double gap_m = GapBetween(FootprintOf(buildings[i]), FootprintOf(buildings[j]));
        if (gap_m >= kLeastWallGap_m - 1e-3) continue;
        ASSERT_NEAR(gap_m, 0.0, 0.02) << "seed " << seed;
        EXPECT_EQ(ModelName(scene, buildings[i]), "row house");
        EXPECT_EQ(ModelName(scene, buildings[j]), "row house");
        ++touching;
      }
    }
  }
  EXPECT_GT(touching, 50);
}

TEST_F(BuildingsTest, NoneStandsFarFromStreetsAndAllOthers) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Scene& scene = SceneOf(seed);
    const GridGeometry& geometry = scene.geometry();
    const std::vector<Asset> buildings = OfKind(scene, AssetKind::kBuilding);
    const SettlementMap map(*scene.terrain);
    std::map<int, int> in_settlement;
    for (const Asset& building : buildings) ++in_settlement[map.At(building.position())];
    for (std::size_t i = 0; i < buildings.size(); ++i) {
      const Footprint footprint = FootprintOf(buildings[i]);
      double nearest_m = INFINITY;
      for (std::size_t j = 0; j < buildings.size(); ++j) {
        if (j != i)
          nearest_m =
              std::min(nearest_m, GapBetween(FootprintOf(buildings[i]), FootprintOf(buildings[j])));
      }
      for (int row = 0; row < geometry.rows(); ++row) {
        for (int col = 0; col < geometry.cols(); ++col) {
          if (scene.terrain->surface(row, col) != SurfaceClass::kRoad) continue;
          const double gap_m = GapTo(footprint, geometry.CenterOf({row, col}));
          // Beside the street, never on its edge.
          ASSERT_GE(gap_m, kLeastSetback_m - geometry.resolution_m()) << "seed " << seed;
          nearest_m = std::min(nearest_m, gap_m);
        }
      }
      // A lone house is alone.
      if (in_settlement[map.At(buildings[i].position())] > 1) {
        EXPECT_LE(nearest_m, kMostToNeighbour_m) << "seed " << seed;
      }
    }
  }
}

TEST_F(BuildingsTest, HousesFaceTheirStreet) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Scene& scene = SceneOf(seed);
    const RoadFinder roads(*scene.terrain);
    int at_street = 0, facing = 0;
    for (const Asset& building : OfKind(scene, AssetKind::kBuilding)) {
      const std::optional<RoadFinder::Road> road = roads.Nearest(building.position());
      if (!road || road->distance_m > kMostSetback_m + building.half_length_m) continue;
      if (ModelName(scene, building) == "barn" || ModelName(scene, building) == "shed") continue;
      ++at_street;
      facing += AngleBetween(building.yaw_rad, road->heading_rad) < 15.0 * kDegree;
    }
    if (at_street < 5) continue;
    // At corners a house faces one of two streets.
    EXPECT_GE(facing, 0.75 * at_street) << "seed " << seed;
  }
}

TEST_F(BuildingsTest, StandLevelAndWithNoCornerInTheAir) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Scene& scene = SceneOf(seed);
    const HeightField& ground = scene.terrain->ground;
    for (const Asset& building : OfKind(scene, AssetKind::kBuilding)) {
      const Footprint footprint = FootprintOf(building);
      double low_m = INFINITY, high_m = -INFINITY;
      for (double u = -1.0; u <= 1.0; u += 0.25) {
        for (double v = -1.0; v <= 1.0; v += 0.25) {
          const double height_m = ground.HeightAt(
              footprint.At(u * footprint.half_length_m, v * footprint.half_width_m));
          low_m = std::min(low_m, height_m);
          high_m = std::max(high_m, height_m);
        }
      }
      EXPECT_LE(building.z_m, low_m + 0.05) << "seed " << seed;
      EXPECT_LE(high_m - building.z_m, kMostReliefBelow_m + 0.05) << "seed " << seed;
    }
  }
}

TEST_F(BuildingsTest, WhatIsBuiltFollowsFromTheSurroundings) {
  std::map<std::string, int> built;
  for (int seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene& scene = SceneOf(seed);
    const SettlementMap map(*scene.terrain);
    std::map<int, int> churches;
    for (const Asset& building : OfKind(scene, AssetKind::kBuilding)) {
      const std::string& name = ModelName(scene, building);
      ++built[name];
      const double around_m = SolidRadius(building) + 20.0;
      if (name == "farmhouse" || name == "barn") {
        EXPECT_LE(map.ToField_m(building.position()), kFarmReach_m + 2.0 * around_m);
      }
      // Barns and sheds may stand at the hem.
      if (name == "barn" || name == "shed") continue;
      const int at = map.At(building.position());
      ASSERT_GE(at, 0);
      const Settlement& settlement = map.settlements()[at];
      if (name == "apartment block" || name == "tower") {
        EXPECT_GE(settlement.area_m2, kCityFrom_m2);
        EXPECT_GE(map.ToBorder_m(building.position()), kInner_m - around_m);
      } else if (name == "row house") {
        EXPECT_GE(settlement.area_m2, kTownFrom_m2);
      } else if (name == "church") {
        EXPECT_GE(settlement.area_m2, kChurchFrom_m2);
        ++churches[at];
      }
    }
    for (const auto& [settlement, count] : churches) EXPECT_EQ(count, 1);
  }
  for (const char* name : {"detached house", "row house", "farmhouse", "barn", "shed",
                           "apartment block", "tower", "church"}) {
    EXPECT_GT(built[name], 0) << name;
  }
}

TEST_F(BuildingsTest, ThereAreAsManyAsTheDensityAsksForOrTheAnswerSaysSo) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const SceneAnswer& answer = AnswerOf(seed);
    const KindCount& count = answer.counts[static_cast<int>(AssetKind::kBuilding)];
    ASSERT_EQ(count.kind, AssetKind::kBuilding);
    EXPECT_EQ(count.placed, CountOf(*answer.scene, AssetKind::kBuilding));
    EXPECT_LE(count.placed, count.wanted);
    // Hillsides have room for fewer.
    EXPECT_GE(count.placed, 0.4 * count.wanted) << "seed " << seed;
    const bool said = std::any_of(
        answer.warnings.begin(), answer.warnings.end(),
        [](const std::string& text) { return text.find("building") != std::string::npos; });
    EXPECT_TRUE(said || count.placed >= 0.7 * count.wanted) << "seed " << seed;
  }
}

TEST_F(BuildingsTest, HousesHaveGardens) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Scene& scene = SceneOf(seed);
    const std::vector<Asset> buildings = OfKind(scene, AssetKind::kBuilding);
    int bushes = 0, flowers = 0;
    for (const Asset& asset : scene.assets) {
      if (asset.kind != AssetKind::kBush && asset.kind != AssetKind::kFlower) continue;
      const bool near = std::any_of(buildings.begin(), buildings.end(), [&](const Asset& house) {
        return GapTo(FootprintOf(house), asset.position()) < 16.0;
      });
      (asset.kind == AssetKind::kBush ? bushes : flowers) += near;
    }
    EXPECT_GT(bushes, 2 * static_cast<int>(buildings.size())) << "seed " << seed;
    EXPECT_LT(bushes, 40 * static_cast<int>(buildings.size())) << "seed " << seed;
    EXPECT_GT(flowers, static_cast<int>(buildings.size())) << "seed " << seed;
  }
}

TEST_F(BuildingsTest, TheArtisticStyleChangesNothing) {
  EnvironmentConfig environment = SceneOf(1).environment;
  for (const auto& style : EnumNames(ArtisticStyle{})) {
    environment.coarse.artistic_style = style.value;
    const SceneAnswer answer = Build(SceneOf(1).terrain, environment, 1);
    EXPECT_TRUE(SameBytes(answer.scene->assets, SceneOf(1).assets)) << style.name;
  }
}

TEST_F(BuildingsTest, TurnByTheRotationOfTheEnvironment) {
  EnvironmentConfig environment = SceneOf(0).environment;
  environment.fine_of(AssetType::kArchitecture).rotation_deg[2] = 30.0;
  const SceneAnswer answer = Build(SceneOf(0).terrain, environment, 0);
  const RoadFinder roads(*answer.scene->terrain);
  int at_street = 0, turned = 0;
  for (const Asset& building : OfKind(*answer.scene, AssetKind::kBuilding)) {
    const std::optional<RoadFinder::Road> road = roads.Nearest(building.position());
    if (ModelName(*answer.scene, building) != "detached house" || !road || road->distance_m > 18.0)
      continue;
    ++at_street;
    turned += AngleBetween(building.yaw_rad, road->heading_rad + 30.0 * kDegree) < 15.0 * kDegree;
  }
  ASSERT_GT(at_street, 3);
  EXPECT_GE(turned, 0.7 * at_street);
}

TEST_F(BuildingsTest, GrowWithTheScaleOfTheEnvironment) {
  const auto mean_height_m = [](const Scene& scene) {
    double sum = 0.0;
    int count = 0;
    for (const Asset& building : OfKind(scene, AssetKind::kBuilding)) {
      if (ModelName(scene, building) != "detached house") continue;
      sum += building.height_m;
      ++count;
    }
    return sum / std::max(count, 1);
  };
  EnvironmentConfig environment = SceneOf(1).environment;
  environment.fine_of(AssetType::kArchitecture).scale = 0.5;
  const SceneAnswer small = Build(SceneOf(1).terrain, environment, 1);
  EXPECT_NEAR(mean_height_m(*small.scene), 0.5 * mean_height_m(SceneOf(1)), 0.4);
}

TEST(BuildingsByHandTest, StandAlongRoadsAndFaceThem) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    if (std::abs(point.y_m) < 4.0) return 'R';
    return std::abs(point.y_m) < 50.0 ? 'B' : 'G';
  };
  const auto terrain = MakeTerrain(ground);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const SceneAnswer answer = Build(terrain, MakeEnvironment(0.25), seed);
    const std::vector<Asset> buildings = OfKind(*answer.scene, AssetKind::kBuilding);
    ASSERT_GT(buildings.size(), 8u);
    int beside_road = 0;
    for (const Asset& building : buildings) {
      EXPECT_LT(std::abs(building.y_m), 50.0) << "outside the built-up area";
      const double to_road_rad = building.y_m > 0.0f ? -M_PI / 2.0 : M_PI / 2.0;
      EXPECT_LT(AngleBetween(building.yaw_rad, to_road_rad), 15.0 * kDegree);
      if (std::abs(building.y_m) - building.half_length_m < 4.0 + kMostSetback_m) ++beside_road;
    }
    EXPECT_GE(beside_road, static_cast<int>(buildings.size()) / 2);
  }
}

TEST(BuildingsByHandTest, WithoutRoadsTheyFollowTheirArea) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    return std::abs(point.x_m - point.y_m) < 45.0 ? 'B' : 'G';
  };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 6);
  const std::vector<Asset> buildings = OfKind(*answer.scene, AssetKind::kBuilding);
  ASSERT_GT(buildings.size(), 8u);
  std::set<float> yaws;
  for (const Asset& building : buildings) {
    // Along or across the diagonal.
    const double off_rad = std::remainder(building.yaw_rad - M_PI / 4.0, M_PI / 2.0);
    EXPECT_LT(std::abs(off_rad), 14.0 * kDegree);
    yaws.insert(building.yaw_rad);
  }
  EXPECT_GT(yaws.size(), buildings.size() / 2) << "no two alike, but for barns and sheds";
}

TEST(BuildingsByHandTest, SpreadOverTheirWholeAreaWithoutRoads) {
  TestGround ground;
  ground.size_m = 1024.0;
  ground.letter_at = [](WorldPoint point) {
    return std::hypot(point.x_m, point.y_m) < 400.0 ? 'B' : 'G';
  };
  const auto terrain = MakeTerrain(ground);
  for (int seed = 0; seed < 5; ++seed) {
    const SceneAnswer answer = Build(terrain, MakeEnvironment(0.25), seed);
    double sum_m = 0.0;
    int count = 0;
    for (const Asset& building : OfKind(*answer.scene, AssetKind::kBuilding)) {
      sum_m += std::hypot(building.x_m, building.y_m);
      ++count;
    }
    ASSERT_GT(count, 300);
    // Of an even disc 2 / 3 of its radius; somewhat denser in the middle.
    EXPECT_GT(sum_m / count, 0.5 * 400.0) << "seed " << seed;
  }
}

TEST(BuildingsByHandTest, ASettlementThatRefusesAllIsGivenUp) {
  TestGround ground;
  ground.size_m = 512.0;
  ground.letter_at = [](WorldPoint) { return 'B'; };
  ground.height_at_m = [](WorldPoint point) { return point.x_m * std::tan(20.0 * kDegree); };
  const auto terrain = MakeTerrain(ground);
  const EnvironmentConfig environment = MakeEnvironment(1.0);
  Placement placement(*terrain, *Catalogue::BuiltIn(), environment, 6, 1);
  PlaceBuildings(&placement);
  EXPECT_TRUE(placement.assets.empty());
  const Tally::Kind& tally = placement.tally.Of(AssetKind::kBuilding);
  long refused = 0;
  for (const long count : tally.refused) refused += count;
  EXPECT_GT(refused, 100);
  EXPECT_LT(refused, 1.6 * tally.wanted) << "of five places for each that is wanted";
}

TEST(BuildingsByHandTest, ACancelledPlacementBuildsNothing) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) { return std::abs(point.y_m) < 4.0 ? 'R' : 'B'; };
  const auto terrain = MakeTerrain(ground);
  const EnvironmentConfig environment = MakeEnvironment(1.0);
  Progress progress;
  Placement placement(*terrain, *Catalogue::BuiltIn(), environment, 6, 1);
  placement.progress = &progress;
  progress.Cancel();
  PlaceBuildings(&placement);
  EXPECT_LE(placement.assets.size(), 1u) << "a church at most";
}

TEST(BuildingsByHandTest, EverySettlementHasOneAtLeast) {
  TestGround ground;
  ground.size_m = 512.0;
  // Hamlets whose shares of the buildings are below a half.
  ground.letter_at = [](WorldPoint point) {
    const double x_m = std::remainder(point.x_m, 128.0), y_m = std::remainder(point.y_m, 128.0);
    const bool inside = std::abs(point.x_m) < 192.0 && std::abs(point.y_m) < 192.0;
    return inside && std::hypot(x_m, y_m) < 15.0 ? 'B' : 'G';
  };
  const auto terrain = MakeTerrain(ground);
  const SettlementMap map(*terrain);
  ASSERT_EQ(map.settlements().size(), 9u);
  const SceneAnswer answer = Build(terrain, MakeEnvironment(0.05), 6);
  std::set<int> with_buildings;
  for (const Asset& building : OfKind(*answer.scene, AssetKind::kBuilding)) {
    with_buildings.insert(map.At(building.position()));
  }
  EXPECT_EQ(with_buildings.size(), 9u);
  EXPECT_LE(CountOf(*answer.scene, AssetKind::kBuilding),
            answer.counts[static_cast<int>(AssetKind::kBuilding)].wanted);
}

TEST(BuildingsByHandTest, NoneStandsOnASteepSlope) {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'B'; };
  // Level in the west, 20 degrees in the east.
  ground.height_at_m = [](WorldPoint point) {
    return std::max(0.0, point.x_m) * std::tan(20.0 * kDegree);
  };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 6);
  const std::vector<Asset> buildings = OfKind(*answer.scene, AssetKind::kBuilding);
  ASSERT_GT(buildings.size(), 10u);
  // As far up as the relief below a building allows, and a step of its samples.
  const double limit_m = kMostReliefBelow_m / std::tan(20.0 * kDegree) + 1.0;
  for (const Asset& building : buildings) {
    for (const WorldPoint& corner : FootprintOf(building).Corners()) {
      EXPECT_LT(corner.x_m, limit_m);
    }
  }
}

}  // namespace
}  // namespace latticeworld
