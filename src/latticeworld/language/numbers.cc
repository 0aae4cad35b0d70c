#include "latticeworld/language/numbers.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace latticeworld {
namespace {

constexpr int kMaxNumber = 1000000;

constexpr std::array<std::string_view, 20> kBelowTwenty = {
    "zero",     "one",     "two",     "three",     "four",     "five",    "six",
    "seven",    "eight",   "nine",    "ten",       "eleven",   "twelve",  "thirteen",
    "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array<std::string_view, 8> kTens = {"twenty", "thirty",  "forty",  "fifty",
                                                   "sixty",  "seventy", "eighty", "ninety"};

template <std::size_t kSize>
int IndexOf(const std::array<std::string_view, kSize>& words, std::string_view word) {
  for (std::size_t i = 0; i < kSize; ++i) {
    if (words[i] == word) return static_cast<int>(i);
  }
  return -1;
}

bool IsWord(const std::vector<Token>& tokens, std::size_t at, std::string_view word) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord && tokens[at].text == word;
}

int ValueOfDigits(std::string_view digits) {
  int value = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') break;
    value = std::min(kMaxNumber, value * 10 + (c - '0'));
  }
  return value;
}

// "forty", "forty two", "seven".
NumberMatch MatchBelowHundred(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != TokenKind::kWord) return {};
  if (const int value = IndexOf(kBelowTwenty, tokens[at].text); value >= 0) return {value, 1};
  const int tens = IndexOf(kTens, tokens[at].text);
  if (tens < 0) return {};
  const int value = (tens + 2) * 10;
  if (at + 1 < tokens.size()) {
    if (const int ones = IndexOf(kBelowTwenty, tokens[at + 1].text); ones >= 1 && ones <= 9) {
      return {value + ones, 2};
    }
  }
  return {value, 1};
}

// "of" after a number word that counts by groups.
std::size_t SkipOf(const std::vector<Token>& tokens, std::size_t at) {
  return IsWord(tokens, at, "of") ? 1 : 0;
}

}  // namespace

NumberMatch MatchNumber(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size()) return {};
  // "half a dozen", "a pair of"
  const bool article = IsWord(tokens, at, "a") || IsWord(tokens, at, "an");
  const std::size_t after_article = at + (article ? 1 : 0);
  if (IsWord(tokens, at, "half") && IsWord(tokens, at + 1, "a") &&
      IsWord(tokens, at + 2, "dozen")) {
    return {6, 3 + SkipOf(tokens, at + 3)};
  }
  if (IsWord(tokens, after_article, "pair") || IsWord(tokens, after_article, "couple")) {
    return {2, after_article + 1 - at + SkipOf(tokens, after_article + 1)};
  }

  // Digits, an article or words make a number ...
  NumberMatch number;
  if (tokens[at].kind == TokenKind::kNumber) {
    number = {ValueOfDigits(tokens[at].text), 1};
  } else if (article) {
    number = {1, 1};
  } else {
    number = MatchBelowHundred(tokens, at);
    if (number.tokens == 0 && IsWord(tokens, at, "dozen")) return {12, 1 + SkipOf(tokens, at + 1)};
  }
  if (number.tokens == 0) return {};

  // ... which "dozen", "hundred", "thousand" or "million" multiplies.
  const std::size_t next = at + number.tokens;
  for (const std::string_view dozen : {"dozen", "dozens"}) {
    if (IsWord(tokens, next, dozen)) {
      const int value = std::min(kMaxNumber, number.value * 12);
      return {value, number.tokens + 1 + SkipOf(tokens, next + 1)};
    }
  }
  for (const auto& [word, factor] : {std::pair<std::string_view, int>{"hundred", 100},
                                     {"thousand", 1000},
                                     {"million", 1000000}}) {
    if (!IsWord(tokens, next, word)) continue;
    number.value = std::min<long long>(kMaxNumber, 1LL * number.value * factor);
    ++number.tokens;
    const std::size_t rest = next + 1 + (IsWord(tokens, next + 1, "and") ? 1 : 0);
    if (const NumberMatch small = MatchBelowHundred(tokens, rest); small.tokens > 0) {
      number.value = std::min(kMaxNumber, number.value + small.value);
      number.tokens = rest + small.tokens - at;
    }
    return number;
  }
  // A bare article is no count.
  return article ? NumberMatch{} : number;
}

}  // namespace latticeworld
