#include "latticeworld/language/sentences/sentence_grammar.h"

#include <gtest/gtest.h>

#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/language/local/tokens/grammar.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

bool Accepts(SentenceKind kind, const std::string& text) {
  static const Grammar layout = *Grammar::FromGbnf(SentenceGrammar(SentenceKind::kLayout));
  static const Grammar environment =
      *Grammar::FromGbnf(SentenceGrammar(SentenceKind::kEnvironment));
  GrammarMatcher matcher(kind == SentenceKind::kLayout ? layout : environment);
  GrammarMatcher::State state = matcher.Begin();
  for (const char c : text) state = matcher.After(state, static_cast<unsigned char>(c));
  return matcher.Accepts(state);
}

TEST(SentenceGrammarTest, AcceptsEveryExample) {
  for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
    std::string all;
    for (const SentenceForm& form : SentenceForms(kind)) {
      EXPECT_TRUE(Accepts(kind, form.example)) << form.example;
      if (all.size() < 1000) all += (all.empty() ? "" : " ") + form.example;
    }
    EXPECT_TRUE(Accepts(kind, all));
    EXPECT_TRUE(Accepts(kind, "-"));
  }
}

TEST(SentenceGrammarTest, RefusesWhatIsNoSentence) {
  for (const std::string text : {"", "A lake", "a lake.", "A lake.A pond.", "A lake lake.",
                                 "Ignore all that.", "A lake in the north. ", "-A lake."}) {
    EXPECT_FALSE(Accepts(SentenceKind::kLayout, text)) << text;
  }
}

// Walks the grammar at random: every text that it allows is made of sentences of the language.
TEST(SentenceGrammarTest, AllowsNothingThatCannotBeRead) {
  for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
    const Grammar grammar = *Grammar::FromGbnf(SentenceGrammar(kind));
    int texts = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      RandomStream random(seed, "grammar walk");
      GrammarMatcher matcher(grammar);
      GrammarMatcher::State state = matcher.Begin();
      std::string text;
      while (text.size() < 400 && !(text.size() > 1 && text.back() == '.' &&
                                    matcher.Accepts(state) && random.Chance(0.5))) {
        std::string next;
        for (int byte = 32; byte < 127; ++byte) {
          if (!matcher.After(state, static_cast<unsigned char>(byte)).empty()) {
            next += static_cast<char>(byte);
          }
        }
        if (next.empty()) break;
        const char c =
            next[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(next.size()) - 1))];
        text += c;
        state = matcher.After(state, static_cast<unsigned char>(c));
      }
      if (!matcher.Accepts(state) || text == "-") continue;
      ++texts;
      for (const std::string& sentence : SplitSentences(text)) {
        EXPECT_TRUE(ReadSentence(sentence, kind).has_value()) << sentence;
      }
    }
    EXPECT_GE(texts, 20);
  }
}

}  // namespace
}  // namespace latticeworld
