#include "latticeworld/language/reading/words/topics.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "language/reading/words/word_tables.h"
#include "latticeworld/language/reading/words/table_words.h"
#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

std::string_view TopicWordFile(std::string_view file_name);

namespace {

using Strings = std::vector<std::string>;

TEST(TopicsTest, ASentenceSpeaksOfItsKindsAndValues) {
  EXPECT_EQ(TopicsOf("3 to 5 sheep or horses grazing by the lake"), (Strings{"sheep", "horse"}));
  EXPECT_EQ(TopicsOf("No goblins."), Strings{"goblin"});
  EXPECT_EQ(TopicsOf("15 agents in all"), Strings{"agent"});
  EXPECT_EQ(TopicsOf("Season: not winter or spring"), (Strings{"season winter", "season spring"}));
  EXPECT_EQ(TopicsOf("Forest: autumn maple or oak"), (Strings{"forest maple", "forest oak"}));
  EXPECT_EQ(TopicsOf("Forest density: at most 5 %"), Strings{"forest density"});
  EXPECT_EQ(TopicsOf("Lake level: -0.3 m"), Strings{"lake level"});
  EXPECT_EQ(TopicsOf("A lake in the north"), Strings());
}

// Every form has a topic.
TEST(TopicsTest, EverySentenceOfEnvironmentsHasOne) {
  for (const SentenceForm& form : SentenceForms(SentenceKind::kEnvironment))
    EXPECT_FALSE(TopicsOf(form.example).empty()) << form.example;
}

TEST(TopicsTest, PeopleSpeakOfATopicInOtherWordsThanItsName) {
  EXPECT_TRUE(SpeakOf(TableWordsOf("Two ponies and their foals"), "horse"));
  EXPECT_TRUE(SpeakOf(TableWordsOf("Three legionaries"), "ancient warrior"));
  EXPECT_TRUE(SpeakOf(TableWordsOf("A flock"), "animal")) << "who speaks of sheep does of animals";
  EXPECT_FALSE(SpeakOf(TableWordsOf("A village, a river and a chapel"), "sheep"));
  EXPECT_FALSE(SpeakOf(TableWordsOf("A village, a river and a chapel"), "agent"));
  EXPECT_TRUE(SpeakOf(TableWordsOf("Spruce twigs"), "branches spruce")) << "too rare for the table";
  EXPECT_FALSE(SpeakOf(TableWordsOf("Snow and rock"), "snow ryegrass")) << "and what never is";
}

// Of examples that the table is not made of: nearly every kind of agent that a text has is spoken
// of, and few of all kinds are in texts of land.
TEST(TopicsTest, TextsSpeakOfTheAgentsThatTheyHaveAndSeldomOfOthers) {
  const std::filesystem::path left_out = std::filesystem::path(READER_EXAMPLES) / "left_out";
  std::set<std::string> kinds;
  for (const std::string& who : SentenceWords("who"))
    if (who != "agent" && who != "animal" && who != "robot") kinds.insert(who);
  int there = 0, spoken = 0, of_land = 0, spoken_of_land = 0;
  for (const char* name : {"k01_environments", "k02_environments", "k01_layouts", "k02_layouts"}) {
    std::ifstream lines(left_out / (std::string(name) + ".jsonl"));
    for (std::string line; std::getline(lines, line);) {
      const auto example = nlohmann::json::parse(line);
      const std::set<std::string> words = TableWordsOf(example["text"].get<std::string>());
      if (example["kind"] == "layout") {
        for (const std::string& kind : kinds) {
          ++of_land;
          spoken_of_land += SpeakOf(words, kind);
        }
        continue;
      }
      for (const auto& sentence : example["sentences"]) {
        for (const std::string& topic : TopicsOf(sentence.get<std::string>())) {
          if (kinds.count(topic) == 0) continue;
          ++there;
          spoken += SpeakOf(words, topic);
        }
      }
    }
  }
  EXPECT_GT(there, 1000);
  EXPECT_GT(spoken, 0.98 * there);
  EXPECT_GT(of_land, 5000);
  EXPECT_LT(spoken_of_land, 0.03 * of_land);
}

// The table is what the examples say: after a change of these, make_word_tables writes it anew.
TEST(TopicsTest, TheTableIsThatOfTheExamples) {
  EXPECT_EQ(LinesOfTable(TopicWordFile("topic_words.txt")),
            LinesOfTable(TopicTable(READER_EXAMPLES)));
}

}  // namespace
}  // namespace latticeworld
