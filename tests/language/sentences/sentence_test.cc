#include "latticeworld/language/sentences/sentence.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace latticeworld {
namespace {

std::string FormOf(const std::string& text, SentenceKind kind = SentenceKind::kLayout) {
  const auto sentence = ReadSentence(text, kind);
  return sentence.has_value() ? sentence->form->name : "none";
}

TEST(SentenceTest, SplitsAtStopsAndLinesButNotInNumbers) {
  EXPECT_EQ(SplitSentences("A lake. Wind: 2.5 m/s.\n- \n No water"),
            (std::vector<std::string>{"A lake", "Wind: 2.5 m/s", "-", "No water"}));
  EXPECT_TRUE(SplitSentences(" \n . ").empty());
}

TEST(SentenceTest, ReadsWhatPeopleWriteToo) {
  EXPECT_EQ(FormOf("a lake at the northern edge"), "there");
  EXPECT_EQ(FormOf("FOREST COVERS 30% OF THE MAP."), "cover");
  EXPECT_EQ(FormOf("The 2 lakes are at least 5 cells apart."), "apart_cells");
  EXPECT_EQ(FormOf("A road from lake A to the northern edge through the center"), "course");
  EXPECT_EQ(FormOf("Forest in the north, the south and the center."), "there");
}

TEST(SentenceTest, RefusesWhatNoFormHas) {
  for (const std::string text :
       {"", ".", "-", "Lovely weather.", "A lake lake.", "A zorblax in the north.",
        "Forest covers % of the map.", "A lake in the north in the south.", "The lake is."}) {
    EXPECT_EQ(FormOf(text), "none") << text;
  }
  EXPECT_EQ(FormOf(std::string(5000, 'a')), "none");
  std::string long_list = "A lake in the north";
  for (int i = 0; i < 2000; ++i) long_list += ", the north";
  EXPECT_EQ(FormOf(long_list), "none");
}

TEST(SentenceTest, PhrasesHoldWhatTheSlotsTook) {
  const auto sentence = ReadSentence("2 small ponds are between the large lake B and the forest.",
                                     SentenceKind::kLayout);
  ASSERT_TRUE(sentence.has_value());
  EXPECT_EQ(sentence->form->name, "between");
  const Phrase* x = sentence->whole.Find("x");
  ASSERT_NE(x, nullptr);
  EXPECT_EQ(x->text, "2 small ponds");
  EXPECT_EQ(x->Find("size")->text, "small");
  EXPECT_EQ(x->Find("n")->text, "2");
  EXPECT_EQ(x->Find("label"), nullptr);
  EXPECT_EQ(sentence->whole.Find("y")->Find("label")->text, "B");
  EXPECT_EQ(sentence->whole.Find("z")->text, "the forest");
  EXPECT_EQ(sentence->whole.FindAll("noun").size(), 3u);
  EXPECT_TRUE(sentence->Says("between"));
}

// Found by the fuzz target small_language.
TEST(SentenceTest, TheWordsOfASentenceAreOneOfTheSameForm) {
  for (const std::string text : {"forest S", "Lake A is NEAR Lake B.", "A lake A"}) {
    const auto sentence = ReadSentence(text, SentenceKind::kLayout);
    ASSERT_TRUE(sentence.has_value()) << text;
    EXPECT_EQ(FormOf(sentence->whole.text), sentence->form->name) << sentence->whole.text;
  }
}

TEST(SentenceTest, AgentsOfSeveralWords) {
  const auto sentence =
      ReadSentence("2 to 5 robotic dogs or wheeled robots patrolling in the village.",
                   SentenceKind::kEnvironment);
  ASSERT_TRUE(sentence.has_value());
  EXPECT_EQ(sentence->form->name, "group_feature");
  EXPECT_EQ(sentence->whole.FindAll("one").size(), 2u);
  EXPECT_EQ(sentence->whole.Find("state")->text, "patrolling");
  EXPECT_EQ(FormOf("1 eagle over the northern forest.", SentenceKind::kEnvironment),
            "group_heading_in");
}

}  // namespace
}  // namespace latticeworld
