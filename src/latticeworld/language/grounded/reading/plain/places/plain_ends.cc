#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Ends of what runs.
namespace latticeworld {
namespace {

// "each end of", "either end of", "both ends of": the token behind it, or `at`.
std::size_t TakeEnds(const std::vector<Token>& tokens, std::size_t at) {
  const bool each = IsOneOf(WordAt(tokens, at), {"each", "either"}) &&
                    IsOneOf(WordAt(tokens, at + 1), {"end", "ends"});
  const bool both = WordAt(tokens, at) == "both" && WordAt(tokens, at + 1) == "ends";
  return each || both ? at + 2 : at;
}

// "Two villages, one at each end of the road": at each end of it. "A village at each end": two
// villages.
void TurnOneAtEachEnd(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "at" || TakeEnds(*tokens, at + 1) == at + 1) return;
  const bool one = at > 0 && ((*tokens)[at - 1].text == "one" || (*tokens)[at - 1].text == "1");
  if (one && at > 1 && (*tokens)[at - 2].kind == TokenKind::kComma) {
    EraseTokens(tokens, at - 2, 2);
    return;
  }
  constexpr std::size_t kLongest = 4;
  for (std::size_t back = 1; back <= kLongest && back <= at; ++back) {
    const std::size_t article = at - back;
    if (!IsOneOf(WordAt(*tokens, article), {"a", "an", "one"})) continue;
    for (std::size_t noun = article + 1; noun < at; ++noun) {
      const ClassWordMatch match = MatchClassWord(*tokens, noun);
      if (match.word == nullptr || noun + match.tokens != at) continue;
      if (match.word->shape == WordShape::kThing) ReplaceTokens(tokens, article, 1, {"two"});
      return;
    }
    return;
  }
}

// "Roads leave the town in all four directions": they run from the town to the four edges.
void TurnAllDirections(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "in") return;
  std::size_t end = at + 1;
  if (!IsOneOf(WordAt(*tokens, end), {"all", "every"})) return;
  ++end;
  if (end < tokens->size() && (WordAt(*tokens, end) == "four" || (*tokens)[end].text == "4")) ++end;
  if (!IsOneOf(WordAt(*tokens, end), {"direction", "directions"})) return;
  ++end;
  std::size_t verb = at;
  while (verb > 0 && !IsPauseAt(*tokens, verb - 1) &&
         !IsOneOf(WordAt(*tokens, verb), {"leave", "leaves", "leaving", "lead", "leading", "run",
                                          "running", "go", "going", "radiate", "radiating"})) {
    --verb;
  }
  const bool leaves = IsOneOf(WordAt(*tokens, verb), {"leave", "leaves", "leaving"});
  if (verb == 0 || MatchClassWord(*tokens, verb).word != nullptr) return;
  const ClassWordMatch line = MatchClassWord(*tokens, verb - 1);
  if (line.word == nullptr || line.word->shape != WordShape::kLine) return;
  const bool owned = verb + 1 < at;  // "from the town", "the town"
  if (!owned && !leaves) return;
  ReplaceTokens(tokens, at, end - at,
                {"to", "the", "northern", "edge", "the", "southern", "edge", "the", "eastern",
                 "edge", "and", "the", "western", "edge"});
  const Token comma = CommaLike((*tokens)[at]);
  InsertTokens(tokens, at + 10, {comma});
  InsertTokens(tokens, at + 7, {comma});
  InsertTokens(tokens, at + 4, {comma});
  if (leaves) ReplaceTokens(tokens, verb, 1, {"run", "from"});
}

// "Leads into the village and ends there": which it does. "Flows towards the center, where it ends
// in a pond": to the center, and ends in a pond. "From the village going north to the edge": to the
// northern edge. "Splits into two branches": it is one river.
void TurnLastWords(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  const auto ends = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i), {"ends", "stops", "terminates", "finishes"});
  };
  if (word == "and" && ends(at + 1) && WordAt(*tokens, at + 2) == "there" &&
      IsPauseAt(*tokens, at + 3)) {
    EraseTokens(tokens, at, 3);
    return;
  }
  if (word == "where" && WordAt(*tokens, at + 1) == "it" && ends(at + 2) && at > 0 &&
      (*tokens)[at - 1].kind == TokenKind::kComma) {
    if (IsPauseAt(*tokens, at + 3)) {
      EraseTokens(tokens, at - 1, 4);
      return;
    }
    for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i);)
      if (IsOneOf(WordAt(*tokens, i), {"towards", "toward"})) (*tokens)[i].text = "to";
    ReplaceTokens(tokens, at - 1, 3, {"and"});
    return;
  }
  if (const std::string side(SideWord(word));
      !side.empty() && WordAt(*tokens, at + 1) == "to" && WordAt(*tokens, at + 2) == "the" &&
      WordAt(*tokens, at + 3) == "edge" && (at == 0 || WordAt(*tokens, at - 1) != "the") &&
      WordAt(*tokens, at + 4) != "of") {
    const bool going =
        at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"going", "running", "leading", "heading"});
    const std::size_t begin = at - (going ? 1 : 0);
    const std::string edge = side + "ern";
    ReplaceTokens(tokens, begin, at + 4 - begin, {"to", "the", edge, "edge"});
    return;
  }
  if (IsOneOf(word, {"splits", "divides", "forks"}) && WordAt(*tokens, at + 1) == "into" &&
      IsOneOf(WordAt(*tokens, at + 2), {"two", "three", "several"}) &&
      IsOneOf(WordAt(*tokens, at + 3), {"branches", "arms", "channels"})) {
    const bool linked = at > 0 && WordAt(*tokens, at - 1) == "and";
    EraseTokens(tokens, at - (linked ? 1 : 0), linked ? 5 : 4);
  }
}

}  // namespace

void TurnEnds(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnOneAtEachEnd(tokens, at);
    TurnAllDirections(tokens, at);
    TurnLastWords(tokens, at);
  }
}

}  // namespace latticeworld
