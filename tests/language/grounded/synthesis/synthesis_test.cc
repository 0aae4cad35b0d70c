#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "language/grounded/synthesis/synthesis_plans.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/synthesis/claim_search.h"
#include "latticeworld/language/grounded/synthesis/draft.h"
#include "latticeworld/language/grounded/synthesis/layout_from_relief.h"
#include "latticeworld/language/grounded/synthesis/layout_synthesis.h"
#include "latticeworld/language/grounded/synthesis/lines/line_copies.h"
#include "latticeworld/language/grounded/synthesis/lines/line_router.h"
#include "latticeworld/language/grounded/synthesis/lines/polyline.h"
#include "latticeworld/language/grounded/synthesis/naturalness.h"
#include "latticeworld/language/grounded/synthesis/piece_wishes.h"
#include "latticeworld/language/grounded/synthesis/relief_conflicts.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 24;

bool IsLegal(const SymbolicLayout& layout) {
  return ParseLayout(ToText(layout), layout.vocabulary).ok();
}

std::string Failures(const LayoutPlan& plan, const SymbolicLayout& layout) {
  std::string failures;
  for (const Claim& claim : plan.claims) {
    const ClaimMeasure measure = Measure(claim, layout);
    if (!measure.holds) {
      failures +=
          std::string(NameOf(claim.kind)) + " " + claim.subject + ": " + measure.explanation + "\n";
    }
  }
  return failures;
}

const LayoutPlan& PlanNamed(const std::string& name) {
  static const std::vector<NamedPlan> plans = SynthesisPlans();
  for (const NamedPlan& plan : plans) {
    if (plan.name == name) return plan.plan;
  }
  ADD_FAILURE() << "no plan " << name;
  return plans.front().plan;
}

struct Synthesized {
  NamedPlan named;
  std::vector<SymbolicLayout> layouts;  // by seed, kSeeds of them
};

const std::vector<Synthesized>& AllSynthesized() {
  static const std::vector<Synthesized> all = [] {
    std::vector<Synthesized> made;
    for (NamedPlan& named : SynthesisPlans()) {
      made.push_back({named, {}});
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        made.back().layouts.push_back(SynthesizeLayout(named.plan, nullptr, seed));
      }
    }
    return made;
  }();
  return all;
}

TEST(LayoutSynthesisTest, SatisfiesEveryPlanForEverySeed) {
  for (const Synthesized& entry : AllSynthesized()) {
    for (const SymbolicLayout& layout : entry.layouts) {
      ASSERT_TRUE(IsLegal(layout)) << entry.named.name;
      EXPECT_EQ(Failures(entry.named.plan, layout), "") << entry.named.name << "\n"
                                                        << ToText(layout);
    }
  }
}

TEST(LayoutSynthesisTest, RepeatsItselfAndDiffersFromSeedToSeed) {
  for (const Synthesized& entry : AllSynthesized()) {
    std::set<std::string> different;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const std::string text = ToText(entry.layouts[seed]);
      different.insert(text);
      if (seed >= 3) continue;
      EXPECT_EQ(text, ToText(SynthesizeLayout(entry.named.plan, nullptr, seed)))
          << entry.named.name;
    }
    // Within a narrow band two may come out alike.
    EXPECT_GE(different.size(), static_cast<std::size_t>(kSeeds) - 2) << entry.named.name;
  }
}

// The share of the letter's cells that fill their bounding box, and nothing else.
TEST(LayoutSynthesisTest, LakesAreNoBoxes) {
  int boxes = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SymbolicLayout layout =
        SynthesizeLayout(PlanNamed("mostly forest with a lake in the centre"), nullptr, seed);
    const LayoutMask lake = MaskOf(layout, 'W');
    int first_row = 31, last_row = 0, first_col = 31, last_col = 0;
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      if (!lake.Contains(cell)) continue;
      first_row = std::min(first_row, cell.row);
      last_row = std::max(last_row, cell.row);
      first_col = std::min(first_col, cell.col);
      last_col = std::max(last_col, cell.col);
    }
    const int box = (last_row - first_row + 1) * (last_col - first_col + 1);
    boxes += lake.count() > 0.9 * box ? 1 : 0;
  }
  EXPECT_LE(boxes, 3);
}

// Rivers and roads are one cell wide and turn by at most 45 degrees a step.
TEST(LayoutSynthesisTest, LinesAreThinAndTurnGently) {
  for (const std::string name : {"a river from north to south", "a road from corner to corner",
                                 "a winding river", "a straight road"}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const SymbolicLayout layout = SynthesizeLayout(PlanNamed(name), nullptr, seed);
      const LayoutMask line = MaskOf(layout, 'W') | MaskOf(layout, 'R');
      int blocks = 0;
      int corners = 0;
      for (int row = 0; row + 1 < kLayoutSize; ++row) {
        for (int col = 0; col + 1 < kLayoutSize; ++col) {
          const int inside = line.Contains({row, col}) + line.Contains({row + 1, col}) +
                             line.Contains({row, col + 1}) + line.Contains({row + 1, col + 1});
          blocks += inside == 4 ? 1 : 0;
          corners += inside == 3 ? 1 : 0;
        }
      }
      EXPECT_EQ(blocks, 0) << name << "\n" << ToText(layout);
      EXPECT_LE(corners, 1) << name << "\n" << ToText(layout);
      EXPECT_EQ(line.Pieces().size(), 1u) << name << "\n" << ToText(layout);
    }
  }
}

TEST(LayoutSynthesisTest, LooksNatural) {
  for (const Synthesized& entry : AllSynthesized()) {
    const NamedPlan& named = entry.named;
    for (const SymbolicLayout& layout : entry.layouts) {
      const LayoutMasks masks(layout);
      // Thin by nature: all roads, and water where the plan has it as a line.
      const bool rivers =
          std::any_of(named.plan.features.begin(), named.plan.features.end(),
                      [](const PlannedFeature& feature) {
                        return feature.letter == 'W' && feature.form == FeatureForm::kLine;
                      });
      LayoutMask lines = rivers ? masks.of('W') : LayoutMask();
      if (named.plan.vocabulary == Vocabulary::kSuburb) lines = lines | masks.of('R');
      const Roughness roughness = RoughnessOf(masks, lines);
      EXPECT_LE(roughness.isolated, 3) << named.name << "\n" << ToText(layout);
      EXPECT_LE(roughness.frayed, 40) << named.name << "\n" << ToText(layout);
    }
  }
}

TEST(LayoutSynthesisTest, HalfAndHalfShareTheMap) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout =
        SynthesizeLayout(PlanNamed("half forest half fields"), nullptr, seed);
    EXPECT_NEAR(MaskOf(layout, 'F').count(), kCellCount / 2, 30);
    EXPECT_NEAR(MaskOf(layout, 'A').count(), kCellCount / 2, 30);
  }
}

TEST(LayoutSynthesisTest, PiecesKeepTheGapThatWasSaid) {
  LayoutPlan plan;
  plan.background = 'G';
  PlannedFeature ponds;
  ponds.letter = 'W';
  ponds.form = FeatureForm::kPatch;
  ponds.pieces = 3;
  ponds.cells = 12;
  ponds.gap = 7.0;
  plan.features = {ponds};
  Claim count;
  count.kind = ClaimKind::kCount;
  count.subject = 'W';
  count.least = count.most = 3.0;
  plan.claims = {count};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = SynthesizeLayout(plan, nullptr, seed);
    const std::vector<LayoutMask> pieces = MaskOf(layout, 'W').Pieces();
    ASSERT_EQ(pieces.size(), 3u) << ToText(layout);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_TRUE((pieces[i].Grown8(6) & pieces[k]).empty()) << ToText(layout);
    }
  }
}

TEST(LayoutSynthesisTest, SeveralLinesInOneFeatureBecomeSeveral) {
  LayoutPlan plan;
  plan.background = 'G';
  PlannedFeature streets;
  streets.letter = 'R';
  streets.form = FeatureForm::kLine;
  streets.pieces = 3;
  plan.features.push_back(streets);
  PlannedRelation parallel;
  parallel.kind = RelationKind::kParallel;
  parallel.subject = 0;
  parallel.object = 0;
  plan.relations.push_back(parallel);
  const LayoutPlan copies = WithLineCopies(plan);
  ASSERT_EQ(copies.features.size(), 3u);
  ASSERT_EQ(copies.relations.size(), 2u);
  for (const PlannedRelation& relation : copies.relations) {
    EXPECT_NE(relation.subject, relation.object);
  }
  Claim three;
  three.kind = ClaimKind::kCount;
  three.subject = 'R';
  three.least = three.most = 3;
  plan.claims.push_back(three);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = SynthesizeLayout(plan, nullptr, seed);
    EXPECT_EQ(Failures(plan, layout), "") << ToText(layout);
  }
}

Relief HillInTheNorth() {
  Grid<float> height(65, 65);
  for (int row = 0; row < 65; ++row) {
    for (int col = 0; col < 65; ++col) height(row, col) = static_cast<float>(64 - row);
  }
  return MakeRelief(std::move(height));
}

LayoutPlan WildPlan(const std::string& letters, FeatureForm form) {
  LayoutPlan plan;
  plan.vocabulary = Vocabulary::kWild;
  plan.background = 'B';
  for (const char letter : letters) {
    PlannedFeature feature;
    feature.letter = letter;
    feature.form = form;
    plan.features.push_back(feature);
    Claim present;
    present.subject = letter;
    plan.claims.push_back(present);
  }
  return plan;
}

TEST(LayoutSynthesisTest, WithoutPlacesSnowAndRockLieHighAndWaterLow) {
  const Relief relief = HillInTheNorth();
  LayoutPlan plan = WildPlan("SR", FeatureForm::kSpread);
  const LayoutPlan lake = WildPlan("W", FeatureForm::kPatch);
  plan.features.push_back(lake.features.front());
  plan.claims.push_back(lake.claims.front());
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = SynthesizeLayout(plan, &relief, seed);
    EXPECT_EQ(Failures(plan, layout), "");
    EXPECT_LT(MaskOf(layout, 'S').Centroid().row, 11.0) << ToText(layout);
    EXPECT_LT(MaskOf(layout, 'R').Centroid().row, 16.0) << ToText(layout);
    EXPECT_GT(MaskOf(layout, 'W').Centroid().row, 20.0) << ToText(layout);
  }
}

TEST(LayoutSynthesisTest, RiversRunDownhill) {
  const Relief relief = HillInTheNorth();
  const LayoutPlan plan = WildPlan("W", FeatureForm::kLine);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = SynthesizeLayout(plan, &relief, seed);
    const LayoutMask river = MaskOf(layout, 'W');
    // On a slope to the south every row is crossed once: no way leads up again.
    int wide_rows = 0;
    for (int row = 0; row < kLayoutSize; ++row) {
      const std::uint32_t bits = river.row(row);
      if (bits == 0) continue;
      const int first = __builtin_ctz(bits);
      const int last = 31 - __builtin_clz(bits);
      wide_rows += __builtin_popcount(bits) != last - first + 1 ? 1 : 0;
    }
    EXPECT_EQ(wide_rows, 0) << ToText(layout);
  }
}

TEST(LayoutSynthesisTest, WordsGoBeforeTheRelief) {
  const Relief relief = HillInTheNorth();
  LayoutPlan plan = WildPlan("S", FeatureForm::kSpread);
  plan.features[0].zones = {FindZone("southern third").value()};
  plan.claims[0].zone = FindZone("southern third").value();
  plan.claims[0].least = 0.2;
  plan.claims[0].words = "snow in the south";
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = SynthesizeLayout(plan, &relief, seed);
    EXPECT_EQ(Failures(plan, layout), "") << ToText(layout);
  }
  const std::vector<std::string> conflicts = ReliefConflicts(plan.claims, plan.vocabulary, relief);
  ASSERT_EQ(conflicts.size(), 1u);
  EXPECT_NE(conflicts[0].find("snow in the south"), std::string::npos);
  plan.claims[0].zone = FindZone("northern third").value();
  EXPECT_TRUE(ReliefConflicts(plan.claims, plan.vocabulary, relief).empty());
}

TEST(LayoutSynthesisTest, ReliefAloneGivesSnowAboveAndWaterBelow) {
  const Relief relief = HillInTheNorth();
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = LayoutFromRelief(Vocabulary::kWild, relief, seed);
    ASSERT_TRUE(IsLegal(layout));
    EXPECT_LT(MaskOf(layout, 'S').Centroid().row, 8.0);
    EXPECT_GT(MaskOf(layout, 'W').Centroid().row, 24.0);
  }
}

// Any plan that a reader could make of word salad, contradictions included.
LayoutPlan RandomPlan(RandomStream* random) {
  LayoutPlan plan;
  plan.vocabulary = random->Chance(0.5) ? Vocabulary::kSuburb : Vocabulary::kWild;
  const auto& classes = ClassesOf(plan.vocabulary);
  const auto letter = [&] {
    return classes[static_cast<std::size_t>(
                       random->UniformInt(0, static_cast<int>(classes.size()) - 1))]
        .letter;
  };
  const std::vector<std::string_view> names = ZoneNames();
  const auto zone = [&] {
    return FindZone(names[static_cast<std::size_t>(
                        random->UniformInt(0, static_cast<int>(names.size()) - 1))])
        .value();
  };
  plan.background = letter();
  const int features = random->UniformInt(0, 7);
  for (int i = 0; i < features; ++i) {
    PlannedFeature feature;
    feature.letter = letter();
    feature.form = static_cast<FeatureForm>(random->UniformInt(0, 2));
    const int zones = std::max(0, random->UniformInt(-2, 3));
    for (int k = 0; k < zones; ++k) feature.zones.push_back(zone());
    if (random->Chance(0.1)) feature.zones.push_back({"a sliver", {{0.501, 0.502, 0.1, 0.2}}});
    if (random->Chance(0.3)) feature.pieces = random->UniformInt(1, 60);
    feature.cells = random->UniformInt(1, 1100);
    if (random->Chance(0.2)) feature.share = random->Uniform(0.0, 1.0);
    feature.dominant = random->Chance(0.2);
    feature.fills_rest = random->Chance(0.1);
    feature.texture = static_cast<Texture>(random->UniformInt(0, 2));
    if (random->Chance(0.3)) feature.shape = static_cast<ClaimShape>(random->UniformInt(0, 6));
    if (random->Chance(0.3)) feature.from = Waypoint{zone(), random->UniformInt(-1, features - 1)};
    if (random->Chance(0.3)) feature.to = Waypoint{zone(), random->UniformInt(-1, features - 1)};
    if (random->Chance(0.3)) feature.via = {{zone(), random->UniformInt(-1, features - 1)}};
    feature.meander = random->Uniform(0.0, 2.0);
    feature.wide = random->Chance(0.2);
    plan.features.push_back(std::move(feature));
  }
  const int relations = features == 0 ? 0 : random->UniformInt(0, 6);
  for (int i = 0; i < relations; ++i) {
    PlannedRelation relation;
    relation.kind = static_cast<RelationKind>(random->UniformInt(0, 13));
    relation.subject = random->UniformInt(0, features - 1);
    relation.object = random->UniformInt(-1, features - 1);
    relation.second_object = random->UniformInt(-1, features - 1);
    relation.heading = {random->UniformInt(-1, 1), random->UniformInt(-1, 1)};
    plan.relations.push_back(relation);
  }
  const int absences = random->UniformInt(0, 3);
  for (int i = 0; i < absences; ++i) plan.absences.push_back({letter(), zone(), ""});
  const int claims = random->UniformInt(0, 9);
  for (int i = 0; i < claims; ++i) {
    Claim claim;
    claim.kind = static_cast<ClaimKind>(random->UniformInt(0, 24));
    claim.subject = letter();
    claim.object = letter();
    claim.second_object = letter();
    claim.zone = zone();
    claim.from = zone();
    claim.to = zone();
    claim.sequence = std::string() + letter() + letter();
    claim.heading = {random->UniformInt(-1, 1), random->UniformInt(-1, 1)};
    claim.shape = static_cast<ClaimShape>(random->UniformInt(0, 6));
    plan.claims.push_back(claim);
  }
  return plan;
}

TEST(LayoutSynthesisTest, AnyPlanGivesALegalLayout) {
  const Relief relief = HillInTheNorth();
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomStream random(seed, "plans");
    const LayoutPlan plan = RandomPlan(&random);
    const SymbolicLayout layout =
        SynthesizeLayout(plan, random.Chance(0.3) ? &relief : nullptr, seed);
    EXPECT_TRUE(IsLegal(layout)) << seed;
  }
}

TEST(ClaimSearchTest, MakesClaimsTrueOnAnyGround) {
  LayoutPlan plan;
  plan.background = 'G';
  Claim lake;
  lake.subject = 'W';
  lake.zone = FindZone("upper right").value();
  Claim two;
  two.kind = ClaimKind::kCount;
  two.subject = 'W';
  two.least = two.most = 2;
  Claim village;
  village.kind = ClaimKind::kDirection;
  village.subject = 'B';
  village.object = 'W';
  village.heading = {-1, 0};
  plan.claims = {lake, two, village};
  const ForbiddenCells forbidden(plan);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Canvas canvas;
    for (int id = 0; id < kCellCount; ++id) canvas.Paint(CellOf(id), 'G', -1);
    RandomStream random(seed, "search");
    EXPECT_EQ(SatisfyClaims(plan, forbidden, 3000, &random, &canvas), 0.0) << seed;
    EXPECT_EQ(Failures(plan, {plan.vocabulary, canvas.letters()}), "");
  }
}

TEST(ClaimSearchTest, NeverPaintsWhatIsForbidden) {
  LayoutPlan plan;
  plan.background = 'G';
  plan.absences.push_back({'W', FindZone("western half").value(), "no water in the west"});
  Claim lake;
  lake.subject = 'W';
  lake.zone = FindZone("western half").value();
  plan.claims = {lake};
  const ForbiddenCells forbidden(plan);
  Canvas canvas;
  for (int id = 0; id < kCellCount; ++id) canvas.Paint(CellOf(id), 'G', -1);
  RandomStream random(1, "search");
  EXPECT_GT(SatisfyClaims(plan, forbidden, 500, &random, &canvas), 0.0);
  EXPECT_TRUE(
      (MaskOf({plan.vocabulary, canvas.letters()}, 'W') & MaskOf(FindZone("western half").value()))
          .empty());
}

TEST(ClaimSearchTest, TidiesStrayCellsButNotLines) {
  LayoutPlan plan;
  plan.background = 'G';
  Canvas canvas;
  for (int id = 0; id < kCellCount; ++id) canvas.Paint(CellOf(id), 'G', -1);
  canvas.Paint({5, 5}, 'F', 0);
  canvas.PaintLine({9, 9}, 'W', 1);
  TidySmallPieces(plan, ForbiddenCells(plan), &canvas);
  EXPECT_EQ(canvas.at({5, 5}), 'G');
  EXPECT_EQ(canvas.at({9, 9}), 'W');
}

TEST(LineRouterTest, GoesAroundWhatIsDear) {
  RouteOptions options;
  options.cost = Grid<float>(kLayoutSize, kLayoutSize, 1.0f);
  for (int row = 0; row < 28; ++row) options.cost(row, 16) = 100.0f;
  for (const CellIndex end : {CellIndex{10, 2}, CellIndex{10, 30}}) {
    LayoutMask stop;
    stop.Add(end);
    options.stops.push_back(stop);
  }
  const std::vector<CellIndex> path = Route(options);
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), (CellIndex{10, 2}));
  EXPECT_EQ(path.back(), (CellIndex{10, 30}));
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(options.cost[path[i]], 1.0f);
    if (i == 0) continue;
    EXPECT_LE(
        std::max(std::abs(path[i].row - path[i - 1].row), std::abs(path[i].col - path[i - 1].col)),
        1);
  }
}

TEST(LineRouterTest, ClimbsNoRidgeThatItCanPass) {
  RouteOptions options;
  options.cost = Grid<float>(kLayoutSize, kLayoutSize, 1.0f);
  Grid<float> height(kLayoutSize, kLayoutSize, 0.0f);
  for (int row = 0; row < 24; ++row) height(row, 16) = 1.0f;
  options.height = &height;
  for (const CellIndex end : {CellIndex{16, 2}, CellIndex{16, 30}}) {
    LayoutMask stop;
    stop.Add(end);
    options.stops.push_back(stop);
  }
  for (const CellIndex cell : Route(options)) EXPECT_EQ(height[cell], 0.0f);
}

TEST(LineRouterTest, EmptyStopGivesNoWay) {
  RouteOptions options;
  options.cost = Grid<float>(kLayoutSize, kLayoutSize, 1.0f);
  LayoutMask start;
  start.Add({0, 0});
  options.stops = {start, LayoutMask()};
  EXPECT_TRUE(Route(options).empty());
}

TEST(PolylineTest, TellsCrossingFromMissing) {
  const std::vector<Spot> across = {{15, 0}, {15, 31}};
  const std::vector<Spot> down = {{0, 15}, {31, 15}};
  const std::vector<Spot> beside = {{0, 3}, {10, 3}};
  EXPECT_EQ(CrossingMiss(across, down), 0.0);
  EXPECT_GT(CrossingMiss(across, beside), 5.0);
  EXPECT_EQ(DistanceBetweenLines(across, down), 0.0);
  EXPECT_DOUBLE_EQ(DistanceBetweenLines(across, beside), 5.0);
  EXPECT_DOUBLE_EQ(DistanceTo(down, {3, 19}), 4.0);
  EXPECT_DOUBLE_EQ(MiddleOf(down).row, 15.5);
}

TEST(PieceWishesTest, SharesAddUpToWhatIsSaid) {
  RandomStream random(1, "wishes");
  for (const PieceWish& wish : PieceWishesOf(PlanNamed("half forest half fields"), &random)) {
    EXPECT_EQ(wish.cells, kCellCount / 2);
  }
  int ponds = 0;
  for (const PieceWish& wish : PieceWishesOf(PlanNamed("seven ponds in the west"), &random)) {
    ++ponds;
    EXPECT_FALSE(wish.spread);
    EXPECT_TRUE(wish.zone == MaskOf(FindZone("western half").value()));
  }
  EXPECT_EQ(ponds, 7);
}

TEST(NaturalnessTest, CountsBordersStrayCellsAndFrays) {
  SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  EXPECT_EQ(RoughnessOf(LayoutMasks(layout), {}).border, 0);
  layout.cells(10, 10) = 'F';
  Roughness roughness = RoughnessOf(LayoutMasks(layout), {});
  EXPECT_EQ(roughness.border, 4);
  EXPECT_EQ(roughness.isolated, 1);
  EXPECT_EQ(roughness.frayed, 1);
  layout.cells(10, 11) = layout.cells(11, 10) = layout.cells(11, 11) = 'F';
  roughness = RoughnessOf(LayoutMasks(layout), {});
  EXPECT_EQ(roughness.border, 8);
  EXPECT_EQ(roughness.isolated, 0);
  EXPECT_EQ(roughness.frayed, 0);
}

}  // namespace
}  // namespace latticeworld
