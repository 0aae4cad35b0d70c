#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Sizes told by another size: "about half that size".
namespace latticeworld {
namespace {

// Tokens [begin, end) that say how many times the size of something.
struct Multiple {
  std::size_t begin = 0;
  std::size_t end = 0;  // 0: none
  double times = 1.0;
  std::size_t than = 0;  // the noun that it is measured by; 0: what was said last
};

bool IsSizeNoun(std::string_view word) {
  return IsOneOf(word, {"size", "area", "amount", "share", "extent", "space", "surface"});
}

// "half", "twice", "a third (of)", "three times"; the token after it, 0: none of these.
std::size_t TakeTimes(const std::vector<Token>& tokens, std::size_t at, double* times) {
  if (IsOneOf(WordAt(tokens, at), {"twice", "double"})) {
    *times = 2.0;
    return at + 1;
  }
  const ShareMatch share = MatchShare(tokens, at);
  if (share.tokens > 0 && share.fraction && share.value > 0.0) {
    *times = share.value;
    const std::size_t end = at + share.tokens;
    return !share.of && WordAt(tokens, end) == "of" ? end + 1 : end;
  }
  const CountMatch count = MatchCount(tokens, at);
  if (count.tokens > 0 && count.least == count.most && count.least > 0 &&
      WordAt(tokens, at + count.tokens) == "times") {
    *times = count.least;
    return at + count.tokens + 1;
  }
  return 0;
}

// The noun after "of" or "as", an article between; 0: none.
std::size_t NounAfter(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t noun = at + (IsOneOf(WordAt(tokens, at), {"the", "a", "that", "this"}) ? 1 : 0);
  return MatchClassWord(tokens, noun).word != nullptr ? noun : 0;
}

Multiple MultipleAt(const std::vector<Token>& tokens, std::size_t at) {
  Multiple found;
  found.begin = at;
  const bool same = WordAt(tokens, at) == "the" && WordAt(tokens, at + 1) == "same";
  std::size_t next = same ? at + 2 : TakeTimes(tokens, at, &found.times);
  if (next == 0) return found;
  if (same) {
    if (!IsSizeNoun(WordAt(tokens, next))) return found;
    ++next;
    if (WordAt(tokens, next) == "as") {
      found.than = NounAfter(tokens, next + 1);
      if (found.than == 0) return found;
    }
  } else if (WordAt(tokens, next) == "as" &&
             IsOneOf(WordAt(tokens, next + 1), {"large", "big", "much", "extensive"})) {
    // "40 % forest, half as much water" and "the lake is half as large", not "half as much wood
    // as meadow".
    const bool much = WordAt(tokens, next + 1) == "much";
    next += 2;
    if (WordAt(tokens, next) == "as") {
      found.than = NounAfter(tokens, next + 1);
      if (found.than == 0) return found;
    } else if (much) {
      const ClassWordMatch noun = MatchClassWord(tokens, next);
      if (noun.word != nullptr && !IsPauseAt(tokens, next + noun.tokens)) return found;
    }
  } else if (IsOneOf(WordAt(tokens, next), {"that", "this", "its"}) ||
             (WordAt(tokens, next) == "the" && IsSizeNoun(WordAt(tokens, next + 1)))) {
    const bool its = WordAt(tokens, next) == "its";
    const bool the = WordAt(tokens, next) == "the";
    ++next;
    const bool size = IsSizeNoun(WordAt(tokens, next));
    if (size) ++next;
    if (its && !size) return found;
    if (size && WordAt(tokens, next) == "of") found.than = NounAfter(tokens, next + 1);
    if (the && found.than == 0) return found;
    // "half of that wood"
    if (!size && !IsPauseAt(tokens, next) &&
        !IsOneOf(WordAt(tokens, next), {"is", "and", "of", "for", "in", "are", "with"})) {
      return found;
    }
  } else {
    return found;
  }
  if (found.than > 0) next = found.than + MatchClassWord(tokens, found.than).tokens;
  found.end = next;
  return found;
}

// The noun of the clause that token `at` stands in, before it or else after it; -1: none.
const ClassWord* NounOfClause(const std::vector<Token>& tokens, std::size_t at) {
  for (std::size_t i = at; i-- > 0 && !IsPauseAt(tokens, i) && WordAt(tokens, i) != "and";) {
    const ClassWordMatch match = MatchClassWord(tokens, i);
    if (match.word != nullptr) return match.word;
  }
  for (std::size_t i = at; !IsPauseAt(tokens, i); ++i) {
    const ClassWordMatch match = MatchClassWord(tokens, i);
    if (match.word != nullptr) return match.word;
  }
  return nullptr;
}

// The share of the map that was said last before `end`, of `noun` where there is one.
std::optional<double> ShareBefore(const std::vector<Token>& tokens, std::size_t end,
                                  const ClassWord* noun) {
  constexpr std::size_t kReach = 120;
  std::optional<double> value;
  for (std::size_t at = end > kReach ? end - kReach : 0; at < end; ++at) {
    const ShareMatch share = MatchShare(tokens, at);
    if (share.tokens == 0 || at + share.tokens > end) continue;
    const std::size_t after = at + share.tokens;
    // "the northern half", "the left third" are places; "two thirds as large" is none of the map.
    Heading heading;
    const bool place = at > 0 && TakeHeading(tokens, at - 1, &heading) == at;
    const bool counted = share.fraction && !share.ordinal && !place &&
                         !IsOneOf(WordAt(tokens, after), {"as", "that", "this", "its"});
    if (counted && (noun == nullptr || NounOfClause(tokens, at) == noun)) value = share.value;
    at = after - 1;
  }
  return value;
}

// The last noun before the one that `at` is said of; 0 tokens: none.
std::vector<Token> OtherNounBefore(const std::vector<Token>& tokens, std::size_t at) {
  const ClassWord* own = nullptr;
  for (std::size_t i = at; i-- > 0;) {
    const ClassWordMatch match = MatchClassWord(tokens, i);
    if (match.word == nullptr) continue;
    if (i > 0 && MatchClassWord(tokens, i - 1).tokens > match.tokens) continue;
    if (own != nullptr && match.word != own) {
      return std::vector<Token>(tokens.begin() + static_cast<std::ptrdiff_t>(i),
                                tokens.begin() + static_cast<std::ptrdiff_t>(i + match.tokens));
    }
    own = match.word;
  }
  return {};
}

bool IsCovering(std::string_view word) {
  return IsOneOf(word, {"cover", "covers", "covering", "fill", "fills", "filling", "occupy",
                        "occupies", "occupying", "up"});
}

}  // namespace

// "a forest on 40 percent of the map and a lake about half that size": covering 20 percent. "A
// forest and a lake half its size": smaller than the forest.
void TurnSizes(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const Multiple found = MultipleAt(*tokens, at);
    if (found.end == 0) continue;
    const ClassWord* than = found.than > 0 ? MatchClassWord(*tokens, found.than).word : nullptr;
    std::size_t begin = at;
    while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1),
                                {"about", "around", "roughly", "some", "only", "nearly", "almost",
                                 "approximately", "just", "of", "with", "at", "exactly"})) {
      --begin;
    }
    const std::optional<double> base = ShareBefore(*tokens, begin, than);
    const Token beside = (*tokens)[at];
    const std::string percent =
        base.has_value() ? std::to_string(std::lround(*base * found.times * 100.0)) : "";
    std::vector<Token> turned;
    // "half as much water", "a quarter of that is water": the noun follows.
    std::size_t after = found.end;
    if (IsOneOf(WordAt(*tokens, after), {"of", "is", "are"})) ++after;
    const bool leads = found.than == 0 && NounAfter(*tokens, after) != 0 && begin > 0 &&
                       (IsPauseAt(*tokens, begin - 1) ||
                        IsOneOf(WordAt(*tokens, begin - 1), {"and", "but", "by"}));
    if (base.has_value() && *base * found.times <= 1.0) {
      std::size_t first = begin;
      if (!leads && first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"is", "are", "be"})) {
        (*tokens)[first - 1].text = "covers";
      } else if (first > 1 && WordAt(*tokens, first - 1) == "up") {
        // "takes up half of that"
        (*tokens)[first - 2].text = "covers";
        --first;
      } else if (!leads && !(first > 0 && IsCovering(WordAt(*tokens, first - 1)))) {
        turned.push_back(WordLike("covering", beside));
      }
      turned.push_back({TokenKind::kNumber, percent, beside.begin, beside.end});
      for (const std::string_view word : {"percent", "of", "the", "map"}) {
        turned.push_back(WordLike(word, beside));
        if (leads && word == "percent") break;
      }
      EraseTokens(tokens, first, found.end - first);
      InsertTokens(tokens, first, turned);
      at = first + turned.size();
      continue;
    }
    if (leads || found.times == 1.0 || base.has_value()) continue;
    const std::vector<Token> other =
        found.than > 0
            ? std::vector<Token>(tokens->begin() + static_cast<std::ptrdiff_t>(found.than),
                                 tokens->begin() + static_cast<std::ptrdiff_t>(found.end))
            : OtherNounBefore(*tokens, begin);
    if (other.empty()) continue;
    for (const std::string_view word : {std::string_view(found.times < 1.0 ? "smaller" : "larger"),
                                        std::string_view("than"), std::string_view("the")}) {
      turned.push_back(WordLike(word, beside));
    }
    for (const Token& token : other) turned.push_back(WordLike(token.text, beside));
    EraseTokens(tokens, begin, found.end - begin);
    InsertTokens(tokens, begin, turned);
    at = begin + turned.size();
  }
}

}  // namespace latticeworld
