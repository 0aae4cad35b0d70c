#include "latticeworld/dataset/captions/phrase_book.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {
namespace {

TEST(PhraseBookTest, FillsSlotsAndNumber) {
  EXPECT_EQ(FillPhrase("{s} [lies|lie] {at}", {{"s", "lakes"}, {"at", "in the north"}}, true),
            "lakes lie in the north");
  EXPECT_EQ(FillPhrase("[is|are]", {}, false), "is");
}

TEST(PhraseBookTest, NamesEveryBadLine) {
  const auto book = PhraseBook::Parse("# a comment\nkey\t*\tphrase\nno tabs\nkey\tq\tvoice?\n");
  ASSERT_FALSE(book.ok());
  ASSERT_EQ(book.status().violations().size(), 2u);
  EXPECT_EQ(book.status().violations()[0].pointer, "line 3");
  EXPECT_EQ(book.status().violations()[1].pointer, "line 4");
}

TEST(PhraseBookTest, AVoiceGetsItsOwnPhrases) {
  const auto book = PhraseBook::Parse("a\tt\tterse\na\tls\tother\nb\tx\tonly\n");
  ASSERT_TRUE(book.ok());
  std::set<std::string> terse, spoken;
  RandomStream random(1, "test");
  for (int i = 0; i < 20; ++i) {
    terse.insert(book->Pick("a", Voice::kTerse, &random));
    spoken.insert(book->Pick("a", Voice::kSpoken, &random));
    EXPECT_EQ(book->Pick("b", Voice::kTerse, &random), "only") << "lent where there is no own";
  }
  EXPECT_EQ(terse, std::set<std::string>{"terse"});
  EXPECT_EQ(spoken, std::set<std::string>{"other"});
}

TEST(PhraseBookTest, HasWordsForAllThatIsSaid) {
  const PhraseBook& book = PhraseBook::BuiltIn();
  const auto expect = [&](const std::string& key) { EXPECT_TRUE(book.Has(key)) << key; };
  for (const auto& entry : EnumNames(Season{})) expect("season." + std::string(entry.name));
  for (const auto& entry : EnumNames(TimeOfDay{})) expect("time." + std::string(entry.name));
  for (const auto& entry : EnumNames(ArtisticStyle{})) expect("style." + std::string(entry.name));
  for (const auto& entry : EnumNames(Weather{})) {
    expect("weather." + std::string(entry.name));
    expect("clause." + std::string(entry.name));
  }
  for (const auto& entry : EnumNames(AgentCategory{})) expect("agent." + std::string(entry.name));
  for (const auto& entry : EnumNames(AgentState{})) expect("state." + std::string(entry.name));
  for (const auto& entry : EnumNames(Region{})) {
    if (entry.value == Region::kAnywhere) continue;
    expect("region." + std::string(entry.name) + ".compass");
    expect("region." + std::string(entry.name) + ".picture");
  }
  for (const std::string& key : book.keys()) {
    if (!StartsWith(key, "zone.")) continue;
    const std::string name = key.substr(5, key.rfind('.') - 5);
    EXPECT_TRUE(FindZone(name).has_value()) << key;
    expect("zone." + name + ".compass");
    expect("zone." + name + ".picture");
  }
}

TEST(PhraseBookTest, EveryNounNamesItsClass) {
  const PhraseBook& book = PhraseBook::BuiltIn();
  int nouns = 0;
  for (const std::string& key : book.keys()) {
    if (!StartsWith(key, "noun.")) continue;
    const std::vector<std::string> parts = Split(key, '.');
    ASSERT_EQ(parts.size(), 4u) << key;
    const Vocabulary vocabulary = FromName<Vocabulary>(parts[1]).value();
    for (const std::string& phrase : book.PhrasesOf(key)) {
      const std::vector<std::string> fields = Split(phrase, ';');
      ASSERT_EQ(fields.size(), 3u) << phrase;
      // The last words of a noun are what it is: "patch of bare ground".
      const std::vector<Token> tokens = Tokenize(fields[1]);
      bool found = false;
      for (std::size_t at = 0; at < tokens.size() && !found; ++at) {
        const ClassWordMatch match = MatchClassWord(tokens, at);
        found = match.word != nullptr && match.word->LetterIn(vocabulary) == parts[2][0];
      }
      EXPECT_TRUE(found) << phrase << " in " << key;
      ++nouns;
    }
  }
  EXPECT_GE(nouns, 50);
}

TEST(PhraseBookTest, MistypedWordsKeepTheirFirstLetterAndShortWordsStay) {
  RandomStream random(3, "test");
  const std::string text = "A lake lies north of the farmland and forest, 40 % of it.";
  const std::string typed = Mistyped(text, 1.0, &random);
  EXPECT_NE(typed, text);
  EXPECT_EQ(Split(typed, ' ').size(), Split(text, ' ').size());
  EXPECT_NE(typed.find("A lake lies n"), std::string::npos) << typed;
  EXPECT_NE(typed.find("40 % of it."), std::string::npos) << typed;
  EXPECT_EQ(Mistyped(text, 0.0, &random), text);
}

TEST(PhraseBookTest, NumbersAndCapitals) {
  EXPECT_EQ(NumberWord(7), "seven");
  EXPECT_EQ(NumberWord(40), "40");
  EXPECT_EQ(Capitalised("the"), "The");
}

}  // namespace
}  // namespace latticeworld
