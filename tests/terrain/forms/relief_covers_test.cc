#include "latticeworld/terrain/forms/relief_covers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

HeightCover Cover(char letter, bool above, double height_m) {
  HeightCover cover;
  cover.letter = letter;
  cover.above = above;
  cover.height_m = height_m;
  cover.words = "cover";
  return cover;
}

// On hills between 0 and 40 m.
Terrain OnHills(const std::vector<HeightCover>& covers, const SymbolicLayout& layout) {
  const Relief relief = Hills();
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(256, 512.0);
  request.layout = &layout;
  request.relief = &relief;
  request.covers = covers;
  request.seed = 1;
  return BuildTerrain(request, Progress()).value();
}

std::string Misses(const std::vector<HeightCover>& covers, const Terrain& terrain) {
  std::string misses;
  for (const ReliefMeasure& measure : MeasureCovers(covers, terrain)) {
    EXPECT_EQ(measure.kind, "relief_cover");
    if (!measure.holds) misses += measure.explanation + "\n";
  }
  return misses;
}

TEST(ReliefCoversTest, SnowLiesAboveItsHeightAndNotBelowIt) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kWild, 'B');
  testing_layouts::PaintDisc('S', 16, 16, 9, &layout);
  const std::vector<HeightCover> snow = {Cover('S', true, 22.0)};
  EXPECT_EQ(Misses(snow, OnHills(snow, layout)), "");
  EXPECT_NE(Misses(snow, OnHills({}, layout)), "");
}

TEST(ReliefCoversTest, ForestKeepsBelowItsHeight) {
  const SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  const std::vector<HeightCover> forest = {Cover('F', false, 18.0)};
  EXPECT_EQ(Misses(forest, OnHills(forest, layout)), "");
}

TEST(ReliefCoversTest, RockLiesBetweenItsHeightAndThatOfSnow) {
  const SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kWild, 'F');
  for (const std::vector<HeightCover>& both :
       {std::vector<HeightCover>{Cover('R', true, 14.0), Cover('S', true, 26.0)},
        std::vector<HeightCover>{Cover('S', true, 26.0), Cover('R', true, 14.0)}}) {
    EXPECT_EQ(Misses(both, OnHills(both, layout)), "");
  }
}

TEST(ReliefCoversTest, WaterRoadsAndFieldsStay) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('A', 8, 8, 5, &layout);
  testing_layouts::PaintDisc('W', 24, 24, 5, &layout);
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(16, c) = 'R';
  const Terrain with = OnHills({Cover('F', true, -100.0)}, layout);
  const Terrain without = OnHills({}, layout);
  EXPECT_EQ(with.water_level_m.size(), without.water_level_m.size());
  int forest = 0;
  for (std::size_t i = 0; i < with.surface.size(); ++i) {
    const SurfaceClass was = without.surface.data()[i];
    const bool open = was == SurfaceClass::kGrass;
    if (!open) {
      EXPECT_EQ(with.surface.data()[i], was);
    }
    if (open && with.surface.data()[i] == SurfaceClass::kForestFloor) ++forest;
  }
  EXPECT_GT(forest, 1000);
}

TEST(ReliefCoversTest, AHeightThatNoLandReachesIsToldAndHoldsNot) {
  const SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kWild, 'B');
  const std::vector<HeightCover> snow = {Cover('S', true, 900.0)};
  EXPECT_EQ(Misses(snow, OnHills(snow, layout)), "no open land lies above 900 m\n");
}

TEST(ReliefCoversTest, WeightsStillSumToOne) {
  const SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kWild, 'B');
  const Terrain terrain = OnHills({Cover('S', true, 20.0)}, layout);
  for (std::size_t i = 0; i < terrain.surface.size(); i += 97) {
    int sum = 0;
    for (const ClassWeight& entry : terrain.weights.classes) sum += entry.weight.levels().data()[i];
    EXPECT_EQ(sum, WeightGrid::kLevels);
  }
}

}  // namespace
}  // namespace latticeworld
