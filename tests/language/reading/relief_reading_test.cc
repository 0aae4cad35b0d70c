#include "latticeworld/language/reading/relief_reading.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/reading/relief_words.h"

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
      constexpr const char* kNames[] = {"under", "beside", "toward", "climbed"};
      all += std::string(" ") + kNames[static_cast<int>(tie.kind)] + "=" + tie.letter;
    }
    if (wish.alone) all += " alone";
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
