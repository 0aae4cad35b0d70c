#include "latticeworld/language/grounded/environment/mending/mend_sides.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// Returns where the land begins in "of the village", "of our little lake", which begins at `of`; 0:
// there is none.
std::size_t LandOf(const EnvironmentWords& words, const std::vector<Token>& tokens,
                   std::size_t of) {
  constexpr std::size_t kAdjectives = 2;
  if (WordAt(tokens, of) != "of") return 0;
  std::size_t land = of + 1;
  if (!IsOneOf(WordAt(tokens, land), {"the", "a", "our", "their", "this", "that", "its"})) return 0;
  ++land;
  for (const std::size_t end = land + kAdjectives; land <= end; ++land) {
    if (WordAt(tokens, land).empty() || words.species.LengthAt(tokens, land) > 0) return 0;
    if (words.features.LengthAt(tokens, land) > 0) return land;
    if (IsOneOf(WordAt(tokens, land), {"map", "scene", "picture", "world", "of", "and"})) return 0;
  }
  return 0;
}

// "To the north of the village", "left of the lake", "just to the right of the forest": north of
// the village, west of the lake, just east of the forest. "The left of the lake" is a part of it.
void MendBeside(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const bool left = WordAt(*tokens, at) == "left", right = WordAt(*tokens, at) == "right";
    const std::size_t heading = left || right                 ? 1
                                : WordAt(*tokens, at).empty() ? 0
                                                              : MatchHeading(*tokens, at).tokens;
    const std::size_t land = heading > 0 ? LandOf(words, *tokens, at + heading) : 0;
    if (land == 0) continue;
    const bool to = at > 1 && WordAt(*tokens, at - 1) == "the" && WordAt(*tokens, at - 2) == "to";
    const bool part = at > 0 && IsOneOf(WordAt(*tokens, at - 1),
                                        {"the", "upper", "lower", "top", "bottom", "far", "middle",
                                         "center", "centre", "north", "south", "go", "goes",
                                         "going", "turn", "turned", "our", "your"});
    if (!to && (part || !(left || right))) continue;
    // "what is left of the forest"
    const bool rest = left && !to && at > 1 && WordAt(*tokens, at - 1) == "is" &&
                      (IsOneOf(WordAt(*tokens, at - 2), {"what", "all", "little", "nothing"}) ||
                       (WordAt(*tokens, at - 2) == "that" && at > 2 &&
                        IsOneOf(WordAt(*tokens, at - 3), {"all", "everything"})));
    if (rest) continue;
    // "the houses to the right of the lake": where those are.
    const std::size_t before = at - (to ? 2 : 0);
    if (before > 0 && !IsPauseAt(*tokens, before - 1) &&
        std::max(words.assets.LengthAt(*tokens, before - 1),
                 words.features.LengthAt(*tokens, before - 1)) > 0) {
      continue;
    }
    // No adjective stands between "of the" and the land.
    EraseTokens(tokens, at + heading + 2, land - at - heading - 2);
    if (left || right) (*tokens)[at].text = left ? "west" : "east";
    if (to) EraseTokens(tokens, at - 2, 2);
  }
}

}  // namespace

void MendSides(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendBeside(words, tokens);
}

}  // namespace latticeworld
