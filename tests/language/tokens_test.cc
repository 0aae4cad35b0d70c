#include "latticeworld/language/tokens.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

std::string Words(std::string_view text) {
  const std::vector<Token> tokens = Tokenize(text);
  return JoinWords(tokens, 0, tokens.size());
}

TEST(TokenizeTest, PartsHyphensAndContractions) {
  EXPECT_EQ(Words("There's a NORTH-east lake; it isn\xE2\x80\x99t deep"),
            "there is a north east lake ; it is not deep");
  EXPECT_EQ(Words("can't won't don't they're"), "can not will not do not they are");
  EXPECT_EQ(Words("the lake's shore, the farmers' fields"), "the lake shore , the farmers fields");
  EXPECT_EQ(Words("\xC3\xA9t\xC3\xA9\xE2\x80\xA6"), "\xC3\xA9t\xC3\xA9 \xE2\x80\xA6");
  EXPECT_EQ(Words("a \xE2\x80\x9C"
                  "deep\xE2\x80\x9D \xE2\x80\x98lake\xE2\x80\x99"),
            "a deep lake");
}

TEST(TokenizeTest, ReadsNumbersFractionsAndOrdinals) {
  EXPECT_EQ(Words("1,000 sheep, 2.5 km"), "1000 sheep , 2.5 km");
  EXPECT_EQ(Words("10% woods, 30 %"), "10 percent woods , 30 percent");
  EXPECT_EQ(Words("1/3 water, 2/3 grass, 1/2, 3/4"),
            "one third water , 2 thirds grass , one half , 3 quarters");
  EXPECT_EQ(Words("\xC2\xBD fields, \xC2\xBE wood, \xE2\x85\x93"),
            "one half fields , three quarters wood , one third");
  EXPECT_EQ(Words("the 3rd lake, the 1st and the 21st"), "the third lake , the first and the 21st");
  EXPECT_EQ(Words("3-4 lakes, ~30% snow"), "3 4 lakes , about 30 percent snow");
  // A date, a ratio above one and parts that have no common name are no fractions.
  EXPECT_EQ(Words("1/3/2020 5/2 1/20 1/100"), "1 3 2020 5 2 1 20 1 100");
}

TEST(TokenizeTest, ReadsSignsForWords) {
  EXPECT_EQ(Words("woods & fields w/ a lake w/o houses and/or roads"),
            "woods and fields with a lake without houses and or roads");
  EXPECT_EQ(Words("river N -> S, road W \xE2\x86\x92 E"), "river n to s , road w to e");
  EXPECT_EQ(Words("river N-S; axis W/E"), "river n s ; axis w e");
  EXPECT_EQ(Words("N.W. corner, the N. edge. E.g. a lake."),
            "nw corner , the n edge . eg a lake .");
  EXPECT_EQ(Words("road runs N. Then a lake"), "road runs n . then a lake");
  EXPECT_EQ(Words("approx. 30 houses"), "approx 30 houses");
  EXPECT_EQ(Words("a wood - dark--and a lake"), "a wood - dark - and a lake");
}

std::string Kinds(std::string_view text) {
  std::string kinds;
  for (const Token& token : Tokenize(text)) kinds += "wn,."[static_cast<int>(token.kind)];
  return kinds;
}

TEST(TokenizeTest, TakesListMarkersForStops) {
  EXPECT_EQ(Kinds("1. a lake\n2. two woods"), ".ww..ww");
  EXPECT_EQ(Kinds("1) a lake 2) a wood 3) fields"), ".ww.ww.w");
  EXPECT_EQ(Kinds("(a) lake\n(b) wood"), ".w..w");
  EXPECT_EQ(Kinds("\xE2\x80\xA2 lake\n- wood\n* field"), ".w.w.w");
  // Counts are left alone.
  EXPECT_EQ(Kinds("There are 2. The wood has 3."), "wwn.wwwn.");
  EXPECT_EQ(Kinds("lakes (3) and ponds (about 4)"), "w,n,ww,wn,");
  EXPECT_EQ(Kinds("3 lakes"), "nw");
}

TEST(TokenizeTest, TokensLieInTheTextInOrder) {
  const std::string text =
      "1) N.W. lakes w/ 1/3 of \xC2\xBD, isn't 30% ~5 -> x--y \xE2\x80\xA2 3rd";
  std::size_t last = 0;
  for (const Token& token : Tokenize(text)) {
    EXPECT_LT(token.begin, token.end) << token.text;
    EXPECT_LE(token.end, text.size()) << token.text;
    EXPECT_GE(token.begin, last) << token.text;
    last = token.begin;
  }
}

TEST(SingularTest, KnowsRegularAndIrregularPlurals) {
  EXPECT_EQ(Singular("ponds"), "pond");
  EXPECT_EQ(Singular("bushes"), "bush");
  EXPECT_EQ(Singular("cities"), "city");
  EXPECT_EQ(Singular("leaves"), "leaf");
  EXPECT_EQ(Singular("wolves"), "wolf");
  EXPECT_EQ(Singular("feet"), "foot");
  EXPECT_EQ(Singular("oxen"), "ox");
  EXPECT_EQ(Singular("fishermen"), "fisherman");
  EXPECT_EQ(Singular("volcanoes"), "volcano");
  EXPECT_EQ(Singular("oases"), "oasis");
  EXPECT_EQ(Singular("oasis"), "oasis");
  EXPECT_EQ(Singular("grass"), "grass");
  EXPECT_EQ(Singular("this"), "this");
  EXPECT_EQ(Singular("houses"), "house");
}

}  // namespace
}  // namespace latticeworld
