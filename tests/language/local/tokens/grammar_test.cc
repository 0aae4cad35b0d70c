#include "latticeworld/language/local/tokens/grammar.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

bool Matches(const std::string& gbnf, const std::string& text) {
  const auto grammar = Grammar::FromGbnf(gbnf);
  EXPECT_TRUE(grammar.ok()) << grammar.status().ToString();
  GrammarMatcher matcher(*grammar);
  GrammarMatcher::State state = matcher.Begin();
  for (const char c : text) state = matcher.After(state, static_cast<unsigned char>(c));
  return matcher.Accepts(state);
}

TEST(GrammarTest, AcceptsWhatRegularExpressionsAccept) {
  const std::vector<std::pair<std::string, std::string>> same = {
      {"root ::= \"a\"* [bc]+ \"a\"?", "a*[bc]+a?"},
      {"root ::= (\"ab\" | \"ba\" c){2,3}\nc ::= \"c\" | \"\"", "(ab|bac?){2,3}"},
      {"root ::= [^a]{1,} \"a\"", "[^a]{1,}a"},
      {"# a comment\nroot ::= x | # another\n  y\nx ::= [a-c]{2}\ny ::= \"a\" root?",
       "a*([a-c]{2}|a)"}};
  RandomStream random(1, "texts");
  for (const auto& [gbnf, regex] : same) {
    int accepted = 0;
    for (int i = 0; i < 400; ++i) {
      std::string text;
      const int size = random.UniformInt(0, 7);
      for (int k = 0; k < size; ++k) text += static_cast<char>('a' + random.UniformInt(0, 2));
      const bool wanted = std::regex_match(text, std::regex(regex));
      accepted += wanted ? 1 : 0;
      EXPECT_EQ(Matches(gbnf, text), wanted) << gbnf << " and '" << text << "'";
    }
    EXPECT_GE(accepted, 5) << regex;
  }
}

TEST(GrammarTest, FollowsRulesThatCallThemselves) {
  const std::string balanced = "root ::= (\"(\" root \")\")*";
  EXPECT_TRUE(Matches(balanced, "(()())()"));
  EXPECT_FALSE(Matches(balanced, "(()"));
  EXPECT_FALSE(Matches(balanced, "())"));
}

TEST(GrammarTest, ReadsEscapes) {
  EXPECT_TRUE(Matches("root ::= \"\\\"\\\\\\n\\x41\" [\\]\\[]", "\"\\\nA["));
}

TEST(GrammarTest, EndsWhereRulesCallThemselvesFirst) {
  const auto grammar = Grammar::FromGbnf("root ::= root \"a\" | \"b\"");
  ASSERT_TRUE(grammar.ok());
  GrammarMatcher matcher(*grammar);
  EXPECT_FALSE(matcher.Begin().empty());
}

TEST(GrammarTest, SaysWhatIsWrongAndInWhichLine) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"", "no rule 'root'"},
      {"root := \"a\"", "line 1: '::='"},
      {"root ::= \"a", "not closed"},
      {"root ::= [a", "not closed"},
      {"root ::= (\"a\"", "')' is wanted"},
      {"root ::= \"a\"\n\nother ::= gone", "line 3: there is no rule 'gone'"},
      {"root ::= \"a\"{3,1}", "fewer repetitions"},
      {"root ::= (\"a\"{100000}){100000}", "nodes"},
      {"root ::= \"a\"{100001}", "more than 100000"},
      {"root ::= [z-a]", "backwards"},
      {"root ::= \"\\q\"", "means nothing"},
      {"root ::= \"a\" ]", "begins nothing"},
      {"root ::= \"a\"\nroot ::= \"b\"", "there twice"},
      {"root ::= " + std::string(200, '(') + "\"a\"" + std::string(200, ')'), "groups in groups"}};
  for (const auto& [gbnf, what] : wrong) {
    const auto grammar = Grammar::FromGbnf(gbnf);
    ASSERT_FALSE(grammar.ok()) << gbnf;
    EXPECT_EQ(grammar.status().code(), StatusCode::kInvalidArgument);
    EXPECT_NE(grammar.status().message().find(what), std::string::npos)
        << grammar.status().message();
  }
}

// Once neither would have ended.
TEST(GrammarTest, NothingMayBeRepeatedAsOftenAsOneLikes) {
  const std::string grammar =
      "root ::= (((\"\"){100000}){100000}){100000} (\"\" | \"a\"){3} ((){90000}){90000,}";
  EXPECT_TRUE(Matches(grammar, ""));
  EXPECT_TRUE(Matches(grammar, "aaa"));
  EXPECT_FALSE(Matches(grammar, "aaaa"));
}

TEST(GrammarTest, RulesThatCallThemselvesFirstTakeNoTimeOverEachByte) {
  const auto grammar = Grammar::FromGbnf("root ::= root root | root \"a\"* | \"a\"*");
  ASSERT_TRUE(grammar.ok());
  GrammarMatcher matcher(*grammar);
  GrammarMatcher::State state = matcher.Begin();
  for (int i = 0; i < 20; ++i) {
    state = matcher.After(state, 'a');
    EXPECT_LE(state.size(), 1u << 14);
  }
  EXPECT_TRUE(matcher.Accepts(state));
}

}  // namespace
}  // namespace latticeworld
