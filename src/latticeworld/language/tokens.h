#ifndef LATTICEWORLD_LANGUAGE_TOKENS_H_
#define LATTICEWORLD_LANGUAGE_TOKENS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace latticeworld {

enum class TokenKind { kWord, kNumber, kComma, kStop };

// A word of an instruction. Hyphens part words ("north-east" is two), so that phrases match however
// they are written.
struct Token {
  TokenKind kind = TokenKind::kWord;
  std::string text;       // lower case; a number without its thousands separators
  std::size_t begin = 0;  // bytes of the instruction: [begin, end)
  std::size_t end = 0;
};

// Words, numbers, commas (also brackets, colons, dashes and "=": the small pauses) and stops (also
// semicolons, line breaks, bullets and the numbers of a list: "1. ", "2) ", "(b) ") of valid UTF-8;
// linear in its length. Bytes outside ASCII are letters, but for the usual typographic punctuation
// and spaces. Read as the words that they stand for: "isn't" (is not), "%" (percent), "1/3" and the
// signs of fractions (one third), "3rd" (third), "&" (and), "w/" (with), "w/o" (without), "->"
// (to),
// "~5" (about 5), "N.W." (nw); such words share the bytes of the sign.
std::vector<Token> Tokenize(std::string_view text);

// The singular of an English plural ("ponds", "bushes", "cities", "leaves", "oxen"), or the word as
// it is.
std::string Singular(std::string_view word);

// The words of tokens [first, last), single spaces between them.
std::string JoinWords(const std::vector<Token>& tokens, std::size_t first, std::size_t last);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_TOKENS_H_
