#include "latticeworld/language/spelling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/language/class_words.h"

namespace latticeworld {
namespace {

// Corrects to the words that layouts know, and leaves common English alone.
const SpellingDictionary& LayoutSpelling() {
  static const SpellingDictionary dictionary(LayoutWords(), CommonEnglishWords());
  return dictionary;
}

std::string Corrected(const SpellingDictionary& dictionary, std::string_view word) {
  return std::string(dictionary.Correct(word).value_or("-"));
}

TEST(SpellingTest, CorrectsOneEditAndNoMore) {
  const SpellingDictionary dictionary({"forest", "river", "village", "lake", "settlement"});
  EXPECT_EQ(Corrected(dictionary, "forrest"), "forest");        // put in
  EXPECT_EQ(Corrected(dictionary, "vilage"), "village");        // left out
  EXPECT_EQ(Corrected(dictionary, "foresk"), "forest");         // changed
  EXPECT_EQ(Corrected(dictionary, "foerst"), "forest");         // swapped
  EXPECT_EQ(Corrected(dictionary, "ofrest"), "forest");         // swapped at the start
  EXPECT_EQ(Corrected(dictionary, "lkae"), "lake");             // four letters: swapped,
  EXPECT_EQ(Corrected(dictionary, "rivr"), "river");            // or one left out,
  EXPECT_EQ(Corrected(dictionary, "lakk"), "-");                // but not changed
  EXPECT_EQ(Corrected(dictionary, "forast1"), "-");             // two edits
  EXPECT_EQ(Corrected(dictionary, "setlemant"), "settlement");  // two of a long word
  EXPECT_EQ(Corrected(dictionary, "morest"), "-");              // another first letter
  EXPECT_EQ(Corrected(dictionary, "lke"), "-");                 // too short
  EXPECT_EQ(Corrected(dictionary, ""), "-");
  EXPECT_EQ(Corrected(dictionary, std::string(3000, 'f')), "-");
}

TEST(SpellingTest, LeavesKnownWordsAndTheirFormsAlone) {
  const SpellingDictionary dictionary({"forest", "trail", "house"}, {"trial", "floor", "hoist"});
  for (const char* word :
       {"forest", "forests", "forested", "trial", "trials", "hoisting", "hoisted", "floors"}) {
    EXPECT_EQ(Corrected(dictionary, word), "-") << word;
  }
}

TEST(SpellingTest, DoesNotGuessBetweenEqualWords) {
  const SpellingDictionary dictionary({"band", "bands", "bank", "lane", "land"});
  EXPECT_EQ(Corrected(dictionary, "banxs"), "bands");  // no other is as near
  EXPECT_EQ(Corrected(dictionary, "lanex"), "lane");
  const SpellingDictionary tie({"mooring", "roaring", "snoring", "storing", "stoning"});
  EXPECT_EQ(Corrected(tie, "stoxing"), "-");
  // A word and its plural mean the same.
  const SpellingDictionary plural({"forest", "forests"});
  EXPECT_EQ(Corrected(plural, "foresst"), "forest");
}

TEST(LayoutSpellingTest, ReadsWhatPeopleMistype) {
  for (const auto& [written, meant] : std::vector<std::pair<const char*, const char*>>{
           {"foerst", "forest"},      {"rivver", "river"},
           {"villge", "village"},     {"hosues", "houses"},
           {"feilds", "fields"},      {"moutain", "mountain"},
           {"woodlnad", "woodland"},  {"raod", "road"},
           {"resevoir", "reservoir"}, {"vinyard", "vineyard"},
           {"motorwya", "motorway"},  {"nothern", "northern"},
           {"sothwest", "southwest"}, {"cornr", "corner"},
           {"midle", "middle"},       {"quater", "quarter"},
           {"thrid", "third"},        {"surounded", "surrounded"},
           {"betwen", "between"},     {"diagnoal", "diagonal"},
           {"swmaps", "swamps"},      {"agricultral", "agricultural"},
           {"runing", "running"},     {"westren", "western"}}) {
    EXPECT_EQ(Corrected(LayoutSpelling(), written), meant);
  }
}

TEST(LayoutSpellingTest, LeavesEnglishAlone) {
  for (const char* word :
       {"there",  "where",   "floor",   "those",   "house",  "horse",     "trial",
        "quiet",  "thorn",   "castle",  "cattle",  "manner", "popular",   "march",
        "words",  "mouth",   "travel",  "screen",  "grave",  "robot",     "rovers",
        "patrol", "drones",  "copies",  "strange", "helmet", "later",     "rods",
        "cars",   "running", "stopped", "nicely",  "bigger", "happiness", "zorblax"}) {
    EXPECT_EQ(Corrected(LayoutSpelling(), word), "-") << word;
  }
  for (const std::string_view word : CommonEnglishWords()) {
    EXPECT_FALSE(LayoutSpelling().Correct(word).has_value()) << word;
  }
  for (const std::string_view word : LayoutWords()) {
    EXPECT_FALSE(LayoutSpelling().Correct(word).has_value()) << word;
  }
}

// Whatever one swap makes of a long word, it is read as that word or not at all.
TEST(LayoutSpellingTest, ASwapNeverLeadsToAnotherWord) {
  RandomStream random(7, "spelling test");
  int read = 0;
  int tried = 0;
  for (const ClassWord& word : AllClassWords()) {
    if (word.phrase.find(' ') != std::string_view::npos || word.phrase.size() < 6) continue;
    std::string written(word.phrase);
    const auto at =
        static_cast<std::size_t>(random.UniformInt(1, static_cast<int>(written.size()) - 2));
    if (written[at] == written[at + 1]) continue;
    std::swap(written[at], written[at + 1]);
    if (LayoutSpelling().Knows(written)) continue;
    ++tried;
    const auto meant = LayoutSpelling().Correct(written);
    if (!meant.has_value()) continue;
    EXPECT_EQ(Singular(*meant), Singular(word.phrase)) << written;
    ++read;
  }
  EXPECT_GT(read, tried * 9 / 10);
}

}  // namespace
}  // namespace latticeworld
