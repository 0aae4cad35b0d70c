#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What follows one upon another: ring around ring, row after row, end after end.
namespace latticeworld {
namespace {

// An article and a class word behind it, or a class word alone; 0: there is none.
std::size_t NounPhraseAt(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t article = IsOneOf(WordAt(tokens, at), {"a", "an", "the", "some"}) ? 1 : 0;
  const std::size_t noun = MatchClassWord(tokens, at + article).tokens;
  return noun == 0 ? 0 : article + noun;
}

// "Around the lake is sand, after sand is forest", "around the lake is sand, then forest": around
// the sand is forest.
void TurnRingAfterRing(std::vector<Token>* tokens, std::size_t at) {
  const bool opens = at == 0 || IsPauseAt(*tokens, at - 1);
  if (!opens || WordAt(*tokens, at) != "around") return;
  // "A mountain in the middle, around is rock": around it.
  if (at > 0 && IsOneOf(WordAt(*tokens, at + 1), {"is", "are"}) &&
      NounPhraseAt(*tokens, at + 2) > 0) {
    InsertTokens(tokens, at + 1, {WordLike("it", (*tokens)[at])});
  }
  const std::size_t object = WordAt(*tokens, at + 1) == "it" ? 1 : NounPhraseAt(*tokens, at + 1);
  std::size_t next = at + 1 + object;
  if (object == 0 || !IsOneOf(WordAt(*tokens, next), {"is", "are", "lies", "comes", "runs"})) {
    return;
  }
  std::size_t subject = next + 1;
  while (true) {
    const std::size_t length = NounPhraseAt(*tokens, subject);
    if (length == 0) return;
    const std::size_t pause = subject + length;
    if (pause >= tokens->size() || (*tokens)[pause].kind != TokenKind::kComma) return;
    next = pause + 1;
    if (WordAt(*tokens, next) == "and") ++next;
    std::size_t outer = 0;
    if (IsOneOf(WordAt(*tokens, next), {"then", "next"})) {
      outer = next + 1;
      if (IsOneOf(WordAt(*tokens, outer), {"comes", "is", "a", "the"}) &&
          NounPhraseAt(*tokens, outer) == 0) {
        ++outer;
      }
    } else if (IsOneOf(WordAt(*tokens, next), {"after", "beyond", "outside"})) {
      std::size_t verb = next + 1;
      if (WordAt(*tokens, verb) == "of") ++verb;
      verb +=
          IsOneOf(WordAt(*tokens, verb), {"that", "it", "this"}) ? 1 : NounPhraseAt(*tokens, verb);
      if (IsOneOf(WordAt(*tokens, verb), {"is", "are", "comes", "lies"})) ++verb;
      outer = verb;
    }
    if (outer == 0 || NounPhraseAt(*tokens, outer) == 0) return;
    const std::size_t noun = subject + (length > MatchClassWord(*tokens, subject).tokens ? 1 : 0);
    const Token beside = (*tokens)[pause];
    std::vector<Token> said = {CommaLike(beside), WordLike("around", beside),
                               WordLike("the", beside)};
    for (std::size_t i = noun; i < pause; ++i) said.push_back((*tokens)[i]);
    said.push_back(WordLike("is", beside));
    EraseTokens(tokens, pause, outer - pause);
    InsertTokens(tokens, pause, said);
    subject = pause + said.size();
  }
}

// "The pond is enclosed by an orchard, and the orchard in turn by a ring of trees": the orchard is
// enclosed by it.
void TurnInTurn(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "by" || at < 2) return;
  std::size_t end = at;
  if (WordAt(*tokens, end - 1) == "turn" && WordAt(*tokens, end - 2) == "in") end -= 2;
  std::size_t begin = end;
  while (begin > 0 && begin + 3 > end && !IsPauseAt(*tokens, begin - 1) &&
         WordAt(*tokens, begin - 1) != "and") {
    --begin;
  }
  if (begin == 0 || WordAt(*tokens, begin - 1) != "and" || WordAt(*tokens, begin) != "the" ||
      begin + NounPhraseAt(*tokens, begin) != end) {
    return;
  }
  for (std::size_t i = begin - 1; i-- > 0 && !IsStopAt(*tokens, i);) {
    if (WordAt(*tokens, i + 1) != "by" ||
        !IsOneOf(WordAt(*tokens, i), {"enclosed", "surrounded", "ringed", "encircled", "framed",
                                      "bordered", "edged", "fringed", "circled"})) {
      continue;
    }
    const std::string participle = (*tokens)[i].text;
    EraseTokens(tokens, end, at - end);
    const Token beside = (*tokens)[end];
    InsertTokens(tokens, end, {WordLike("is", beside), WordLike(participle, beside)});
    return;
  }
}

// "First comes snow at the top, second comes rock, third comes forest and last comes my house at
// the bottom": snow at the top, then rock, then forest and my house at the bottom.
void TurnOrdinals(std::vector<Token>* tokens, std::size_t at) {
  const bool opens = at == 0 || IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
  if (!opens || !IsOneOf(WordAt(*tokens, at),
                         {"first", "second", "third", "fourth", "last", "finally", "lastly"})) {
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at + 1), {"comes", "come", "is", "lies"})) return;
  if (NounPhraseAt(*tokens, at + 2) == 0 &&
      !IsOneOf(WordAt(*tokens, at + 2), {"my", "a", "the", "our"})) {
    return;
  }
  // Alone it says where a row begins, and is read elsewhere.
  bool rows = WordAt(*tokens, at) != "first";
  for (std::size_t i = at + 1; !rows && !IsStopAt(*tokens, i); ++i)
    rows = WordAt(*tokens, i) == "second" && IsOneOf(WordAt(*tokens, i + 1), {"comes", "is"});
  if (!rows) return;
  const bool after_and = at > 0 && WordAt(*tokens, at - 1) == "and";
  if (WordAt(*tokens, at) == "first" || after_and) {
    EraseTokens(tokens, at, 2);
  } else {
    ReplaceTokens(tokens, at, 2, {"then"});
  }
}

// "Carries on north until it reaches a town": to a town.
void TurnUntil(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "until" || at == 0 || WordAt(*tokens, at + 1) != "it") return;
  std::size_t verb = at + 2;
  if (!IsOneOf(WordAt(*tokens, verb),
               {"reaches", "meets", "hits", "gets", "comes", "joins", "arrives", "ends"})) {
    return;
  }
  ++verb;
  if (IsOneOf(WordAt(*tokens, verb), {"to", "at", "in"})) ++verb;
  ReplaceTokens(tokens, at, verb - at, {"to"});
}

// "Two roads run north and south": north to south.
void TurnBothWays(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"run", "runs", "running", "go", "goes", "going"}) ||
      WordAt(*tokens, at + 2) != "and" || !IsPauseAt(*tokens, at + 4)) {
    return;
  }
  const std::string_view one = WordAt(*tokens, at + 1), other = WordAt(*tokens, at + 3);
  const bool opposite = (one == "north" && other == "south") ||
                        (one == "south" && other == "north") ||
                        (one == "east" && other == "west") || (one == "west" && other == "east");
  if (opposite) (*tokens)[at + 2].text = "to";
}

// "In the corner down left": in the lower left corner.
void TurnCornerBehind(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "corner") return;
  std::size_t first = at + 1;
  if (IsOneOf(WordAt(*tokens, first), {"at", "on", "to"})) ++first;
  if (WordAt(*tokens, first) == "the") ++first;
  const auto row = [](std::string_view word) -> std::string_view {
    if (IsOneOf(word, {"down", "bottom", "below", "lower"})) return "lower";
    return IsOneOf(word, {"up", "top", "above", "upper"}) ? "upper" : "";
  };
  std::string_view vertical = row(WordAt(*tokens, first));
  std::string_view side = WordAt(*tokens, first + 1);
  if (vertical.empty()) {
    vertical = row(side);
    side = WordAt(*tokens, first);
  }
  if (vertical.empty() || !IsOneOf(side, {"left", "right"}) || !IsPauseAt(*tokens, first + 2)) {
    return;
  }
  ReplaceTokens(tokens, at, first + 2 - at,
                {vertical, side == "left" ? "left" : "right", "corner"});
}

}  // namespace

void TurnChains(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnRingAfterRing(tokens, at);
    TurnInTurn(tokens, at);
    TurnOrdinals(tokens, at);
    TurnUntil(tokens, at);
    TurnBothWays(tokens, at);
    TurnCornerBehind(tokens, at);
  }
}

}  // namespace latticeworld
