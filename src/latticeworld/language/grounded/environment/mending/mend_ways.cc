#include "latticeworld/language/grounded/environment/mending/mend_ways.h"

#include <cstddef>
#include <string_view>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsRoad(std::string_view word) {
  return IsOneOf(word, {"road", "street", "path", "track", "lane", "trail", "way"});
}

bool IsRiver(std::string_view word) {
  return IsOneOf(word, {"river", "stream", "brook", "water", "creek", "canal"});
}

// The noun behind an article at `at`; "": there is none.
std::string_view NounAt(const std::vector<Token>& tokens, std::size_t at) {
  const bool article = IsOneOf(WordAt(tokens, at), {"the", "a", "our", "this"});
  return article ? WordAt(tokens, at + 1) : std::string_view();
}

// The token behind a verb of ways that lead to land, as "enters", "comes into"; `at`: no such verb.
std::size_t LeadsTo(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"enters", "leaves", "reaches", "meets", "touches", "passes"})) {
    return at + 1;
  }
  const bool goes = IsOneOf(WordAt(tokens, at), {"comes", "goes", "runs", "leads", "turns"});
  if (!goes) return at;
  if (IsOneOf(WordAt(tokens, at + 1), {"into", "to", "past"})) return at + 2;
  const bool out = WordAt(tokens, at + 1) == "out" && WordAt(tokens, at + 2) == "of";
  return out ? at + 3 : at;
}

// "Where the road crosses the river": at the bridge. "Where the road enters the village": on the
// road by the village.
void MendWhere(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 6 <= tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "where") continue;
    const std::string_view way = NounAt(*tokens, at + 1);
    const std::size_t verb = at + 3;
    const bool crosses = IsOneOf(WordAt(*tokens, verb), {"crosses", "meets", "bridges"});
    const std::string_view crossed = NounAt(*tokens, verb + 1);
    const bool led = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"above", "over", "near", "by"});
    if (crosses && ((IsRoad(way) && IsRiver(crossed)) || (IsRiver(way) && IsRoad(crossed)))) {
      ReplaceTokens(tokens, at, verb + 3 - at, {"at", "the", "bridge"});
      if (led) EraseTokens(tokens, at, 1);
      continue;
    }
    const std::size_t land = LeadsTo(*tokens, verb);
    const bool there =
        IsOneOf(NounAt(*tokens, land), {"village", "town", "settlement", "hamlet", "city", "forest",
                                        "wood", "woods", "fields", "mountains", "desert"}) &&
        WordAt(*tokens, land + 2) != "in";
    if (!IsRoad(way) || land == verb || !there) continue;
    ReplaceTokens(tokens, verb, land - verb, {"by"});
    ReplaceTokens(tokens, at, 1, {"on"});
    if (led) EraseTokens(tokens, at, 1);
  }
}

// "Halfway along the road", "two halfway": in the middle of the road, two in the middle.
void MendHalfway(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const bool apart = WordAt(*tokens, at) == "half" && WordAt(*tokens, at + 1) == "way";
    const std::size_t next = at + (apart ? 2 : 1);
    if (!apart && WordAt(*tokens, at) != "halfway") continue;
    if (IsOneOf(WordAt(*tokens, next), {"along", "down", "up"})) {
      ReplaceTokens(tokens, at, next + 1 - at, {"in", "the", "middle", "of"});
    } else if (IsPauseAt(*tokens, next)) {
      ReplaceTokens(tokens, at, next - at, {"in", "the", "middle"});
    }
  }
}

}  // namespace

void MendWays(std::vector<Token>* tokens) {
  MendWhere(tokens);
  MendHalfway(tokens);
}

}  // namespace latticeworld
