#include "latticeworld/language/grounded/reading/stripe_items.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

constexpr std::string_view kOrdinals[] = {"first", "second",  "third",  "fourth", "fifth",
                                          "sixth", "seventh", "eighth", "ninth",  "tenth"};
constexpr std::string_view kCardinals[] = {"one", "two",   "three", "four", "five",
                                           "six", "seven", "eight", "nine", "ten"};

template <std::size_t kCount>
int IndexIn(const std::string_view (&words)[kCount], std::string_view word) {
  const auto* found = std::find(std::begin(words), std::end(words), word);
  return found == std::end(words) ? 0 : static_cast<int>(found - std::begin(words)) + 1;
}

// "three", "3", "c"; 0: no number.
int NumberAt(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size()) return 0;
  if (tokens[at].kind == TokenKind::kNumber) return std::atoi(tokens[at].text.c_str());
  const std::string_view word = WordAt(tokens, at);
  if (word.size() == 1 && word[0] >= 'a' && word[0] <= 'h') return word[0] - 'a' + 1;
  return IndexIn(kCardinals, word);
}

int PartsOf(std::string_view word) {
  if (word == "third") return 3;
  if (word == "quarter") return 4;
  if (word == "fifth") return 5;
  if (word == "sixth") return 6;
  return 0;
}

bool IsMark(const std::vector<Token>& tokens, std::size_t at, std::string_view mark) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kComma && tokens[at].text == mark;
}

// A side or the middle: "left", "the far right"; the token after it, 0: none.
std::size_t TakeSideWord(const std::vector<Token>& tokens, std::size_t at, Heading* side) {
  if (WordAt(tokens, at) == "the") ++at;
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found || direction.heading.IsDiagonal()) return 0;
  *side = direction.heading;
  return cursor.at();
}

// "(far left)", "from the top", ", counted from the west,": which of the ends it is.
std::size_t SkipQualifier(const std::vector<Token>& tokens, std::size_t at, StripeItem* item) {
  constexpr std::size_t kLongest = 7;
  std::size_t next = at;
  const bool bracket = IsMark(tokens, next, "(");
  const bool comma = IsMark(tokens, next, ",");
  if (bracket || comma) ++next;
  bool counted = false;
  while (IsOneOf(WordAt(tokens, next),
                 {"counted", "counting", "seen", "starting", "beginning", "reading", "which", "is",
                  "that", "the", "one", "from", "on", "at", "to", "in", "my", "your"})) {
    counted = true;
    ++next;
  }
  if (!(bracket || counted) || next > at + kLongest) return at;
  Heading side;
  std::size_t end = TakeSideWord(tokens, next, &side);
  if (end == 0) return at;
  if (IsOneOf(WordAt(tokens, end), {"side", "edge", "end", "one", "most", "hand"})) ++end;
  if (WordAt(tokens, end) == "side") ++end;
  if (WordAt(tokens, end) == "of" && WordAt(tokens, end + 1) == "the" &&
      IsMapWord(WordAt(tokens, end + 2))) {
    end += 3;
  }
  if (bracket) {
    if (!IsMark(tokens, end, ")")) return at;
    ++end;
  } else if (comma) {
    if (!IsMark(tokens, end, ",")) return at;
    ++end;
  }
  item->sided = true;
  item->side = side;
  return end;
}

// Verbs between a part and what it holds: "is", "should be", "belongs to", ":".
std::size_t SkipHolds(const std::vector<Token>& tokens, std::size_t at) {
  if (IsMark(tokens, at, ":") || IsMark(tokens, at, "=") || IsMark(tokens, at, "-")) ++at;
  while (IsOneOf(WordAt(tokens, at),
                 {"is",      "are",     "be",        "was",     "will",    "should",   "must",
                  "shall",   "becomes", "become",    "holds",   "hold",    "contains", "shows",
                  "gets",    "carries", "for",       "belongs", "to",      "reserved", "given",
                  "goes",    "made",    "of",        "with",    "covered", "filled",   "consists",
                  "consist", "has",     "being",     "all",     "only",    "purely",   "entirely",
                  "nothing", "but",     "comprises", "under",   "planted", "also",     "again"})) {
    ++at;
  }
  return at;
}

}  // namespace

bool IsStripeNoun(std::string_view word) {
  const std::string one = Singular(word);
  return IsOneOf(one, {"stripe", "strip", "band", "column", "row", "layer", "zone", "belt", "tier",
                       "slice", "panel", "part", "section", "step"});
}

bool ClassSoon(const std::vector<Token>& tokens, std::size_t at, std::size_t words) {
  for (std::size_t i = at; i < at + words && !IsPauseAt(tokens, i); ++i) {
    if (MatchClassWord(tokens, i).word != nullptr) return true;
    if (IsOneOf(WordAt(tokens, i), {"wooded", "forested", "grassy", "rocky", "snowy", "sandy",
                                    "farmed", "bare", "urban", "residential", "built"})) {
      return true;
    }
    if (IsOneOf(WordAt(tokens, i), {"and", "or", "in", "at", "by", "near"})) return false;
  }
  return false;
}

bool TakeStripeItem(const std::vector<Token>& tokens, std::size_t at, const StripeItem* before,
                    bool declared, StripeItem* item) {
  *item = StripeItem();
  item->begin = at;
  std::size_t next = at;
  while (IsOneOf(WordAt(tokens, next), {"and", "then", "while", "with", "finally"})) ++next;
  const bool article = IsOneOf(WordAt(tokens, next), {"the", "a", "my", "its"});
  if (article) ++next;
  const std::string word(WordAt(tokens, next));
  Heading side;
  const std::size_t sided = TakeSideWord(tokens, next, &side);
  const std::string after(WordAt(tokens, sided));
  const bool of_parts = PartsOf(after) > 0;
  // "the second", "first stripe", "the last one"
  int ordinal = IndexIn(kOrdinals, word);
  if (IsOneOf(word, {"last", "final"})) ordinal = StripeItem::kLast;
  if (IsOneOf(word, {"next", "following"})) ordinal = StripeItem::kNext;
  const bool named = IsStripeNoun(word) || IsOneOf(word, {"number", "no", "nr"});
  if (sided > 0 && (of_parts || (IsStripeNoun(after) && after == Singular(after)) ||
                    (declared && after == "one"))) {
    item->sided = true;
    item->side = side;
    item->parts = PartsOf(after);
    item->noun = after != "one";
    next = sided + 1;
  } else if (ordinal != 0) {
    item->nth = ordinal;
    ++next;
    const std::string noun(WordAt(tokens, next));
    item->parts = PartsOf(noun);
    item->noun = item->parts > 0 || (IsStripeNoun(noun) && noun == Singular(noun));
    if (item->noun || noun == "one") ++next;
    if (WordAt(tokens, next) == "of") {
      if (IsOneOf(WordAt(tokens, next + 1), {"them", "these", "those"})) {
        next += 2;
      } else if (WordAt(tokens, next + 1) == "the" && IsMapWord(WordAt(tokens, next + 2))) {
        next += 3;
      } else if (IsOneOf(WordAt(tokens, next + 1), {"the", "a", "an", "this", "it"})) {
        return false;  // "the first part of the road"
      }
    }
    const bool alone = !item->noun && noun != "one";
    if (alone && !article && before == nullptr && !IsMark(tokens, next, ":") &&
        !IsOneOf(noun, {"a", "an", "some", "the"})) {
      return false;
    }
  } else if (named && NumberAt(tokens, next + 1) > 0) {
    item->nth = NumberAt(tokens, next + 1);
    item->noun = item->numbered = true;
    next += 2;
  } else if (before != nullptr && before->numbered && NumberAt(tokens, next) == before->nth + 1) {
    item->nth = before->nth + 1;
    item->numbered = true;
    ++next;
  } else {
    return false;
  }
  next = SkipQualifier(tokens, next, item);
  const std::size_t body = SkipHolds(tokens, next);
  // If there is no verb, what the stripe holds follows at once.
  const bool said = body > next;
  if (item->numbered && !said && !IsMark(tokens, body, "(")) return false;
  if (!ClassSoon(tokens, body, said ? 5 : 4)) return false;
  item->body = body;
  return true;
}

}  // namespace latticeworld
