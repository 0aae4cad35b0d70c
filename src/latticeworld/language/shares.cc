#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/phrase_table.h"

namespace latticeworld {
namespace {

// The least share of a thing that is there at all.
constexpr double kSome = 0.002;

struct Amount {
  double value;
  double least;
  double most;
  bool mostly = false;
  bool of_mass = false;  // of what is counted it says how many: "lots of houses"
};

const PhraseTable<Amount>& Amounts() {
  static const PhraseTable<Amount> table{
      {{1.0, 0.9, 1.0}, {"all of", "the whole of", "the entirety of"}},
      {{0.85, 0.75, 1.0, true},
       {"almost all",          "nearly all",         "virtually all",        "practically all",
        "almost all of",       "nearly all of",      "virtually all of",     "practically all of",
        "just about all of",   "just about all",     "the vast majority of", "almost everything",
        "nearly everything",   "almost the whole",   "nearly the whole",     "almost the entire",
        "nearly the entire",   "a vast majority of", "well nigh all of",     "close to all of",
        "almost the whole of", "nearly the whole of"}},
      {{0.65, 0.45, 1.0, true},
       {"most of",
        "the majority of",
        "the bulk of",
        "a majority of",
        "the better part of",
        "the greater part of",
        "the greatest part of",
        "the lions share of",
        "the lion share of",
        "the larger part of",
        "the largest part of",
        "the main part of",
        "the biggest part of",
        "the major part of",
        "the best part of",
        "the most part of",
        "the larger share of",
        "the better half of",
        "the larger half of",
        "the largest share of",
        "the major portion of",
        "the bigger part of",
        "the greater portion of",
        "the largest portion of"}},
      {{0.65, 0.5, 1.0, true},
       {"more than half of", "more than half", "over half of", "over half"}},
      {{0.35, 0.2, 1.0},
       {"much of",
        "a large part of",
        "a good part of",
        "a great deal of",
        "a large portion of",
        "a big part of",
        "a big chunk of",
        "a large chunk of",
        "a good deal of",
        "a considerable part of",
        "a large share of",
        "a good chunk of",
        "a large area of",
        "a large swathe of",
        "a large proportion of",
        "a good portion of",
        "large parts of",
        "big parts of",
        "wide parts of",
        "a great part of",
        "large portions of",
        "a huge part of",
        "a huge chunk of",
        "a substantial part of",
        "a sizeable part of",
        "large swathes of",
        "a sizable part of",
        "a significant part of",
        "a big portion of",
        "a vast area of"}},
      {{0.25, 0.12, 1.0, false, true},
       {"lots of", "a lot of", "plenty of", "loads of", "tons of", "heaps of", "masses of",
        "an abundance of", "a wealth of", "an ample amount of", "a large amount of",
        "large amounts of", "a great amount of", "oodles of"}},
      {{0.08, kSome, 0.25, false, true}, {"a little"}},
      {{0.08, kSome, 0.25},
       {"a bit of",
        "a little bit of",
        "a touch of",
        "a hint of",
        "a dash of",
        "a trace of",
        "a small part of",
        "a small portion of",
        "a small amount of",
        "a small share of",
        "a small bit of",
        "a small area of",
        "a spot of",
        "a smidgen of",
        "a minor part of",
        "small amounts of",
        "small parts of",
        "a pinch of",
        "a small fraction of",
        "a small chunk of",
        "a minority of",
        "a modest amount of",
        "bits of"}},
      {{0.04, kSome, 0.12},
       {"a sliver of", "a scrap of", "a tiny bit of", "a tiny part of", "a tiny portion of",
        "a tiny amount of", "slivers of", "a shred of", "a mere sliver of", "a thin sliver of",
        "a narrow sliver of", "a tiny fraction of"}},
      {{0.03, 0.0, 0.08},
       {"hardly any", "barely any", "scarcely any", "next to no", "almost no", "very little",
        "nearly no", "practically no", "virtually no", "little to no", "little or no",
        "extremely little", "precious little", "hardly a"}},
  };
  return table;
}

// What may stand before a number of a share and bends its bounds.
enum class Bend { kAbout, kAtLeast, kAtMost, kNearly, kMore, kLess, kExactly };

const PhraseTable<Bend>& Bends() {
  static const PhraseTable<Bend> table{
      {Bend::kAbout,
       {"about", "around", "roughly", "approximately", "some", "circa", "ca", "approx", "say",
        "more or less", "something like", "in the region of", "a good", "close to", "maybe",
        "perhaps", "fully"}},
      {Bend::kAtLeast,
       {"at least", "no less than", "not less than", "a minimum of", "minimum", "min"}},
      {Bend::kAtMost,
       {"at most", "up to", "no more than", "not more than", "a maximum of", "maximum", "max",
        "at the most"}},
      {Bend::kNearly,
       {"nearly", "almost", "just under", "a little under", "not quite", "slightly less than",
        "a bit less than", "just below", "a little less than", "just short of", "close on"}},
      {Bend::kMore,
       {"more than", "over", "just over", "a little over", "above", "upwards of",
        "slightly more than", "well over", "a little more than", "a bit more than", "better than"}},
      {Bend::kLess, {"less than", "under", "below", "fewer than", "well under"}},
      {Bend::kExactly, {"exactly", "precisely", "just", "only", "a full", "a mere"}},
  };
  return table;
}

// What may stand after it: "70 % or more".
const PhraseTable<Bend>& BendsAfter() {
  static const PhraseTable<Bend> table{
      {Bend::kAtLeast, {"or more", "or above", "or over", "or higher", "and more", "and above"}},
      {Bend::kAtMost, {"or less", "or below", "or under", "or fewer", "and less"}},
  };
  return table;
}

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

ShareMatch ShareOf(const Fraction& fraction, const Bend* bend) {
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
      case Bend::kAbout:
        break;
      case Bend::kAtLeast:
        below = 0.0;
        above = 1.0;
        break;
      case Bend::kAtMost:
      case Bend::kLess:
        below = 1.0;
        above = 0.0;
        break;
      case Bend::kNearly:
        above = 0.02;
        break;
      case Bend::kMore:
        below = 0.0;
        above = 0.3;
        break;
      case Bend::kExactly:
        below = std::min(below, 0.06);
        above = std::min(above, 0.06);
        break;
    }
  }
  share.least = std::clamp(fraction.low - below, kSome, 1.0);
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
  const auto bend = Bends().At(tokens, at, false);
  std::size_t begin = at + bend.tokens;
  if (bend.value != nullptr && begin >= tokens.size()) return {};
  Fraction fraction = MatchPercent(tokens, begin);
  if (fraction.tokens == 0) fraction = MatchParts(tokens, begin);
  const auto amount = Amounts().At(tokens, at, false);
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
  PhraseTable<Bend>::Match after;
  if (bend.value == nullptr && end < tokens.size()) after = BendsAfter().At(tokens, end, false);
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
