#include <gtest/gtest.h>

#include <map>
#include <string>

#include "layout/claim_checks.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

SymbolicLayout Meadow() { return Uniform(Vocabulary::kSuburb, 'G'); }

// One shape each, as a person would draw it.
std::map<std::string, SymbolicLayout> Drawings() {
  std::map<std::string, SymbolicLayout> drawings;
  const auto draw = [&](const char* name) -> SymbolicLayout* {
    return &(drawings[name] = Meadow());
  };
  Disc(draw("disc"), {14, 17}, 6.3, 'R');
  Disc(draw("pond"), {14, 17}, 1.5, 'R');
  Fill(draw("square"), {8, 8}, {16, 16}, 'R');
  SymbolicLayout* bumpy = draw("bumpy disc");
  Disc(bumpy, {14, 17}, 6.0, 'R');
  Disc(bumpy, {9, 13}, 2.2, 'R');
  Disc(bumpy, {18, 22}, 2.2, 'R');
  Disc(bumpy, {8, 20}, 1.6, 'G');
  Fill(draw("bar"), {8, 4}, {11, 26}, 'R');
  SymbolicLayout* slanted = draw("slanted bar");
  for (int i = 0; i < 18; ++i) Fill(slanted, {6 + i, 6 + i}, {9 + i, 8 + i}, 'R');
  SymbolicLayout* crescent = draw("crescent");
  Disc(crescent, {15, 15}, 9.0, 'R');
  Disc(crescent, {15, 20}, 8.5, 'G');
  SymbolicLayout* horseshoe = draw("horseshoe");
  Disc(horseshoe, {15, 15}, 9.0, 'R');
  Disc(horseshoe, {15, 15}, 5.5, 'G');
  Fill(horseshoe, {16, 12}, {31, 18}, 'G');
  SymbolicLayout* ring = draw("ring");
  Disc(ring, {15, 15}, 9.0, 'R');
  Disc(ring, {15, 15}, 6.0, 'G');
  SymbolicLayout* thick = draw("thick ring");
  Disc(thick, {15, 15}, 9.0, 'R');
  Disc(thick, {15, 15}, 4.3, 'G');
  SymbolicLayout* moat = draw("small ring");
  Fill(moat, {8, 8}, {10, 10}, 'R');
  moat->cells(9, 9) = 'B';
  SymbolicLayout* gate = draw("ring with a gate");
  Disc(gate, {15, 15}, 9.0, 'R');
  Disc(gate, {15, 15}, 6.0, 'G');
  Fill(gate, {15, 15}, {15, 31}, 'G');
  Line(draw("straight line"), {{16, 0}, {16, 31}}, 'R');
  Line(draw("slanted line"), {{3, 1}, {22, 30}}, 'R');
  Fill(draw("straight band"), {16, 0}, {18, 31}, 'R');
  Line(draw("winding line"), {{16, 0}, {10, 8}, {21, 18}, {14, 31}}, 'R');
  Line(draw("arc"), {{24, 2}, {12, 9}, {10, 16}, {12, 23}, {24, 30}}, 'R');
  SymbolicLayout* grid = draw("grid");
  for (int at = 4; at < 32; at += 8) {
    Line(grid, {{at, 2}, {at, 30}}, 'R');
    Line(grid, {{2, at}, {30, at}}, 'R');
  }
  SymbolicLayout* wide = draw("grid over the map");
  for (int at = 10; at < 32; at += 11) {
    Line(wide, {{at, 0}, {at, 31}}, 'R');
    Line(wide, {{0, at}, {31, at}}, 'R');
  }
  SymbolicLayout* ladder = draw("ladder");
  Line(ladder, {{4, 4}, {26, 4}, {26, 12}, {4, 12}, {4, 4}}, 'R');
  Line(ladder, {{15, 4}, {15, 12}}, 'R');
  SymbolicLayout* cross = draw("cross");
  Line(cross, {{16, 0}, {16, 31}}, 'R');
  Line(cross, {{0, 16}, {31, 16}}, 'R');
  return drawings;
}

void ExpectShaped(ClaimShape shape, const std::map<std::string, bool>& expected) {
  const std::map<std::string, SymbolicLayout> drawings = Drawings();
  for (const auto& [name, holds] : expected) {
    ASSERT_EQ(drawings.count(name), 1u) << name;
    const ClaimMeasure measure = Measured(Shaped('R', shape), drawings.at(name));
    EXPECT_EQ(measure.holds, holds) << NameOf(shape) << " " << name << ": " << measure.explanation;
  }
}

TEST(ClaimShapesTest, RoundFillsItsOutline) {
  ExpectShaped(ClaimShape::kRound, {{"disc", true},
                                    {"pond", true},
                                    {"square", true},
                                    {"bumpy disc", true},
                                    {"bar", false},
                                    {"slanted bar", false},
                                    {"crescent", false},
                                    {"horseshoe", false},
                                    {"ring", false},
                                    {"thick ring", false},
                                    {"cross", false},
                                    {"grid", false},
                                    {"winding line", false}});
}

TEST(ClaimShapesTest, ElongatedIsTwiceAsLongAsWide) {
  ExpectShaped(ClaimShape::kElongated, {{"bar", true},
                                        {"slanted bar", true},
                                        {"crescent", true},
                                        {"straight line", true},
                                        {"winding line", true},
                                        {"disc", false},
                                        {"pond", false},
                                        {"square", false},
                                        {"bumpy disc", false}});
  for (int length = 4; length <= 20; ++length) {
    SymbolicLayout layout = Meadow();
    Fill(&layout, {8, 4}, {13, 3 + length}, 'W');
    if (length >= 6) {
      EXPECT_EQ(Holds(Shaped('W', ClaimShape::kElongated), layout), length >= 12) << length;
    }
  }
}

TEST(ClaimShapesTest, BentHasItsMiddleOffItsChord) {
  ExpectShaped(ClaimShape::kBent, {{"crescent", true},
                                   {"horseshoe", true},
                                   {"arc", true},
                                   {"bar", false},
                                   {"slanted bar", false},
                                   {"straight line", false},
                                   {"disc", false},
                                   {"square", false}});
}

TEST(ClaimShapesTest, ARingEncloses) {
  ExpectShaped(ClaimShape::kRing, {{"ring", true},
                                   {"small ring", true},
                                   {"ring with a gate", true},
                                   {"horseshoe", false},
                                   {"crescent", false},
                                   {"disc", false},
                                   {"winding line", false}});
  const std::map<std::string, SymbolicLayout> drawings = Drawings();
  EXPECT_LT(Distance(Shaped('R', ClaimShape::kRing), drawings.at("horseshoe")),
            Distance(Shaped('R', ClaimShape::kRing), drawings.at("straight line")));
  SymbolicLayout forest = Uniform(Vocabulary::kSuburb, 'F');
  Disc(&forest, {16, 16}, 2.0, 'W');
  EXPECT_FALSE(Holds(Shaped('F', ClaimShape::kRing), forest)) << "a pond does not make a ring";
}

TEST(ClaimShapesTest, StraightAndWindingExcludeEachOther) {
  const std::map<std::string, bool> straight = {{"straight line", true},
                                                {"slanted line", true},
                                                {"straight band", true},
                                                {"winding line", false},
                                                {"arc", false}};
  ExpectShaped(ClaimShape::kStraight, straight);
  std::map<std::string, bool> winding;
  for (const auto& [name, holds] : straight) winding[name] = !holds;
  ExpectShaped(ClaimShape::kWinding, winding);
  ExpectShaped(ClaimShape::kStraight, {{"disc", false}, {"square", false}});
  ExpectShaped(ClaimShape::kWinding, {{"disc", false}, {"square", false}});
}

TEST(ClaimShapesTest, WindingGrowsWithTheBends) {
  double straight_before = -1.0, winding_before = 1.1;
  for (int bend = 0; bend <= 6; ++bend) {
    SymbolicLayout layout = Meadow();
    Line(&layout, {{16, 0}, {16 - bend, 8}, {16, 16}, {16 + bend, 24}, {16, 31}}, 'W');
    const double straight = Distance(Shaped('W', ClaimShape::kStraight), layout);
    const double winding = Distance(Shaped('W', ClaimShape::kWinding), layout);
    EXPECT_GE(straight, straight_before) << bend;
    EXPECT_LE(winding, winding_before) << bend;
    EXPECT_EQ(winding == 0.0, bend >= 2) << bend;
    EXPECT_EQ(straight == 0.0, bend <= 1) << bend;
    straight_before = straight;
    winding_before = winding;
  }
}

TEST(ClaimShapesTest, AGridHasBlocks) {
  ExpectShaped(ClaimShape::kGridded, {{"grid", true},
                                      {"grid over the map", true},
                                      {"ladder", true},
                                      {"cross", false},
                                      {"ring", false},
                                      {"straight line", false},
                                      {"disc", false}});
}

TEST(ClaimShapesTest, TheLargestPieceCounts) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {10, 10}, 5.0, 'W');
  Line(&layout, {{28, 2}, {28, 12}}, 'W');
  EXPECT_TRUE(Holds(Shaped('W', ClaimShape::kRound), layout));
  Claim south = Shaped('W', ClaimShape::kRound);
  south.zone = *FindZone("southern half");
  EXPECT_FALSE(Holds(south, layout));
  EXPECT_EQ(Distance(Shaped('F', ClaimShape::kRound), layout), 1.0);
}

TEST(ClaimShapesTest, ARiverKeepsItsShapeUnderABridge) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{16, 0}, {8, 10}, {22, 20}, {16, 31}}, 'W');
  Line(&layout, {{0, 15}, {31, 15}}, 'R');
  EXPECT_TRUE(Holds(Shaped('W', ClaimShape::kWinding), layout)) << ToText(layout);
  EXPECT_TRUE(Holds(Shaped('R', ClaimShape::kStraight), layout));
  SymbolicLayout arched = Meadow();  // straight on either side of the road
  Line(&arched, {{16, 0}, {6, 15}, {16, 31}}, 'W');
  Line(&arched, {{0, 15}, {31, 15}}, 'R');
  EXPECT_TRUE(Holds(Shaped('W', ClaimShape::kWinding), arched)) << ToText(arched);
}

}  // namespace
}  // namespace latticeworld
