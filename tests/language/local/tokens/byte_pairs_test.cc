#include "latticeworld/language/local/tokens/byte_pairs.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

std::vector<std::string> Words(const std::string& text, bool single_digits = true) {
  std::vector<std::string> words;
  for (const std::string_view word : ByteLevelWords(text, single_digits)) words.emplace_back(word);
  return words;
}

// A vocabulary of all bytes, in GPT-2's alphabet, and of what merges make.
struct Vocabulary {
  std::vector<std::string> pieces;
  std::vector<std::string> merges;
};
Vocabulary MakeVocabulary() {
  Vocabulary made;
  const auto add = [&made](unsigned code) {
    std::string piece;
    if (code < 0x80) {
      piece += static_cast<char>(code);
    } else {
      piece += static_cast<char>(0xC0 | code >> 6);
      piece += static_cast<char>(0x80 | (code & 0x3F));
    }
    made.pieces.push_back(piece);
  };
  unsigned next = 256;
  for (unsigned byte = 0; byte < 256; ++byte) {
    const bool printable =
        (byte >= 0x21 && byte <= 0x7E) || (byte >= 0xA1 && byte <= 0xAC) || byte >= 0xAE;
    add(printable ? byte : next++);
  }
  const std::string blank = "\xC4\xA0";
  for (const auto& [left, right] : std::vector<std::pair<std::string, std::string>>{
           {"l", "a"}, {"k", "e"}, {"la", "ke"}, {blank, "lake"}, {blank, "a"}, {"a", "k"}}) {
    made.merges.push_back(left + " " + right);
    made.pieces.push_back(left + right);
  }
  return made;
}

TEST(ByteLevelWordsTest, AWordTakesTheBlankBeforeIt) {
  EXPECT_EQ(Words("A lake, isn't it?"),
            (std::vector<std::string>{"A", " lake", ",", " isn", "'t", " it", "?"}));
  EXPECT_EQ(Words("a  b\n\nc "), (std::vector<std::string>{"a", " ", " b", "\n", "\n", "c", " "}));
}

TEST(ByteLevelWordsTest, DigitsStandAloneWhereTheyDoSo) {
  EXPECT_EQ(Words("in 120 m"), (std::vector<std::string>{"in", " ", "1", "2", "0", " m"}));
  EXPECT_EQ(Words("in 120 m", false), (std::vector<std::string>{"in", " 120", " m"}));
}

TEST(ByteLevelWordsTest, LettersAndSignsBeyondAscii) {
  EXPECT_EQ(Words("See\xE2\x80\x94 \xC3\xBC"
                  "ber"),
            (std::vector<std::string>{"See", "\xE2\x80\x94",
                                      " \xC3\xBC"
                                      "ber"}));
}

TEST(BytePairsTest, MergesTheLowestRankFirst) {
  const Vocabulary made = MakeVocabulary();
  const auto pairs = BytePairs::Make(made.pieces, made.merges, true);
  ASSERT_TRUE(pairs.ok()) << pairs.status().ToString();
  const auto pieces = [&](const std::string& text) {
    std::vector<std::string> spelled;
    for (const TokenId token : pairs->Encode(text))
      spelled.push_back(BytesOfPiece(made.pieces[token]));
    return spelled;
  };
  EXPECT_EQ(pieces("a lake"), (std::vector<std::string>{"a", " lake"}));
  // "a k" is of a higher rank than "l a" and "k e".
  EXPECT_EQ(pieces("lakx"), (std::vector<std::string>{"la", "k", "x"}));
  EXPECT_EQ(pieces("xake"), (std::vector<std::string>{"x", "a", "ke"}));
}

TEST(BytePairsTest, GivesBackEveryText) {
  const Vocabulary made = MakeVocabulary();
  const auto pairs = BytePairs::Make(made.pieces, made.merges, true);
  ASSERT_TRUE(pairs.ok());
  RandomStream random(3, "texts");
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (int k = random.UniformInt(0, 700); k > 0; --k) {
      text += random.Chance(0.7) ? "a lake 12"[random.UniformInt(0, 8)]
                                 : static_cast<char>(random.UniformInt(0, 255));
    }
    std::string back;
    for (const TokenId token : pairs->Encode(text)) back += BytesOfPiece(made.pieces[token]);
    EXPECT_EQ(back, text);
  }
}

TEST(BytePairsTest, RefusesWhatCannotBe) {
  Vocabulary made = MakeVocabulary();
  made.merges.push_back("la zorblax");
  EXPECT_EQ(BytePairs::Make(made.pieces, made.merges, true).status().code(), StatusCode::kDataLoss);
  made = MakeVocabulary();
  made.pieces[65] = "lalala";
  const Status status = BytePairs::Make(made.pieces, {}, true).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_NE(status.message().find("65"), std::string::npos) << status.message();
}

}  // namespace
}  // namespace latticeworld
