#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/reading/relief/relief_reading.h"

namespace latticeworld {
namespace {

using Strings = std::vector<std::string>;

LayoutReading ReadLayout(const std::string& text) {
  LayoutRequest request;
  request.instruction = text;
  std::vector<ModelReply> replies;
  return MakeRuleReader()->ReadLayout(request, Progress(), &replies).value();
}

EnvironmentReading ReadEnvironment(const std::string& text) {
  const SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  EnvironmentRequest request;
  request.instruction = text;
  request.layout = &layout;
  std::vector<ModelReply> replies;
  return MakeRuleReader()->ReadEnvironment(request, Progress(), &replies).value();
}

// The place stands within words that a claim of the river quotes, and no claim has it.
TEST(RuleReaderTest, WhatAClaimQuotesAndDoesNotAskForIsLost) {
  const LayoutReading reading = ReadLayout(
      "The town is squeezed between the river to the west and the wooded hills to the east.");
  EXPECT_EQ(reading.plan.not_understood, Strings{"west"});
  bool quoted = false;
  for (const Claim& claim : reading.plan.claims) {
    quoted = quoted || claim.words.find("to the west") != std::string::npos;
  }
  EXPECT_TRUE(quoted);
}

TEST(RuleReaderTest, WhatTheRulesHaveReadIsNotLost) {
  for (const std::string text :
       {"A village lies between a lake in the north and a second lake in the south.",
        "A river winds from the north to the south between dense forest in the upper left and "
        "farmland on the right. A road runs from the west to the east, with a small village in "
        "the center."}) {
    EXPECT_EQ(ReadLayout(text).plan.not_understood, Strings()) << text;
  }
  for (const std::string text :
       {"Twenty sheep: ten graze in the north, the other ten lie resting somewhere.",
        "Two flocks of sheep: seven top right, eight bottom right.",
        "A sunny autumn afternoon. Nine sheep graze in the lower left, two goblins patrol near "
        "the upper right, an eagle circles above, and a wheeled robot waits in the center."}) {
    EXPECT_EQ(ReadEnvironment(text).heard.not_understood, Strings()) << text;
  }
}

// Words of the land's form are read apart.
TEST(RuleReaderTest, WhatIsReadOfTheLandsFormIsNotLost) {
  for (const std::string text : {"A lake in the center. A hill north of the lake.",
                                 "A hill A in the south. A crater north of hill A.",
                                 "A road along the southern edge. A hill in the center with a path "
                                 "of 15 degrees to its top."}) {
    LayoutReading reading = ReadLayout(text);
    ReadRelief(text, &reading);
    EXPECT_EQ(reading.plan.not_understood, Strings()) << text;
  }
  // The hills say nothing of the river.
  const std::string text =
      "The town is squeezed between the river to the west and the wooded hills to the east.";
  LayoutReading reading = ReadLayout(text);
  ReadRelief(text, &reading);
  EXPECT_EQ(reading.plan.not_understood, Strings{"west"});
}

}  // namespace
}  // namespace latticeworld
