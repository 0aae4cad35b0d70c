#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

Relief Slope(double fall) {
  Grid<float> height_m(129, 129);
  for (int r = 0; r < 129; ++r) {
    for (int c = 0; c < 129; ++c) {
      height_m(r, c) = static_cast<float>(fall * 4.0 * c + 0.4 * std::sin(0.2 * r));
    }
  }
  return MakeRelief(std::move(height_m));
}

TEST(BenchesTest, FieldsOnASlopeLieInBenchesThatARobotClimbs) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'A');
  const Relief relief = Slope(0.10);
  const Terrain fields = Build(layout, GridGeometry::FromCells(512, 512.0), 3, &relief);
  const std::vector<double> slopes_deg = SlopesOfClass_deg(fields, SurfaceClass::kFarmland);
  // The slope itself has 5.7 degrees everywhere.
  EXPECT_LT(At(slopes_deg, 0.25), 2.5);
  EXPECT_GT(At(slopes_deg, 0.9), 8.0);
  EXPECT_LT(At(slopes_deg, 1.0), 25.0);
}

TEST(BenchesTest, NearlyLevelFieldsStayAsTheyAre) {
  const Relief relief = Slope(0.02);
  const auto geometry = GridGeometry::FromCells(256, 512.0);
  const Terrain fields =
      Build(testing_layouts::Filled(Vocabulary::kSuburb, 'A'), geometry, 3, &relief);
  const Terrain grass =
      Build(testing_layouts::Filled(Vocabulary::kSuburb, 'G'), geometry, 3, &relief);
  EXPECT_EQ(fields.ground.height_m(), grass.ground.height_m());
}

// Relief of the ground under houses of 10 x 10 m all over the building land, 3 m from streets,
// whose embankments are beside them.
std::vector<double> ReliefUnderHouses_m(const Terrain& terrain) {
  std::vector<double> relief_m;
  const auto is_building = [&terrain](int r, int c) {
    return terrain.surface(r, c) == SurfaceClass::kBuilding;
  };
  for (int r = 8; r < 504; r += 3) {
    for (int c = 8; c < 504; c += 3) {
      float low = 1e9f, high = -1e9f;
      bool inside = true;
      for (int i = -8; i <= 8; ++i) {
        for (int k = -8; k <= 8; ++k) {
          inside = inside && is_building(r + i, c + k);
          if (std::max(std::abs(i), std::abs(k)) > 5) continue;
          low = std::min(low, terrain.ground.height_m()(r + i, c + k));
          high = std::max(high, terrain.ground.height_m()(r + i, c + k));
        }
      }
      if (inside) relief_m.push_back(high - low);
    }
  }
  std::sort(relief_m.begin(), relief_m.end());
  return relief_m;
}

TEST(BenchesTest, BuildingLandIsLevelUnderAHouse) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('B', 16, 16, 4.5, &layout);
  for (int seed = 1; seed <= 20; ++seed) {
    const Terrain gentle = Build(layout, GridGeometry::FromCells(512, 512.0), seed);
    const std::vector<double> relief_m = ReliefUnderHouses_m(gentle);
    ASSERT_GT(relief_m.size(), 200u);
    EXPECT_LT(At(relief_m, 0.5), 0.05) << "seed " << seed;
  }
}

TEST(BenchesTest, OnASlopeBuildingLandLiesInTerraces) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('B', 16, 16, 4.5, &layout);
  const Relief relief = Slope(0.08);
  const Terrain terrain = Build(layout, GridGeometry::FromCells(512, 512.0), 3, &relief);
  const std::vector<double> relief_m = ReliefUnderHouses_m(terrain);
  // Ten metres of the slope itself fall by 0.8 m.
  EXPECT_LT(At(relief_m, 0.3), 0.05);
  EXPECT_LT(At(SlopesOfClass_deg(terrain, SurfaceClass::kBuilding), 1.0), 30.0);
}

}  // namespace
}  // namespace latticeworld
