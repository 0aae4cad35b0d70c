#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Shares of all that there is.
namespace latticeworld {
namespace {

// "The rest is half fields and half grass": the rest is fields and grass, for half of it is not
// half of the map.
void TurnHalvedRest(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"rest", "remainder"}) || WordAt(*tokens, at + 1) != "is" ||
      WordAt(*tokens, at + 2) != "half") {
    return;
  }
  // "70 % forest, the rest is half water and half grass": of the other 30 %.
  double left = 1.0;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at;) {
    const ShareMatch share = MatchShare(*tokens, i);
    const bool number = share.tokens > 0 && share.fraction && !share.ordinal;
    if (number) left -= share.value;
    i += number ? share.tokens : std::size_t{1};
  }
  const bool percent = at > 0 && WordAt(*tokens, at - 1) == "the" && left > 0.0 && left < 1.0;
  const std::size_t and_at = at + 3 + MatchClassWord(*tokens, at + 3).tokens;
  if (and_at == at + 3 || WordAt(*tokens, and_at) != "and" || WordAt(*tokens, and_at + 1) != "half")
    return;
  if (percent) {
    const std::string number = std::to_string(std::lround(left * 100.0));
    ReplaceTokens(tokens, at, 1, {"remaining", number, "percent"});
    (*tokens)[at + 1].kind = TokenKind::kNumber;
    return;
  }
  EraseTokens(tokens, and_at + 1, 1);
  EraseTokens(tokens, at + 2, 1);
}

// "Equal amounts of forest and grass, and a little water": the water is none of the equal ones.
void TurnAfterEqual(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "equal" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"amounts", "parts", "shares"})) {
    return;
  }
  for (std::size_t i = at + 2; !IsStopAt(*tokens, i); ++i) {
    if (!IsMark(*tokens, i)) continue;
    const std::size_t next = i + (WordAt(*tokens, i + 1) == "and" ? 2 : 1);
    if (!IsOneOf(WordAt(*tokens, next), {"a", "some", "no", "one", "two", "three", "but", "with"}))
      continue;
    EraseTokens(tokens, i + 1, next - i - 1);
    (*tokens)[i] = StopLike((*tokens)[i]);
    return;
  }
}

// "The forest is larger than all the rest together": covers more than everything else together.
void TurnLargerThanAll(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "is" || !IsOneOf(WordAt(*tokens, at + 1), {"larger", "bigger"}) ||
      WordAt(*tokens, at + 2) != "than") {
    return;
  }
  std::size_t end = at + 3;
  while (IsOneOf(WordAt(*tokens, end), {"all", "the", "of", "rest", "everything", "else"})) ++end;
  if (end < at + 5 || !IsOneOf(WordAt(*tokens, end - 1), {"rest", "else"})) return;
  if (IsOneOf(WordAt(*tokens, end), {"together", "combined"})) ++end;
  if (!IsPauseAt(*tokens, end)) return;
  ReplaceTokens(tokens, at, end - at, {"covers", "more", "than", "everything", "else", "together"});
}

// "The four quarters are forest, grass, fields and water": equal parts of each.
void TurnQuartersAre(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "four" || WordAt(*tokens, at + 1) != "quarters") return;
  std::size_t next = at + 2;
  if (WordAt(*tokens, next) == "of" && IsMapWord(WordAt(*tokens, next + 2))) next += 3;
  if (WordAt(*tokens, next) != "are") return;
  ++next;
  std::size_t list = next;
  int named = 0;
  while (!IsStopAt(*tokens, list)) {
    const std::size_t length = MatchClassWord(*tokens, list).tokens;
    if (length == 0) return;
    ++named;
    list += length;
    if (IsMark(*tokens, list)) ++list;
    if (WordAt(*tokens, list) == "and") ++list;
  }
  if (named != 4) return;
  const std::size_t begin = at - (at > 0 && WordAt(*tokens, at - 1) == "the" ? 1 : 0);
  ReplaceTokens(tokens, begin, next - begin, {"equal", "parts"});
}

// "The border of the map is water, so it is an island": a sentence.
void TurnSoIsland(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || WordAt(*tokens, at + 1) != "so") return;
  std::size_t next = at + 2;
  if (WordAt(*tokens, next) == "that") ++next;
  if (WordAt(*tokens, next) != "it" || WordAt(*tokens, next + 1) != "is" ||
      WordAt(*tokens, next + 2) != "an" || WordAt(*tokens, next + 3) != "island") {
    return;
  }
  ReplaceTokens(tokens, at + 1, next + 2 - at - 1, {"there", "is"});
  (*tokens)[at] = StopLike((*tokens)[at]);
}

// "The village has a road to the north and one to the east": a road leads from the village to the
// northern edge, another one to the eastern edge. "Three roads: one to the north, one to the east":
// in the north, in the east.
void TurnRoadsTo(std::vector<Token>* tokens, std::size_t at) {
  const auto to_side = [&](std::size_t i) -> std::string_view {
    return WordAt(*tokens, i) == "to" && WordAt(*tokens, i + 1) == "the" &&
                   !SideWord(WordAt(*tokens, i + 2)).empty()
               ? SideWord(WordAt(*tokens, i + 2))
               : std::string_view();
  };
  // "Three roads: one to the north, ..."
  if (IsMark(*tokens, at) && (*tokens)[at].text == ":") {
    bool roads = false;
    for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i);)
      roads = roads || (MatchClassWord(*tokens, i).is_line() && MatchClassWord(*tokens, i).plural);
    if (!roads || WordAt(*tokens, at + 1) != "one" || to_side(at + 2).empty()) return;
    for (std::size_t i = at + 1; !IsStopAt(*tokens, i); ++i) {
      if (WordAt(*tokens, i) != "one" || to_side(i + 1).empty()) continue;
      ReplaceTokens(tokens, i, 2, {"in"});
    }
    EraseTokens(tokens, at, 1);
    return;
  }
  // "The village has a road to the north and one to the east"
  if (WordAt(*tokens, at) != "has" || WordAt(*tokens, at + 1) != "a" || at == 0) return;
  const ClassWordMatch line = MatchClassWord(*tokens, at + 2);
  const std::size_t first = at + 2 + line.tokens;
  const std::string one(to_side(first));
  if (!line.is_line() || one.empty() || WordAt(*tokens, first + 3) != "and" ||
      !IsOneOf(WordAt(*tokens, first + 4), {"one", "another"})) {
    return;
  }
  // Each road gets a sentence.
  const std::string other(to_side(first + 5));
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (other.empty() || named.empty() || named.front().end != at) return;
  const std::string owner = JoinWords(*tokens, named.front().begin, at);
  const std::string road = JoinWords(*tokens, at + 2, first);
  const Token beside = (*tokens)[at];
  const std::vector<Token> said =
      SaidLike("is here . a " + road + " leads from the " + owner + " to the " + one +
                   "ern edge . another " + road + " leads from the " + owner + " to the " + other +
                   "ern edge",
               beside);
  EraseTokens(tokens, at, first + 8 - at);
  InsertTokens(tokens, at, said);
}

}  // namespace

void TurnTotals(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnHalvedRest(tokens, at);
    TurnAfterEqual(tokens, at);
    TurnLargerThanAll(tokens, at);
    TurnQuartersAre(tokens, at);
    TurnSoIsland(tokens, at);
    TurnRoadsTo(tokens, at);
  }
}

}  // namespace latticeworld
