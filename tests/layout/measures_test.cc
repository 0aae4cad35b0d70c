#include "latticeworld/layout/measures.h"

#include <gtest/gtest.h>

#include "layout/layouts.h"

namespace latticeworld {
namespace {

TEST(MeasuresTest, ShareCountsCellsOfTheRegion) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 0}, {31, 15}, 'F');
  EXPECT_DOUBLE_EQ(ShareIn(layout, 'F', Region::kAnywhere), 0.5);
  EXPECT_DOUBLE_EQ(ShareIn(layout, 'F', Region::kUpperLeft), 1.0);
  EXPECT_DOUBLE_EQ(ShareIn(layout, 'F', Region::kMiddleRight), 0.0);
  EXPECT_DOUBLE_EQ(ShareIn(layout, 'F', Region::kCenter), 0.5);
}

TEST(MeasuresTest, SharesOfAllClassesSumToOne) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SymbolicLayout layout = Random(Vocabulary::kSuburb, seed);
    for (const auto& region : EnumNames(Region{})) {
      double sum = 0.0;
      for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
        sum += ShareIn(layout, entry.letter, region.value);
      }
      ASSERT_NEAR(sum, 1.0, 1e-12);
    }
  }
}

TEST(MeasuresTest, ComponentsTouchAtCornersToo) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  Fill(&layout, {1, 1}, {2, 2}, 'W');
  layout.cells(3, 3) = 'W';  // touches at a corner
  layout.cells(10, 10) = 'W';
  const std::vector<LayoutComponent> lakes = ComponentsOf(layout, 'W');
  ASSERT_EQ(lakes.size(), 2u);
  EXPECT_EQ(lakes[0].cells.size(), 5u);
  EXPECT_EQ(lakes[1].cells.size(), 1u);
  EXPECT_EQ(lakes[1].cells[0], (CellIndex{10, 10}));
  EXPECT_TRUE(ComponentsOf(layout, 'S').empty());
}

}  // namespace
}  // namespace latticeworld
