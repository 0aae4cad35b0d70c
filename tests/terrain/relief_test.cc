#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/terrain/forms/relief_claims.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

using testing_layouts::Filled;
using testing_layouts::PaintDisc;

constexpr std::uint64_t kSeeds = 8;

ReliefWish Wish(ReliefKind kind) {
  ReliefWish wish;
  wish.kind = kind;
  wish.words = std::string(NameOf(kind));
  return wish;
}

Terrain BuildWith(const std::vector<ReliefWish>& wishes, const SymbolicLayout& layout,
                  std::uint64_t seed, const GridGeometry& geometry, int threads = 0) {
  TerrainRequest request;
  request.geometry = geometry;
  request.layout = &layout;
  request.reliefs = wishes;
  request.seed = seed;
  request.threads = threads;
  return BuildTerrain(request, Progress()).value();
}

// Small worlds are planned on a smaller lattice: enough to hold any form.
GridGeometry Small() { return GridGeometry::FromCells(256, 190.0); }

std::string Misses(const std::vector<ReliefWish>& wishes, const SymbolicLayout& layout,
                   const Terrain& terrain) {
  std::string misses;
  for (const ReliefMeasure& measure : MeasureReliefs(wishes, layout, terrain)) {
    EXPECT_EQ(measure.holds, measure.distance == 0.0);
    if (!measure.holds) misses += measure.explanation + "\n";
  }
  return misses;
}

// The share of cells that lie in hollows deeper than 0.2 m.
double HollowShare(const Terrain& terrain) {
  Grid<float> surface = terrain.ground.height_m();
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const float level_m = terrain.water_level_m.data()[i];
    if (!std::isnan(level_m)) surface.data()[i] = level_m;
  }
  const Grid<float> filled = FillDepressions(surface, nullptr);
  int deep = 0;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    if (filled.data()[i] - surface.data()[i] > 0.2f) ++deep;
  }
  return static_cast<double>(deep) / static_cast<double>(filled.size());
}

TEST(ReliefTest, AWorldThatIsOneMountainIsHighAndSteepAsMountainsAre) {
  SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  PaintDisc('S', 15, 16, 5, &layout);
  ReliefWish wish = Wish(ReliefKind::kMountain);
  wish.letter = 'S';
  wish.alone = true;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const GridGeometry geometry = GridGeometry::FromCells(512, 512.0);
    const Terrain terrain = BuildWith({wish}, layout, seed, geometry);
    internal::ReliefPiece whole;
    whole.area = LayoutMask::All();
    const internal::AreaRelief relief =
        internal::MeasureArea(whole, geometry, terrain.ground.height_m(), terrain.water_level_m);
    EXPECT_GE(relief.relief_m, 150.0) << seed;
    EXPECT_GE(relief.slope_deg, 20.0) << seed;
    EXPECT_LE(relief.slope_deg, 35.0) << seed;
    EXPECT_LT(HollowShare(terrain), 0.002) << seed;
  }
}

TEST(ReliefTest, EveryKindHoldsWhatItClaimsAndDrains) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  for (const auto& [kind, name] : EnumNames(ReliefKind{})) {
    ReliefWish wish = Wish(kind);
    if (kind == ReliefKind::kSlope) wish.heading = {1, 0};
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Terrain terrain = BuildWith({wish}, layout, seed, Small());
      EXPECT_EQ(Misses({wish}, layout, terrain), "") << name << ", seed " << seed;
      // Between dunes rain seeps away.
      const bool closed =
          kind == ReliefKind::kBasin || kind == ReliefKind::kCrater || kind == ReliefKind::kDunes;
      if (!closed) EXPECT_LT(HollowShare(terrain), 0.004) << name << ", seed " << seed;
    }
  }
}

TEST(ReliefTest, LandWithoutTheFormDoesNotHoldItsClaim) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  const Terrain terrain = BuildWith({}, layout, 1, Small());
  for (const ReliefKind kind :
       {ReliefKind::kMountain, ReliefKind::kHill, ReliefKind::kRidge, ReliefKind::kPlateau,
        ReliefKind::kMesa, ReliefKind::kCrater, ReliefKind::kBasin, ReliefKind::kValley,
        ReliefKind::kGorge, ReliefKind::kCanyon, ReliefKind::kCliff, ReliefKind::kTerraces,
        ReliefKind::kSaddle, ReliefKind::kHilly, ReliefKind::kMountainous, ReliefKind::kRugged,
        ReliefKind::kSteep}) {
    EXPECT_NE(Misses({Wish(kind)}, layout, terrain), "") << NameOf(kind);
  }
}

TEST(ReliefTest, HeightsDepthsAndSlopesAreWhatTheWordsSay) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  ReliefWish hill = Wish(ReliefKind::kHill);
  hill.height_m = 25.0;
  hill.slope_deg = 25.0;
  ReliefWish ridge = Wish(ReliefKind::kRidge);
  ridge.height_m = 15.0;
  ReliefWish gorge = Wish(ReliefKind::kGorge);
  gorge.depth_m = 12.0;
  ReliefWish valley = Wish(ReliefKind::kValley);
  valley.depth_m = 10.0;
  ReliefWish cliff = Wish(ReliefKind::kCliff);
  cliff.height_m = 9.0;
  ReliefWish plateau = Wish(ReliefKind::kPlateau);
  plateau.height_m = 14.0;
  ReliefWish slope = Wish(ReliefKind::kSlope);
  slope.slope_deg = 8.0;
  for (const ReliefWish& wish : {hill, ridge, gorge, valley, cliff, plateau, slope}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Terrain terrain = BuildWith({wish}, layout, seed, Small());
      EXPECT_EQ(Misses({wish}, layout, terrain), "") << wish.words << ", seed " << seed;
    }
  }
}

TEST(ReliefTest, WidthsAndLengthsAreWhatTheWordsSay) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  std::vector<ReliefWish> wishes;
  for (const ReliefKind kind : {ReliefKind::kRidge, ReliefKind::kValley, ReliefKind::kCanyon,
                                ReliefKind::kGorge, ReliefKind::kMoraine}) {
    ReliefWish wish = Wish(kind);
    wish.length_m = 100.0;
    wishes.push_back(wish);
    wish.length_m.reset();
    wish.width_m = 30.0;
    wishes.push_back(wish);
  }
  for (const ReliefKind kind : {ReliefKind::kHill, ReliefKind::kPlateau, ReliefKind::kMesa,
                                ReliefKind::kCrater, ReliefKind::kBasin}) {
    ReliefWish wish = Wish(kind);
    wish.width_m = 50.0;
    wishes.push_back(wish);
  }
  for (const ReliefWish& wish : wishes) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Terrain terrain = BuildWith({wish}, layout, seed, Small());
      EXPECT_EQ(Misses({wish}, layout, terrain), "") << wish.words << ", seed " << seed;
    }
  }
}

TEST(ReliefTest, WhatIsTooHighForItsWorldIsAsHighAsItsWidthLetsItBeAndSaysSo) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'S');
  ReliefWish wish = Wish(ReliefKind::kMountain);
  wish.letter = 'S';
  wish.alone = true;
  wish.height_m = 9000.0;
  const GridGeometry geometry = GridGeometry::FromCells(128, 64.0);
  const Terrain terrain = BuildWith({wish}, layout, 3, geometry);
  const auto [low, high] =
      std::minmax_element(terrain.ground.height_m().begin(), terrain.ground.height_m().end());
  EXPECT_LT(*high - *low, 64.0f);
  const std::string misses = Misses({wish}, layout, terrain);
  EXPECT_NE(misses.find("9000 m +- 15 % is asked"), std::string::npos) << misses;
  EXPECT_NE(misses.find("is the most that its width of 64 m carries"), std::string::npos) << misses;
}

TEST(ReliefTest, GivenHeightsStayAsTheyAre) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  const Relief relief = Valley();
  TerrainRequest request;
  request.geometry = Small();
  request.layout = &layout;
  request.relief = &relief;
  request.seed = 4;
  const Terrain without = BuildTerrain(request, Progress()).value();
  request.reliefs = {Wish(ReliefKind::kMountain)};
  const Terrain with = BuildTerrain(request, Progress()).value();
  EXPECT_EQ(with.ground.height_m(), without.ground.height_m());
  EXPECT_EQ(ReliefLeftAlone(request.reliefs).size(), 1u);
}

TEST(ReliefTest, ReliefIsTheSameWithAnyNumberOfThreads) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(26, c) = 'R';
  ReliefWish wish = Wish(ReliefKind::kHill);
  wish.ties.push_back({ReliefTie::Kind::kClimbed, 'R', {}, {}});
  const Terrain one = BuildWith({wish, Wish(ReliefKind::kGorge)}, layout, 5, Small(), 1);
  const Terrain many = BuildWith({wish, Wish(ReliefKind::kGorge)}, layout, 5, Small(), 5);
  EXPECT_EQ(one.ground.height_m(), many.ground.height_m());
  EXPECT_EQ(one.surface, many.surface);
}

// By bends: the hill's flank is steeper than any road.
TEST(ReliefTest, ARoadClimbsAHillWithinItsSlope) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(26, c) = 'R';
  ReliefWish wish = Wish(ReliefKind::kHill);
  wish.zones = {*FindZone("center")};
  wish.height_m = 30.0;
  wish.ties.push_back({ReliefTie::Kind::kClimbed, 'R', {}, {}});
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const GridGeometry geometry = GridGeometry::FromCells(512, 512.0);
    const Terrain terrain = BuildWith({wish}, layout, seed, geometry);
    EXPECT_EQ(Misses({wish}, layout, terrain), "") << seed;
    const std::vector<double> slopes = SlopesOfClass_deg(terrain, SurfaceClass::kRoad);
    EXPECT_LE(At(slopes, 0.8), 8.5) << seed;  // 12 % is 6.8 degrees; the rest are its edges
  }
}

TEST(ReliefTest, ARoadLeadsOverAPass) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(26, c) = 'R';
  ReliefWish wish = Wish(ReliefKind::kSaddle);
  wish.zones = {*FindZone("center")};
  wish.ties.push_back({ReliefTie::Kind::kClimbed, 'R', {}, {}});
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = BuildWith({wish}, layout, seed, GridGeometry::FromCells(512, 512.0));
    EXPECT_EQ(Misses({wish}, layout, terrain), "") << seed;
  }
}

// Measured on the finished ground, over 20 m of the way's middle.
TEST(ReliefTest, WaysClimbWithinTheSlopeThatWordsSay) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(26, c) = 'R';
  for (const double slope_deg : {8.0, 15.0}) {
    for (const ReliefKind kind : {ReliefKind::kHill, ReliefKind::kSaddle}) {
      ReliefWish wish = Wish(kind);
      wish.zones = {*FindZone("center")};
      wish.steepness = 1.5;
      ReliefTie climb;
      climb.kind = ReliefTie::Kind::kClimbed;
      climb.letter = 'R';
      climb.slope_deg = slope_deg;
      wish.ties = {climb};
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Terrain terrain =
            BuildWith({wish}, layout, seed, GridGeometry::FromCells(512, 512.0));
        EXPECT_EQ(Misses({wish}, layout, terrain), "")
            << NameOf(kind) << ", " << slope_deg << " degrees, seed " << seed;
      }
    }
  }
}

TEST(ReliefTest, AWayThatIsSteeperOrFlatterThanSaidDoesNotHoldItsClaim) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(26, c) = 'R';
  ReliefWish wish = Wish(ReliefKind::kHill);
  wish.zones = {*FindZone("center")};
  ReliefTie climb;
  climb.kind = ReliefTie::Kind::kClimbed;
  climb.letter = 'R';
  climb.slope_deg = 10.0;
  wish.ties = {climb};
  const Terrain terrain = BuildWith({wish}, layout, 2, GridGeometry::FromCells(512, 512.0));
  EXPECT_EQ(Misses({wish}, layout, terrain), "");
  for (const double other_deg : {5.0, 20.0}) {
    wish.ties[0].slope_deg = other_deg;
    const std::string misses = Misses({wish}, layout, terrain);
    EXPECT_NE(misses.find("slopes by"), std::string::npos) << other_deg << ": " << misses;
  }
  wish.ties[0].slope_deg = 10.0;
  const Terrain bare = BuildWith({}, layout, 2, GridGeometry::FromCells(512, 512.0));
  EXPECT_NE(Misses({wish}, layout, bare).find("no way leads up"), std::string::npos);
}

// A road of the layout, or where there is none a way of its own, in either vocabulary.
TEST(ReliefTest, AWayLeadsOverAGorgeOnABridgeAndTheGorgeGoesOnBelow) {
  SymbolicLayout road = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) road.cells(14 + c / 8, c) = 'R';
  SymbolicLayout beside = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) beside.cells(28, c) = 'R';
  const SymbolicLayout layouts[] = {road, beside, Filled(Vocabulary::kSuburb, 'G'),
                                    Filled(Vocabulary::kWild, 'B')};
  for (const ReliefKind kind : {ReliefKind::kGorge, ReliefKind::kCanyon}) {
    ReliefWish wish = Wish(kind);
    wish.from = {*FindZone("northern edge")};
    wish.to = {*FindZone("southern edge")};
    ReliefTie bridged;
    bridged.kind = ReliefTie::Kind::kBridged;
    wish.ties = {bridged};
    for (const SymbolicLayout& layout : layouts) {
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Terrain terrain = BuildWith({wish}, layout, seed, Small());
        EXPECT_EQ(Misses({wish}, layout, terrain), "")
            << NameOf(kind) << ", layout " << &layout - layouts << ", seed " << seed;
      }
    }
  }
}

TEST(ReliefTest, WithoutABridgeNoneIsClaimedToLeadOverAGorge) {
  const SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  const ReliefWish gorge = Wish(ReliefKind::kGorge);
  Terrain terrain = BuildWith({gorge}, layout, 1, Small());
  EXPECT_TRUE(terrain.bridges.empty());
  ReliefWish wish = gorge;
  ReliefTie bridged;
  bridged.kind = ReliefTie::Kind::kBridged;
  wish.ties = {bridged};
  EXPECT_NE(Misses({wish}, layout, terrain).find("no bridge leads over the gorge"),
            std::string::npos);
  // Nor does one that stands beside it.
  Bridge beside;
  const double half_m = terrain.geometry().half_size_m();
  beside.line = {{-half_m, -half_m}, {-half_m + 20.0, -half_m}};
  beside.width_m = 4.0;
  beside.deck_z_m = 30.0;
  beside.supports_m = {2.0, 18.0};
  terrain.bridges = {beside};
  EXPECT_NE(Misses({wish}, layout, terrain), "");
}

TEST(ReliefTest, APassLiesBetweenTheRisesThatTheWordsName) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  ReliefWish hills = Wish(ReliefKind::kHill);
  hills.count = 2;
  ReliefWish pass = Wish(ReliefKind::kSaddle);
  pass.between = {0};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = BuildWith({hills, pass}, layout, seed, Small());
    EXPECT_EQ(Misses({hills, pass}, layout, terrain), "") << seed;
  }
}

TEST(ReliefTest, AFormLiesWhereItIsSaidToLieFromAnother) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  for (const Claim::Heading heading :
       {Claim::Heading{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {1, 1}, {-1, 1}}) {
    ReliefWish hill = Wish(ReliefKind::kHill);
    ReliefWish crater = Wish(ReliefKind::kCrater);
    ReliefTie tie;
    tie.kind = ReliefTie::Kind::kToward;
    tie.heading = heading;
    tie.wish = 0;
    crater.ties = {tie};
    const Terrain terrain = BuildWith({hill, crater}, layout, 2, Small());
    EXPECT_EQ(Misses({hill, crater}, layout, terrain), "") << heading.east << ", " << heading.south;
  }
}

// By height: what stands on a hill is on its top, and what stands in a valley in its floor.
TEST(ReliefTest, AVillageStandsOnItsHillAndInItsValley) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  PaintDisc('B', 15, 16, 2, &layout);
  for (const ReliefKind kind : {ReliefKind::kHill, ReliefKind::kPlateau, ReliefKind::kValley}) {
    ReliefWish wish = Wish(kind);
    wish.ties.push_back({ReliefTie::Kind::kUnder, 'B', {}, {}});
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Terrain terrain = BuildWith({wish}, layout, seed, GridGeometry::FromCells(512, 512.0));
      EXPECT_EQ(Misses({wish}, layout, terrain), "") << wish.words << ", seed " << seed;
    }
  }
}

TEST(ReliefTest, TheLayoutsWaterRunsThroughItsGorge) {
  SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  for (int c = 0; c < kLayoutSize; ++c) {
    const int r = 15 + static_cast<int>(std::lround(3.0 * std::sin(c / 6.0)));
    layout.cells(r, c) = layout.cells(r + 1, c) = 'W';
  }
  ReliefWish wish = Wish(ReliefKind::kValley);
  wish.depth_m = 25.0;
  wish.ties.push_back({ReliefTie::Kind::kUnder, 'W', {}, {}});
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = BuildWith({wish}, layout, seed, GridGeometry::FromCells(512, 512.0));
    EXPECT_EQ(Misses({wish}, layout, terrain), "") << seed;
  }
}

}  // namespace
}  // namespace latticeworld
