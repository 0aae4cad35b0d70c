#include "latticeworld/language/reading/words/subjects.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "language/reading/words/word_tables.h"
#include "latticeworld/language/reading/words/table_words.h"

namespace latticeworld {

std::string_view SubjectWordFile(std::string_view file_name);

namespace {

using Strings = std::vector<std::string>;

TEST(SubjectsTest, SentencesEndWithAStopOrALineAndJoinedTheyAreTheText) {
  const std::string text = "A lake, 1.5 km. Is it deep? No!\n - forest; rain: heavy  ";
  std::string joined;
  Strings sentences;
  for (const std::string_view sentence : FreeSentences(text)) {
    joined += sentence;
    sentences.emplace_back(sentence);
  }
  EXPECT_EQ(joined, text);
  EXPECT_EQ(sentences,
            (Strings{"A lake, 1.5 km. ", "Is it deep? ", "No!\n ", "- forest; ", "rain: heavy  "}));
  EXPECT_TRUE(FreeSentences("").empty());
}

TEST(SubjectsTest, WordsAreLettersInTheSingular) {
  EXPECT_EQ(TableWordsOf("Foxes, ponies, wolves & 3 GLASSES; bus-stops"),
            (std::set<std::string>{"fox", "pony", "wolf", "glass", "bus", "stop"}));
}

TEST(SubjectsTest, ASentenceThatIsClearlyOfTheOtherKindIsLeftOut) {
  const std::string land = "A winding river runs from the northern edge to a lake in the south. ";
  const std::string weather = "Foggy autumn morning, and three sheep are grazing.";
  EXPECT_EQ(TextOf(SentenceKind::kLayout, land + weather), land);
  EXPECT_EQ(TextOf(SentenceKind::kEnvironment, land + weather), weather);
  EXPECT_EQ(TextOf(SentenceKind::kLayout, weather), "");
  const std::string both = "Ten goblins in the lower part of the map on the left.";
  EXPECT_EQ(TextOf(SentenceKind::kLayout, both), both);
  EXPECT_EQ(TextOf(SentenceKind::kEnvironment, both), both) << "goblins are of no land";
  const std::string either = "A village.";
  EXPECT_EQ(TextOf(SentenceKind::kLayout, either), either);
  EXPECT_EQ(TextOf(SentenceKind::kEnvironment, either), either);
}

TEST(SubjectsTest, WithoutWordsOfItsOwnAnEnvironmentHasThoseOfTheLayout) {
  const std::string land = "A winding river runs to a lake in the south. A village. ";
  const std::string weather = "Foggy autumn morning, and three sheep are grazing.";
  EXPECT_EQ(EnvironmentText(land + weather, " "), weather);
  EXPECT_EQ(EnvironmentText(land + weather, "Rain."), "Rain.");
  EXPECT_EQ(EnvironmentText(land, ""), "");
  EXPECT_EQ(EnvironmentText("Snow above 80 m. Forest surrounds the lake.", ""), "")
      << "sentences of the small language are of one kind";
}

TEST(SubjectsTest, WhatNeitherInstructionIsReadForIsWarnedOf) {
  const std::string land = "A winding river runs to a lake in the south.";
  const std::string weather = "Foggy autumn morning, and three sheep are grazing.";
  EXPECT_EQ(WarningsOfUnread(land + " " + weather + " " + weather, "Rain."),
            Strings{"not read, for it speaks of what environment_instruction describes: \"" +
                    weather + "\", \"" + weather + "\""});
  EXPECT_EQ(
      WarningsOfUnread("A village.", "Rain. " + land),
      Strings{"not read, for it speaks of what layout_instruction describes: \"" + land + "\""});
  EXPECT_TRUE(WarningsOfUnread(land + " " + weather, "").empty()) << "it is the environment's text";
  EXPECT_TRUE(WarningsOfUnread(land + " " + weather, weather).empty()) << "it is read there";
  EXPECT_TRUE(WarningsOfUnread(land, weather).empty());
}

// Of examples that the table is not made of.
TEST(SubjectsTest, NearlyAllOfATextsOwnSentencesStayAndMostOfTheOthersGo) {
  const std::filesystem::path left_out = std::filesystem::path(READER_EXAMPLES) / "left_out";
  const auto share = [&](const std::string& kind, SentenceKind of) {
    std::size_t all = 0, left = 0;
    for (const char* author : {"k01", "k02"}) {
      std::ifstream lines(left_out / (author + ("_" + kind) + "s.jsonl"));
      for (std::string line; std::getline(lines, line);) {
        const auto text = nlohmann::json::parse(line)["text"].get<std::string>();
        all += text.size();
        left += TextOf(of, text).size();
      }
    }
    EXPECT_GT(all, 50000u);
    return static_cast<double>(left) / static_cast<double>(all);
  };
  EXPECT_GT(share("layout", SentenceKind::kLayout), 0.99);
  EXPECT_GT(share("environment", SentenceKind::kEnvironment), 0.99);
  EXPECT_LT(share("layout", SentenceKind::kEnvironment), 0.4);
  EXPECT_LT(share("environment", SentenceKind::kLayout), 0.4);
}

// The table is what the examples say: after a change of these, make_word_tables writes it anew.
TEST(SubjectsTest, TheTableIsThatOfTheExamples) {
  EXPECT_EQ(LinesOfTable(SubjectWordFile("subject_words.txt")),
            LinesOfTable(SubjectTable(READER_EXAMPLES)));
}

}  // namespace
}  // namespace latticeworld
