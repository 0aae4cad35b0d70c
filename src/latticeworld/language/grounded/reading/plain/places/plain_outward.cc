#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// What lies around, behind and beside something that was named before.
namespace latticeworld {
namespace {

void PutWords(std::vector<Token>* turned, const std::vector<std::string_view>& words,
              const Token& beside) {
  for (const std::string_view word : words) turned->push_back(WordLike(word, beside));
}

void Put(std::vector<Token>* turned, const std::vector<Token>& words, const Token& beside) {
  for (const Token& token : words) turned->push_back(WordLike(token.text, beside));
}

// The last noun in tokens [begin, end); empty: none.
std::vector<Token> LastNoun(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
  std::vector<Token> noun;
  for (std::size_t at = begin; at < end; ++at) {
    const ClassWordMatch match = MatchClassWord(tokens, at);
    if (match.word == nullptr || at + match.tokens > end) continue;
    noun = TokensBetween(tokens, at, at + match.tokens);
    at += match.tokens - 1;
  }
  return noun;
}

// "to its west", "on its western side": the token after it; 0: none of these.
std::size_t TakeOwnSide(const std::vector<Token>& tokens, std::size_t at, Heading* heading) {
  const bool own = IsOneOf(WordAt(tokens, at), {"to", "on", "at"}) &&
                   IsOneOf(WordAt(tokens, at + 1), {"its", "their"});
  if (!own) return 0;
  const std::size_t end = TakeHeading(tokens, at + 1, heading);
  if (end == 0) return 0;
  return IsFlank(WordAt(tokens, end)) ? end + 1 : end;
}

// "The town lies between the river to its west and the wood to its east": between the two; the
// river is to the west of the town, the wood to the east of it.
void TurnOwnersBetween(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 4 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "between") continue;
    const std::size_t begin = SentenceBegin(*tokens, at);
    const std::vector<Token> subject = LastNoun(*tokens, begin, at);
    if (subject.empty()) continue;
    // "the river to its west" leaves the river; its side is told in a sentence of its own.
    std::vector<Token> sides;
    std::size_t noun = 0;  // [noun, end_of_noun)
    std::size_t end_of_noun = 0;
    bool both = false;
    for (std::size_t i = at + 1; !IsStopAt(*tokens, i); ++i) {
      const ClassWordMatch match = MatchClassWord(*tokens, i);
      if (match.word != nullptr) {
        both = both || noun > 0;
        noun = i;
        end_of_noun = i + match.tokens;
        i = end_of_noun - 1;
        continue;
      }
      Heading heading;
      const std::size_t end = noun > 0 && i == end_of_noun ? TakeOwnSide(*tokens, i, &heading) : 0;
      if (end == 0) {
        if (both && IsPauseAt(*tokens, i)) break;
        continue;
      }
      const Token beside = (*tokens)[i];
      sides.push_back({TokenKind::kStop, ".", beside.begin, beside.begin});
      PutWords(&sides, {"the"}, beside);
      Put(&sides, TokensBetween(*tokens, noun, noun + end_of_noun - noun), beside);
      PutWords(&sides, {"is", "to", "the", NameOf(heading), "of", "the"}, beside);
      Put(&sides, subject, beside);
      EraseTokens(tokens, i, end - i);
      --i;
    }
    // These sentences follow the one that they come from.
    if (sides.empty()) continue;
    std::size_t stop = at;
    while (!IsStopAt(*tokens, stop)) ++stop;
    InsertTokens(tokens, stop, sides);
    at = stop + sides.size();
  }
}

// "Around it woods, and outside of that only fields": around the woods.
void TurnOuterRings(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    const bool outside = WordAt(*tokens, at) == "outside";
    if (!outside && WordAt(*tokens, at) != "beyond") continue;
    const std::size_t that = at + (WordAt(*tokens, at + 1) == "of" ? 2 : 1);
    if (!IsOneOf(WordAt(*tokens, that), {"that", "this"})) continue;
    std::size_t next = that + 1;
    if (IsOneOf(WordAt(*tokens, next), {"ring", "circle", "loop", "belt"})) ++next;
    if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
    const bool fronted = IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
    if (IsPauseAt(*tokens, next)) continue;
    if (!fronted) continue;
    // The ring before stands in the sentence before at the farthest.
    std::size_t begin = SentenceBegin(*tokens, at);
    if (begin > 0) begin = SentenceBegin(*tokens, begin - 1);
    bool ring = false;
    for (std::size_t i = begin; i < at; ++i) {
      ring = ring || IsOneOf(WordAt(*tokens, i),
                             {"around", "round", "surrounding", "surrounded", "surrounds", "ring",
                              "ringed", "encircled", "encircling", "circled", "belt"});
    }
    const std::vector<Token> inner = LastNoun(*tokens, begin, at);
    if (inner.empty() || (!ring && !outside)) continue;
    const Token beside = (*tokens)[at];
    while (IsOneOf(WordAt(*tokens, next), {"there", "is", "are", "should", "be", "comes", "only",
                                           "lies", "just", "come", "lie", "nothing", "but"})) {
      ++next;
    }
    std::size_t first = at;
    if (WordAt(*tokens, first - 1) == "and") --first;
    if (first > 0 && IsPauseAt(*tokens, first - 1)) --first;
    std::vector<Token> turned = {{TokenKind::kStop, ".", beside.begin, beside.begin}};
    PutWords(&turned, {"around", "the"}, beside);
    Put(&turned, inner, beside);
    PutWords(&turned, {"there", "is"}, beside);
    EraseTokens(tokens, first, next - first);
    InsertTokens(tokens, first, turned);
    at = first + turned.size();
  }
}

// A side of the map and what lies along it.
struct Edge {
  Heading heading;
  std::vector<Token> noun;
};

// The edge that the words before `end` name last, in their sentence or the one before: "along the
// southern edge there is a beach"; (0, 0): none.
Edge EdgeBefore(const std::vector<Token>& tokens, std::size_t end) {
  std::size_t begin = SentenceBegin(tokens, end);
  if (begin > 0) begin = SentenceBegin(tokens, begin - 1);
  Edge edge;
  for (std::size_t at = begin; at < end; ++at) {
    if (!IsOneOf(WordAt(tokens, at), {"along", "on", "at", "in", "by"})) continue;
    if (WordAt(tokens, at + 1) == "its") continue;
    Heading heading;
    const std::size_t after = TakeHeading(tokens, at + 1, &heading);
    if (after == 0 || after > end || WordAt(tokens, after) == "of") continue;
    edge.heading = heading;
  }
  // "a strip of sand along the west coast": the sand.
  for (std::size_t at = begin; at < end; ++at) {
    const ClassWordMatch match = MatchClassWord(tokens, at);
    if (match.word == nullptr || at + match.tokens > end) continue;
    const bool side = at > begin && IsOneOf(WordAt(tokens, at), {"coast", "coastline", "shore"});
    if (!side || edge.noun.empty()) edge.noun = TokensBetween(tokens, at, at + match.tokens);
    at += match.tokens - 1;
  }
  return edge;
}

// The things that follow each other from `at` to a stop, "grass, then forest": where the words of
// each begin and end; false: it is no such list.
bool TakeSteps(const std::vector<Token>& tokens, std::size_t at, std::vector<std::size_t>* firsts,
               std::vector<std::size_t>* lasts, std::size_t* end) {
  constexpr std::size_t kLongest = 4;
  std::size_t i = at;
  while (true) {
    while (IsOneOf(WordAt(tokens, i),
                   {"there", "is", "are", "comes", "come", "lies", "and", "then", "finally",
                    "followed", "by", "follows", "after", "that", "you", "find"}) ||
           (i > at && IsMark(tokens, i))) {
      ++i;
    }
    if (IsStopAt(tokens, i)) break;
    const std::size_t first = i;
    ClassWordMatch match;
    for (; i < first + kLongest && !IsPauseAt(tokens, i); ++i) {
      match = MatchClassWord(tokens, i);
      if (match.word != nullptr) break;
    }
    if (match.word == nullptr) return false;
    i += match.tokens;
    if (!IsPauseAt(tokens, i) && !IsOneOf(WordAt(tokens, i), {"and", "then", "followed"})) {
      return false;
    }
    firsts->push_back(first);
    lasts->push_back(i);
  }
  *end = i;
  return !firsts->empty();
}

// "Along the southern edge a beach; inland from it grass, then forest": to the north of the beach
// grass, to the north of the grass forest.
void TurnInland(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    // "inland", or "behind it", at the beginning of a clause
    std::size_t next = at;
    while (IsOneOf(WordAt(*tokens, next), {"further", "farther"})) ++next;
    const bool inland = WordAt(*tokens, next) == "inland";
    const bool behind = next == at && WordAt(*tokens, at) == "behind" &&
                        IsOneOf(WordAt(*tokens, at + 1), {"it", "that", "this", "them"});
    if (!inland && !behind) continue;
    const bool fronted = IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
    if (!fronted) continue;
    // The last edge that was named, and what lies along it, give way and beginning.
    const Edge edge = EdgeBefore(*tokens, at);
    const bool known = (edge.heading.east != 0) != (edge.heading.south != 0);
    if (!known || edge.noun.empty()) continue;
    // "inland from it, ..."
    std::size_t after = next + (behind ? 2 : 1);
    if (inland && IsOneOf(WordAt(*tokens, after), {"from", "of", "behind"})) {
      ++after;
      while (!IsPauseAt(*tokens, after) &&
             (IsOneOf(WordAt(*tokens, after), {"it", "that", "this", "there", "the", "here"}) ||
              WordAt(*tokens, after) == edge.noun.back().text)) {
        ++after;
      }
    }
    if (after < tokens->size() && (*tokens)[after].kind == TokenKind::kComma) ++after;
    // Each step on the way gets a sentence that tells it from the one before.
    std::vector<std::size_t> firsts;
    std::vector<std::size_t> lasts;
    std::size_t end = 0;
    if (!TakeSteps(*tokens, after, &firsts, &lasts, &end)) continue;
    const std::string_view way = NameOf({-edge.heading.east, -edge.heading.south});
    std::vector<Token> turned;
    std::vector<Token> last = edge.noun;
    for (std::size_t i = 0; i < firsts.size(); ++i) {
      const std::vector<Token> step =
          TokensBetween(*tokens, firsts[i], firsts[i] + lasts[i] - firsts[i]);
      const Token beside = step.front();
      turned.push_back({TokenKind::kStop, ".", beside.begin, beside.begin});
      PutWords(&turned, {"to", "the", way, "of", "the"}, beside);
      Put(&turned, last, beside);
      PutWords(&turned, {"there", "is"}, beside);
      turned.insert(turned.end(), step.begin(), step.end());
      last = LastNoun(step, 0, step.size());
    }
    std::size_t first = at;
    if (WordAt(*tokens, first - 1) == "and") --first;
    if (first > 0 && IsPauseAt(*tokens, first - 1)) --first;
    EraseTokens(tokens, first, end - first);
    InsertTokens(tokens, first, turned);
    at = first + turned.size();
  }
}

// "A lake along the eastern side, with forest on its far shore": on its eastern shore, which is
// far from the middle of the map.
void TurnFarShores(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    const bool far = IsOneOf(WordAt(*tokens, at), {"far", "farther", "further", "outer"});
    const bool near = IsOneOf(WordAt(*tokens, at), {"near", "nearer", "inner"});
    if ((!far && !near) || !IsFlank(WordAt(*tokens, at + 1)) ||
        !IsOneOf(WordAt(*tokens, at - 1), {"its", "the"})) {
      continue;
    }
    if (!IsPauseAt(*tokens, at + 2) && !IsOneOf(WordAt(*tokens, at + 2), {"and", "is", "there"})) {
      continue;
    }
    const Edge edge = EdgeBefore(*tokens, at - 1);
    if (edge.heading.east == 0 && edge.heading.south == 0) continue;
    const Heading side = far ? edge.heading : Heading{-edge.heading.east, -edge.heading.south};
    (*tokens)[at - 1].text = "its";
    (*tokens)[at].text = NameOf(side);
  }
}

// "Houses line the road, and behind them are fields": next to the houses, on whichever side.
void TurnBehindRows(std::vector<Token>* tokens) {
  for (std::size_t at = 2; at + 1 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "behind") continue;
    const std::size_t begin = SentenceBegin(*tokens, at);
    std::vector<Token> row;
    bool lined = false;
    bool placed = false;
    for (std::size_t i = begin; i < at; ++i) {
      const ClassWordMatch match = MatchClassWord(*tokens, i);
      const bool line = match.word != nullptr && match.word->shape == WordShape::kLine;
      if (match.word != nullptr && !line) row = TokensBetween(*tokens, i, i + match.tokens);
      lined = lined || IsOneOf(WordAt(*tokens, i), {"line", "lining", "lined", "along"});
      Heading heading;
      placed = placed || (IsOneOf(WordAt(*tokens, i), {"the", "in", "to", "on"}) &&
                          TakeHeading(*tokens, i, &heading) > 0);
      if (match.word != nullptr) i += match.tokens - 1;
    }
    for (std::size_t i = at; !IsStopAt(*tokens, i); ++i) {
      placed = placed || IsOneOf(WordAt(*tokens, i), {"both", "either", "sides"});
    }
    if (!lined || placed || row.empty()) continue;
    std::size_t end = at + 1;
    if (IsOneOf(WordAt(*tokens, end), {"them", "these", "those"})) {
      ++end;
    } else if (WordAt(*tokens, end) == "the" && WordAt(*tokens, end + 1) == row.back().text) {
      end += 2;
    } else {
      continue;
    }
    const Token beside = (*tokens)[at];
    std::vector<Token> turned;
    PutWords(&turned, {"next", "to", "the"}, beside);
    Put(&turned, row, beside);
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
    at += turned.size();
  }
}

}  // namespace

void TurnOutward(std::vector<Token>* tokens) {
  TurnOwnersBetween(tokens);
  TurnOuterRings(tokens);
  TurnInland(tokens);
  TurnFarShores(tokens);
  TurnBehindRows(tokens);
}

}  // namespace latticeworld
