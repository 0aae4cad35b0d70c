#include "latticeworld/generation/fidelity/reading_difference.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/layout_of_sentences.h"

namespace latticeworld {
namespace {

using Strings = std::vector<std::string>;

class ReadingDifferenceTest : public testing::Test {
 protected:
  // A lake in the north, a village in the south, grass between them.
  ReadingDifferenceTest() {
    for (int row = 0; row < 10; ++row) {
      for (int column = 0; column < kLayoutSize; ++column) layout_.cells(row, column) = 'W';
    }
    for (int row = 26; row < 30; ++row) {
      for (int column = 12; column < 20; ++column) layout_.cells(row, column) = 'B';
    }
  }

  // The one warning of two readings of a layout in sentences; "": none.
  std::string OfLayouts(const Strings& first, const Strings& second, const Strings& so_far = {}) {
    LayoutReading reading;
    reading.plan = LayoutOfSentences(first, layout_.vocabulary);
    reading.second = LayoutOfSentences(second, layout_.vocabulary).claims;
    return Only(DifferenceWarnings(reading, {}, layout_, {}, so_far));
  }
  std::string OfEnvironments(const Strings& first, const Strings& second) {
    EnvironmentReading reading;
    reading.heard = EnvironmentOfSentences(first, *Catalogue::BuiltIn());
    reading.second = EnvironmentOfSentences(second, *Catalogue::BuiltIn());
    EnvironmentConfig environment;
    environment.coarse.weather = Weather::kFog;
    environment.agents = {{AgentCategory::kSheep, 5, AgentState::kGrazing, Region::kUpper}};
    return Only(DifferenceWarnings({}, reading, layout_, environment, {}));
  }
  static std::string Only(const Strings& warnings) {
    EXPECT_LE(warnings.size(), 1u);
    return warnings.empty() ? std::string() : warnings.front();
  }

  SymbolicLayout layout_{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
};

TEST_F(ReadingDifferenceTest, WhatOnlyOneReadingAsksForIsNamedOnBothSides) {
  const std::string warning =
      OfLayouts({"A lake in the north", "A village in the south"},
                {"A lake in the north", "A road from the west to the east"});
  EXPECT_EQ(
      warning.rfind("a second reading differs: it does not ask for \"A village in the south\"", 0),
      0u)
      << warning;
  EXPECT_NE(warning.find("; it asks for \"A road from the west to the east\" ("), std::string::npos)
      << warning;
  EXPECT_EQ(warning.find("lake"), std::string::npos) << warning;
}

TEST_F(ReadingDifferenceTest, WhatTheSecondAsksForAndTheWorldHasByChanceIsNamedToo) {
  EXPECT_EQ(OfLayouts({"A lake in the north"}, {"A lake in the north", "A village in the south"}),
            "a second reading differs: it asks for \"A village in the south\" (present)");
}

TEST_F(ReadingDifferenceTest, ReadingsThatCanBothHoldAgree) {
  EXPECT_EQ(OfLayouts({"A lake in the north"}, {"A lake in the north"}), "");
  EXPECT_EQ(OfLayouts({"A lake in the north"}, {"Water covers 20 % to 40 % of the map"}), "");
  EXPECT_EQ(OfLayouts({"A lake"}, {}), "") << "there is no second reading";
  EXPECT_EQ(OfEnvironments({"Weather: fog", "5 sheep grazing"}, {"Weather: fog", "5 sheep"}), "");
}

TEST_F(ReadingDifferenceTest, OtherPlacesNumbersAndKindsAreDifferences) {
  const std::string places = OfLayouts({"A village in the south"}, {"A village in the north-west"});
  EXPECT_NE(places.find("does not ask for \"A village in the south\""), std::string::npos);
  EXPECT_NE(places.find("it asks for \"A village in the north-west\""), std::string::npos);
  const std::string agents =
      OfEnvironments({"Weather: fog", "5 sheep"}, {"Weather: rain", "7 sheep"});
  for (const char* part : {"does not ask for \"Weather: fog\" (coarse), \"5 sheep\" (agents)",
                           "it asks for \"Weather: rain\" (", "\"7 sheep\" ("}) {
    EXPECT_NE(agents.find(part), std::string::npos) << agents;
  }
}

TEST_F(ReadingDifferenceTest, WhatAWarningQuotesAlreadyIsLeftOut) {
  EXPECT_EQ(OfLayouts({"A lake in the north"}, {"A lake in the north", "A road"},
                      {"not understood: \"A road\""}),
            "");
}

TEST_F(ReadingDifferenceTest, ManyDifferencesStayOneLine) {
  const std::string warning = OfLayouts(
      {"A lake in the north"},
      {"A lake in the north", "A road", "Forest in the west", "Forest in the east",
       "A desert in the center", "A field in the south", "A river from the west to the east"});
  EXPECT_NE(warning.find(" and 1 more"), std::string::npos) << warning;
}

}  // namespace
}  // namespace latticeworld
