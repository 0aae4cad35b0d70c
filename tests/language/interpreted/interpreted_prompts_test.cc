#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/prompts.h"

namespace latticeworld {
namespace {

// The sentences that a prompt quotes as examples: "A lake in the north."
std::vector<std::string> Examples(const std::string& prompt) {
  std::vector<std::string> examples;
  const std::regex quoted("\"([A-Z][^\"]*\\.)\"");
  for (std::sregex_iterator at(prompt.begin(), prompt.end(), quoted), end; at != end; ++at)
    examples.push_back((*at)[1]);
  return examples;
}

std::string SystemText(const std::vector<ChatMessage>& messages) { return messages.at(0).text; }

TEST(InterpretedPromptsTest, EverythingIsFilledInForBothVocabularies) {
  for (const auto vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const auto messages = LayoutWordsMessages({"a {{tarn}}", vocabulary, nullptr, 1});
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].text.find("{{"), std::string::npos);
    EXPECT_NE(messages[1].text.find("a {{tarn}}"), std::string::npos);
    const bool wild = vocabulary == Vocabulary::kWild;
    EXPECT_EQ(messages[0].text.find("glacier") != std::string::npos, wild);
    EXPECT_EQ(messages[0].text.find("farmland or fields") != std::string::npos, !wild);
  }
  EnvironmentRequest request;
  request.instruction = "at dusk";
  const std::string system = SystemText(EnvironmentWordsMessages(request));
  EXPECT_EQ(system.find("{{"), std::string::npos);
  for (const char* name : {"sandstorm", "cyberpunk", "robotic dog", "wetland"})
    EXPECT_NE(system.find(name), std::string::npos) << name;
  EXPECT_NE(ReadBackText("(nothing)").find("(nothing)"), std::string::npos);
  EXPECT_NE(SentencesRepairText({{"x", "", "is wrong", ""}}).find("- is wrong"), std::string::npos);
}

// A model that keeps to the examples is read: otherwise they mislead it.
TEST(InterpretedPromptsTest, EveryExampleOfALayoutIsReadWhole) {
  const auto examples =
      Examples(SystemText(LayoutWordsMessages({"x", Vocabulary::kSuburb, nullptr, 1})));
  ASSERT_GT(examples.size(), 40u);
  for (const std::string& example : examples) {
    const LayoutReading reading = ReadLayoutInstruction(example, Vocabulary::kSuburb);
    EXPECT_FALSE(reading.plan.claims.empty()) << example;
    EXPECT_TRUE(reading.plan.not_understood.empty())
        << example << ": " << reading.plan.not_understood[0];
  }
}

TEST(InterpretedPromptsTest, EveryExampleOfAnEnvironmentIsReadWhole) {
  const auto examples = Examples(SystemText(EnvironmentWordsMessages({})));
  ASSERT_GT(examples.size(), 15u);
  for (const std::string& example : examples) {
    const EnvironmentClaims reading = ReadEnvironmentInstruction(example);
    EXPECT_FALSE(reading.claims.empty()) << example;
    EXPECT_TRUE(reading.not_understood.empty()) << example << ": " << reading.not_understood[0];
  }
}

}  // namespace
}  // namespace latticeworld
