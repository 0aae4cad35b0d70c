#include "latticeworld/language/class_words.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace latticeworld {
namespace {

// "F-": forest in suburb, nothing in wild. "?": no class at all. Lower case: only the nearest.
std::string Letters(std::string_view text) {
  const std::vector<Token> tokens = Tokenize(text);
  const ClassWordMatch match = MatchClassWord(tokens, 0);
  if (match.word == nullptr) return "?";
  if (match.tokens != tokens.size()) return "part";
  std::string letters;
  for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const char letter = match.word->LetterIn(vocabulary);
    const bool exact = match.word->IsExactIn(vocabulary);
    letters += letter == '\0' ? '-' : exact ? letter : static_cast<char>(letter - 'A' + 'a');
  }
  return letters;
}

TEST(ClassWordsTest, EveryLineOfTheFileIsRead) {
  const Result<std::vector<ClassWord>> words = ReadClassWords(ClassWordFile());
  ASSERT_TRUE(words.ok()) << words.status().ToString();
  EXPECT_GE(words->size(), 700u);
  std::size_t lines = 0;
  for (std::string_view rest = ClassWordFile(); !rest.empty();) {
    const std::size_t end = rest.find('\n');
    ASSERT_NE(end, std::string_view::npos) << "the last line must end";
    if (end > 0 && rest.front() != '#') ++lines;
    rest.remove_prefix(end + 1);
  }
  EXPECT_EQ(words->size(), lines);
}

TEST(ClassWordsTest, EveryPhraseIsFoundWhole) {
  for (const ClassWord& word : AllClassWords()) {
    const std::vector<Token> tokens = Tokenize(word.phrase);
    const ClassWordMatch match = MatchClassWord(tokens, 0);
    ASSERT_NE(match.word, nullptr) << word.phrase;
    EXPECT_EQ(match.word->phrase, word.phrase);
    EXPECT_EQ(match.tokens, tokens.size()) << word.phrase;
    EXPECT_FALSE(match.plural) << word.phrase;
  }
}

TEST(ClassWordsTest, EveryClassOfBothVocabulariesHasManyWords) {
  for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    for (const LayoutClass& layout_class : ClassesOf(vocabulary)) {
      int exact = 0;
      for (const ClassWord& word : AllClassWords()) {
        const bool same = word.LetterIn(vocabulary) == layout_class.letter;
        exact += same && word.IsExactIn(vocabulary) ? 1 : 0;
      }
      EXPECT_GE(exact, 60) << layout_class.name;
    }
  }
}

TEST(ClassWordsTest, KnowTheWordsOfTheField) {
  for (const char* text : {"forest", "spinney", "copse", "pine trees", "rain forest", "canopy"}) {
    EXPECT_EQ(Letters(text), "FF") << text;
  }
  for (const char* text : {"cornfield", "vineyards", "apple orchard", "rice paddies",
                           "ploughed land", "plowed land", "fields of barley", "hop garden"}) {
    EXPECT_EQ(Letters(text), "Ab") << text;
  }
  for (const char* text :
       {"hamlet", "farmstead", "barns", "factories", "terraced houses", "chapel", "skyscrapers",
        "rows of houses", "city centre", "city center", "castle"}) {
    EXPECT_EQ(Letters(text), "B-") << text;
  }
  for (const char* text : {"lane", "motorway", "dirt tracks", "footpath", "cobbled street"}) {
    EXPECT_EQ(Letters(text), "R-") << text;
  }
  EXPECT_EQ(Letters("railway"), "r-");
  for (const char* text : {"tarn", "loch", "becks", "fjord", "reservoir", "mill pond", "ditches",
                           "bodies of water", "rapids", "harbor", "oases"}) {
    EXPECT_EQ(Letters(text), "WW") << text;
  }
  EXPECT_EQ(Letters("marshes"), "ww");
  for (const char* text : {"steppe", "savannah", "moor", "pasture", "hay meadows", "prairies"}) {
    EXPECT_EQ(Letters(text), "GB") << text;
  }
  EXPECT_EQ(Letters("golf course"), "Gb");
  EXPECT_EQ(Letters("low bushes"), "gB");
  EXPECT_EQ(Letters("hedges"), "fb");
  for (const char* text : {"mudflats", "salt flat", "sand dunes", "wasteland", "beaches"}) {
    EXPECT_EQ(Letters(text), "Dr") << text;
  }
  for (const char* text : {"scree", "boulder fields", "quarry", "cliffs", "rocky ridge"}) {
    EXPECT_EQ(Letters(text), "dR") << text;
  }
  for (const char* text : {"glaciers", "snow-capped peaks", "snowy mountains", "icefield"}) {
    EXPECT_EQ(Letters(text), "dS") << text;
  }
  EXPECT_EQ(Letters("zorblax"), "?");
  EXPECT_EQ(Letters("hill"), "?");
}

TEST(ClassWordsTest, TellPluralsFormsAndSizes) {
  const auto match = [](std::string_view text) { return MatchClassWord(Tokenize(text), 0); };
  EXPECT_TRUE(match("ponds").plural);
  EXPECT_TRUE(match("rows of houses").plural);
  EXPECT_FALSE(match("woods").plural);
  EXPECT_FALSE(match("crossroads").plural);
  EXPECT_EQ(match("river").word->shape, WordShape::kLine);
  EXPECT_EQ(match("lake").word->shape, WordShape::kThing);
  EXPECT_EQ(match("forest").word->shape, WordShape::kMass);
  EXPECT_LT(match("tarn").word->cells, match("lake").word->cells);
  EXPECT_LT(match("lake").word->cells, match("ocean").word->cells);
  EXPECT_LT(match("hamlet").word->cells, match("city").word->cells);
}

TEST(ClassWordFileTest, NamesEveryLineThatIsWrong) {
  const std::string_view bad =
      "# a comment\n"
      "lake\tW=\tW=\tpatch\t50\n"
      "lake\tW=\tW=\tpatch\t50\n"
      "Pond\tW=\tW=\tpatch\t9\n"
      "pool\tX=\tW=\tpatch\t9\n"
      "road\tR=\tA=\tline\t0\n"
      "mere\tW\tW=\tpatch\t9\n"
      "tarn\tW=\tW=\tround\t9\n"
      "loch\tW=\tW=\tpatch\tmany\n"
      "bay\tW=\tW=\tpatch\t0\n"
      "beck\tW=\tW=\tline\t3\n"
      "fen\tW=\tW=\n"
      "sea\tW=\tW=\tspread\t9\t9\n"
      "air\t-\t-\tspread\t9";
  const Result<std::vector<ClassWord>> words = ReadClassWords(bad);
  ASSERT_FALSE(words.ok());
  std::string found;
  for (const Violation& violation : words.status().violations()) {
    found += violation.pointer.substr(5) + ":" + violation.code + " ";
  }
  EXPECT_EQ(found,
            "3:repeated_phrase 4:bad_phrase 5:bad_letter 6:bad_letter 7:bad_letter 8:bad_form "
            "9:bad_cells 10:bad_cells 11:bad_cells 12:wrong_field_count "
            "13:wrong_field_count 14:no_class ");
}

}  // namespace
}  // namespace latticeworld
