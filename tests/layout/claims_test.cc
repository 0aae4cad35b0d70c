#include "latticeworld/layout/claims.h"

#include <gtest/gtest.h>

#include "layouts.h"

namespace latticeworld {
namespace {

Claim MakeClaim(ClaimKind kind, char subject, std::vector<Region> regions = {},
                char object = '\0') {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.regions = std::move(regions);
  claim.object = object;
  return claim;
}

bool Holds(const Claim& claim, const SymbolicLayout& layout) {
  const ClaimMeasure measure = Measure(claim, layout);
  EXPECT_EQ(measure.holds, measure.distance == 0.0);
  EXPECT_GE(measure.distance, 0.0);
  EXPECT_LE(measure.distance, 1.0);
  EXPECT_FALSE(measure.explanation.empty());
  return measure.holds;
}

TEST(ClaimsTest, PresentAndAbsentLookAtTheRegionAlone) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {2, 2}, {6, 6}, 'W');
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kPresent, 'W', {Region::kUpperLeft}), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kPresent, 'W', {Region::kLower}), layout));
  EXPECT_FALSE(
      Holds(MakeClaim(ClaimKind::kPresent, 'W', {Region::kUpperLeft, Region::kLower}), layout));
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kAbsent, 'W', {Region::kLower}), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kAbsent, 'W'), layout));
}

TEST(ClaimsTest, MostlyAndMoreThanCompareShares) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 0}, {31, 9}, 'F');
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kMostly, 'G'), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kMostly, 'F'), layout));
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kMoreThan, 'F', {}, 'A'), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kMoreThan, 'F', {}, 'G'), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kMoreThan, 'A', {}, 'D'), layout));  // none of either
}

TEST(ClaimsTest, LittleIsSomeButNotMuch) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kLittle, 'F'), layout));
  Fill(&layout, {0, 0}, {3, 3}, 'F');
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kLittle, 'F'), layout));
  Fill(&layout, {0, 0}, {31, 20}, 'F');
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kLittle, 'F'), layout));
}

TEST(ClaimsTest, ClusteredAndScatteredCountPieces) {
  SymbolicLayout clustered = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&clustered, {8, 8}, {15, 15}, 'B');
  SymbolicLayout scattered = Uniform(Vocabulary::kSuburb, 'G');
  for (int i = 0; i < 7; ++i) scattered.cells(4 * i + 1, (9 * i) % 31) = 'B';
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kClustered, 'B'), clustered));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kClustered, 'B'), scattered));
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kScattered, 'B'), scattered));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kScattered, 'B'), clustered));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kScattered, 'D'), clustered));
}

TEST(ClaimsTest, ACourseIsOneConnectedPiece) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 16}, {31, 16}, 'W');
  Claim claim = MakeClaim(ClaimKind::kCourse, 'W');
  claim.from = Region::kUpper;
  claim.to = Region::kLower;
  EXPECT_TRUE(Holds(claim, layout));
  layout.cells(15, 16) = 'G';  // cut in two
  EXPECT_FALSE(Holds(claim, layout));
}

TEST(ClaimsTest, AdjacentAndSurroundsLookAtBorders) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {9, 9}, {20, 20}, 'F');
  Fill(&layout, {12, 12}, {16, 16}, 'W');
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kSurrounds, 'F', {}, 'W'), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kSurrounds, 'G', {}, 'W'), layout));
  EXPECT_TRUE(Holds(MakeClaim(ClaimKind::kAdjacent, 'F', {}, 'G'), layout));
  EXPECT_FALSE(Holds(MakeClaim(ClaimKind::kAdjacent, 'W', {}, 'G'), layout));
}

}  // namespace
}  // namespace latticeworld
