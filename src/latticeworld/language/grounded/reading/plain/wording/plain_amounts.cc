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

// "twice as much wood as meadow": more of it. "half as much wood as meadow": less.
void TurnComparisons(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 5;
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    std::size_t as = at;
    bool more = false;
    bool less = false;
    const std::string word(WordAt(*tokens, at));
    // "more forest than anything else"
    if (word == "more") {
      const ClassWordMatch noun = MatchClassWord(*tokens, at + 1);
      const std::size_t than = at + 1 + noun.tokens;
      if (noun.word != nullptr && WordAt(*tokens, than) == "than" &&
          IsOneOf(WordAt(*tokens, than + 1), {"anything", "everything"}) &&
          WordAt(*tokens, than + 2) == "else") {
        EraseTokens(tokens, than, 3);
        (*tokens)[at].text = "mostly";
        continue;
      }
    }
    if (IsOneOf(word, {"twice", "double", "thrice"})) {
      more = true;
      ++as;
    } else if (word == "half") {
      less = true;
      ++as;
    } else if (WordAt(*tokens, at + 1) == "times" || (*tokens)[at].kind == TokenKind::kNumber) {
      more = true;
      as += WordAt(*tokens, at + 1) == "times" ? 2 : 1;
    } else if (word == "not" || word == "nowhere" || word == "hardly") {
      less = true;
      ++as;
      while (IsOneOf(WordAt(*tokens, as), {"nearly", "quite", "near", "half"})) ++as;
    }
    if (!(more || less) || WordAt(*tokens, as) != "as" ||
        !IsOneOf(WordAt(*tokens, as + 1), {"much", "many"})) {
      continue;
    }
    std::size_t than = as + 2;
    while (than < tokens->size() && than < as + 2 + kReach && WordAt(*tokens, than) != "as") {
      if (IsPauseAt(*tokens, than)) break;
      ++than;
    }
    if (WordAt(*tokens, than) != "as") continue;
    (*tokens)[than].text = "than";
    const Token first = (*tokens)[at];
    EraseTokens(tokens, at, as + 2 - at);
    InsertTokens(tokens, at, {WordLike(more ? "more" : "less", first)});
  }
}

// "the bigger is in the north, the smaller in the south": the bigger one.
void TurnComparatives(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const bool compared =
        WordAt(*tokens, at) == "the" &&
        IsOneOf(WordAt(*tokens, at + 1), {"bigger", "smaller", "larger", "biggest", "smallest",
                                          "largest", "longer", "shorter", "wider", "narrower"});
    const bool alone =
        IsOneOf(WordAt(*tokens, at + 2),
                {"is", "in", "lies", "at", "to", "should", "sits", "stands", "on", "goes", "must",
                 "shall", "runs", "near", "by", "towards", "toward"});
    if (!compared || !alone) continue;
    InsertTokens(tokens, at + 2, {WordLike("one", (*tokens)[at + 1])});
  }
}

// "neither the top right nor the bottom left has a single tree": both have none. "where the
// diagonals cross": in the center. "One goes from ...": somebody does.
void TurnNegations(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 14;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    // "neither the top right nor the bottom left has a tree": in both there is none.
    if (word == "neither") {
      std::size_t nor = at + 1;
      while (nor < at + kReach && !IsPauseAt(*tokens, nor) && WordAt(*tokens, nor) != "nor") ++nor;
      PlaceCursor cursor(*tokens, at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1));
      std::size_t has = nor + 1;
      while (has < nor + kReach && !IsPauseAt(*tokens, has) &&
             !IsOneOf(WordAt(*tokens, has), {"has", "have", "holds", "contains", "bears"})) {
        ++has;
      }
      const bool places = TakeDirection(&cursor).found && WordAt(*tokens, nor) == "nor" &&
                          has < nor + kReach && !IsPauseAt(*tokens, has);
      if (!places) continue;
      std::size_t last = has + 1;
      if (IsOneOf(WordAt(*tokens, last), {"a", "any", "one"})) ++last;
      if (WordAt(*tokens, last) == "single") ++last;
      const Token verb = (*tokens)[has];
      EraseTokens(tokens, has, last - has);
      InsertTokens(tokens, has,
                   {WordLike("there", verb), WordLike("is", verb), WordLike("no", verb)});
      (*tokens)[nor].text = "and";
      (*tokens)[at].text = "in";
      if (at > 0 && !IsPauseAt(*tokens, at - 1)) continue;
    }
    // "where the diagonals cross": in the center.
    if (word == "where" && WordAt(*tokens, at + 2) == "diagonals" &&
        IsOneOf(WordAt(*tokens, at + 3), {"cross", "meet", "intersect"})) {
      const Token first = (*tokens)[at];
      EraseTokens(tokens, at, 4);
      InsertTokens(tokens, at,
                   {WordLike("in", first), WordLike("the", first), WordLike("center", first)});
    }
    // "One goes from": you go from.
    if (word == "one" && IsOneOf(WordAt(*tokens, at + 1), {"goes", "walks", "gets", "drives"}) &&
        WordAt(*tokens, at + 2) == "from") {
      (*tokens)[at].text = "you";
      (*tokens)[at + 1].text = "go";
    }
  }
}

// "no trees except along the river": only along it. "rocks, but none near the water": not near it.
// "snow above the middle, bushes below it": in the halves.
void TurnExceptions(std::vector<Token>* tokens) {
  bool middle = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if ((*tokens)[at].kind == TokenKind::kStop) middle = false;
    const std::string word(WordAt(*tokens, at));
    const auto is_relation = [&](std::size_t next) {
      return IsOneOf(WordAt(*tokens, next), {"along", "near", "by", "beside", "around", "next",
                                             "close", "alongside", "between"});
    };
    if (word == "no") {
      const ClassWordMatch noun = MatchClassWord(*tokens, at + 1);
      std::size_t next = at + 1 + noun.tokens;
      if (IsOneOf(WordAt(*tokens, next), {"anywhere", "at"})) {
        next += WordAt(*tokens, next) == "at" && WordAt(*tokens, next + 1) == "all" ? 2 : 1;
      }
      if (noun.word != nullptr && IsOneOf(WordAt(*tokens, next), {"except", "but", "save"}) &&
          is_relation(next + 1)) {
        (*tokens)[next].text = "only";
        EraseTokens(tokens, at, 1);
      }
    }
    if (word == "none" && at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"but", "and"}) &&
        is_relation(at + 1)) {
      (*tokens)[at].text = "not";
    }
    // A side of the middle.
    PlaceCursor cursor(*tokens, at);
    std::string side;
    std::size_t end = at;
    if (IsOneOf(word, {"above", "below", "beneath"})) {
      side = word == "above" ? "northern" : "southern";
      end = at + 1;
    } else if (const Direction direction = TakeDirection(&cursor);
               direction.found && !direction.heading.IsDiagonal() &&
               WordAt(*tokens, cursor.at()) == "of") {
      const Heading heading = direction.heading;
      side = heading.south < 0   ? "northern"
             : heading.south > 0 ? "southern"
             : heading.east > 0  ? "eastern"
             : heading.east < 0  ? "western"
                                 : "";
      end = cursor.at() + 1;
    }
    if (side.empty()) continue;
    const bool again = middle && WordAt(*tokens, end) == "it";
    std::size_t last = end;
    if (WordAt(*tokens, last) == "the") ++last;
    const bool line = IsOneOf(WordAt(*tokens, last),
                              {"middle", "centre", "center", "midline", "equator", "halfway"});
    if (line) {
      ++last;
      if (WordAt(*tokens, last) == "line") ++last;
      const bool of_other = WordAt(*tokens, last) == "of";
      if (of_other) continue;
    }
    if (!line && !again) continue;
    if (again) last = end + 1;
    middle = true;
    std::size_t first = at;
    if (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"the"})) --first;
    if (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"to", "on", "in", "just"})) --first;
    ReplaceTokens(tokens, first, last - first, {"in", "the", side, "half"});
    at = first + 3;
  }
}

// "everything that is not lake or road is forest": these, and elsewhere forest. "going up the map":
// north.
void TurnExclusions(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 14;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    const bool goes = IsOneOf(word, {"going", "moving", "walking", "travelling", "traveling",
                                     "reading", "heading", "driving", "looking"});
    const std::string way(WordAt(*tokens, at + 1));
    if (goes && IsOneOf(way, {"up", "upward", "upwards", "down", "downward", "downwards"})) {
      std::size_t end = at + 2;
      if (WordAt(*tokens, end) == "the") ++end;
      const bool map = IsMapWord(WordAt(*tokens, end));
      if (map) ++end;
      if (map || IsPauseAt(*tokens, at + 2)) {
        ReplaceTokens(tokens, at + 1, end - at - 1, {way[0] == 'u' ? "north" : "south"});
      }
    }
    if (!IsOneOf(word, {"everything", "all", "whatever", "anything", "land", "ground"})) continue;
    std::size_t next = at + 1;
    if (IsOneOf(WordAt(*tokens, next), {"that", "which"})) ++next;
    if (!IsOneOf(WordAt(*tokens, next), {"is", "are"}) ||
        !IsOneOf(WordAt(*tokens, next + 1), {"not", "neither"})) {
      continue;
    }
    next += 2;
    std::size_t verb = next;
    while (verb < next + kReach &&
           !IsOneOf(WordAt(*tokens, verb), {"is", "should", "becomes", "shall", "must", "are"}) &&
           verb < tokens->size() && (*tokens)[verb].kind != TokenKind::kStop) {
      ++verb;
    }
    if (!IsOneOf(WordAt(*tokens, verb), {"is", "should", "becomes", "shall", "must", "are"})) {
      continue;
    }
    // Edits go from the end to the beginning, so that earlier positions stay valid.
    ReplaceTokens(tokens, verb, 1, {"elsewhere"});
    InsertTokens(tokens, verb,
                 {{TokenKind::kComma, ",", (*tokens)[verb].begin, (*tokens)[verb].begin}});
    for (std::size_t i = verb; i-- > next;) {
      if (IsOneOf(WordAt(*tokens, i), {"or", "nor"})) (*tokens)[i].text = "and";
      const ClassWordMatch noun = MatchClassWord(*tokens, i);
      const bool starts =
          noun.word != nullptr && (i == next || MatchClassWord(*tokens, i - 1).tokens < 2);
      if (starts && !IsOneOf(WordAt(*tokens, i - 1), {"the", "a", "an"})) {
        InsertTokens(tokens, i, {WordLike("the", (*tokens)[i])});
      }
    }
    EraseTokens(tokens, at, next - at);
  }
}

}  // namespace latticeworld
