#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/spelling.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

// Words that begin or continue what one of the matchers reads, and some that end it.
const std::vector<std::string>& Words() {
  static const std::vector<std::string> words = {
      "north",  "south",    "east",    "west",     "northern", "left",       "right",   "upper",
      "NW",     "n",        "center",  "middle",   "half",     "third",      "quarter", "two",
      "three",  "a",        "the",     "of",       "and",      "between",    "corner",  "corners",
      "edge",   "edges",    "both",    "all",      "four",     "sides",      "just",    "a bit",
      "map",    "whole",    "row",     "rows",     "30",       "%",          "to",      "or",
      "more",   "at least", "about",   "in",       "five",     "strip",      "band",    "along",
      "across", "down",     "far",     "very",     "most",     "few",        "lake",    "lakes",
      "forest", "houses",   "rows of", "large",    "tiny",     ",",          ".",       "1/3",
      "1.",     "w/",       "halfway", "opposite", "diagonal", "background", "by",      "hand"};
  return words;
}

std::string RandomText(RandomStream* random, int length) {
  std::string text;
  for (int i = 0; i < length; ++i) {
    const auto at = random->UniformInt(0, static_cast<int>(Words().size()) - 1);
    text += (i > 0 ? " " : "") + Words()[static_cast<std::size_t>(at)];
  }
  return text;
}

void ExpectLegal(const Place& place, const std::string& text) {
  for (const UnitBox& box : place.zone.boxes) {
    EXPECT_GE(box.u_min, -1e-9) << text;
    EXPECT_LE(box.u_max, 1.0 + 1e-9) << text;
    EXPECT_GE(box.v_min, -1e-9) << text;
    EXPECT_LE(box.v_max, 1.0 + 1e-9) << text;
    EXPECT_LT(box.u_min, box.u_max) << text;
    EXPECT_LT(box.v_min, box.v_max) << text;
    EXPECT_GE(box.u_min, place.box.u_min - 1e-9) << text;
    EXPECT_LE(box.v_max, place.box.v_max + 1e-9) << text;
  }
  EXPECT_EQ(place.zone.is_anywhere(), place.main == Region::kAnywhere) << text;
  EXPECT_EQ(place.zone.is_anywhere(), place.regions.empty()) << text;
  const std::optional<Zone> named = FindZone(place.zone.name);
  EXPECT_TRUE(!named.has_value() || *named == place.zone) << text;
}

TEST(MatchersTest, StayInTheTextAndGiveLegalValues) {
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    RandomStream random(seed, "matchers test");
    const std::string text = RandomText(&random, 8);
    const std::vector<Token> tokens = Tokenize(text);
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      const std::size_t left = tokens.size() - at;
      for (const std::string_view preposition : {"in", "along", "across", "down"}) {
        const PlaceMatch place = MatchPlaceAfter(preposition, tokens, at);
        ASSERT_LE(place.tokens, left) << text;
        EXPECT_EQ(place.tokens == 0, place.places.empty()) << text;
        for (const Place& one : place.places) ExpectLegal(one, text);
      }
      const ShareMatch share = MatchShare(tokens, at);
      ASSERT_LE(share.tokens, left) << text;
      EXPECT_LE(share.least, share.value + 1e-9) << text;
      EXPECT_GE(share.most, share.value - 1e-9) << text;
      EXPECT_LE(share.most, 1.0) << text;
      const CountMatch count = MatchCount(tokens, at);
      ASSERT_LE(count.tokens, left) << text;
      EXPECT_LE(count.least, count.most) << text;
      ASSERT_LE(MatchSize(tokens, at).tokens, left) << text;
      ASSERT_LE(MatchHeading(tokens, at).tokens, left) << text;
      ASSERT_LE(MatchAxis(tokens, at).tokens, left) << text;
      ASSERT_LE(MatchNumber(tokens, at).tokens, left) << text;
      ASSERT_LE(MatchClassWord(tokens, at).tokens, left) << text;
    }
  }
}

TEST(MatchersTest, TakeAnyText) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream random(seed, "any text");
    std::string text;
    for (int i = 0; i < 200; ++i) {
      // ASCII without NUL, and now and then a letter of two, a sign of three or of four bytes.
      const int kind = random.UniformInt(0, 20);
      if (kind < 18) {
        text += static_cast<char>(random.UniformInt(1, 127));
      } else {
        text += kind == 18 ? "\xC3\xA9" : kind == 19 ? "\xE2\x86\x92" : "\xF0\x9F\x8C\xB2";
      }
    }
    const std::vector<Token> tokens = Tokenize(text);
    std::size_t last = 0;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      EXPECT_GE(tokens[at].begin, last);
      EXPECT_LE(tokens[at].end, text.size());
      EXPECT_FALSE(tokens[at].text.empty());
      last = tokens[at].begin;
      EXPECT_LE(MatchPlace(tokens, at).tokens, tokens.size() - at);
      EXPECT_LE(MatchShare(tokens, at).tokens, tokens.size() - at);
      EXPECT_LE(MatchCount(tokens, at).tokens, tokens.size() - at);
    }
  }
}

// A place within a place within a place ... is given up, however deep it goes.
TEST(MatchersTest, NestedPlacesEndBeforeTheStackDoes) {
  for (const char* nested : {"between ", "halfway between ", "the north of the middle of ",
                             "a strip along ", "just north of "}) {
    std::string text;
    for (int i = 0; i < 200000; ++i) text += nested;
    const std::vector<Token> tokens = Tokenize(text);
    EXPECT_LT(MatchPlace(tokens, 0).tokens, 100u) << nested;
  }
}

}  // namespace
}  // namespace latticeworld
