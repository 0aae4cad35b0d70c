#include "latticeworld/language/extents.h"

#include <algorithm>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/phrase_table.h"

namespace latticeworld {
namespace {

constexpr double kLargeShare = 0.08;

const PhraseTable<SizeMatch>& Sizes() {
  static const PhraseTable<SizeMatch> table{
      {{3.0, kLargeShare, 1.0},
       {"vast",         "huge",      "enormous",     "gigantic",  "immense",
        "massive",      "giant",     "extensive",    "sprawling", "expansive",
        "endless",      "boundless", "colossal",     "mighty",    "tremendous",
        "gargantuan",   "humongous", "never ending", "unending",  "great big",
        "far reaching", "oversized", "ginormous",    "limitless", "hulking"}},
      {{1.8, kLargeShare, 1.0},
       {"large",        "big",        "great",        "sizeable",    "sizable",    "considerable",
        "substantial",  "good sized", "decent sized", "large sized", "generous",   "hefty",
        "spacious",     "larger",     "bigger",       "large scale", "good size",  "fair sized",
        "roomy",        "bulky",      "biggish",      "largish",     "very large", "largest",
        "very largest", "biggest"}},
      {{1.0, 0.0, 1.0},
       {"medium", "medium sized", "mid sized", "middling", "moderate", "moderately sized",
        "average", "average sized", "normal sized", "ordinary sized", "medium size", "midsize",
        "midsized", "moderate sized", "regular sized"}},
      {{0.5, 0.0, 1.0},
       {"small", "little", "modest", "compact", "smallish", "small sized", "smaller",
        "modestly sized", "littler", "small scale", "undersized", "cosy", "cozy"}},
      {{0.25, 0.0, 1.0},
       {"tiny",         "minute",      "miniature",   "diminutive", "wee",
        "mini",         "teeny",       "minuscule",   "miniscule",  "petite",
        "pocket sized", "itty bitty",  "tiny little", "teensy",     "small little",
        "weeny",        "microscopic", "pint sized",  "puny",       "bijou"}},
      {{1.0, 0.0, 2.0}, {"wide", "broad", "wider", "broader", "thick", "two cell wide"}},
      {{1.0, 0.0, 0.5}, {"narrow", "thin", "slim", "slender", "skinny", "narrower", "thinner"}},
  };
  return table;
}

const PhraseTable<bool>& Intensifiers() {
  // Whether the word strengthens what follows.
  static const PhraseTable<bool> table{
      {true,
       {"very", "extremely", "really", "super", "exceedingly", "exceptionally", "incredibly",
        "terribly", "especially", "particularly", "absolutely", "truly", "enormously", "immensely",
        "ever so", "so very", "unusually", "awfully", "extra"}},
      {false,
       {"rather", "quite", "fairly", "pretty", "relatively", "somewhat", "reasonably", "moderately",
        "comparatively", "a bit", "slightly", "kind of", "sort of", "decently", "kinda", "sorta",
        "suitably", "a little"}},
  };
  return table;
}

struct Bounds {
  int least;
  int most;
};
constexpr int kOpen = CountMatch::kUnbounded;

const PhraseTable<Bounds>& CountWords() {
  // Exact numbers stand first, then vague ones, from few to very many.
  static const PhraseTable<Bounds> table{
      {{1, 1},
       {"a single",         "single",        "a lone",        "lone",         "a solitary",
        "solitary",         "only one",      "just one",      "one single",   "exactly one",
        "a sole",           "sole",          "one lone",      "one solitary", "one lonely",
        "a lonely",         "lonely",        "precisely one", "a singular",   "no more than one",
        "one and only one", "only a single", "just a single", "one isolated"}},
      {{2, 2},
       {"a couple of", "a couple", "couple of", "a pair of", "a pair", "pair of", "twin", "twins",
        "a duo of", "a brace of", "just a couple of", "only a couple of", "two twin"}},
      {{3, 3}, {"a trio of", "trio of", "a triplet of", "a triad of"}},
      {{4, 4}, {"a quartet of", "a foursome of", "quartet of"}},
      {{5, 5}, {"a quintet of"}},
      {{2, 5}, {"a few", "a small number of", "just a few", "only a few", "a smattering of"}},
      {{2, 3}, {"a couple or three", "a couple or so"}},
      {{1, 3}, {"few", "very few", "precious few", "only few"}},
      {{1, 2}, {"one or two"}},
      {{3, 7}, {"a handful of", "a handful", "handful of"}},
      {{2, kOpen},
       {"multiple", "various", "more than one", "at least a couple of", "a variety of"}},
      {{3, kOpen},
       {"several", "a number of", "quite a few", "a series of", "a string of", "a chain of",
        "more than a couple of", "a good few", "a fair few", "more than two", "a fair number of"}},
      {{4, kOpen},
       {"many",
        "numerous",
        "a lot of",
        "lots of",
        "plenty of",
        "loads of",
        "a great many",
        "a good many",
        "a large number of",
        "a great number of",
        "very many",
        "so many",
        "a multitude of",
        "a bunch of",
        "heaps of",
        "tons of",
        "more than a few",
        "ever so many",
        "a host of",
        "an abundance of",
        "a good number of",
        "a swarm of",
        "umpteen",
        "large numbers of",
        "a profusion of"}},
      {{6, kOpen},
       {"countless", "innumerable", "dozens of", "scores of", "hundreds of", "thousands of",
        "a myriad of", "myriad", "a myriad", "untold", "no end of", "uncounted"}},
  };
  return table;
}

bool IsPause(const Token& token) {
  return token.kind == TokenKind::kComma || token.kind == TokenKind::kStop;
}

bool IsWord(const std::vector<Token>& tokens, std::size_t at, std::string_view word) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord && tokens[at].text == word;
}

enum class Bend { kAbout, kAtLeast, kAtMost, kNearly, kMore, kLess, kExactly };

const PhraseTable<Bend>& Bends() {
  static const PhraseTable<Bend> table{
      {Bend::kAbout,
       {"about", "around", "roughly", "approximately", "some", "circa", "ca", "approx", "say",
        "maybe", "perhaps", "something like"}},
      {Bend::kAtLeast,
       {"at least", "no fewer than", "not fewer than", "no less than", "not less than",
        "a minimum of", "minimum"}},
      {Bend::kAtMost,
       {"at most", "up to", "no more than", "not more than", "a maximum of", "maximum",
        "as many as", "at the most", "max"}},
      {Bend::kNearly, {"nearly", "almost", "close to", "just under"}},
      {Bend::kMore, {"more than", "over", "upwards of", "well over"}},
      {Bend::kLess, {"fewer than", "less than", "under"}},
      {Bend::kExactly,
       {"exactly", "precisely", "just", "only", "a total of", "no more and no less than"}},
  };
  return table;
}

// A plain number; "30 %" and "two thirds" are none.
NumberMatch MatchWhole(const std::vector<Token>& tokens, std::size_t at) {
  const NumberMatch number = MatchNumber(tokens, at);
  if (number.tokens == 0) return {};
  // "one in five", "2 out of 3" and everything with a denominator or a percent sign.
  const ShareMatch share = MatchShare(tokens, at);
  if (share.fraction && share.tokens > number.tokens) return {};
  return number;
}

// "three to five", "2-3", "two or three", "between two and four"; at the first number.
CountMatch MatchRange(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t first_at = at;
  const bool between = IsWord(tokens, at, "between") || IsWord(tokens, at, "from");
  if (between) ++first_at;
  const NumberMatch first = MatchWhole(tokens, first_at);
  if (first.tokens == 0) return {};
  std::size_t second_at = first_at + first.tokens;
  bool joined = false;
  if (IsWord(tokens, second_at, "to") || IsWord(tokens, second_at, "or") ||
      (between && IsWord(tokens, second_at, "and"))) {
    ++second_at;
    joined = true;
  } else if (second_at < tokens.size() && tokens[second_at].kind == TokenKind::kNumber &&
             tokens[second_at - 1].kind == TokenKind::kNumber) {
    joined = true;  // "3-4": the hyphen is no token
  }
  if (!joined) return {};
  const NumberMatch second = MatchWhole(tokens, second_at);
  if (second.tokens == 0 || second.value <= first.value) return {};
  return {first.value, second.value, second_at + second.tokens - at};
}

CountMatch Bent(Bend bend, int value) {
  const int slack = std::max(1, value / 5);
  switch (bend) {
    case Bend::kAbout:
      return {std::max(1, value - slack), value + slack};
    case Bend::kAtLeast:
      return {value, kOpen};
    case Bend::kAtMost:
      return {std::min(1, value), value};
    case Bend::kNearly:
      return {std::max(1, value - slack), value};
    case Bend::kMore:
      return {value + 1, kOpen};
    case Bend::kLess:
      return {std::min(1, value), std::max(value - 1, std::min(1, value))};
    case Bend::kExactly:
      break;
  }
  return {value, value};
}

}  // namespace

SizeMatch MatchSize(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size()) return {};
  const auto intensifier = Intensifiers().At(tokens, at, false);
  const std::size_t begin = at + intensifier.tokens;
  if (begin >= tokens.size()) return {};
  const auto found = Sizes().At(tokens, begin, false);
  if (found.value == nullptr) return {};
  SizeMatch size = *found.value;
  if (intensifier.value != nullptr && *intensifier.value) {
    if (size.factor > 1.0) size.factor = std::max(size.factor, 2.6);
    if (size.factor < 1.0) size.factor = std::min(size.factor, 0.3);
    if (size.width > 1.0) size.width = 3.0;
    if (size.width < 1.0) size.width = 0.3;
  }
  size.tokens = intensifier.tokens + found.tokens;
  return size;
}

CountMatch MatchCount(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size() || IsPause(tokens[at])) return {};
  CountMatch best;
  const auto take = [&](const CountMatch& match) {
    if (match.tokens > best.tokens) best = match;
  };
  if (const auto words = CountWords().At(tokens, at, false); words.value != nullptr) {
    take({words.value->least, words.value->most, words.tokens});
  }
  take(MatchRange(tokens, at));
  const auto bend = Bends().At(tokens, at, false);
  const std::size_t begin = at + bend.tokens;
  if (begin >= tokens.size()) return best;
  CountMatch count;
  if (const CountMatch range = bend.tokens > 0 ? MatchRange(tokens, begin) : CountMatch();
      range.tokens > 0) {
    count = {range.least, range.most, bend.tokens + range.tokens};
  } else if (const NumberMatch number = MatchWhole(tokens, begin); number.tokens > 0) {
    count = Bent(bend.value != nullptr ? *bend.value : Bend::kExactly, number.value);
    count.tokens = bend.tokens + number.tokens;
    // "three or more", "a dozen or so", "3x".
    const std::size_t after = at + count.tokens;
    if (IsWord(tokens, after, "or") && IsWord(tokens, after + 1, "more")) {
      count = {number.value, kOpen, count.tokens + 2};
    } else if (IsWord(tokens, after, "or") && IsWord(tokens, after + 1, "so")) {
      const std::size_t length = count.tokens + 2;
      count = Bent(Bend::kAbout, number.value);
      count.tokens = length;
    } else if (IsWord(tokens, after, "or") &&
               (IsWord(tokens, after + 1, "fewer") || IsWord(tokens, after + 1, "less"))) {
      count = {std::min(1, number.value), number.value, count.tokens + 2};
    } else if (tokens[begin].kind == TokenKind::kNumber && IsWord(tokens, after, "x")) {
      ++count.tokens;
    }
  }
  take(count);
  return best;
}

}  // namespace latticeworld
