#include "latticeworld/language/reading/environment_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/reading_of_sentences.h"

namespace latticeworld {
namespace {

using Parts = std::set<ReadingPart>;
using Strings = std::vector<std::string>;

const Parts kAll = {ReadingPart::kCoarse, ReadingPart::kFine, ReadingPart::kAgents};

class EnvironmentExchangeTest : public testing::Test {
 protected:
  // Reads the text as these sentences and exchanges it with its reading as those.
  void Exchange(const Parts& parts, const Strings& sentences, const Strings& others) {
    request_.instruction = text_;
    request_.layout = &layout_;
    reading_ = ReadingOfSentences(request_, sentences);
    second_ = ReadingOfSentences(request_, others).heard;
    latticeworld::Exchange(request_, parts, &reading_, &second_);
  }
  std::string Said() {
    Strings sentences = reading_.sentences;
    std::sort(sentences.begin(), sentences.end());
    return Join(sentences, ". ");
  }
  std::string Season() const { return reading_.heard.coarse_of(CoarseKey::kSeason).value; }

  const SymbolicLayout layout_{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  std::string text_ = "a text";
  EnvironmentRequest request_;
  EnvironmentReading reading_;
  HeardEnvironment second_;
};

TEST_F(EnvironmentExchangeTest, WhatOnlyOneHasCountsAndStaysWithTheOther) {
  Exchange({}, {"2 goblins", "Grass: dry"}, {"Weather: rain", "Flowers density: sparse"});
  EXPECT_EQ(Said(), "2 goblins. Flowers density: 2 to 35 %. Grass: dry. Weather: rain");
  EXPECT_EQ(second_.coarse_of(CoarseKey::kWeather).value, "rain");
  EXPECT_EQ(second_.fine.size(), 1u);
  Exchange({}, {"Weather: rain"}, {"2 goblins"});
  EXPECT_EQ(Said(), "2 goblins. Weather: rain");
  Exchange({}, {"Weather: rain"}, {"No agents"});
  EXPECT_EQ(reading_.heard.absences.size(), 1u);
}

// A number that the text says of something else is no wind.
TEST_F(EnvironmentExchangeTest, AParameterThatTheTextDoesNotSayGivesWayToOneThatIsNothingLikeIt) {
  const Strings windy = {"Wind: 5 to 12 m/s"};
  text_ = "Sunny and windy with three sheep.";
  Exchange({}, {"Wind: 3 m/s", "3 sheep"}, windy);
  EXPECT_EQ(Said(), "3 sheep. Wind: 5 to 12 m/s");
  EXPECT_EQ(second_.fine.at(0).value, 3.0);
  text_ = "Windy but sunny.";
  Exchange({}, {"Wind: 0 m/s"}, windy);
  EXPECT_EQ(Said(), "Wind: 5 to 12 m/s");

  Exchange({}, {"Wind: at least 10 m/s"}, windy);
  EXPECT_EQ(Said(), "Wind: at least 10 m/s") << "they meet";
  text_ = "A windy place, three m/s, with three sheep.";
  Exchange({}, {"Wind: 3 m/s", "3 sheep"}, windy);
  EXPECT_EQ(Said(), "3 sheep. Wind: 3 m/s") << "the text says three twice";
  text_ = "The houses look to the south.";
  Exchange({}, {"Building heading: 180 degrees"}, {"Building heading: 90 degrees"});
  EXPECT_EQ(Said(), "Building heading: 180 degrees") << "the text says it without a number";
}

// "Nobody else" was read as one agent in all.
TEST_F(EnvironmentExchangeTest, ATotalThatIsLessThanItsGroupsAndThatTheTextDoesNotSayIsDropped) {
  text_ = "Three sheep, one drone and nobody else. No horses.";
  const Strings groups = {"3 sheep", "1 aerial robot", "No horses"};
  Strings read = groups;
  read.push_back("1 agent in all");
  Exchange({}, read, {});
  EXPECT_EQ(reading_.sentences, groups);
  ASSERT_EQ(reading_.heard.absences.size(), 1u);
  EXPECT_EQ(reading_.heard.absences[0].kind, EnvironmentClaimKind::kNoAgents);

  read.back() = "4 agents in all";
  Exchange({}, read, {});
  EXPECT_EQ(reading_.sentences, read) << "it is what the groups are together";
  text_ = "Three sheep and one drone, two agents in all.";
  read.back() = "2 agents in all";
  Exchange({}, read, {});
  EXPECT_EQ(reading_.sentences, read) << "the text says it";
}

TEST_F(EnvironmentExchangeTest, WhatBothSayIsTheFirstsUnlessThePartCounts) {
  const Strings mine = {"Season: winter", "Grass: dry", "2 goblins"};
  const Strings others = {"Season: autumn", "Grass: lush", "3 goblins"};
  Exchange({}, mine, others);
  EXPECT_EQ(Said(), "2 goblins. Grass: dry. Season: winter");
  EXPECT_EQ(second_.coarse_of(CoarseKey::kSeason).value, "autumn");
  Exchange({ReadingPart::kCoarse}, mine, others);
  EXPECT_EQ(Said(), "2 goblins. Grass: dry. Season: autumn");
  EXPECT_EQ(second_.coarse_of(CoarseKey::kSeason).value, "winter");
  Exchange({ReadingPart::kFine}, mine, others);
  EXPECT_EQ(Said(), "2 goblins. Grass: lush. Season: winter");
  ASSERT_EQ(second_.fine.size(), 1u);
  EXPECT_EQ(second_.fine[0].claim.values, Strings{"dry"});
  Exchange({ReadingPart::kAgents}, mine, others);
  EXPECT_EQ(Said(), "3 goblins. Grass: dry. Season: winter");
  ASSERT_EQ(second_.agents.size(), 1u);
  EXPECT_EQ(second_.agents[0].quantity, 2);
  Exchange(kAll, mine, others);
  EXPECT_EQ(Said(), "3 goblins. Grass: lush. Season: autumn");
}

// "Grass: reed" is of a material and "Grass: dry" of a season's variant: both hold.
TEST_F(EnvironmentExchangeTest, WhatIsOfAnotherKindTakesNoPlace) {
  Exchange(kAll, {"Grass: reed"}, {"Grass: dry"});
  EXPECT_EQ(Said(), "Grass: dry. Grass: reed");
}

TEST_F(EnvironmentExchangeTest, WhatTheSecondDoesNotSpeakOfStays) {
  Exchange(kAll, {"Season: winter", "Grass: dry", "2 goblins"}, {});
  EXPECT_EQ(Said(), "2 goblins. Grass: dry. Season: winter");
}

TEST_F(EnvironmentExchangeTest, WhatIsRuledOutTakesNoValuesPlace) {
  Exchange(kAll, {"Season: winter"}, {"Season: not spring"});
  EXPECT_EQ(Season(), "winter");
  Exchange({}, {"Season: not spring"}, {"Season: winter"});
  EXPECT_EQ(Season(), "winter");
  Exchange({}, {}, {"Season: not spring"});
  EXPECT_EQ(Said(), "Season: summer or autumn or winter");
}

TEST_F(EnvironmentExchangeTest, AHintTakesNoValuesPlaceButFillsIt) {
  request_.instruction = text_;
  request_.layout = &layout_;
  reading_ = ReadingOfSentences(request_, {"Season: autumn"});
  second_ = ReadingOfSentences(request_, {"Season: winter"}).heard;
  second_.coarse[static_cast<std::size_t>(CoarseKey::kSeason)].hint = true;
  latticeworld::Exchange(request_, kAll, &reading_, &second_);
  EXPECT_EQ(Season(), "autumn");
  reading_ = ReadingOfSentences(request_, {"2 goblins"});
  latticeworld::Exchange(request_, {}, &reading_, &second_);
  EXPECT_EQ(Season(), "winter");
}

TEST_F(EnvironmentExchangeTest, AgentsAreAllOfOneReading) {
  Exchange({}, {"2 goblins"}, {"2 goblins", "5 sheep"});
  EXPECT_EQ(Said(), "2 goblins") << "five sheep are what the second reading asks for";
  Exchange({}, {"No agents"}, {"2 sheep"});
  EXPECT_EQ(Said(), "No agents");
  Exchange({}, {"Time: night"}, {"2 sheep"});
  EXPECT_EQ(Said(), "2 sheep. Time: night") << "only one reading has any";
}

TEST_F(EnvironmentExchangeTest, WordsThatNothingCarriesAnyMoreAreNotUnderstood) {
  text_ = "Two goblins, and five sheep by night.";
  Exchange({ReadingPart::kAgents}, {"2 goblins", "5 sheep", "Time: night"}, {"2 goblins"});
  EXPECT_EQ(Said(), "2 goblins. Time: night");
  EXPECT_FALSE(reading_.coverage.lost.empty());
  for (const std::string& words : reading_.coverage.lost) {
    EXPECT_NE(std::find(reading_.heard.not_understood.begin(), reading_.heard.not_understood.end(),
                        words),
              reading_.heard.not_understood.end())
        << words;
  }
}

TEST_F(EnvironmentExchangeTest, WarningsAreThoseOfWhatIsSaid) {
  const std::string wind = "Wind: 500 m/s";
  Exchange({}, {wind}, {});
  ASSERT_EQ(reading_.heard.warnings.size(), 1u) << "more than there can be";
  Exchange({ReadingPart::kFine}, {wind}, {"Wind: 5 m/s"});
  EXPECT_EQ(reading_.heard.warnings, Strings());
  Exchange({ReadingPart::kFine}, {"Wind: 5 m/s"}, {wind});
  EXPECT_EQ(reading_.heard.warnings.size(), 1u);
}

}  // namespace
}  // namespace latticeworld
