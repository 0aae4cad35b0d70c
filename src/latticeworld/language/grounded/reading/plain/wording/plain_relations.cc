#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// The first word of the clause that `at` belongs to.
std::size_t ClauseBegin(const std::vector<Token>& tokens, std::size_t at) {
  while (at > 0 && !IsPauseAt(tokens, at - 1)) --at;
  if (IsOneOf(WordAt(tokens, at), {"and", "but", "while", "then"})) ++at;
  return at;
}

bool HasClass(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  for (std::size_t at = first; at < last; ++at) {
    if (MatchClassWord(tokens, at).word != nullptr) return true;
  }
  return false;
}

bool IsBe(std::string_view word) { return IsOneOf(word, {"is", "are", "be", "was", "were"}); }

bool IsCoast(std::string_view word) {
  return IsOneOf(word, {"coast", "seashore", "coastline", "seaside", "seafront"});
}

// The words of "except for", "apart from" at the beginning of a sentence; 0: it begins otherwise.
std::size_t LeadingException(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view word = WordAt(tokens, at);
  const std::string_view next = WordAt(tokens, at + 1);
  if (word == "except" || word == "save") return next == "for" ? 2 : 0;
  if (word == "apart" || word == "aside") return next == "from" ? 2 : 0;
  if (word == "other") return next == "than" ? 2 : 0;
  if (word == "with" && next == "the" && WordAt(tokens, at + 2) == "exception") return 4;
  return 0;
}

// "no two houses touch": the houses are scattered. "no trees within 3 cells of a house": the trees
// at least 3 cells away from the house.
void TurnNoneNear(std::vector<Token>* tokens, std::size_t at) {
  std::size_t noun_at = at + 1;
  if (WordAt(*tokens, noun_at) == "two") ++noun_at;
  const ClassWordMatch noun = MatchClassWord(*tokens, noun_at);
  if (noun.word == nullptr) return;
  std::size_t next = noun_at + noun.tokens;
  if (noun_at == at + 2) {
    while (IsOneOf(WordAt(*tokens, next), {"of", "them", "should", "may", "must", "can"})) ++next;
    if (IsOneOf(WordAt(*tokens, next), {"touch", "touching", "adjoin", "meet", "adjacent"})) {
      ReplaceTokens(tokens, next, 1, {"are", "scattered"});
      EraseTokens(tokens, at, noun_at - at);
      return;
    }
  }
  if (IsBe(WordAt(*tokens, next))) ++next;
  const bool number = IsNumberAt(*tokens, next + 1) ||
                      IsOneOf(WordAt(*tokens, next + 1), {"two", "three", "four", "five"});
  const bool within =
      WordAt(*tokens, next) == "within" && number &&
      IsOneOf(WordAt(*tokens, next + 2), {"cells", "steps", "squares", "tiles", "cell", "pixels"});
  if (!within) return;
  if (WordAt(*tokens, next + 3) == "of") {
    ReplaceTokens(tokens, next + 3, 1, {"away", "from"});
    if (IsOneOf(WordAt(*tokens, next + 5), {"a", "an", "any"})) (*tokens)[next + 5].text = "the";
  }
  ReplaceTokens(tokens, next, 1, {"at", "least"});
  ReplaceTokens(tokens, at, 1, {"the"});
}

// "as far from the factory as possible": far away from it.
void TurnAsFar(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at + 1) != "far") return;
  std::size_t from = at + 2;
  if (WordAt(*tokens, from) == "away") ++from;
  if (WordAt(*tokens, from) != "from") return;
  for (std::size_t i = from; i < from + 12 && !IsStopAt(*tokens, i); ++i) {
    if (WordAt(*tokens, i) != "as" ||
        !IsOneOf(WordAt(*tokens, i + 1), {"possible", "can", "you", "it"})) {
      continue;
    }
    const std::size_t said = WordAt(*tokens, i + 1) == "possible" ? 2 : 3;
    EraseTokens(tokens, i, std::min(said, tokens->size() - i));
    ReplaceTokens(tokens, at, from - at, {"far", "away"});
    return;
  }
}

// "ends where the meadow begins": touches the meadow.
void TurnEndsWhere(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at + 1) != "where") return;
  const std::size_t verb = PauseAfter(*tokens, at + 2) - 1;
  if (IsOneOf(WordAt(*tokens, verb),
              {"begins", "starts", "begin", "start", "ends", "stops", "end", "stop"}) &&
      HasClass(*tokens, at + 2, verb)) {
    EraseTokens(tokens, verb, 1);
    ReplaceTokens(tokens, at, 2, {"touches"});
  }
}

// "swings around the town to the east": with a bend to the east of the town. False: it is not said
// on which side.
bool TurnBendsRoundSide(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t thing = at + (WordAt(*tokens, at + 2) == "the" ? 3 : 2);
  const std::size_t to = thing + MatchClassWord(*tokens, thing).tokens;
  if (to == thing || !IsOneOf(WordAt(*tokens, to), {"to", "on", "in"})) return false;
  const std::size_t first = to + (WordAt(*tokens, to + 1) == "the" ? 2 : 1);
  PlaceCursor cursor(*tokens, first);
  if (!TakeDirection(&cursor).found) return false;
  std::size_t end = cursor.at();
  if (WordAt(*tokens, end) == "side") ++end;
  if (!IsPauseAt(*tokens, end)) return false;
  std::vector<Token> where;
  for (const std::string_view word : {"with", "a", "bend", "to", "the"}) {
    where.push_back(WordLike(word, (*tokens)[at]));
  }
  for (std::size_t i = first; i < cursor.at(); ++i) where.push_back((*tokens)[i]);
  where.push_back(WordLike("of", where.back()));
  for (std::size_t i = at + 2; i < to; ++i) where.push_back((*tokens)[i]);
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, where);
  return true;
}

// "bends round the town": with a bend next to it.
void TurnBendsRound(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at + 1), {"round", "around"}) || IsPauseAt(*tokens, at + 2)) return;
  if (TurnBendsRoundSide(tokens, at)) return;
  ReplaceTokens(tokens, at, 2, {"with", "a", "bend", "next", "to"});
}

}  // namespace

void TurnLeadingExceptions(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (at > 0 && !IsStopAt(*tokens, at - 1)) continue;
    const std::size_t opening = LeadingException(*tokens, at);
    if (opening == 0) continue;
    const std::size_t comma = PauseAfter(*tokens, at + opening);
    const bool listed = IsStopAt(*tokens, comma) || !HasClass(*tokens, at + opening, comma);
    if (listed || IsOneOf(WordAt(*tokens, comma + 1), {"and", "or"})) continue;
    const std::size_t end = PauseAfter(*tokens, comma + 1);
    if (!HasClass(*tokens, comma + 1, end)) continue;
    // The rule first, then what is taken out of it.
    std::vector<Token> turned = TokensBetween(*tokens, comma + 1, end);
    const std::vector<Token> exception = TokensBetween(*tokens, at + opening, comma);
    turned.push_back(WordLike("except", (*tokens)[at]));
    turned.push_back(WordLike("for", (*tokens)[at]));
    turned.insert(turned.end(), exception.begin(), exception.end());
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
  }
}

void TurnSeparations(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 4 < tokens->size(); ++at) {
    const bool parted =
        IsOneOf(WordAt(*tokens, at), {"separated", "divided", "parted", "shielded", "screened",
                                      "cut", "sheltered", "hidden", "isolated", "set"});
    if (!parted || !IsBe(WordAt(*tokens, at - 1))) continue;
    std::size_t from = at + 1;
    if (IsOneOf(WordAt(*tokens, from), {"off", "apart", "away"})) ++from;
    if (WordAt(*tokens, from) != "from") continue;
    const std::size_t end = PauseAfter(*tokens, from);
    std::size_t by = from + 1;
    while (by < end && WordAt(*tokens, by) != "by") ++by;
    const std::size_t begin = ClauseBegin(*tokens, at);
    const bool whole = by < end && HasClass(*tokens, begin, at - 1) &&
                       HasClass(*tokens, from, by) && HasClass(*tokens, by, end);
    if (!whole) continue;
    const Token beside = (*tokens)[at];
    std::vector<Token> turned = TokensBetween(*tokens, by + 1, end);
    for (const std::string_view word : {"lies", "between"})
      turned.push_back(WordLike(word, beside));
    for (std::size_t i = begin; i + 1 < at; ++i) turned.push_back((*tokens)[i]);
    turned.push_back(WordLike("and", beside));
    for (std::size_t i = from + 1; i < by; ++i) turned.push_back((*tokens)[i]);
    EraseTokens(tokens, begin, end - begin);
    InsertTokens(tokens, begin, turned);
  }
}

void TurnParts(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"splits", "divides", "cuts", "split", "divide", "bisects",
                                       "splitting", "dividing", "cutting", "bisecting"}) ||
        (at > 0 && IsBe(WordAt(*tokens, at - 1)))) {
      continue;
    }
    const std::size_t thing = at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1);
    const ClassWordMatch noun = MatchClassWord(*tokens, thing);
    if (noun.word == nullptr || noun.plural) continue;
    const std::size_t end = thing + noun.tokens;
    std::size_t last = end;
    if (IsOneOf(WordAt(*tokens, end), {"in", "into"})) {
      std::size_t part = end + 1;
      constexpr std::size_t kLongest = 8;  // "a northern and a southern half"
      while (part < end + kLongest && !IsPauseAt(*tokens, part) &&
             !IsOneOf(WordAt(*tokens, part),
                      {"two", "halves", "parts", "half", "part", "pieces", "sections"})) {
        ++part;
      }
      if (IsPauseAt(*tokens, part) || part == end + kLongest) continue;
      last = part + 1;
      if (IsOneOf(WordAt(*tokens, last), {"halves", "parts", "pieces", "sections"})) ++last;
    } else if (!IsPauseAt(*tokens, end)) {
      continue;
    }
    // "runs through the town with the town on both sides of it"
    const Token beside = (*tokens)[at];
    const std::vector<Token> name = TokensBetween(*tokens, thing, end);
    std::vector<Token> turned = {WordLike("runs", beside), WordLike("through", beside),
                                 WordLike("the", beside)};
    turned.insert(turned.end(), name.begin(), name.end());
    turned.push_back(CommaLike(beside));
    for (const std::string_view word : {"with", "the"}) turned.push_back(WordLike(word, beside));
    turned.insert(turned.end(), name.begin(), name.end());
    for (const std::string_view word : {"on", "both", "sides", "of", "it"}) {
      turned.push_back(WordLike(word, beside));
    }
    EraseTokens(tokens, at, last - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

void TurnDistances(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::string_view word = WordAt(*tokens, at);
    if (word == "no") {
      TurnNoneNear(tokens, at);
    } else if (word == "as") {
      TurnAsFar(tokens, at);
    } else if (IsOneOf(word, {"ends", "end", "stops", "stop", "begins", "starts", "begin"})) {
      TurnEndsWhere(tokens, at);
    } else if (IsOneOf(word, {"bends", "curves", "loops", "swings", "bending", "curving",
                              "swinging", "curls", "looping", "bend", "turns"})) {
      TurnBendsRound(tokens, at);
    }
  }
}

void TurnMeasures(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    std::size_t next = at;
    if (IsOneOf(word, {"cover", "covers", "covering", "fill", "fills", "occupy", "occupies"})) {
      next = at + 1;
    } else if (IsOneOf(word, {"take", "takes", "make", "makes"}) &&
               WordAt(*tokens, at + 1) == "up") {
      next = at + 2;
    }
    // "covers more than 40 percent" says a share, "covers more than the fields" compares.
    if (next > at && IsOneOf(WordAt(*tokens, next), {"more", "less"})) {
      std::size_t than = next + 1;
      if (IsOneOf(WordAt(*tokens, than), {"ground", "land", "area", "space", "room"})) ++than;
      if (WordAt(*tokens, than) != "than") continue;
      const std::string after(WordAt(*tokens, than + 1));
      const bool number =
          than + 1 < tokens->size() && (*tokens)[than + 1].kind == TokenKind::kNumber;
      const bool others = IsOneOf(after, {"everything", "all", "anything", "any"});
      if (others) {
        const bool together = after == "everything" || after == "all";
        const std::size_t end = PauseAfter(*tokens, than);
        if (HasClass(*tokens, than, end)) continue;
        if (together) {
          ReplaceTokens(tokens, at, end - at,
                        {"cover", "more", "than", "half", "of", "the", "map"});
          (*tokens)[at].text = "is";
        } else {
          ReplaceTokens(tokens, at, end - at, {"cover", "most", "of", "the", "map"});
        }
        continue;
      }
      if (number || IsOneOf(after, {"half", "a", "one", "two", "three"})) {
        ReplaceTokens(tokens, at, next - at, {"is"});
      } else if (HasClass(*tokens, than + 1, PauseAfter(*tokens, than))) {
        const bool more = WordAt(*tokens, next) == "more";
        ReplaceTokens(tokens, at, than - at, {"is", more ? "larger" : "smaller"});
      }
      continue;
    }
    // "the fields are more than the forest"
    if (IsBe(word) && IsOneOf(WordAt(*tokens, at + 1), {"more", "less"}) &&
        WordAt(*tokens, at + 2) == "than") {
      const std::size_t thing = at + 3 + (WordAt(*tokens, at + 3) == "the" ? 1 : 0);
      if (MatchClassWord(*tokens, thing).word != nullptr) {
        (*tokens)[at + 1].text = WordAt(*tokens, at + 1) == "more" ? "larger" : "smaller";
      }
    }
    // "Lots of forest, less grassland": less than of that.
    if (word == "less" && at >= 2 && IsPauseAt(*tokens, at - 1)) {
      const ClassWordMatch noun = MatchClassWord(*tokens, at + 1);
      std::size_t before = at - 1;
      while (before > 0 && !IsPauseAt(*tokens, before - 1)) --before;
      if (noun.word == nullptr || !IsPauseAt(*tokens, at + 1 + noun.tokens)) continue;
      for (std::size_t i = before; i + 1 < at; ++i) {
        const ClassWordMatch first = MatchClassWord(*tokens, i);
        if (first.word == nullptr) continue;
        std::vector<Token> than = TokensBetween(*tokens, i, i + first.tokens);
        than.insert(than.begin(), WordLike("than", (*tokens)[at]));
        InsertTokens(tokens, at + 1 + noun.tokens, than);
        break;
      }
    }
    // "fill whatever is left with grass"
    if (IsOneOf(word, {"fill", "cover", "plant"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"whatever", "what", "all", "everything", "any"})) {
      const std::size_t end = PauseAfter(*tokens, at);
      std::size_t with = at + 2;
      bool left = false;
      for (; with < end && WordAt(*tokens, with) != "with"; ++with) {
        left = left || IsOneOf(WordAt(*tokens, with), {"left", "remains", "remaining", "else"});
      }
      if (left && with < end) ReplaceTokens(tokens, at, with + 1 - at, {"the", "rest", "is"});
    }
  }
}

void TurnCoasts(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const ClassWordMatch noun = MatchClassWord(*tokens, at);
    const bool water = noun.word != nullptr && (noun.word->suburb == 'W' || noun.word->wild == 'W');
    if (water && !IsCoast(WordAt(*tokens, at))) return;
  }
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (IsCoast(WordAt(*tokens, at)) &&
        IsOneOf(WordAt(*tokens, at - 1), {"the", "a", "our", "this"})) {
      (*tokens)[at].text = "sea";
    }
  }
}

}  // namespace latticeworld
