#include "latticeworld/language/reading/relief/relief_reading.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/reading/relief/relief_words.h"
#include "latticeworld/language/reading/relief/way_slopes.h"

namespace latticeworld {
namespace {

LayoutReading Read(const std::string& text, Vocabulary vocabulary, InstructionReader* reader) {
  LayoutRequest request;
  request.instruction = text;
  request.vocabulary = vocabulary;
  std::vector<ModelReply> replies;
  LayoutReading reading = reader->ReadLayout(request, Progress(), &replies).value();
  ReadRelief(text, &reading);
  return reading;
}

LayoutReading ByRules(const std::string& text, Vocabulary vocabulary = Vocabulary::kSuburb) {
  return Read(text, vocabulary, MakeRuleReader().get());
}

LayoutReading BySentences(const std::string& text, Vocabulary vocabulary = Vocabulary::kSuburb) {
  return Read(text, vocabulary, MakeControlledReader().get());
}

// The wishes in short: "hill h=120 z=northern third".
std::string Short(const LayoutReading& reading) {
  std::string all;
  const auto add = [&all](const char* name, const std::optional<double>& value) {
    if (value) all += std::string(" ") + name + "=" + std::to_string(static_cast<int>(*value));
  };
  for (const ReliefWish& wish : reading.plan.reliefs) {
    if (!all.empty()) all += "; ";
    all += NameOf(wish.kind);
    if (!wish.label.empty()) all += " " + wish.label;
    for (const int rise : wish.between) all += " between=" + std::to_string(rise);
    if (wish.count > 0) all += " n=" + std::to_string(wish.count);
    if (wish.letter != '\0') all += std::string(" ") + wish.letter;
    add("h", wish.height_m);
    add("d", wish.depth_m);
    add("w", wish.width_m);
    add("l", wish.length_m);
    add("s", wish.slope_deg);
    for (const Zone& zone : wish.zones) all += " z=" + zone.name;
    for (const Zone& zone : wish.from) all += " from=" + zone.name;
    for (const Zone& zone : wish.to) all += " to=" + zone.name;
    for (const ReliefTie& tie : wish.ties) {
      constexpr const char* kNames[] = {"under", "beside", "toward", "climbed", "bridged"};
      all += std::string(" ") + kNames[static_cast<int>(tie.kind)] + "=" +
             (tie.wish >= 0        ? std::to_string(tie.wish)
              : tie.letter == '\0' ? "way"
                                   : std::string(1, tie.letter));
      add("by", tie.slope_deg);
    }
    if (wish.alone) all += " alone";
  }
  for (const HeightCover& cover : reading.plan.covers) {
    all += std::string(all.empty() ? "" : "; ") + cover.letter + (cover.above ? ">" : "<") +
           std::to_string(static_cast<int>(cover.height_m));
  }
  return all;
}

struct Sample {
  const char* text;
  const char* wishes;
};

TEST(ReliefReadingTest, EveryFormOfTheSmallLanguageSaysItsRelief) {
  for (const Sample& sample : std::vector<Sample>{
           {"A hill in the north.", "hill z=northern third"},
           {"2 small hills in the west.", "hill n=2 z=western third"},
           {"The land is hilly in the north.", "hilly z=northern third"},
           {"The land is rolling.", "rolling"},
           {"The land rises by 30 m to north.", "slope h=30"},
           {"A hill. The hill is 120 m high.", "hill h=120"},
           {"A valley. The valley is 40 m deep.", "valley d=40"},
           {"A valley. The valley is 90 m wide.", "valley w=90"},
           {"A hill. The slope of the hill is 15 degrees.", "hill s=15"},
           {"A road runs along the southern edge. A hill. The road climbs the hill.",
            "hill climbed=R"},
           {"A village. A valley. The village is inside the valley.", "valley under=B"},
           {"A lake. A hill is north of the lake.", "hill toward=W"},
           {"A ridge. The ridge is 300 m long.", "ridge D l=300"},
           {"A saddle in the center.", "saddle z=center"},
           {"Forest below 40 m.", "F<40"},
           {"A hill A. A hill B. Hill B is 40 m high.", "hill A; hill B h=40"},
           {"A hill A. A crater is north of hill A.", "hill A; crater D toward=0"},
           {"A slope. The slope of the slope is 5 degrees.", "slope s=5"},
           {"A hill. A path of 15 degrees climbs the hill.", "hill climbed=R by=15"},
           {"A saddle. A road of 8 degrees climbs the saddle.", "saddle climbed=R by=8"},
           {"A hill. A road climbs the hill. The slope of the road is 8 degrees.",
            "hill climbed=R by=8"},
           {"A gorge. A bridge is over the gorge.", "gorge D bridged=R"},
           {"A canyon. A road crosses the canyon.", "canyon D bridged=R"},
       }) {
    const LayoutReading reading = BySentences(sample.text);
    EXPECT_EQ(Short(reading), sample.wishes) << sample.text;
    for (const std::string& warning : reading.plan.warnings) {
      EXPECT_EQ(warning.find("cannot be laid by it yet"), std::string::npos) << warning;
    }
  }
}

TEST(ReliefReadingTest, FreeTextSaysReliefWhoeverReadsTheRest) {
  for (const Sample& sample : std::vector<Sample>{
           {"A hill in the north. The hill is 120 m high.", "hill h=120 z=northern third"},
           {"There is a steep hill 40 m high in the upper left.", "hill h=40 z=upper left"},
           {"A 25 m deep gorge from the west to the east.",
            "gorge d=25 from=western edge to=eastern edge"},
           {"Three hills and a plateau in the east.", "hill n=3; plateau z=eastern third"},
           {"A lake in the center. A hill north of the lake.", "hill toward=W"},
           {"A ridge 300 m long and 20 m high in the north.", "ridge h=20 l=300 z=northern third"},
           {"A valley with a width of 60 m.", "valley w=60"},
           {"A ridge 1 km long.", "ridge l=1000"},
           {"A saddle between two hills in the center.", "hill n=2 z=center; saddle between=0"},
           {"A hill A and a hill B. The pass between hill A and hill B.",
            "hill A; hill B; saddle between=0 between=1"},
           {"A mountain pass in the north.", "saddle z=northern third"},
           {"The forest lies below a height of 40 metres.", "F<40"},
           {"A slope of 5 degrees.", "slope s=5"},
           // Measures belong to the nearest noun.
           {"A hill 20 m high and a plateau in the west.", "hill h=20; plateau z=western third"},
           {"A hill in the north and a 25 m deep valley.", "hill z=northern third; valley d=25"},
           {"A hill in the north, a gorge in the south.",
            "hill z=northern third; gorge z=southern third"},
           {"In the north a hill, in the south a gorge.",
            "hill z=northern third; gorge z=southern third"},
           {"A steep hill with a path of 15 degrees to its top.", "hill climbed=R by=15"},
           {"A steep hill with a path of 15 degrees to its top and a bridge over the gorge.",
            "hill climbed=R by=15; gorge bridged=R"},
           {"A road of 8 degrees climbs to the pass.", "saddle climbed=R by=8"},
           {"An 8 degree road leads over the pass.", "saddle climbed=R by=8"},
           {"A hill 40 m high. A path with a slope of 12 degrees leads to its top.",
            "hill h=40 climbed=R by=12"},
           {"A road climbs the hill at 10 degrees.", "hill climbed=R by=10"},
           {"A hill with a slope of 20 degrees and a path of 10 degrees to its top.",
            "hill s=20 climbed=R by=10"},
           {"A bridge over the gorge.", "gorge bridged=R"},
           {"A road leads across a deep canyon in the north.", "canyon z=northern third bridged=R"},
           {"A gorge with a stone bridge.", "gorge bridged=R"},
           {"A gorge without a bridge.", "gorge"},
           {"A bridge over the river and a gorge in the east.", "gorge z=eastern third"},
           {"Gently rolling hills with a farm in the south.", "rolling z=southern third under=A"},
           {"A river runs through a gorge from the north to the south.",
            "gorge from=northern edge to=southern edge under=W"},
           {"A road leads over the pass.", "saddle climbed=R"},
           {"A village in the west and a hill in the east.", "hill z=eastern third"},
           {"Rocky slopes in the north.", ""},
       }) {
    LayoutReading reading = ByRules(sample.text);
    for (ReliefWish& wish : reading.plan.reliefs) wish.letter = '\0';
    EXPECT_EQ(Short(reading), sample.wishes) << sample.text;
  }
}

TEST(ReliefReadingTest, AMountainThatIsAllThatIsSaidIsAllOfTheWorld) {
  EXPECT_EQ(Short(ByRules("Snow mountain.", Vocabulary::kWild)), "mountain S alone");
  EXPECT_EQ(Short(ByRules("Snow mountains in the north.", Vocabulary::kWild)),
            "mountain S z=northern third");
}

TEST(ReliefReadingTest, NounsThatOnlyBeginWithReliefAreNone) {
  for (const char* text : {"A mountain village in the north.", "A mountain stream.",
                           "Terraced houses in the west.", "A crater lake.", "A valley road.",
                           "A river from the north to the south.", "No hills in the north."}) {
    EXPECT_EQ(Short(ByRules(text)), "") << text;
  }
}

TEST(ReliefReadingTest, WhatReliefHasReadIsNotCalledNotUnderstood) {
  const LayoutReading reading = ByRules("A steep hill in the north.");
  EXPECT_TRUE(reading.plan.not_understood.empty()) << reading.plan.not_understood.front();
}

TEST(ReliefReadingTest, WordsOfReliefCountAsRead) {
  const LayoutReading reading = ByRules("A hill in the north. The hill is 120 m high.");
  EXPECT_EQ(reading.coverage.carried, reading.coverage.words);
}

TEST(ReliefReadingTest, ContradictoryHeightsAreTold) {
  const LayoutReading reading =
      BySentences("A hill. The hill is 20 m high. The hill is 120 m high.");
  ASSERT_EQ(reading.plan.warnings.size(), 1u);
  EXPECT_NE(reading.plan.warnings[0].find("cannot both be"), std::string::npos);
  EXPECT_EQ(reading.plan.reliefs[0].height_m, 120.0);
}

TEST(ReliefReadingTest, ASlopeOfAWayThatClimbsNothingIsTold) {
  const LayoutReading reading = ByRules("A road of 8 degrees from the west to the east.");
  EXPECT_EQ(Short(reading), "");
  bool told = false;
  for (const std::string& warning : reading.plan.warnings) {
    told = told || warning.find("climbs nothing") != std::string::npos;
  }
  EXPECT_TRUE(told);
}

// Fifteen paths, where the number is read for the land's.
TEST(ReliefReadingTest, TheNumberOfASlopeIsNoNumberOfWays) {
  const LayoutReading reading = ByRules("A steep hill with a path of 15 degrees to its top.");
  ASSERT_EQ(reading.plan.features.size(), 1u);
  EXPECT_EQ(reading.plan.features[0].pieces, 0);
  EXPECT_EQ(WithoutWaySlopes("A lake. A hill with a path of 15 degrees to its top. A farm.",
                             Vocabulary::kSuburb),
            "A lake. A hill with a path  to its top. A farm.");
  EXPECT_EQ(WithoutWaySlopes("A hill of 15 degrees and a road.", Vocabulary::kSuburb),
            "A hill of 15 degrees and a road.");
}

TEST(ReliefReadingTest, TwoSlopesOfOneWayAreToldAndTheLaterCounts) {
  const LayoutReading reading = BySentences(
      "A hill. A path of 15 degrees climbs the hill. A path of 20 degrees climbs the hill.");
  EXPECT_EQ(Short(reading), "hill climbed=R by=20");
  ASSERT_EQ(reading.plan.warnings.size(), 1u);
  EXPECT_NE(reading.plan.warnings[0].find("cannot both be"), std::string::npos);
}

// The wild has no class for ways: those that relief asks for are there all the same.
TEST(ReliefReadingTest, WaysThatReliefAsksForAreReadInTheWildToo) {
  const auto wild = [](const char* text) {
    LayoutReading reading = ByRules(text, Vocabulary::kWild);
    for (ReliefWish& wish : reading.plan.reliefs) wish.letter = '\0';
    return Short(reading);
  };
  EXPECT_EQ(wild("A bridge over the gorge."), "gorge bridged=way");
  EXPECT_EQ(wild("A path of 15 degrees climbs the hill."), "hill climbed=way by=15");
  EXPECT_EQ(wild("A path climbs the hill."), "hill");
}

TEST(ReliefReadingTest, LandRisesAgainstWhereItFallsTo) {
  const auto heading = [](const std::string& text) {
    const LayoutReading reading = ByRules(text);
    EXPECT_EQ(reading.plan.reliefs.size(), 1u) << text;
    const Claim::Heading to = reading.plan.reliefs.front().heading;
    return std::to_string(to.east) + " " + std::to_string(to.south);
  };
  EXPECT_EQ(heading("The land rises by 30 m to the north."), "0 -1");
  EXPECT_EQ(heading("The land falls by 20 m to the east."), "-1 0");
  EXPECT_EQ(heading("The land slopes down to the south by 20 m."), "0 -1");
  EXPECT_EQ(heading("The ground slopes up to the west."), "-1 0");
  EXPECT_EQ(heading("A gentle slope rises to the south."), "0 1");
}

TEST(ReliefReadingTest, LandThatIsSaidToRiseToOppositeSidesIsTold) {
  const LayoutReading reading =
      BySentences("The land rises by 30 m to north. The land rises by 20 m to south.");
  ASSERT_EQ(reading.plan.reliefs.size(), 1u);
  EXPECT_EQ(reading.plan.reliefs[0].height_m, 20.0);
  ASSERT_EQ(reading.plan.warnings.size(), 1u);
}

TEST(ReliefReadingTest, LandThatIsSaidToBeFlatAndRuggedIsTold) {
  const LayoutReading reading = BySentences("The land is flat. The land is rugged.");
  ASSERT_EQ(reading.plan.warnings.size(), 1u);
  EXPECT_NE(reading.plan.warnings[0].find("are said of the same land"), std::string::npos);
  EXPECT_EQ(Short(reading), "rugged");
  EXPECT_TRUE(BySentences("The land is flat in the north. The land is rugged in the south.")
                  .plan.warnings.empty());
}

TEST(ReliefReadingTest, SnowAboveTwoHeightsIsTold) {
  const LayoutReading reading =
      Read("Snow above 80 m. Snow above 40 m.", Vocabulary::kWild, MakeControlledReader().get());
  ASSERT_EQ(reading.plan.covers.size(), 1u);
  EXPECT_EQ(reading.plan.covers[0].height_m, 40.0);
  ASSERT_EQ(reading.plan.warnings.size(), 1u);
  EXPECT_NE(reading.plan.warnings[0].find("cannot both be"), std::string::npos);
}

// Else snow is laid somewhere, and "above" is taken for north.
TEST(ReliefReadingTest, WhatCoversByHeightIsNoLandOfTheLayout) {
  const LayoutReading reading =
      ByRules("A lake in the south. A hill in the north. Snow above 80 m.", Vocabulary::kWild);
  EXPECT_EQ(Short(reading), "hill z=northern third; S>80");
  EXPECT_TRUE(reading.plan.relations.empty());
  EXPECT_TRUE(reading.plan.not_understood.empty());
  for (const PlannedFeature& feature : reading.plan.features) EXPECT_NE(feature.letter, 'S');
  for (const Claim& claim : reading.plan.claims)
    EXPECT_EQ(claim.words.find("Snow"), std::string::npos);
}

TEST(ReliefReadingTest, WordsThatOnlyPassAreNoPass) {
  for (const char* text : {"Roads pass through the forest.", "A river passes the village.",
                           "Water above 80 m.", "A village above the lake."}) {
    EXPECT_EQ(Short(ByRules(text)), "") << text;
  }
}

TEST(ReliefReadingTest, TheEnvironmentsTerrainTypeActsWhereTheLayoutSaysNothing) {
  EnvironmentReading environment;
  environment.heard.coarse_of(CoarseKey::kTerrainType).value = "mountain";
  LayoutReading bare = ByRules("A lake in the north.");
  AddTerrainType(environment, &bare);
  EXPECT_EQ(Short(bare), "mountainous");
  LayoutReading said = ByRules("A hill in the north.");
  AddTerrainType(environment, &said);
  EXPECT_EQ(Short(said), "hill z=northern third");
}

TEST(ReliefWordsTest, ANounMeansWhatItsLastWordMeans) {
  EXPECT_EQ(ReliefOfNoun("snow mountain"), ReliefKind::kMountain);
  EXPECT_EQ(ReliefOfNoun("mountain ridge"), ReliefKind::kRidge);
  EXPECT_EQ(ReliefOfNoun("mountain range"), ReliefKind::kMountain);
  EXPECT_EQ(ReliefOfNoun("mountain village"), std::nullopt);
}

}  // namespace
}  // namespace latticeworld
