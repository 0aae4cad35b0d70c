#include "latticeworld/terrain/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/cover.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

// What holds of every terrain.
void ExpectSound(const Terrain& terrain) {
  const Grid<float>& ground = terrain.ground.height_m();
  int wet_cells = 0, unlike = 0, floating = 0, hanging = 0, infinite = 0;
  for (int r = 0; r < ground.rows(); ++r) {
    for (int c = 0; c < ground.cols(); ++c) {
      infinite += !std::isfinite(ground(r, c));
      const bool wet = IsWet(terrain, r, c);
      wet_cells += wet;
      // Water that is no bed is a ford.
      const bool ford = wet && terrain.surface(r, c) == SurfaceClass::kRoad;
      unlike += (wet && !ford) != (terrain.surface(r, c) == SurfaceClass::kWaterBed);
      unlike += (wet && !ford) != (terrain.weights.DominantAt({r, c}) == 'W');
      if (wet) {
        floating += terrain.water_level_m(r, c) <= ground(r, c);
        internal::ForEachNeighbour(ground, r, c, [&](int row, int col) {
          if (!IsWet(terrain, row, col)) hanging += ground(row, col) < terrain.water_level_m(r, c);
        });
      }
      const WorldPoint center = terrain.geometry().CenterOf({r, c});
      const double depth_m = terrain.WaterDepthAt(center);
      const double expected_m = wet ? terrain.water_level_m(r, c) - ground(r, c) : 0.0;
      if (std::abs(depth_m - expected_m) > 1e-3) ++unlike;
    }
  }
  EXPECT_EQ(infinite, 0);
  EXPECT_EQ(unlike, 0) << "water, surface, weights and WaterDepthAt must agree";
  EXPECT_EQ(floating, 0) << "of " << wet_cells << " wet cells";
  EXPECT_EQ(hanging, 0) << "dry cells beside water and below it, of " << wet_cells << " wet cells";
}

TEST(TerrainTest, IsSoundForManyLayoutsSizesAndSeeds) {
  const std::vector<std::pair<int, double>> sizes = {{32, 16.0},   {129, 512.0}, {700, 70.0},
                                                     {97, 1500.0}, {200, 100.0}, {64, 8192.0}};
  std::uint64_t seed = 1;
  const Relief relief = Valley();
  for (const SymbolicLayout& layout : testing_layouts::Many()) {
    const auto& [cells, size_m] = sizes[seed % sizes.size()];
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << ", " << cells << " cells, " << size_m << " m\n"
                 << ToText(layout));
    const auto geometry = GridGeometry::FromCells(cells, size_m);
    ExpectSound(Build(layout, geometry, seed));
    ExpectSound(Build(layout, geometry, seed, &relief));
    ++seed;
  }
}

TEST(TerrainTest, IsTheSameWithAnyNumberOfThreads) {
  const SymbolicLayout layout = testing_layouts::RiverAndRoad();
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(301, 301.0);
  request.layout = &layout;
  request.seed = 5;
  request.threads = 1;
  const Terrain one = BuildTerrain(request, Progress()).value();
  for (const int threads : {2, 3, 7}) {
    request.threads = threads;
    const Terrain many = BuildTerrain(request, Progress()).value();
    EXPECT_EQ(one.ground.height_m(), many.ground.height_m()) << threads;
    EXPECT_EQ(one.surface, many.surface) << threads;
    EXPECT_EQ(one.weights.classes[1].weight, many.weights.classes[1].weight) << threads;
  }
}

TEST(TerrainTest, NamesEveryIllegalOption) {
  TerrainOptions options;
  EXPECT_TRUE(Validate(options).empty());
  options.max_road_slope = 0.0;
  options.embankment_slope = 2.0;
  options.max_bank_slope = std::nan("");
  options.ford_depth_m = 0.5;
  EXPECT_EQ(Validate(options).size(), 4u);
  const SymbolicLayout layout = testing_layouts::RiverAndRoad();
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(64, 64.0);
  request.layout = &layout;
  request.options = options;
  EXPECT_EQ(BuildTerrain(request, Progress()).status().code(), StatusCode::kInvalidArgument);
}

TEST(TerrainTest, WithoutReliefWaterLiesLowAndSnowHigh) {
  for (int seed = 1; seed <= 6; ++seed) {
    const Terrain terrain = Build(testing_layouts::Blobs(Vocabulary::kWild, seed),
                                  GridGeometry::FromCells(256, 512.0), seed);
    std::map<SurfaceClass, std::pair<double, int>> sums;
    for (int r = 0; r < 256; ++r) {
      for (int c = 0; c < 256; ++c) {
        auto& [sum, count] = sums[terrain.surface(r, c)];
        sum += IsWet(terrain, r, c) ? terrain.water_level_m(r, c) : terrain.ground.height_m()(r, c);
        ++count;
      }
    }
    const auto mean = [&sums](SurfaceClass surface) {
      return sums[surface].first / sums[surface].second;
    };
    for (const SurfaceClass other :
         {SurfaceClass::kGrass, SurfaceClass::kForestFloor, SurfaceClass::kRock}) {
      EXPECT_LT(mean(SurfaceClass::kWaterBed), mean(other)) << "seed " << seed;
    }
    EXPECT_GT(mean(SurfaceClass::kSnow), mean(SurfaceClass::kGrass) + 3.0) << "seed " << seed;
    EXPECT_GT(mean(SurfaceClass::kSnow), mean(SurfaceClass::kForestFloor) + 3.0) << "seed " << seed;
  }
}

TEST(TerrainTest, WithoutReliefSoftGroundIsGentleAndNothingIsACliff) {
  for (int seed = 1; seed <= 3; ++seed) {
    for (const SymbolicLayout& layout :
         {testing_layouts::RiverAndRoad(), testing_layouts::Blobs(Vocabulary::kSuburb, seed),
          testing_layouts::Blobs(Vocabulary::kWild, seed)}) {
      const Terrain terrain = Build(layout, GridGeometry::FromCells(512, 512.0), seed);
      SCOPED_TRACE(testing::Message() << "seed " << seed << "\n" << ToText(layout));
      EXPECT_LT(At(SlopesOfClass_deg(terrain, SurfaceClass::kRoad), 0.99), 8.0);
      EXPECT_LT(At(SlopesOfClass_deg(terrain, SurfaceClass::kFarmland), 0.95), 10.0);
      EXPECT_LT(At(SlopesOfClass_deg(terrain, SurfaceClass::kBuilding), 0.95), 7.0);
      EXPECT_LT(At(SlopesOfClass_deg(terrain, SurfaceClass::kGrass), 0.90), 20.0);
      EXPECT_LT(At(SlopesOfClass_deg(terrain, SurfaceClass::kForestFloor), 0.90), 20.0);
      for (const auto& entry : EnumNames(SurfaceClass{})) {
        EXPECT_LT(At(SlopesOfClass_deg(terrain, entry.value), 0.999), 42.0) << entry.name;
        EXPECT_LT(At(SlopesOfClass_deg(terrain, entry.value), 1.0), 50.0) << entry.name;
      }
    }
  }
}

TEST(TerrainTest, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const SymbolicLayout layout = testing_layouts::Blobs(Vocabulary::kSuburb, 5);
  const auto geometry = GridGeometry::FromCells(128, 256.0);
  const Terrain a = Build(layout, geometry, 11);
  const Terrain b = Build(layout, geometry, 11);
  EXPECT_EQ(a.ground.height_m(), b.ground.height_m());
  EXPECT_EQ(a.surface, b.surface);
  // NaN is unlike itself: compare the bytes.
  EXPECT_EQ(std::memcmp(a.water_level_m.data(), b.water_level_m.data(),
                        a.water_level_m.size() * sizeof(float)),
            0);
  EXPECT_NE(a.ground.height_m(), Build(layout, geometry, 12).ground.height_m());
}

TEST(TerrainTest, IsNearlyTheSameLandAtHalfTheResolution) {
  const SymbolicLayout layout = testing_layouts::Blobs(Vocabulary::kWild, 3);
  const Terrain fine = Build(layout, GridGeometry::FromCells(512, 512.0), 4);
  const Terrain coarse = Build(layout, GridGeometry::FromCells(256, 512.0), 4);
  std::vector<double> differences;
  for (int r = 0; r < 256; ++r) {
    for (int c = 0; c < 256; ++c) {
      const WorldPoint point = coarse.geometry().CenterOf({r, c});
      differences.push_back(std::abs(fine.ground.HeightAt(point) - coarse.ground.HeightAt(point)));
    }
  }
  std::sort(differences.begin(), differences.end());
  EXPECT_LT(At(differences, 0.5), 0.1);
  EXPECT_LT(At(differences, 0.95), 0.5);
}

TEST(TerrainTest, KeepsTheMetricHeightsOfAReliefAwayFromWaterAndPaving) {
  const Relief relief = Valley();
  const SymbolicLayout layout = testing_layouts::RiverAndRoad();
  const auto geometry = GridGeometry::FromCells(256, 512.0);
  const Terrain terrain = Build(layout, geometry, 2, &relief);
  const Terrain dry =
      Build(testing_layouts::Filled(Vocabulary::kSuburb, 'G'), geometry, 2, &relief);
  int compared = 0;
  for (int r = 0; r < 256; ++r) {
    for (int c = 0; c < 256; ++c) {
      // The picture's own height there: 100 x 140 samples over the world.
      const float given = relief.height_m(static_cast<int>((r + 0.5) / 2.56),
                                          static_cast<int>((c + 0.5) / 256.0 * 140.0));
      EXPECT_NEAR(dry.ground.height_m()(r, c), given, 1.2);
      const bool far = std::abs(r - 164) > 24 && (c < 50 || c > 215);
      if (!far) continue;
      EXPECT_NEAR(terrain.ground.height_m()(r, c), dry.ground.height_m()(r, c), 0.01);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST(TerrainTest, ARiverOnAReliefFallsAlongItsCourse) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  for (int r = 0; r < kLayoutSize; ++r) layout.cells(r, 16) = layout.cells(r, 17) = 'W';
  const Relief relief = Valley();
  const Terrain terrain = Build(layout, GridGeometry::FromCells(256, 512.0), 6, &relief);
  std::vector<double> levels;
  for (int r = 0; r < 256; ++r) {
    double sum = 0.0;
    int count = 0;
    for (int c = 0; c < 256; ++c) {
      if (!IsWet(terrain, r, c)) continue;
      sum += terrain.water_level_m(r, c);
      ++count;
    }
    if (count > 0) levels.push_back(sum / count);
  }
  ASSERT_GT(levels.size(), 250u);
  for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_LT(levels[i], levels[i - 1] + 0.15);
  EXPECT_GT(levels.front() - levels.back(), 25.0);
}

TEST(TerrainTest, ARiverOnAReliefCutsThroughARidge) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  for (int r = 0; r < kLayoutSize; ++r) layout.cells(r, 16) = layout.cells(r, 17) = 'W';
  Grid<float> height_m = Valley().height_m;
  for (int r = 0; r < height_m.rows(); ++r) {
    const double from_ridge = (r - 55) / 6.0;
    for (int c = 0; c < height_m.cols(); ++c) {
      height_m(r, c) += static_cast<float>(12.0 * std::exp(-from_ridge * from_ridge));
    }
  }
  const Relief relief = MakeRelief(std::move(height_m));
  const Terrain terrain = Build(layout, GridGeometry::FromCells(256, 512.0), 6, &relief);
  double highest_below_m = -1e9;
  for (int r = 255; r >= 0; --r) {
    double level_m = -1e9;
    for (int c = 0; c < 256; ++c) {
      if (IsWet(terrain, r, c)) level_m = std::max<double>(level_m, terrain.water_level_m(r, c));
    }
    if (level_m < -1e8) continue;
    EXPECT_GT(level_m, highest_below_m - 0.3) << "row " << r;
    highest_below_m = std::max(highest_below_m, level_m);
  }
}

// Median slope of the cells of one class on `layout`, and of the same cells where all is grass.
std::pair<double, double> SlopesWithAndWithout_deg(const SymbolicLayout& layout,
                                                   SurfaceClass surface, const Relief& relief) {
  const auto geometry = GridGeometry::FromCells(256, 512.0);
  const Terrain with = Build(layout, geometry, 4, &relief);
  Terrain without = Build(testing_layouts::Filled(Vocabulary::kSuburb, 'G'), geometry, 4, &relief);
  without.surface = with.surface;
  return {At(SlopesOfClass_deg(with, surface), 0.5), At(SlopesOfClass_deg(without, surface), 0.5)};
}

TEST(TerrainTest, RoadsAreSmootherAndBuildingLandLevellerThanTheGroundThatTheyLieOn) {
  Grid<float> height_m(257, 257);
  for (int r = 0; r < 257; ++r) {
    for (int c = 0; c < 257; ++c) {
      height_m(r, c) = static_cast<float>(0.03 * c + 0.5 * std::sin(0.7 * r) * std::sin(0.6 * c));
    }
  }
  const Relief relief = MakeRelief(std::move(height_m));
  SymbolicLayout road = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) road.cells(20, c) = 'R';
  const auto [smooth, rough] = SlopesWithAndWithout_deg(road, SurfaceClass::kRoad, relief);
  EXPECT_GT(rough, 3.0);
  EXPECT_LT(smooth, 0.4 * rough);
  SymbolicLayout village = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('B', 12, 12, 2.5, &village);
  const auto [level, given] = SlopesWithAndWithout_deg(village, SurfaceClass::kBuilding, relief);
  EXPECT_GT(given, 3.0);
  EXPECT_LT(level, 0.1 * given);
}

TEST(TerrainTest, WaterIsNowhereOfNegativeDepth) {
  const Terrain terrain =
      Build(testing_layouts::RiverAndRoad(), GridGeometry::FromCells(128, 256.0), 3);
  RandomStream random(3, "points");
  int wet = 0;
  for (int i = 0; i < 50000; ++i) {
    const double x_m = random.Uniform(-128.0, 128.0);
    const double depth_m = terrain.WaterDepthAt({x_m, random.Uniform(-128.0, 128.0)});
    ASSERT_GE(depth_m, 0.0);
    wet += depth_m > 0.0;
  }
  EXPECT_GT(wet, 2000);
}

TEST(TerrainTest, ACancelledBuildEndsWithCancelled) {
  const SymbolicLayout layout = testing_layouts::RiverAndRoad();
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(64, 64.0);
  request.layout = &layout;
  Progress cancelled;
  cancelled.Cancel();
  EXPECT_EQ(BuildTerrain(request, cancelled).status().code(), StatusCode::kCancelled);
  std::vector<double> fractions;
  const Progress watched(
      [&fractions](std::string_view, double fraction) { fractions.push_back(fraction); });
  EXPECT_TRUE(BuildTerrain(request, watched).ok());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
}

TEST(CoverTest, EveryLetterOfBothVocabulariesHasItsSurface) {
  const auto surfaces = [](Vocabulary vocabulary) {
    std::map<char, SurfaceClass> result;
    for (const LayoutClass& entry : ClassesOf(vocabulary)) {
      result[entry.letter] = internal::SurfaceOf(vocabulary, entry.letter);
    }
    return result;
  };
  EXPECT_EQ(surfaces(Vocabulary::kSuburb),
            (std::map<char, SurfaceClass>{{'A', SurfaceClass::kFarmland},
                                          {'B', SurfaceClass::kBuilding},
                                          {'D', SurfaceClass::kBarren},
                                          {'F', SurfaceClass::kForestFloor},
                                          {'G', SurfaceClass::kGrass},
                                          {'R', SurfaceClass::kRoad},
                                          {'W', SurfaceClass::kWaterBed}}));
  EXPECT_EQ(surfaces(Vocabulary::kWild),
            (std::map<char, SurfaceClass>{{'B', SurfaceClass::kGrass},
                                          {'F', SurfaceClass::kForestFloor},
                                          {'R', SurfaceClass::kRock},
                                          {'S', SurfaceClass::kSnow},
                                          {'W', SurfaceClass::kWaterBed}}));
}

}  // namespace
}  // namespace latticeworld
