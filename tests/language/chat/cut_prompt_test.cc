#include "latticeworld/language/chat/cut_prompt.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

// Of two messages with so many characters together.
ChatRequest Sent(std::size_t characters, const std::string& character = "x") {
  ChatRequest request;
  std::string text;
  for (std::size_t i = 0; i < characters / 2; ++i) text += character;
  request.messages = {{ChatRole::kSystem, text, ""}, {ChatRole::kUser, text, ""}};
  return request;
}

TEST(CutPromptTest, TooFewTokensForTheCharactersAreAWarningWithBothNumbers) {
  const std::string warning = CutPromptWarning(Sent(13066), 1300);
  EXPECT_NE(warning.find("1300 tokens"), std::string::npos) << warning;
  EXPECT_NE(warning.find("13066 characters"), std::string::npos) << warning;
  EXPECT_NE(warning.find("OLLAMA_CONTEXT_LENGTH"), std::string::npos) << warning;
}

TEST(CutPromptTest, WhatOllamaLeavesOfAnEnvironmentsPromptIsAWarning) {
  // A whole context of 2048 or 4096 of older ones; half of it and two of newer ones.
  for (const int tokens : {1026, 2048, 2050, 4096}) {
    EXPECT_NE(CutPromptWarning(Sent(13066), tokens), "") << tokens;
  }
}

TEST(CutPromptTest, UsualPromptsAndUnknownCountsAreNoWarning) {
  for (const int tokens : {0, 2800, 3300, 4095, 4097, 4099, 13066}) {
    EXPECT_EQ(CutPromptWarning(Sent(13066), tokens), "") << tokens;
  }
  EXPECT_EQ(CutPromptWarning(Sent(4000), 2048), "") << "full of tokens of few letters by chance";
  EXPECT_EQ(CutPromptWarning(Sent(30, "\xE6\xA3\xAE"), 6), "") << "characters, not bytes";
}

}  // namespace
}  // namespace latticeworld
