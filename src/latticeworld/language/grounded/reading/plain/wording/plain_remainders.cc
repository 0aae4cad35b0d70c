#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// The whole of the map, its halves and thirds, and what is left of it.
namespace latticeworld {
namespace {

// "of the map", "the land"
bool IsOfMap(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t whole = at;
  while (IsOneOf(WordAt(tokens, whole), {"of", "the"})) ++whole;
  return whole > at && IsMapWord(WordAt(tokens, whole));
}

// "A forest in the western half; the other half is grass", "the top third is forest, the other two
// thirds are water": the eastern half, the southern two thirds. "One half is water, the other half
// is forest", "half of the land is water, the other half forest": half of the map.
void TurnOtherPart(std::vector<Token>* tokens) {
  std::string side, part;
  // "one half", "half of the map"
  bool halved = WordAt(*tokens, 0) == "half" && IsOfMap(*tokens, 1);
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const std::string_view word = WordAt(*tokens, at);
    const bool half = word == "half";
    if (!half && !IsOneOf(word, {"third", "thirds", "quarter", "quarters"})) continue;
    const std::string said(SideWord(WordAt(*tokens, at - 1)));
    if (!said.empty()) {
      side = said;
      part = word;
      const bool corner = at > 1 && !SideWord(WordAt(*tokens, at - 2)).empty();
      if (corner) part = "corner";
      continue;
    }
    halved = halved || (half && (WordAt(*tokens, at - 1) == "one" || IsOfMap(*tokens, at + 1)));
    const std::size_t other = at - (half ? 1 : 2);
    if (other >= at || other == 0 || WordAt(*tokens, other - 1) != "the" ||
        !IsOneOf(WordAt(*tokens, other), {"other", "opposite", "remaining", "second"}) ||
        WordAt(*tokens, at + 1) == "of") {
      continue;
    }
    const bool rest =
        half ? part == "half"
             : (part == "third" && word == "thirds" && WordAt(*tokens, at - 1) == "two") ||
                   (part == "quarter" && word == "quarters" && WordAt(*tokens, at - 1) == "three");
    if (part == "corner" && word == "quarters") {
      EraseTokens(tokens, at, 1);  // "the other three"
    } else if (rest) {
      (*tokens)[other].text = std::string(OppositeOf(side)) + "ern";
      part.clear();
    } else if (half && halved && part.empty()) {
      ReplaceTokens(tokens, other - 1, 3, {"half", "of", "the", "map"});
      halved = false;
    }
  }
}

// "In the western third trees, in the middle third farms": in the middle columns. "The second
// third": the middle one. "Houses fill the whole map": fill the map.
void TurnMiddleThird(std::vector<Token>* tokens) {
  bool columns = false, rows = false;
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "third") continue;
    const std::string_view side = SideWord(WordAt(*tokens, at - 1));
    columns = columns || side == "east" || side == "west";
    rows = rows || side == "north" || side == "south";
  }
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const bool whole = IsOneOf(WordAt(*tokens, at), {"whole", "entire"}) && at > 1 &&
                       WordAt(*tokens, at - 1) == "the" && IsMapWord(WordAt(*tokens, at + 1)) &&
                       IsOneOf(WordAt(*tokens, at - 2), {"fill", "fills", "cover", "covers"});
    if (whole) EraseTokens(tokens, at, 1);
    if (WordAt(*tokens, at) != "third" || columns == rows) continue;
    if (!IsOneOf(WordAt(*tokens, at - 1), {"middle", "central", "center", "second"})) continue;
    const std::size_t the = at > 1 && WordAt(*tokens, at - 2) == "the" ? at - 2 : at - 1;
    if (the == 0 || !IsOneOf(WordAt(*tokens, the - 1), {"in", "on", "of", "across", "through"}))
      continue;
    (*tokens)[at - 1].text = "middle";
    (*tokens)[at].text = columns ? "columns" : "rows";
  }
}

// "The background is grass", "default terrain: forest", "a base of meadow", "grass fills in the
// gaps", "anything not mentioned is forest": the rest.
void TurnBase(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t the = IsOneOf(WordAt(*tokens, at), {"the", "a", "my", "our"}) ? 1 : 0;
  std::size_t next = at + the;
  if (IsOneOf(WordAt(*tokens, next), {"anything", "everything", "whatever", "what", "all"})) {
    const std::size_t first = next++;
    if (IsOneOf(WordAt(*tokens, next), {"that", "i"})) ++next;
    while (IsOneOf(WordAt(*tokens, next), {"is", "was", "has", "have", "did", "been"})) ++next;
    const bool denied = IsOneOf(WordAt(*tokens, next), {"not", "haven't", "didn't", "isn't"});
    if (IsOneOf(WordAt(*tokens, next), {"unmentioned", "unspecified", "unassigned", "empty"}) ||
        (denied && IsOneOf(WordAt(*tokens, next + 1),
                           {"mentioned", "specified", "mention", "specify", "assigned", "covered",
                            "named", "listed", "described", "used", "taken"}))) {
      ReplaceTokens(tokens, first, next + (denied ? 2 : 1) - first, {"everything", "else"});
    }
    return;
  }
  const bool opens = at == 0 || IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
  if (opens &&
      IsOneOf(WordAt(*tokens, next), {"background", "base", "default", "basis", "backdrop"})) {
    // If the text also names a foreground, the background is a place and no remainder.
    for (const Token& token : *tokens)
      if (token.kind == TokenKind::kWord && token.text == "foreground") return;
    ++next;
    if (IsOneOf(WordAt(*tokens, next),
                {"terrain", "land", "layer", "ground", "cover", "class", "tile", "type"})) {
      ++next;
    }
    const bool says = IsOneOf(WordAt(*tokens, next), {"is", "should", "shall", "will", "must"}) ||
                      (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma &&
                       (*tokens)[next].text == ":");
    if (says) ReplaceTokens(tokens, at, next - at, {"the", "rest"});
    return;
  }
  if (IsOneOf(WordAt(*tokens, at), {"gaps", "gap", "holes", "blanks"}) && at > 0) {
    std::size_t begin = at - (WordAt(*tokens, at - 1) == "the" ? 1 : 0);
    if (begin == 0 || begin == at) return;
    if (WordAt(*tokens, begin - 1) == "in") --begin;
    if (begin == 0 || !IsOneOf(WordAt(*tokens, begin - 1), {"fill", "fills", "filling"})) return;
    std::size_t end = at + 1;
    if (IsOneOf(WordAt(*tokens, end), {"between", "in"}) &&
        IsOneOf(WordAt(*tokens, end + 1), {"them", "these", "those", "between"})) {
      end += 2;
    }
    ReplaceTokens(tokens, begin, end - begin, {"the", "rest"});
  }
}

// "Divides the land into two halves, forest on the western side": crosses the map. "Two unequal
// halves": how large they are is told by the rest.
void TurnUnequal(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "two" && IsOneOf(WordAt(*tokens, at + 1), {"unequal", "uneven"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"parts", "halves", "pieces", "sides"})) {
    EraseTokens(tokens, at + 1, 1);
  }
  std::size_t next = at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, at), {"divides", "splits", "cuts", "parts", "bisects"}) ||
      !(IsMapWord(WordAt(*tokens, next)) ||
        IsOneOf(WordAt(*tokens, next), {"land", "country", "terrain", "region", "area", "valley",
                                        "landscape", "countryside"}))) {
    return;
  }
  ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"in", "into"}) || WordAt(*tokens, next + 1) != "two") return;
  next += 2;
  if (IsOneOf(WordAt(*tokens, next), {"unequal", "uneven", "equal"})) ++next;
  if (IsOneOf(WordAt(*tokens, next), {"parts", "halves", "pieces", "sides"})) ++next;
  const bool things_next = IsPauseAt(*tokens, next) && !IsStopAt(*tokens, next) &&
                           MatchClassWord(*tokens, next + 1).tokens > 0;
  Heading half;  // "...; the left one is forest": of TurnBanks
  if (next < tokens->size() && TakeHeading(*tokens, next + 1, &half) > 0) return;
  if (things_next) (*tokens)[next] = StopLike((*tokens)[next]);
  if (IsStopAt(*tokens, next)) ReplaceTokens(tokens, at, next - at, {"crosses", "the", "map"});
}

// "Split into two halves: forest and grass": half forest and half grass.
void TurnHalvesOf(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "two" || WordAt(*tokens, at + 1) != "halves" ||
      at + 2 >= tokens->size() || (*tokens)[at + 2].text != ":") {
    return;
  }
  const std::size_t first = at + 3, one = MatchClassWord(*tokens, first).tokens;
  const std::size_t second = first + one + 1, other = MatchClassWord(*tokens, second).tokens;
  if (one == 0 || other == 0 || !IsStopAt(*tokens, second + other) ||
      (WordAt(*tokens, second - 1) != "and" && (*tokens)[second - 1].kind != TokenKind::kComma)) {
    return;
  }
  InsertTokens(tokens, second, {WordLike("half", (*tokens)[second])});
  ReplaceTokens(tokens, at, 3, {"x", "half"});
  (*tokens)[at] = StopLike((*tokens)[at]);
}

// "Keep the center empty", "leave the middle open": the center is grass.
void TurnKeptEmpty(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"keep", "leave"})) return;
  PlaceCursor cursor(*tokens, at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0));
  if (!TakeDirection(&cursor).found) return;
  std::size_t end = cursor.at();
  if (IsOneOf(WordAt(*tokens, end), {"half", "third", "quarter", "corner", "part", "edge", "side"}))
    ++end;
  if (!IsOneOf(WordAt(*tokens, end), {"empty", "open", "clear", "free"}) ||
      !IsPauseAt(*tokens, end + 1)) {
    return;
  }
  ReplaceTokens(tokens, end, 1, {"is", "grass"});
  EraseTokens(tokens, at, 1);
}

// "An all-forest map": mostly forest. "A frame of trees around the whole map": at the edges.
void TurnWholeMap(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "all") {
    const std::size_t length = MatchClassWord(*tokens, at + 1).tokens;
    const std::size_t map = at + 1 + length;
    if (length == 0 || !IsMapWord(WordAt(*tokens, map))) return;
    const bool article = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"an", "a", "the"});
    EraseTokens(tokens, map, 1);
    ReplaceTokens(tokens, article ? at - 1 : at, article ? 2 : 1, {"mostly"});
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"around", "round"}) || WordAt(*tokens, at + 1) != "the")
    return;
  const std::size_t map = at + 2 + (IsOneOf(WordAt(*tokens, at + 2), {"whole", "entire"}) ? 1 : 0);
  if (IsMapWord(WordAt(*tokens, map)) && IsPauseAt(*tokens, map + 1))
    ReplaceTokens(tokens, at, map + 1 - at, {"at", "the", "edges"});
}

// "About a quarter water, the rest split evenly between forest and farmland": a sentence of its
// own. "The rest is land": which land, nobody says.
void TurnSplitRest(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "the" || !IsOneOf(WordAt(*tokens, at + 1), {"rest", "remainder"}))
    return;
  std::size_t next = at + 2;
  while (IsOneOf(WordAt(*tokens, next), {"is", "being", "should", "be", "gets", "to"})) ++next;
  if (IsOneOf(WordAt(*tokens, next), {"land", "dry"})) {
    next += WordAt(*tokens, next) == "dry" ? 2 : 1;
    if (WordAt(*tokens, next) == "with")
      ++next;
    else if (!IsPauseAt(*tokens, next))
      return;
    EraseTokens(tokens, at, next - at);
    return;
  }
  std::size_t evenly = next;
  const auto is_even = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i), {"evenly", "equally"});
  };
  if (is_even(evenly)) ++evenly;
  if (!IsOneOf(WordAt(*tokens, evenly), {"split", "divided", "shared"})) return;
  if (is_even(evenly + 1)) EraseTokens(tokens, evenly + 1, 1);
  if (evenly > next) EraseTokens(tokens, next, 1);
  if (at > 0 && (*tokens)[at - 1].kind == TokenKind::kComma)
    (*tokens)[at - 1] = StopLike((*tokens)[at - 1]);
}

// "Use meadow as filler", "where there is no road or house, put grass": the rest is.
void TurnFiller(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "use") {
    const std::size_t end = at + 1 + MatchClassWord(*tokens, at + 1).tokens;
    if (end == at + 1 || !IsOneOf(WordAt(*tokens, end), {"as", "for"})) return;
    const std::size_t what = end + 1 + (IsOneOf(WordAt(*tokens, end + 1), {"a", "the"}) ? 1 : 0);
    if (!IsOneOf(WordAt(*tokens, what), {"filler", "background", "base", "default"})) return;
    EraseTokens(tokens, end, what + 1 - end);
    ReplaceTokens(tokens, at, 1, {"the", "rest", "is"});
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"where", "wherever"}) || WordAt(*tokens, at + 1) != "there" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"is", "are"}) ||
      !IsOneOf(WordAt(*tokens, at + 3), {"no", "not"}) || (at > 0 && !IsStopAt(*tokens, at - 1))) {
    return;
  }
  std::size_t next = at + 4;
  while (!IsStopAt(*tokens, next)) {
    const std::size_t noun = MatchClassWord(*tokens, next).tokens;
    const bool link = (*tokens)[next].kind == TokenKind::kComma ||
                      IsOneOf(WordAt(*tokens, next), {"or", "and", "any", "a", "no"});
    if (noun == 0 && !link) break;
    next += noun == 0 ? 1 : noun;
  }
  std::size_t put = next;
  while (IsOneOf(WordAt(*tokens, put),
                 {"put", "use", "there", "should", "be", "is", "place", "it", "just", "have"})) {
    ++put;
  }
  // "where there is no water forest grows": a class word was taken for one of those.
  if (put == next || MatchClassWord(*tokens, put).tokens == 0) return;
  ReplaceTokens(tokens, at, put - at, {"the", "rest", "is"});
}

// "Everything except the lake is forest", "aside from a lake it is all forest": everything is
// forest except for the lake. "Surround everything with forest": forest at the edges.
void TurnEverythingExcept(std::vector<Token>* tokens, std::size_t at) {
  // "Surround everything with"
  if (WordAt(*tokens, at) == "surround" && WordAt(*tokens, at + 1) == "everything" &&
      IsOneOf(WordAt(*tokens, at + 2), {"with", "by"})) {
    const std::size_t end = PauseAfter(*tokens, at + 3);
    InsertTokens(tokens, end,
                 {WordLike("at", (*tokens)[at]), WordLike("the", (*tokens)[at]),
                  WordLike("edges", (*tokens)[at])});
    EraseTokens(tokens, at, 3);
    return;
  }
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  // "Everything except", "aside from"
  std::size_t thing = at;
  const bool everything = IsOneOf(WordAt(*tokens, at), {"everything", "all"});
  if (everything) {
    if (!IsOneOf(WordAt(*tokens, at + 1), {"except", "but"})) return;
    thing = at + 2 + (WordAt(*tokens, at + 2) == "for" ? 1 : 0);
  } else if (IsOneOf(WordAt(*tokens, at), {"apart", "aside"}) &&
             WordAt(*tokens, at + 1) == "from") {
    thing = at + 2;
  } else {
    return;
  }
  if (!IsOneOf(WordAt(*tokens, thing), {"the", "a", "an", "one"})) return;
  // The exception ends at the verb, or before the "it" of the second form.
  std::size_t is = thing;
  while (!IsPauseAt(*tokens, is) && !IsOneOf(WordAt(*tokens, is), {"is", "should", "must"})) ++is;
  if (IsPauseAt(*tokens, is)) return;
  const bool it = WordAt(*tokens, is - 1) == "it";
  if (it == everything) return;
  const std::vector<Token> exception = TokensBetween(*tokens, thing, is - (it ? 1 : 0));
  std::size_t what = is + 1;
  while (IsOneOf(WordAt(*tokens, what), {"be", "all", "just", "only"})) ++what;
  const std::size_t end = PauseAfter(*tokens, what);
  if (MatchClassWord(*tokens, what).tokens == 0) return;
  // Everything is that, except for the exception.
  const Token beside = (*tokens)[at];
  std::vector<Token> said = {WordLike("everything", beside), WordLike("is", beside)};
  for (const Token& token : TokensBetween(*tokens, what, end)) said.push_back(token);
  for (const std::string_view word : {"except", "for"}) said.push_back(WordLike(word, beside));
  said.insert(said.end(), exception.begin(), exception.end());
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

}  // namespace

void TurnRemainders(std::vector<Token>* tokens) {
  TurnOtherPart(tokens);
  TurnMiddleThird(tokens);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnBase(tokens, at);
    TurnUnequal(tokens, at);
    TurnHalvesOf(tokens, at);
    TurnKeptEmpty(tokens, at);
    TurnWholeMap(tokens, at);
    TurnSplitRest(tokens, at);
    TurnFiller(tokens, at);
    TurnEverythingExcept(tokens, at);
  }
}

}  // namespace latticeworld
