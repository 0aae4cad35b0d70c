#include "latticeworld/language/extents.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

struct Bounds {
  double least;
  double most;
  std::size_t tokens;
};
Bounds Share(std::string_view text) {
  const ShareMatch match = MatchShare(Tokenize(text), 0);
  return {match.least, match.most, match.tokens};
}

void ExpectShare(std::string_view text, double least, double most, std::size_t tokens) {
  const Bounds share = Share(text);
  EXPECT_NEAR(share.least, least, 0.006) << text;
  EXPECT_NEAR(share.most, most, 0.006) << text;
  EXPECT_EQ(share.tokens, tokens) << text;
}

TEST(ShareTest, Fractions) {
  ExpectShare("half of the map", 0.42, 0.58, 2);
  ExpectShare("a quarter of", 0.17, 0.33, 3);
  ExpectShare("a third of the map", 0.25, 0.41, 3);
  ExpectShare("two thirds", 0.587, 0.747, 2);
  ExpectShare("three-quarters of it", 0.67, 0.83, 3);
  ExpectShare("30 %", 0.22, 0.38, 2);
  ExpectShare("thirty per cent of", 0.22, 0.38, 4);
  ExpectShare("one in five cells", 0.12, 0.28, 3);
  ExpectShare("2 out of 3", 0.587, 0.747, 4);
  ExpectShare("\xC2\xBD of", 0.42, 0.58, 3);
  ExpectShare("1/3", 0.25, 0.41, 2);
  ExpectShare("a tenth of", 0.035, 0.165, 3);
}

TEST(ShareTest, BendsAndRanges) {
  ExpectShare("at least a third of", 0.333, 1.0, 5);
  ExpectShare("up to 20 %", 0.002, 0.2, 4);
  ExpectShare("about a quarter", 0.17, 0.33, 3);
  ExpectShare("almost half", 0.42, 0.52, 2);
  ExpectShare("20 to 30 percent", 0.16, 0.34, 4);
  ExpectShare("20-30%", 0.16, 0.34, 3);
  ExpectShare("between 20 and 30 percent", 0.16, 0.34, 5);
  ExpectShare("30 % and 40 %", 0.22, 0.38, 2);
}

TEST(ShareTest, Amounts) {
  ExpectShare("nearly all of", 0.75, 1.0, 3);
  ExpectShare("a bit of forest", 0.002, 0.25, 3);
  ExpectShare("hardly any", 0.0, 0.08, 2);
  ExpectShare("a sliver of", 0.002, 0.12, 3);
  ExpectShare("more than half of", 0.5, 1.0, 4);
  EXPECT_TRUE(MatchShare(Tokenize("most of"), 0).mostly);
  EXPECT_TRUE(MatchShare(Tokenize("the bulk of"), 0).mostly);
  EXPECT_FALSE(MatchShare(Tokenize("half of"), 0).mostly);
  EXPECT_GT(Share("a lot of forest").tokens, 0u);
  EXPECT_GT(Share("a little water").tokens, 0u);
}

TEST(ShareTest, WhatIsNoShare) {
  for (const char* text : {"half a dozen ponds", "three lakes", "a lot of houses", "a little lake",
                           "the third lake", "120 %", "forest", "lots of villages"}) {
    EXPECT_EQ(Share(text).tokens, 0u) << text;
  }
  EXPECT_TRUE(MatchShare(Tokenize("a third"), 0).ordinal);
  EXPECT_FALSE(MatchShare(Tokenize("a third of"), 0).ordinal);
}

TEST(CountTest, Words) {
  const auto count = [](std::string_view text) {
    const CountMatch match = MatchCount(Tokenize(text), 0);
    if (match.tokens == 0) return std::string("none");
    return std::to_string(match.least) + ".." +
           (match.most == CountMatch::kUnbounded ? "" : std::to_string(match.most)) + " in " +
           std::to_string(match.tokens);
  };
  EXPECT_EQ(count("7 lakes"), "7..7 in 1");
  EXPECT_EQ(count("forty-two"), "42..42 in 2");
  EXPECT_EQ(count("two hundred and five"), "205..205 in 4");
  EXPECT_EQ(count("a dozen"), "12..12 in 2");
  EXPECT_EQ(count("half a dozen ponds"), "6..6 in 3");
  EXPECT_EQ(count("a couple of"), "2..2 in 3");
  EXPECT_EQ(count("twin lakes"), "2..2 in 1");
  EXPECT_EQ(count("a few"), "2..5 in 2");
  EXPECT_EQ(count("several"), "3.. in 1");
  EXPECT_EQ(count("many"), "4.. in 1");
  EXPECT_EQ(count("countless"), "6.. in 1");
  EXPECT_EQ(count("a single"), "1..1 in 2");
  EXPECT_EQ(count("only one"), "1..1 in 2");
  EXPECT_EQ(count("two or three"), "2..3 in 3");
  EXPECT_EQ(count("3-4 lakes"), "3..4 in 2");
  EXPECT_EQ(count("three to five"), "3..5 in 3");
  EXPECT_EQ(count("between two and four"), "2..4 in 4");
  EXPECT_EQ(count("at least five"), "5.. in 3");
  EXPECT_EQ(count("up to four"), "1..4 in 3");
  EXPECT_EQ(count("more than two"), "3.. in 3");
  EXPECT_EQ(count("more than three"), "4.. in 3");
  EXPECT_EQ(count("fewer than four"), "1..3 in 3");
  EXPECT_EQ(count("three or more"), "3.. in 3");
  EXPECT_EQ(count("about ten"), "8..12 in 2");
  EXPECT_EQ(count("3x"), "3..3 in 2");
  EXPECT_EQ(count("a lake"), "none");
  EXPECT_EQ(count("30 %"), "none");
  EXPECT_EQ(count("two thirds"), "none");
  EXPECT_EQ(count("one in five"), "none");
}

TEST(SizeTest, Words) {
  const auto size = [](std::string_view text) { return MatchSize(Tokenize(text), 0); };
  EXPECT_GT(size("vast").factor, size("large").factor);
  EXPECT_GT(size("very large").factor, size("large").factor);
  EXPECT_LT(size("tiny").factor, size("small").factor);
  EXPECT_LT(size("very small").factor, size("small").factor);
  EXPECT_DOUBLE_EQ(size("medium-sized").factor, 1.0);
  EXPECT_DOUBLE_EQ(size("large").least_share, 0.08);
  EXPECT_DOUBLE_EQ(size("small").least_share, 0.0);
  EXPECT_GT(size("wide").width, 1.0);
  EXPECT_LT(size("narrow").width, 1.0);
  EXPECT_EQ(size("very small lake").tokens, 2u);
  EXPECT_EQ(size("lake").tokens, 0u);
  EXPECT_EQ(size("very").tokens, 0u);
}

}  // namespace
}  // namespace latticeworld
