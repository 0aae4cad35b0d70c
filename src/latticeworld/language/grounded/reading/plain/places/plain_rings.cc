#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What lies inside of something and outside of it.
namespace latticeworld {
namespace {

// The tokens of an article, if any, and a class word behind it; 0: there is none.
std::size_t NounPhraseAt(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  if (IsOneOf(WordAt(tokens, next), {"a", "an", "the", "one"})) ++next;
  if (IsOneOf(WordAt(tokens, next), {"small", "big", "large", "little", "open"})) ++next;
  const std::size_t noun = MatchClassWord(tokens, next).tokens;
  return noun == 0 ? 0 : next + noun - at;
}

// "Forest on all four sides, a meadow within": a meadow surrounded by forest.
bool TurnWithin(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t outer = NounPhraseAt(*tokens, at);
  if (outer == 0) return false;
  std::size_t next = at + outer;
  if (WordAt(*tokens, next) != "on") return false;
  ++next;
  if (WordAt(*tokens, next) == "all") {
    ++next;
    if (next < tokens->size() && (WordAt(*tokens, next) == "four" || (*tokens)[next].text == "4"))
      ++next;
  } else if (WordAt(*tokens, next) == "every") {
    ++next;
  } else {
    return false;
  }
  if (!IsOneOf(WordAt(*tokens, next), {"side", "sides"})) return false;
  ++next;
  if (IsStopAt(*tokens, next)) return false;
  if ((*tokens)[next].kind == TokenKind::kComma) ++next;
  if (WordAt(*tokens, next) == "and") ++next;
  const std::size_t inner = next;
  const std::size_t length = NounPhraseAt(*tokens, inner);
  if (length == 0) return false;
  const std::size_t within = inner + length;
  if (!IsOneOf(WordAt(*tokens, within), {"within", "inside"}) || !IsPauseAt(*tokens, within + 1))
    return false;
  std::vector<Token> said(tokens->begin() + static_cast<std::ptrdiff_t>(inner),
                          tokens->begin() + static_cast<std::ptrdiff_t>(within));
  for (const std::string_view word : {"surrounded", "by"})
    said.push_back(WordLike(word, (*tokens)[within]));
  said.insert(said.end(), tokens->begin() + static_cast<std::ptrdiff_t>(at),
              tokens->begin() + static_cast<std::ptrdiff_t>(at + outer));
  EraseTokens(tokens, at, within + 1 - at);
  InsertTokens(tokens, at, said);
  return true;
}

// "A town inside a ring road": surrounded by it.
void TurnInsideRing(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"inside", "within"})) return;
  const std::size_t noun = at + (IsOneOf(WordAt(*tokens, at + 1), {"a", "the"}) ? 2 : 1);
  const bool ring = WordAt(*tokens, noun) == "ring" &&
                    IsOneOf(WordAt(*tokens, noun + 1), {"road", "of", "street", "highway"});
  if (ring) ReplaceTokens(tokens, at, 1, {"surrounded", "by"});
}

// "..., surrounded by a road, fields outside": and the rest is fields.
void TurnOutside(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "outside" || !IsStopAt(*tokens, at + 1)) return;
  std::size_t begin = at;
  while (begin > 0 && (*tokens)[begin - 1].kind == TokenKind::kWord) --begin;
  if (begin == 0 || (*tokens)[begin - 1].kind != TokenKind::kComma) return;
  if (WordAt(*tokens, begin) == "and") ++begin;
  if (begin + NounPhraseAt(*tokens, begin) != at) return;
  std::size_t sentence = begin;
  bool ringed = false;
  while (sentence > 0 && (*tokens)[sentence - 1].kind != TokenKind::kStop) {
    --sentence;
    ringed = ringed || WordAt(*tokens, sentence) == "surrounded";
  }
  if (!ringed) return;
  const Token beside = (*tokens)[begin];
  EraseTokens(tokens, at, 1);
  InsertTokens(tokens, begin,
               {WordLike("the", beside), WordLike("rest", beside), WordLike("is", beside)});
}

// "Woods at the top, water at the bottom, and in between a village": and a village in between.
void TurnInBetween(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "in" || WordAt(*tokens, at + 1) != "between" || at == 0) return;
  const bool listed =
      (*tokens)[at - 1].kind == TokenKind::kComma ||
      (WordAt(*tokens, at - 1) == "and" && at > 1 && (*tokens)[at - 2].kind == TokenKind::kComma);
  const std::size_t length = NounPhraseAt(*tokens, at + 2);
  if (!listed || length == 0 || !IsStopAt(*tokens, at + 2 + length)) return;
  const auto begin = tokens->begin() + static_cast<std::ptrdiff_t>(at);
  std::rotate(begin, begin + 2, begin + 2 + static_cast<std::ptrdiff_t>(length));
}

}  // namespace

void TurnRings(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (at == 0 || IsPauseAt(*tokens, at - 1)) TurnWithin(tokens, at);
    TurnInsideRing(tokens, at);
    TurnInBetween(tokens, at);
  }
  for (std::size_t at = 0; at < tokens->size(); ++at) TurnOutside(tokens, at);
}

}  // namespace latticeworld
