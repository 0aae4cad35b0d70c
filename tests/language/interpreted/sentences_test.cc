#include "latticeworld/language/interpreted/sentences.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace latticeworld {
namespace {

using Strings = std::vector<std::string>;

TEST(SentencesTest, AreFoundInWhateverAModelPutsAroundThem) {
  const Strings wanted = {"A lake in the north", "No road", "Two farms"};
  const std::string object =
      R"({"sentences": ["A lake in the north", " No road!\n", "", "Two farms."]})";
  for (const std::string& answer :
       {object, "<think>{\"sentences\": []}</think>" + object, "```json\n" + object + "\n```",
        "First {\"sentences\": 3}, rather: " + object + " Done."}) {
    const auto sentences = ReadSentences(answer);
    ASSERT_TRUE(sentences.ok()) << answer;
    EXPECT_EQ(*sentences, wanted) << answer;
  }
}

TEST(SentencesTest, MayBeNone) {
  const auto sentences = ReadSentences(R"({"sentences": []})");
  ASSERT_TRUE(sentences.ok());
  EXPECT_TRUE(sentences->empty());
}

TEST(SentencesTest, WhatIsNoListOfThemIsRefused) {
  for (const char* answer : {"", "A lake.", "[\"A lake.\"]", "{\"sentences\": \"A lake.\"}",
                             "{\"sentences\": [1]}", "{\"sentences\": [\"A la"}) {
    const auto sentences = ReadSentences(answer);
    ASSERT_FALSE(sentences.ok()) << answer;
    ASSERT_EQ(sentences.status().violations().size(), 1u) << answer;
    EXPECT_EQ(sentences.status().violations()[0].code, "no_sentences") << answer;
  }
}

TEST(SentencesTest, AreFoundBesideListsInLists) {
  const std::string deep = std::string(1000, '[') + std::string(1000, ']');
  const auto sentences =
      ReadSentences("{\"why\": " + deep + ", \"how\": 1, \"sentences\": [\"A lake\"]}");
  ASSERT_TRUE(sentences.ok());
  EXPECT_EQ(*sentences, Strings({"A lake"}));
}

TEST(SentencesTest, ThatNoInstructionCouldHoldAreRefused) {
  std::string many = "{\"sentences\": [\"x\"";
  for (int i = 0; i < 64; ++i) many += ", \"x\"";
  const std::string length = "{\"sentences\": [\"" + std::string(20000, 'x') + "\"]}";
  for (const std::string& answer : {many + "]}", length}) {
    const auto sentences = ReadSentences(answer);
    ASSERT_FALSE(sentences.ok());
    EXPECT_EQ(sentences.status().violations()[0].code, "too_long");
  }
}

TEST(SentencesTest, AreTrimmed) {
  EXPECT_EQ(Trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(Trimmed(" \n"), "");
  EXPECT_EQ(Trimmed(""), "");
}

}  // namespace
}  // namespace latticeworld
