#include "latticeworld/language/reading/layout_of_sentences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/synthesis/layout_synthesis.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/layout/claims/claims_json.h"

namespace latticeworld {
namespace {

LayoutPlan Read(const std::string& text, Vocabulary vocabulary = Vocabulary::kSuburb) {
  return LayoutOfSentences(SplitSentences(text), vocabulary);
}

// The claims without their words, a line each.
std::string ClaimsOf(const std::string& text, Vocabulary vocabulary = Vocabulary::kSuburb) {
  LayoutPlan plan = Read(text, vocabulary);
  for (Claim& claim : plan.claims) claim.words.clear();
  return plan.claims.empty() ? "" : EncodeClaims(plan.claims);
}

bool Claims(const LayoutPlan& plan, ClaimKind kind, char subject) {
  for (const Claim& claim : plan.claims)
    if (claim.kind == kind && claim.subject == subject) return true;
  return false;
}

struct Sample {
  const char* text;
  ClaimKind kind;
  char subject;
};

TEST(LayoutOfSentencesTest, EveryFormOfALayoutMakesItsClaim) {
  const std::vector<Sample> samples = {
      {"A lake in the north.", ClaimKind::kPresent, 'W'},
      {"No forest in the south.", ClaimKind::kAbsent, 'F'},
      {"Forest only in the north.", ClaimKind::kLocated, 'F'},
      {"Most houses are in the eastern half.", ClaimKind::kLocated, 'B'},
      {"3 lakes. 2 of the lakes are in the west.", ClaimKind::kCount, 'W'},
      {"Forest covers 30 % of the map.", ClaimKind::kAmount, 'F'},
      {"Water covers at least 50 % of the northern half.", ClaimKind::kAmount, 'W'},
      {"Mostly forest in the north.", ClaimKind::kDominant, 'F'},
      {"Farmland fills the western half.", ClaimKind::kAmount, 'A'},
      {"A lake. The rest is grassland.", ClaimKind::kRest, 'G'},
      {"More forest than farmland.", ClaimKind::kMoreThan, 'F'},
      {"The village touches the lake.", ClaimKind::kAdjacent, 'B'},
      {"The village is near the lake.", ClaimKind::kAdjacent, 'B'},
      {"The road is at most 3 cells from the lake.", ClaimKind::kAdjacent, 'R'},
      {"The road is away from the water.", ClaimKind::kApart, 'R'},
      {"The village is far from the lake.", ClaimKind::kApart, 'B'},
      {"2 lakes. The lakes are apart.", ClaimKind::kApart, 'W'},
      {"Forest surrounds the lake.", ClaimKind::kSurrounds, 'F'},
      {"A pond is inside the forest.", ClaimKind::kWithin, 'W'},
      {"Trees in the north. Forest is on both sides of the river.", ClaimKind::kBothSides, 'F'},
      {"The village is between the lake and the forest.", ClaimKind::kBetween, 'B'},
      {"2 lakes. The village is between the lakes.", ClaimKind::kBetween, 'B'},
      {"The village is north of the lake.", ClaimKind::kDirection, 'B'},
      {"A river from the northern edge to the southern edge.", ClaimKind::kCourse, 'W'},
      {"The road runs through the forest.", ClaimKind::kThrough, 'R'},
      {"A road runs along the southern edge.", ClaimKind::kAlong, 'R'},
      {"Houses are along the road.", ClaimKind::kAlong, 'B'},
      {"The road crosses the river.", ClaimKind::kCrosses, 'R'},
      {"2 roads. The roads cross each other.", ClaimKind::kCrosses, 'R'},
      {"2 roads. The roads are parallel.", ClaimKind::kParallel, 'R'},
      {"A road connects the village and the lake.", ClaimKind::kConnects, 'R'},
      {"2 villages. A road connects the villages.", ClaimKind::kConnects, 'R'},
      {"The lake is round.", ClaimKind::kShape, 'W'},
      {"The roads form a grid.", ClaimKind::kShape, 'R'},
      {"The houses are scattered.", ClaimKind::kScattered, 'B'},
      {"The houses are close together.", ClaimKind::kClustered, 'B'},
  };
  for (const Sample& sample : samples) {
    const LayoutPlan plan = Read(sample.text);
    EXPECT_TRUE(Claims(plan, sample.kind, sample.subject)) << sample.text << "\n"
                                                           << ClaimsOf(sample.text);
  }
  EXPECT_TRUE(Claims(Read("From north to south: snow, rock, forest.", Vocabulary::kWild),
                     ClaimKind::kOrder, 'S'));
}

TEST(LayoutOfSentencesTest, ClaimsQuoteTheirSentence) {
  const LayoutPlan plan = Read("A lake in the north. The village touches the lake.");
  ASSERT_EQ(plan.claims.size(), 3u);
  EXPECT_EQ(plan.claims.front().words, "A lake in the north");
  EXPECT_EQ(plan.claims.back().words, "The village touches the lake");
}

TEST(LayoutOfSentencesTest, NumbersAreExactOrBounded) {
  const auto count = [](const std::string& text) {
    for (const Claim& claim : Read(text).claims)
      if (claim.kind == ClaimKind::kCount) return claim;
    return Claim();
  };
  EXPECT_EQ(count("2 lakes.").least, 2);
  EXPECT_EQ(count("2 lakes.").most, 2);
  EXPECT_EQ(count("At least 3 lakes.").least, 3);
  EXPECT_EQ(count("At least 3 lakes.").most, Claim::kUnsaid);
  EXPECT_EQ(count("2 to 5 lakes.").most, 5);
  EXPECT_EQ(count("1 lake.").most, 1);
  EXPECT_EQ(count("A lake.").kind, ClaimKind::kPresent) << "an article counts nothing";
}

TEST(LayoutOfSentencesTest, LabelsTellThingsOfOneNounApart) {
  const LayoutPlan plan =
      Read("Lake A in the north. Lake B in the south. A road from lake A to lake B.");
  ASSERT_EQ(plan.features.size(), 3u);
  EXPECT_EQ(plan.features[2].from->feature, 0);
  EXPECT_EQ(plan.features[2].to->feature, 1);
}

// Each feature's class and the number of its pieces, 0 where none is said: "B2 W0".
std::string LandOf(const std::string& text) {
  std::vector<std::string> land;
  for (const PlannedFeature& feature : Read(text).features)
    land.push_back(feature.letter + std::to_string(feature.pieces_least));
  return Join(land, " ");
}

TEST(LayoutOfSentencesTest, LandThatAThingStandsByIsThereOnceAndInItsNumber) {
  EXPECT_EQ(LandOf("A well is between 2 villages."), "B2");
  EXPECT_EQ(LandOf("Houses. A well is between 2 villages."), "B2") << "those of the villages";
  EXPECT_EQ(LandOf("A well is between 2 villages. A village in the north."), "B0")
      << "a sentence of its own counts";
  EXPECT_EQ(LandOf("A well is between a lake and the forest. A bench is near a lake."), "F0 W0");
  EXPECT_EQ(LandOf("A well is near the lake. Water in the west."), "W0");
  EXPECT_EQ(LandOf("A well is near the lake. No water."), "");
  EXPECT_EQ(LandOf("A church. A well is near the church."), "") << "it is no land";
}

TEST(LayoutOfSentencesTest, WhatIsNoSentenceIsNotUnderstood) {
  const LayoutPlan plan = Read("A lake. Hello there. Forest in the north.");
  EXPECT_EQ(plan.not_understood, std::vector<std::string>{"Hello there"});
  EXPECT_EQ(plan.features.size(), 2u);
  EXPECT_TRUE(Read("").claims.empty());
}

TEST(LayoutOfSentencesTest, WhatLandCannotShowYetIsSaid) {
  const LayoutPlan plan = Read("Snow in the north. Snow above 80 m.");
  ASSERT_FALSE(plan.warnings.empty());
  EXPECT_NE(plan.warnings.back().find("Snow above 80 m"), std::string::npos);
}

TEST(LayoutOfSentencesTest, WhatIsHeardInPartIsSaid) {
  for (const std::string text :
       {"More forest than water in the north", "Most forest is in the north and the south",
        "A house is 20 m from the lake", "A house is in front of the lake",
        "The road climbs the hill", "The lakes touch each other"}) {
    const LayoutPlan plan = Read(text + ".");
    const bool told =
        std::any_of(plan.warnings.begin(), plan.warnings.end(), [&](const std::string& warning) {
          return warning.find("heard in part: \"" + text) != std::string::npos;
        });
    EXPECT_TRUE(told) << text;
  }
}

TEST(LayoutOfSentencesTest, AContradictionNamesBothSentences) {
  const LayoutPlan plan = Read("Forest in the north. No forest in the north.");
  ASSERT_FALSE(plan.warnings.empty());
  for (const char* said : {"Forest in the north", "No forest in the north"}) {
    EXPECT_NE(plan.warnings.back().find(said), std::string::npos) << plan.warnings.back();
  }
}

// Plans of the small language are laid out so that their claims hold.
TEST(LayoutOfSentencesTest, LayoutsHoldTheClaims) {
  int held = 0;
  int all = 0;
  for (const std::string text :
       {"A lake in the north-west corner. A village touches the lake. The village is east of the "
        "lake. A road from the village to the southern edge. The rest is farmland.",
        "Mostly meadow. 1 pond in the center. A small field in the east.",
        "A winding river from the northern edge to the southern edge. Houses are on both sides of "
        "the river. No forest.",
        "Forest covers 50 % of the map. Forest fills the northern half. 2 ponds are south of the "
        "forest.",
        "A city in the center. The city is close together. A ring-shaped road surrounds the city. "
        "Farmland surrounds the road."}) {
    const LayoutPlan plan = Read(text);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const SymbolicLayout layout = SynthesizeLayout(plan, nullptr, seed);
      for (const Claim& claim : plan.claims) {
        ++all;
        if (Measure(claim, layout).holds) ++held;
      }
    }
  }
  EXPECT_GE(held, all * 97 / 100) << held << " of " << all;
}

}  // namespace
}  // namespace latticeworld
