#include "latticeworld/terrain/forms/relief_places.h"

#include <gtest/gtest.h>

#include "latticeworld/layout/class_letters.h"
#include "terrain/test_layouts.h"

namespace latticeworld::internal {
namespace {

// A hill with land of the letter on it, in a layout of its own class with a disc of that letter.
ReliefPiece HillUnder(char letter, Vocabulary vocabulary) {
  SymbolicLayout layout = testing_layouts::Filled(vocabulary, class_letter::kForest);
  testing_layouts::PaintDisc(letter, 16.0, 16.0, 4.0, &layout);
  ReliefTie tie;
  tie.kind = ReliefTie::Kind::kUnder;
  tie.letter = letter;
  ReliefWish hill;
  hill.ties = {tie};
  return PlaceReliefs({hill}, layout, 512.0).at(0);
}

// 'B' is a building in suburb and grassland in wild.
TEST(ReliefPlacesTest, OnlyBuildingsAreCarried) {
  EXPECT_TRUE(HillUnder(suburb_letter::kBuilding, Vocabulary::kSuburb).carries_built);
  EXPECT_FALSE(HillUnder(wild_letter::kGrassland, Vocabulary::kWild).carries_built);
  EXPECT_FALSE(HillUnder(suburb_letter::kGrassland, Vocabulary::kSuburb).carries_built);
}

}  // namespace
}  // namespace latticeworld::internal
