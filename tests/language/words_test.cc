#include <gtest/gtest.h>

#include <set>
#include <string>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/numbers.h"
#include "latticeworld/language/grounded/places.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

std::string Words(std::string_view text) {
  const std::vector<Token> tokens = Tokenize(text);
  return JoinWords(tokens, 0, tokens.size());
}

TEST(TokenizeTest, PartsHyphensAndContractions) {
  EXPECT_EQ(Words("There's a NORTH-east lake; it isn\xE2\x80\x99t deep"),
            "there is a north east lake ; it is not deep");
  EXPECT_EQ(Words("1,000 sheep, 2.5 km"), "1000 sheep , 2.5 km");
  EXPECT_EQ(Words("\xC3\xA9t\xC3\xA9\xE2\x80\xA6"), "\xC3\xA9t\xC3\xA9 \xE2\x80\xA6");
}

TEST(ClassWordsTest, AreManyDistinctAndLegal) {
  std::set<std::string_view> phrases;
  for (const ClassWord& word : AllClassWords()) {
    EXPECT_TRUE(phrases.insert(word.phrase).second) << word.phrase;
    for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
      const char letter = word.LetterIn(vocabulary);
      EXPECT_TRUE(letter == '\0' || FindClass(vocabulary, letter) != nullptr) << word.phrase;
    }
    const ClassWordMatch match = MatchClassWord(Tokenize(word.phrase), 0);
    ASSERT_NE(match.word, nullptr) << word.phrase;
    EXPECT_EQ(match.word->phrase, word.phrase);
  }
  EXPECT_GE(phrases.size(), 150u);
}

TEST(ClassWordsTest, KnowPluralsAndTheLongestPhrase) {
  const auto letter = [](std::string_view text, Vocabulary vocabulary) {
    const ClassWordMatch match = MatchClassWord(Tokenize(text), 0);
    return match.word != nullptr ? match.word->LetterIn(vocabulary) : '?';
  };
  EXPECT_EQ(letter("apple orchards", Vocabulary::kSuburb), 'A');
  EXPECT_EQ(letter("row houses", Vocabulary::kSuburb), 'B');
  EXPECT_EQ(letter("gravel roads", Vocabulary::kSuburb), 'R');
  EXPECT_EQ(letter("snow-capped peaks", Vocabulary::kWild), 'S');
  EXPECT_EQ(letter("cities", Vocabulary::kSuburb), 'B');
  EXPECT_EQ(letter("bushes", Vocabulary::kWild), 'B');
  EXPECT_EQ(letter("zorblax", Vocabulary::kWild), '?');
}

TEST(NumbersTest, ReadWordsAndDigits) {
  const auto value = [](std::string_view text) { return MatchNumber(Tokenize(text), 0).value; };
  EXPECT_EQ(value("9 sheep"), 9);
  EXPECT_EQ(value("forty-two"), 42);
  EXPECT_EQ(value("ninety nine"), 99);
  EXPECT_EQ(value("a pair of horses"), 2);
  EXPECT_EQ(value("half a dozen eggs"), 6);
  EXPECT_EQ(value("two dozen"), 24);
  EXPECT_EQ(value("two hundred and five"), 205);
  EXPECT_EQ(value("99999999999999999999"), 1000000);
  EXPECT_EQ(MatchNumber(Tokenize("a lake"), 0).tokens, 0u);
}

TEST(PlacesTest, NameNinthsSidesAndHalves) {
  const auto main = [](std::string_view text) {
    const PlaceMatch match = MatchPlace(Tokenize(text), 0);
    return match.tokens == 0 ? Region::kAnywhere : match.places.front().main;
  };
  EXPECT_EQ(main("upper left"), Region::kUpperLeft);
  EXPECT_EQ(main("north-east corner of the map"), Region::kUpperRight);
  EXPECT_EQ(main("the bottom right"), Region::kLowerRight);
  EXPECT_EQ(main("southern edge"), Region::kLower);
  EXPECT_EQ(main("middle of the left side"), Region::kMiddleLeft);
  EXPECT_EQ(main("centre"), Region::kCenter);
  EXPECT_EQ(main("right next to"), Region::kAnywhere);
  EXPECT_EQ(main("edge of the forest"), Region::kAnywhere);
  EXPECT_EQ(MatchPlace(Tokenize("corners"), 0).places.size(), 4u);
  const Place half = MatchPlace(Tokenize("northern half"), 0).places.front();
  EXPECT_EQ(half.regions.size(), 3u);
  EXPECT_DOUBLE_EQ(half.box.v_max, 0.5);
}

}  // namespace
}  // namespace latticeworld
