#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// How far what is said reaches: to the whole map, or to one of the things that were named.
namespace latticeworld {
namespace {

// "The far north is woods and there is no rock anywhere": no rock on the whole map, not in the
// north alone.
void TurnAnywhere(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "anywhere" || !IsPauseAt(*tokens, at + 1)) return;
  constexpr std::size_t kReach = 5;
  for (std::size_t no = at; no-- > 0 && no + kReach > at;) {
    if (IsPauseAt(*tokens, no)) return;
    if (WordAt(*tokens, no) != "no") continue;
    std::size_t begin = no;
    while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"is", "are", "there"})) --begin;
    if (begin > 0 && WordAt(*tokens, begin - 1) == "and") --begin;
    if (begin > 0 && (*tokens)[begin - 1].kind == TokenKind::kComma) --begin;
    if (begin == no || begin == 0 || IsStopAt(*tokens, begin - 1)) return;
    const Token stop = StopLike((*tokens)[begin]);
    EraseTokens(tokens, begin, no - begin);
    InsertTokens(tokens, begin, {stop});
    return;
  }
}

// "More sand than grass, and the water only in the north-west": the water alone. "Joined by roads
// that meet in the center": the roads do.
void TurnClauseOfItsOwn(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0) return;
  if ((*tokens)[at].kind == TokenKind::kComma && WordAt(*tokens, at + 1) == "and" &&
      WordAt(*tokens, at + 2) == "the") {
    const std::size_t length = MatchClassWord(*tokens, at + 3).tokens;
    const std::size_t only = at + 3 + length;
    if (length > 0 && WordAt(*tokens, only) == "only" &&
        IsOneOf(WordAt(*tokens, only + 1), {"in", "at", "on", "along"})) {
      const Token stop = StopLike((*tokens)[at]);
      EraseTokens(tokens, at, 2);
      InsertTokens(tokens, at, {stop});
    }
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"that", "which"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"meet", "cross", "intersect", "join"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"in", "at", "near"})) {
    return;
  }
  constexpr std::size_t kLongest = 3;
  for (std::size_t length = 1; length <= kLongest && length < at; ++length) {
    const ClassWordMatch line = MatchClassWord(*tokens, at - length);
    const bool joins = line.word != nullptr && line.tokens == length &&
                       line.word->shape == WordShape::kLine &&
                       WordAt(*tokens, at - length - 1) == "by";
    if (!joins) continue;
    std::vector<Token> said = {StopLike((*tokens)[at])};
    for (std::size_t i = at - length; i < at; ++i) said.push_back((*tokens)[i]);
    ReplaceTokens(tokens, at, 2, {"meet"});
    InsertTokens(tokens, at, said);
    return;
  }
}

// "And no people live there", "nobody lives here": no houses.
void TurnUninhabited(std::vector<Token>* tokens, std::size_t at) {
  std::size_t verb = at;
  if (WordAt(*tokens, at) == "nobody") {
    verb = at + 1;
  } else if (WordAt(*tokens, at) == "no" && IsOneOf(WordAt(*tokens, at + 1), {"one", "people"})) {
    verb = at + 2;
  } else {
    return;
  }
  if (!IsOneOf(WordAt(*tokens, verb), {"live", "lives", "living", "dwells", "dwell"})) return;
  std::size_t end = verb + 1;
  if (IsOneOf(WordAt(*tokens, end), {"there", "here", "anywhere"})) ++end;
  if (WordAt(*tokens, end) == "on" && IsOneOf(WordAt(*tokens, end + 1), {"it", "them"})) end += 2;
  if (!IsPauseAt(*tokens, end)) return;
  ReplaceTokens(tokens, at, end - at, {"no", "houses"});
  std::size_t begin = at;
  if (begin > 0 && WordAt(*tokens, begin - 1) == "and") --begin;
  if (begin > 0 && (*tokens)[begin - 1].kind == TokenKind::kComma) --begin;
  if (begin == at || begin == 0) return;
  const Token stop = StopLike((*tokens)[begin]);
  EraseTokens(tokens, begin, at - begin);
  InsertTokens(tokens, begin, {stop});
}

// "..., and nothing but grass in between": grass, of which the map is not full.
void TurnNothingBetween(std::vector<Token>* tokens, std::size_t at) {
  const bool nothing = WordAt(*tokens, at) == "nothing" && WordAt(*tokens, at + 1) == "but";
  const bool only = IsOneOf(WordAt(*tokens, at), {"only", "just"});
  if (at == 0 || (!nothing && !only)) return;
  constexpr std::size_t kReach = 9;
  for (std::size_t i = at + 2; i < at + kReach && !IsPauseAt(*tokens, i); ++i) {
    const bool between = WordAt(*tokens, i) == "between" &&
                         (IsPauseAt(*tokens, i + 1) ||
                          (IsOneOf(WordAt(*tokens, i + 1), {"them", "these", "those"}) &&
                           IsPauseAt(*tokens, i + 2)));
    if (!between) continue;
    // "under our boots" and the like say nothing of the land.
    const std::size_t noun = at + (nothing ? 2 : 1);
    const std::size_t length = MatchClassWord(*tokens, noun).tokens;
    if (length == 0) return;
    const std::size_t in = WordAt(*tokens, i - 1) == "in" ? i - 1 : i;
    if (in > noun + length) EraseTokens(tokens, noun + length, in - (noun + length));
    EraseTokens(tokens, at, noun - at);
    return;
  }
}

// "On our left as we walked north": on the left.
void TurnWalked(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"as", "when", "while"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"we", "you", "i"})) {
    return;
  }
  std::size_t verb = at + 2;
  if (IsOneOf(WordAt(*tokens, verb), {"are", "were", "was", "am"})) ++verb;
  if (!IsOneOf(WordAt(*tokens, verb),
               {"walk",    "walked", "walking", "go",      "went", "going",  "drive",   "drove",
                "driving", "head",   "headed",  "heading", "look", "looked", "looking", "face",
                "faced",   "facing", "hike",    "hiked",   "ride", "rode"})) {
    return;
  }
  Heading heading;
  const std::size_t end = TakeHeading(*tokens, verb + 1, &heading);
  // Only who looks north has the west on the left.
  if (end > 0 && NameOf(heading) == "north" && IsPauseAt(*tokens, end))
    EraseTokens(tokens, at, end - at);
}

// "The town has a river on its north side and fields on every other side": fields around the town.
void TurnEveryOther(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"on", "to"})) return;
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) == "every" || WordAt(*tokens, next) == "all") {
    ++next;
    if (WordAt(*tokens, next) == "the") ++next;
    if (WordAt(*tokens, next) != "other") return;
    ++next;
  } else if (WordAt(*tokens, next) == "the" && WordAt(*tokens, next + 1) == "other" &&
             IsOneOf(WordAt(*tokens, next + 2), {"three", "two", "sides"})) {
    next += WordAt(*tokens, next + 2) == "sides" ? 2 : 3;
  } else {
    return;
  }
  if (!IsOneOf(WordAt(*tokens, next), {"side", "sides"}) || !IsPauseAt(*tokens, next + 1)) return;
  // It lies around what the sentence is about: the first thing in it.
  std::size_t begin = SentenceBegin(*tokens, at);
  while (begin < at && MatchClassWord(*tokens, begin).tokens == 0) ++begin;
  const std::size_t length = MatchClassWord(*tokens, begin).tokens;
  if (begin + length > at) return;
  std::vector<std::string> thing;
  for (std::size_t i = begin; i < begin + length; ++i) thing.push_back((*tokens)[i].text);
  std::vector<std::string_view> said = {"around", "the"};
  said.insert(said.end(), thing.begin(), thing.end());
  ReplaceTokens(tokens, at, next + 1 - at, said);
}

// "A town touches the lake on its southern side": on the southern side of the lake.
void TurnItsSide(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "its" || at < 3 ||
      !IsOneOf(WordAt(*tokens, at - 1), {"on", "along", "at", "near", "from"})) {
    return;
  }
  Heading heading;
  const std::size_t side = TakeHeading(*tokens, at, &heading);
  if (side == 0 || !(IsFlank(WordAt(*tokens, side)) ||
                     IsOneOf(WordAt(*tokens, side), {"edge", "end", "shore", "border"}))) {
    return;
  }
  constexpr std::size_t kLongest = 3;
  std::size_t noun = 0;
  for (std::size_t length = 1; length <= kLongest && length + 1 < at; ++length)
    if (MatchClassWord(*tokens, at - 1 - length).tokens == length) noun = at - 1 - length;
  if (noun == 0 || WordAt(*tokens, noun - 1) != "the") return;
  // Who has the thing there has the side.
  for (std::size_t i = noun; i-- > 0 && !IsPauseAt(*tokens, i);)
    if (IsOneOf(WordAt(*tokens, i), {"has", "have", "with", "having", "keeps", "between"})) return;
  std::vector<Token> said;
  for (const char* word : {"of", "the"}) said.push_back(WordLike(word, (*tokens)[side]));
  for (std::size_t i = noun; i < at - 1; ++i)
    said.push_back(WordLike((*tokens)[i].text, (*tokens)[side]));
  (*tokens)[at].text = "the";
  InsertTokens(tokens, side + 1, said);
}

// "On the north side of the river are houses, on the other orchards": on the other side. "Left side
// of the river is forest, right side is field": the right side of the river. "Forest on three sides
// of a meadow, and a lake on the fourth": beside it.
void TurnOtherSide(std::vector<Token>* tokens, std::size_t at) {
  std::size_t begin = SentenceBegin(*tokens, at);
  if (WordAt(*tokens, at) == "on" && WordAt(*tokens, at + 1) == "the" &&
      IsOneOf(WordAt(*tokens, at + 2), {"other", "opposite"})) {
    const std::size_t noun = at + 3 + (IsOneOf(WordAt(*tokens, at + 3), {"a", "the"}) ? 1 : 0);
    if (MatchClassWord(*tokens, noun).tokens == 0) return;
    for (std::size_t i = begin; i < at; ++i) {
      const bool side = IsFlank(WordAt(*tokens, i)) && WordAt(*tokens, i + 1) == "of";
      if (!side) continue;
      InsertTokens(tokens, at + 3, {WordLike("side", (*tokens)[at + 2])});
      return;
    }
  }
  if (WordAt(*tokens, at) == "on" && WordAt(*tokens, at + 1) == "the" &&
      WordAt(*tokens, at + 2) == "fourth" && IsPauseAt(*tokens, at + 3)) {
    for (std::size_t i = begin; i + 1 < at; ++i) {
      if (WordAt(*tokens, i) != "three" || WordAt(*tokens, i + 1) != "sides") continue;
      ReplaceTokens(tokens, at, 3, {"beside", "it"});
      return;
    }
  }
  const bool opens = at > begin && (IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and");
  Heading heading;
  const std::size_t side = opens ? TakeHeading(*tokens, at, &heading) : 0;
  if (side == 0 || !IsFlank(WordAt(*tokens, side)) ||
      !IsOneOf(WordAt(*tokens, side + 1), {"is", "are", "has"})) {
    return;
  }
  for (std::size_t i = begin; i + 2 < at; ++i) {
    if (!IsFlank(WordAt(*tokens, i)) || WordAt(*tokens, i + 1) != "of") continue;
    const std::size_t noun = i + 2 + (WordAt(*tokens, i + 2) == "the" ? 1 : 0);
    const std::size_t length = MatchClassWord(*tokens, noun).tokens;
    if (length == 0) return;
    std::vector<Token> said = {WordLike("of", (*tokens)[side]), WordLike("the", (*tokens)[side])};
    for (std::size_t k = noun; k < noun + length; ++k)
      said.push_back(WordLike((*tokens)[k].text, (*tokens)[side]));
    InsertTokens(tokens, side + 1, said);
    return;
  }
}

// "Enclosed on three sides by forest": bordered by it.
void TurnSomeSides(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"enclosed", "surrounded", "bordered", "framed", "ringed",
                                     "bounded", "hemmed", "walled"})) {
    return;
  }
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) == "in") ++next;
  const bool sides = WordAt(*tokens, next) == "on" &&
                     IsOneOf(WordAt(*tokens, next + 1), {"two", "three", "most"}) &&
                     WordAt(*tokens, next + 2) == "sides" && WordAt(*tokens, next + 3) == "by";
  if (sides) ReplaceTokens(tokens, at, next + 3 - at, {"bordered"});
}

}  // namespace

void TurnScopes(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAnywhere(tokens, at);
    TurnClauseOfItsOwn(tokens, at);
    TurnUninhabited(tokens, at);
    TurnNothingBetween(tokens, at);
    TurnWalked(tokens, at);
    TurnEveryOther(tokens, at);
    TurnItsSide(tokens, at);
    TurnOtherSide(tokens, at);
    TurnSomeSides(tokens, at);
  }
}

}  // namespace latticeworld
