#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/share_words.h"

namespace latticeworld {
namespace {

bool IsPause(const Token& token) {
  return token.kind == TokenKind::kComma || token.kind == TokenKind::kStop;
}

bool IsWord(const std::vector<Token>& tokens, std::size_t at, std::string_view word) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord && tokens[at].text == word;
}

bool IsNumber(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kNumber;
}

// "half" 2, "third" 3, ... ; 0: no such word.
int DenominatorOf(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::array<std::array<std::string_view, 2>, 11> kWords = {
      {{"half", "halves"},
       {"third", "thirds"},
       {"quarter", "quarters"},
       {"fifth", "fifths"},
       {"sixth", "sixths"},
       {"seventh", "sevenths"},
       {"eighth", "eighths"},
       {"ninth", "ninths"},
       {"tenth", "tenths"},
       {"eleventh", "elevenths"},
       {"twelfth", "twelfths"}}};
  if (at >= tokens.size() || tokens[at].kind != TokenKind::kWord) return 0;
  const std::string& word = tokens[at].text;
  if (word == "fourth" || word == "fourths") return 4;
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    if (word == kWords[i][0] || word == kWords[i][1]) return static_cast<int>(i) + 2;
  }
  return 0;
}

std::size_t PercentTokens(const std::vector<Token>& tokens, std::size_t at) {
  if (IsWord(tokens, at, "percent") || IsWord(tokens, at, "pct") || IsWord(tokens, at, "pc")) {
    return 1;
  }
  return IsWord(tokens, at, "per") && IsWord(tokens, at + 1, "cent") ? 2 : 0;
}

struct Fraction {
  double low = 0.0;
  double high = 0.0;  // of a range; else low
  bool ordinal = false;
  std::string name;
  std::size_t tokens = 0;
};

double ValueOf(const Token& token) { return std::strtod(token.text.c_str(), nullptr); }

struct Quantity {
  double value = 0.0;
  std::size_t tokens = 0;
};

// A number, in digits (with decimals) or words.
Quantity MatchQuantity(const std::vector<Token>& tokens, std::size_t at) {
  if (IsNumber(tokens, at)) return {ValueOf(tokens[at]), 1};
  if (IsWord(tokens, at, "a") || IsWord(tokens, at, "an")) return {};
  const NumberMatch number = MatchNumber(tokens, at);
  return {static_cast<double>(number.value), number.tokens};
}

// "30 %", "thirty percent", "20 to 30 %".
Fraction MatchPercent(const std::vector<Token>& tokens, std::size_t at) {
  const bool between = IsWord(tokens, at, "between") || IsWord(tokens, at, "from");
  const std::size_t begin = at + (between ? 1 : 0);
  const Quantity first = MatchQuantity(tokens, begin);
  if (first.tokens == 0) return {};
  std::size_t end = begin + first.tokens;
  double second = first.value;
  std::size_t percent = PercentTokens(tokens, end);
  const std::size_t first_percent = percent;
  std::size_t next = end + percent;
  if (IsWord(tokens, next, "to") || IsWord(tokens, next, "or") || IsWord(tokens, next, "and")) {
    ++next;
  }
  const Quantity other = MatchQuantity(tokens, next);
  const std::size_t other_percent =
      other.tokens > 0 ? PercentTokens(tokens, next + other.tokens) : 0;
  // "30 % forest and 40 % fields" is no range, and neither is "30 % and 40 %".
  const bool is_range = other_percent > 0 && other.value > first.value &&
                        (between || !IsWord(tokens, end + first_percent, "and"));
  if (between && !is_range) return {};
  if (is_range) {
    second = other.value;
    end = next + other.tokens;
    percent = other_percent;
  }
  if (percent == 0 || second > 100.0) return {};
  Fraction fraction;
  fraction.low = first.value / 100.0;
  fraction.high = second / 100.0;
  fraction.name =
      FormatDouble(first.value) + (is_range ? " to " + FormatDouble(second) : std::string()) + " %";
  fraction.tokens = end + percent - at;
  return fraction;
}

// "half", "a third", "two thirds", "nine tenths", "one in five", "2 out of 3".
Fraction MatchParts(const std::vector<Token>& tokens, std::size_t at) {
  Fraction fraction;
  const bool article = IsWord(tokens, at, "a") || IsWord(tokens, at, "an") ||
                       IsWord(tokens, at, "the") || IsWord(tokens, at, "one");
  const std::size_t word = at + (article ? 1 : 0);
  if (const int parts = DenominatorOf(tokens, word); parts > 0) {
    // "half a dozen" counts; "the second half" and "half hidden" are no amounts.
    if (IsWord(tokens, word + 1, "a") && IsWord(tokens, word + 2, "dozen")) return {};
    if (parts == 2 && IsWord(tokens, word, "halves")) return {};
    fraction.low = 1.0 / parts;
    fraction.ordinal = parts != 2 && parts != 4 && !IsWord(tokens, at, "one");
    fraction.name = tokens[word].text;
    fraction.tokens = word + 1 - at;
  } else if (const Quantity count = MatchQuantity(tokens, at); count.tokens > 0) {
    const std::size_t after = at + count.tokens;
    const int of_parts = DenominatorOf(tokens, after);
    std::size_t total_at = after;
    if (IsWord(tokens, after, "in")) {
      total_at = after + 1;
    } else if (IsWord(tokens, after, "out") && IsWord(tokens, after + 1, "of")) {
      total_at = after + 2;
    }
    if (of_parts > 1 && count.value >= 2 && count.value < of_parts) {
      fraction.low = count.value / of_parts;
      fraction.name = JoinWords(tokens, at, after + 1);
      fraction.tokens = count.tokens + 1;
    } else if (total_at > after) {
      if (IsWord(tokens, total_at, "every")) ++total_at;
      const Quantity total = MatchQuantity(tokens, total_at);
      if (total.tokens == 0 || total.value <= count.value || count.value <= 0.0) return {};
      fraction.low = count.value / total.value;
      fraction.name = JoinWords(tokens, at, total_at + total.tokens);
      fraction.tokens = total_at + total.tokens - at;
    } else {
      return {};
    }
  } else {
    return {};
  }
  fraction.high = fraction.low;
  return fraction;
}

// How far a reader lets a layout stray from a fraction that is said.
double ToleranceOf(double share) {
  if (share >= 0.4) return 0.08;
  return std::max(0.05, 0.08 - std::max(0.0, 0.15 - share) * 0.3);
}

ShareMatch ShareOf(const Fraction& fraction, const ShareBend* bend) {
  ShareMatch share;
  share.value = (fraction.low + fraction.high) / 2;
  share.fraction = true;
  share.ordinal = fraction.ordinal && bend == nullptr;
  share.name = fraction.name;
  // A range says itself how far it goes.
  const bool is_range = fraction.high > fraction.low;
  double below = is_range ? 0.04 : ToleranceOf(fraction.low);
  double above = is_range ? 0.04 : ToleranceOf(fraction.high);
  if (bend != nullptr) {
    switch (*bend) {
      case ShareBend::kAbout:
        break;
      case ShareBend::kAtLeast:
        below = 0.0;
        above = 1.0;
        break;
      case ShareBend::kAtMost:
      case ShareBend::kLess:
        below = 1.0;
        above = 0.0;
        break;
      case ShareBend::kNearly:
        above = 0.02;
        break;
      case ShareBend::kMore:
        below = 0.0;
        above = 0.3;
        break;
      case ShareBend::kExactly:
        below = std::min(below, 0.06);
        above = std::min(above, 0.06);
        break;
    }
  }
  share.least = std::clamp(fraction.low - below, kLeastShareThere, 1.0);
  share.most = std::clamp(fraction.high + above, share.least, 1.0);
  return share;
}

// "the third lake" counts lakes.
bool CountedThingFollows(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != TokenKind::kWord) return false;
  const ClassWordMatch noun = MatchClassWord(tokens, at);
  return noun.word != nullptr && noun.word->shape != WordShape::kMass && !noun.plural &&
         noun.word->phrase != "water";
}

// Whether what follows spreads over the land ("a lot of forest", "a little water") and is not
// counted
// ("a lot of houses", "a little lake").
bool MassFollows(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::size_t kReach = 3;
  for (std::size_t i = at; i < std::min(tokens.size(), at + kReach); ++i) {
    if (tokens[i].kind != TokenKind::kWord) return false;
    const ClassWordMatch noun = MatchClassWord(tokens, i);
    if (noun.word != nullptr) {
      return noun.word->shape == WordShape::kMass || noun.word->phrase == "water";
    }
  }
  return false;
}

}  // namespace

ShareMatch MatchShare(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size() || IsPause(tokens[at])) return {};
  const auto bend = BendWords().At(tokens, at, false);
  std::size_t begin = at + bend.tokens;
  if (bend.value != nullptr && begin >= tokens.size()) return {};
  Fraction fraction = MatchPercent(tokens, begin);
  if (fraction.tokens == 0) fraction = MatchParts(tokens, begin);
  const auto amount = AmountWords().At(tokens, at, false);
  if (amount.value != nullptr && amount.tokens >= bend.tokens + fraction.tokens &&
      (!amount.value->of_mass || MassFollows(tokens, at + amount.tokens))) {
    ShareMatch share;
    share.value = amount.value->value;
    share.least = amount.value->least;
    share.most = amount.value->most;
    share.mostly = amount.value->mostly;
    share.tokens = amount.tokens;
    share.of = IsWord(tokens, at + amount.tokens - 1, "of");
    return share;
  }
  if (fraction.tokens == 0) return {};
  const std::size_t end = begin + fraction.tokens;
  PhraseTable<ShareBend>::Match after;
  if (bend.value == nullptr && end < tokens.size()) after = BendWordsAfter().At(tokens, end, false);
  ShareMatch share = ShareOf(fraction, after.value != nullptr ? after.value : bend.value);
  share.tokens = bend.tokens + fraction.tokens + after.tokens;
  if (share.ordinal && CountedThingFollows(tokens, at + share.tokens)) return {};
  if (IsWord(tokens, at + share.tokens, "of")) {
    share.of = true;
    share.ordinal = false;
    ++share.tokens;
  }
  return share;
}

}  // namespace latticeworld
