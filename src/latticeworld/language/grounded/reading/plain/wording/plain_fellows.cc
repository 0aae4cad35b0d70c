#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// One more of a kind, some of a kind, and what lies between them.
namespace latticeworld {
namespace {

// "south of", "next to", "beside": where something stands, told by another.
bool IsBeside(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"beside", "near", "by", "behind", "opposite", "below", "above",
                                   "beyond", "next", "close"})) {
    return true;
  }
  Heading heading;
  const std::size_t start =
      at + (WordAt(tokens, at) == "to" && WordAt(tokens, at + 1) == "the" ? 2 : 0);
  const std::size_t end = TakeHeading(tokens, start, &heading);
  return end > 0 && WordAt(tokens, end) == "of";
}

// The class word of "a village" or "a small village" that comes first in the sentence of `at`.
std::vector<Token> SubjectOf(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && !IsStopAt(tokens, begin - 1)) --begin;
  bool article = false;
  for (; begin < at; ++begin) {
    const ClassWordMatch match = MatchClassWord(tokens, begin);
    if (match.word == nullptr) {
      article = article || IsOneOf(WordAt(tokens, begin), {"a", "an", "one"});
      continue;
    }
    const bool thing = article && !match.plural && match.word->shape == WordShape::kThing;
    if (!thing) return {};
    const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(begin);
    return {first, first + static_cast<std::ptrdiff_t>(match.tokens)};
  }
  return {};
}

// "in the forest": in what it stands.
bool IsInside(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(WordAt(tokens, at), {"in", "inside", "within"}) &&
         IsOneOf(WordAt(tokens, at + 1), {"the", "a"}) && MatchClassWord(tokens, at + 2).tokens > 0;
}

// "A village north of the lake, another one south of it", "another in the forest": another village.
void NameAnother(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "another") return;
  const std::size_t one = WordAt(*tokens, at + 1) == "one" ? 1 : 0;
  if (!IsBeside(*tokens, at + 1 + one) && !IsInside(*tokens, at + 1 + one)) return;
  std::vector<Token> name;
  for (const Token& token : SubjectOf(*tokens, at))
    name.push_back(WordLike(token.text, (*tokens)[at]));
  if (name.empty()) return;
  EraseTokens(tokens, at + 1, one);
  InsertTokens(tokens, at + 1, name);
}

// "Are in the north", "lies in the lower left quarter".
bool PlacedThere(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t in = at;
  while (IsOneOf(WordAt(tokens, in), {"is", "are", "lies", "lie", "stands", "stand", "should",
                                      "must", "be", "located", "found"})) {
    ++in;
  }
  if (in == at || !IsOneOf(WordAt(tokens, in), {"in", "on", "at"})) return false;
  PlaceCursor cursor(tokens, in + 1 + (WordAt(tokens, in + 1) == "the" ? 1 : 0));
  return TakeDirection(&cursor).found;
}

// "Half of the houses are in the north, the other half in the south": the houses both times, for
// nothing is said of halves of the map. "Most of the houses": the houses.
void NameSome(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"half", "most", "many", "some"})) return;
  std::size_t the = at + 1;
  if (WordAt(*tokens, the) == "of") ++the;
  if (WordAt(*tokens, the) != "the") return;
  const ClassWordMatch match = MatchClassWord(*tokens, the + 1);
  // "Half of the forest is in the north"
  const bool mass = match.word != nullptr && match.word->shape == WordShape::kMass &&
                    IsOneOf(WordAt(*tokens, the + 1 + match.tokens), {"is", "lies", "in"});
  const bool things =
      match.word != nullptr && match.plural && match.word->shape == WordShape::kThing;
  if (!things && !mass) return;
  const bool half = WordAt(*tokens, at) == "half";
  // "Half of the forest lies in the west": half of what there is, if no word tells of the other.
  const std::size_t verb = the + 1 + match.tokens;
  if (PlacedThere(*tokens, verb) && (WordAt(*tokens, at) == "most" || half)) {
    bool other = false;
    for (std::size_t i = verb + 1; !IsStopAt(*tokens, i); ++i) {
      const bool begins = IsPauseAt(*tokens, i - 1) || WordAt(*tokens, i - 1) == "and";
      other = other || IsOneOf(WordAt(*tokens, i), {"other", "others", "rest"}) ||
              (begins && WordAt(*tokens, i) == "half");
    }
    if (!other) return;
  }
  const std::vector<Token> name(
      tokens->begin() + static_cast<std::ptrdiff_t>(the),
      tokens->begin() + static_cast<std::ptrdiff_t>(the + 1 + match.tokens));
  EraseTokens(tokens, at, the - at);
  for (std::size_t i = at + name.size(); half && !IsStopAt(*tokens, i); ++i) {
    if (WordAt(*tokens, i) != "half") continue;
    const bool other = WordAt(*tokens, i - 1) == "other";
    if (!other && !IsPauseAt(*tokens, i - 1) && WordAt(*tokens, i - 1) != "and") continue;
    const std::size_t first = i - (other ? 1 + (WordAt(*tokens, i - 2) == "the" ? 1 : 0) : 0);
    std::vector<Token> again;
    for (const Token& token : name) again.push_back(WordLike(token.text, (*tokens)[first]));
    EraseTokens(tokens, first, i + 1 - first);
    InsertTokens(tokens, first, again);
    return;
  }
}

// "Five ponds and paths between them", "two lakes and some rock between them": with paths, with
// some rock between them.
void JoinBetween(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "between" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"them", "these", "those"}) ||
      !IsPauseAt(*tokens, at + 2)) {
    return;
  }
  constexpr std::size_t kLongest = 4;
  for (std::size_t back = 1; back <= kLongest && back < at; ++back) {
    const std::size_t and_at = at - back;
    if (IsPauseAt(*tokens, and_at)) return;
    if (WordAt(*tokens, and_at) != "and") continue;
    const ClassWordMatch line = MatchClassWord(*tokens, and_at + 1);
    const bool runs = line.word != nullptr && line.word->shape == WordShape::kLine &&
                      and_at + 1 + line.tokens == at;
    bool two = false;
    for (std::size_t i = and_at; i > 0 && and_at - i < 4 && !IsPauseAt(*tokens, i - 1); --i)
      two = two || IsOneOf((*tokens)[i - 1].text, {"two", "2", "both"});
    if (runs || two) (*tokens)[and_at].text = "with";
    return;
  }
}

}  // namespace

void TurnFellows(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    NameAnother(tokens, at);
    NameSome(tokens, at);
    JoinBetween(tokens, at);
  }
}

}  // namespace latticeworld
