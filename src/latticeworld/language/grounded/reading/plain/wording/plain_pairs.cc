#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Things that come in twos and threes, and each of them by itself.
namespace latticeworld {
namespace {

// "Three lakes, lying one below the other", "none touching the next": no lake of its own; none
// touching another.
void TurnEachNext(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "one" &&
      IsOneOf(WordAt(*tokens, at + 1),
              {"below", "above", "behind", "beside", "after", "under", "over"}) &&
      WordAt(*tokens, at + 2) == "the" && WordAt(*tokens, at + 3) == "other") {
    const bool lying = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"lying", "placed", "arranged"});
    EraseTokens(tokens, at - (lying ? 1 : 0), lying ? 5 : 4);
    return;
  }
  if (WordAt(*tokens, at) == "none" && IsOneOf(WordAt(*tokens, at + 1), {"touching", "near"}) &&
      WordAt(*tokens, at + 2) == "the" && WordAt(*tokens, at + 3) == "next") {
    ReplaceTokens(tokens, at, 4, {"none", "touching", "another"});
  }
}

// "One cottage on each bank", "two cottages, one on each side of the river": two on both banks.
void TurnOneEach(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"one", "a", "an"})) return;
  const std::size_t length = MatchClassWord(*tokens, at + 1).tokens;
  const std::size_t on = at + 1 + length;
  if (!IsOneOf(WordAt(*tokens, on), {"on", "at"}) ||
      !IsOneOf(WordAt(*tokens, on + 1), {"each", "either"}) ||
      !IsOneOf(WordAt(*tokens, on + 2), {"bank", "side", "shore"}) ||
      (WordAt(*tokens, on + 3) == "of" && IsMapWord(WordAt(*tokens, on + 5)))) {
    return;
  }
  ReplaceTokens(tokens, on, 3, {"on", "both", "banks"});
  if (length > 0) {
    ReplaceTokens(tokens, at, 1, {"two"});
  } else if (WordAt(*tokens, at) == "one" && at > 0 && IsPauseAt(*tokens, at - 1)) {
    EraseTokens(tokens, at - 1, 2);
  }
}

// "Two woods, a larger and a smaller one. The former fills the north-west": two woods; the first.
void TurnLargerAndSmaller(std::vector<Token>* tokens, std::size_t at) {
  if (!IsPauseAt(*tokens, at) || IsStopAt(*tokens, at)) return;
  const auto takes = [&](std::size_t i) -> std::size_t {
    if (!IsOneOf(WordAt(*tokens, i), {"a", "one"})) return 0;
    std::size_t next = i + 1;
    if (!IsSize(WordAt(*tokens, next))) return 0;
    ++next;
    if (WordAt(*tokens, next) == "one") ++next;
    return next - i;
  };
  const std::size_t first = takes(at + 1);
  const std::size_t and_at = at + 1 + first;
  if (first == 0 || WordAt(*tokens, and_at) != "and") return;
  const std::size_t second = takes(and_at + 1);
  if (second == 0 || !IsPauseAt(*tokens, and_at + 1 + second)) return;
  EraseTokens(tokens, at, first + second + 2);
  // The former and the latter are pieces of one thing.
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) != "the" || WordAt(*tokens, next + 1) != "former") return;
  ReplaceTokens(tokens, next, 2, {"one"});
  while (!IsStopAt(*tokens, next) && WordAt(*tokens, next) != "latter") ++next;
  if (WordAt(*tokens, next) == "latter") (*tokens)[next].text = "other";
}

// "Two woods. One fills the north-west, the other ...": one is in the north-west.
void TurnOneFills(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "one" || at == 0 || !IsPauseAt(*tokens, at - 1)) return;
  if (!IsOneOf(WordAt(*tokens, at + 1), {"fills", "covers", "occupies", "takes"})) return;
  const std::size_t place = at + 2 + (WordAt(*tokens, at + 2) == "up" ? 1 : 0);
  PlaceCursor cursor(*tokens, place + (WordAt(*tokens, place) == "the" ? 1 : 0));
  if (TakeDirection(&cursor).found) ReplaceTokens(tokens, at + 1, place - at - 1, {"is", "in"});
}

// "There are two lakes, a big one in the north and a small one in the south": one in the north.
void TurnSizedOne(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "a" || !IsSize(WordAt(*tokens, at + 1)) ||
      WordAt(*tokens, at + 2) != "one" ||
      !IsOneOf(WordAt(*tokens, at + 3), {"in", "at", "on", "near"})) {
    return;
  }
  for (std::size_t i = at; i > 0 && !IsStopAt(*tokens, i - 1); --i) {
    if (!IsOneOf((*tokens)[i - 1].text, {"two", "three", "2", "3"})) continue;
    // "two lakes in the west and a small one in the east" are three
    const std::size_t length = MatchClassWord(*tokens, i).tokens;
    if (length == 0 || !IsPauseAt(*tokens, i + length)) return;
    EraseTokens(tokens, at, 2);
    return;
  }
}

// "One road leads to the lake and another to the forest": and a second road leads there.
void TurnAnotherRuns(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "another" || at < 2) return;
  const std::size_t one = at + 1 + (WordAt(*tokens, at + 1) == "one" ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, one), {"from", "to", "leads", "goes", "runs"})) return;
  std::size_t begin = SentenceBegin(*tokens, at);
  if (!IsOneOf(WordAt(*tokens, begin), {"one", "a"})) return;
  const ClassWordMatch line = MatchClassWord(*tokens, begin + 1);
  if (line.word == nullptr || line.word->shape != WordShape::kLine) return;
  std::vector<Token> said = {WordLike("a", (*tokens)[at]), WordLike("second", (*tokens)[at])};
  for (const Token& token : TokensBetween(*tokens, begin + 1, begin + 1 + line.tokens))
    said.push_back(WordLike(token.text, (*tokens)[at]));
  const bool verb = !IsOneOf(WordAt(*tokens, one), {"from", "to"});
  if (!verb) said.push_back(WordLike("leads", (*tokens)[at]));
  EraseTokens(tokens, at, one - at);
  InsertTokens(tokens, at, said);
  std::size_t link = at - 1;
  if (WordAt(*tokens, link) == "and") (*tokens)[link] = StopLike((*tokens)[link]);
  if (WordAt(*tokens, begin) == "one") (*tokens)[begin].text = "a";
}

}  // namespace

void TurnPairs(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnEachNext(tokens, at);
    TurnOneEach(tokens, at);
    TurnLargerAndSmaller(tokens, at);
    TurnOneFills(tokens, at);
    TurnSizedOne(tokens, at);
    TurnAnotherRuns(tokens, at);
  }
}

}  // namespace latticeworld
