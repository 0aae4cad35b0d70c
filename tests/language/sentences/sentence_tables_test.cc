#include "latticeworld/language/sentences/sentence_tables.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

TEST(SentenceTablesTest, EveryExampleIsASentenceOfItsForm) {
  for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
    std::set<std::string> names;
    for (const SentenceForm& form : SentenceForms(kind)) {
      EXPECT_TRUE(names.insert(form.name).second) << "twice: " << form.name;
      const auto sentence = ReadSentence(form.example, kind);
      ASSERT_TRUE(sentence.has_value()) << form.example;
      EXPECT_EQ(sentence->form->name, form.name) << form.example;
    }
  }
}

TEST(SentenceTablesTest, EverySlotOfAPatternIsKnown) {
  const auto check = [](const Pattern& pattern, const auto& self) -> void {
    if (pattern.kind == Pattern::Kind::kSlot) {
      const bool built_in = pattern.name == "n" || pattern.name == "label";
      EXPECT_TRUE(built_in || SlotPattern(pattern.name) != nullptr ||
                  !SentenceWords(pattern.name).empty())
          << pattern.name;
      if (SlotPattern(pattern.name) != nullptr) self(*SlotPattern(pattern.name), self);
    }
    for (const Pattern& part : pattern.parts) self(part, self);
  };
  for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
    for (const SentenceForm& form : SentenceForms(kind)) check(form.pattern, check);
  }
}

TEST(SentenceTablesTest, NounsOfTheLandNameAClass) {
  for (const char* list : {"mass", "countable"}) {
    for (const std::string& noun : SentenceWords(list)) {
      EXPECT_NE(MatchClassWord(Tokenize(noun), 0).word, nullptr) << noun;
      EXPECT_EQ(MatchClassWord(Tokenize(noun), 0).tokens, Tokenize(noun).size()) << noun;
    }
  }
}

TEST(SentenceTablesTest, PluralsAreRegular) {
  EXPECT_EQ(PluralNoun("lake"), "lakes");
  EXPECT_EQ(PluralNoun("city"), "cities");
  EXPECT_EQ(PluralNoun("valley"), "valleys");
  EXPECT_EQ(PluralNoun("beach"), "beaches");
  EXPECT_EQ(PluralNoun("sheep"), "sheep");
  EXPECT_EQ(PluralNoun("oasis"), "oases");
  EXPECT_EQ(PluralNoun("robotic dog"), "robotic dogs");
  EXPECT_EQ(SingularNoun("countable", "cities"), "city");
  EXPECT_EQ(SingularNoun("countable", "zorblaxes"), "zorblaxes");
}

}  // namespace
}  // namespace latticeworld
