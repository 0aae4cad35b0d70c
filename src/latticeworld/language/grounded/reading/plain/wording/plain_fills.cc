#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What fills a place or a gap, and what lies along both sides.
namespace latticeworld {
namespace {

bool Opens(const std::vector<Token>& tokens, std::size_t at) {
  return at == 0 || IsPauseAt(tokens, at - 1) ||
         IsOneOf(WordAt(tokens, at - 1), {"and", "please", "then", "to", "now"});
}

// "<place> with": where the "with" of a part of "fill ... with ..." stands; 0: there is none. The
// place names nothing of the map's classes.
std::size_t WithAfter(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::size_t kReach = 7;
  for (std::size_t i = at; i < at + kReach && !IsPauseAt(tokens, i); ++i) {
    if (WordAt(tokens, i) == "with") return i > at ? i : 0;
    if (MatchClassWord(tokens, i).tokens > 0) return 0;
  }
  return 0;
}

// "Fill the northern third with buildings and the southern third with crops": buildings fill the
// northern third, crops fill the southern third.
void TurnFilledParts(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"fill", "cover", "plant", "pack"}) || !Opens(*tokens, at))
    return;
  std::vector<Token> said;
  std::size_t next = at + 1;
  int parts = 0;
  while (true) {
    const std::size_t with = WithAfter(*tokens, next);
    if (with == 0) break;
    std::size_t end = with + 1;
    std::size_t following = 0;
    for (; !IsStopAt(*tokens, end) && following == 0; ++end) {
      const bool comma = (*tokens)[end].kind == TokenKind::kComma;
      if (!comma && WordAt(*tokens, end) != "and") continue;
      const std::size_t begin = end + (comma && WordAt(*tokens, end + 1) == "and" ? 2 : 1);
      if (WithAfter(*tokens, begin) > 0) following = begin;
      if (following > 0 || comma) break;
    }
    if (end == with + 1) break;
    if (parts > 0) said.push_back(CommaLike((*tokens)[with]));
    for (const Token& token : TokensBetween(*tokens, with + 1, end)) said.push_back(token);
    said.push_back(WordLike("fill", (*tokens)[with]));
    for (const Token& token : TokensBetween(*tokens, next, with)) said.push_back(token);
    ++parts;
    next = following > 0 ? following : end;
    if (following == 0) break;
  }
  if (parts < 2) return;
  EraseTokens(tokens, at, next - at);
  InsertTokens(tokens, at, said);
}

// "Lawns flank the stream": lie on both sides of it.
void TurnFlanking(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "flank") return;
  const bool things =
      WordAt(*tokens, at + 1) == "the" && MatchClassWord(*tokens, at + 2).tokens > 0;
  bool after_noun = false;
  for (std::size_t i = at; i-- > 0 && i + 3 >= at;)
    after_noun = after_noun || i + MatchClassWord(*tokens, i).tokens == at;
  if (!things || !after_noun) return;
  // "... the village on the left and on the right"
  const std::size_t on = at + 2 + MatchClassWord(*tokens, at + 2).tokens;
  std::size_t end = on;
  for (const bool second : {false, true}) {
    if (second && WordAt(*tokens, end) != "and") break;
    std::size_t next = end + (second ? 1 : 0);
    if (IsOneOf(WordAt(*tokens, next), {"on", "to", "in"})) ++next;
    if (WordAt(*tokens, next) == "the") ++next;
    PlaceCursor cursor(*tokens, next);
    if (!TakeDirection(&cursor).found) break;
    end = cursor.at();
    if (second && IsPauseAt(*tokens, end)) EraseTokens(tokens, on, end - on);
  }
  ReplaceTokens(tokens, at, 1, {"lie", "on", "both", "sides", "of"});
}

// "Cover the top with forest, leave the middle empty and fill the bottom with water": a sentence
// for each of what is to be done.
void TurnCommands(std::vector<Token>* tokens, std::size_t at) {
  const auto commands = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i), {"fill", "cover", "leave", "put", "place", "add", "keep",
                                        "plant", "make", "draw", "set"});
  };
  if (!commands(at) || at < 2) return;
  const bool comma = (*tokens)[at - 1].kind == TokenKind::kComma && (*tokens)[at - 1].text == ",";
  if (!comma && WordAt(*tokens, at - 1) != "and" && WordAt(*tokens, at - 1) != "then") return;
  std::size_t begin = at - 1;
  while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
  if (IsOneOf(WordAt(*tokens, begin), {"please", "now", "then"})) ++begin;
  // "Put and place" things: two verbs of one command.
  if (!commands(begin) || at - begin < 4) return;
  std::size_t link = at - 1;
  while (link > 0 && (WordAt(*tokens, link - 1) == "and" || WordAt(*tokens, link - 1) == "then" ||
                      (*tokens)[link - 1].kind == TokenKind::kComma)) {
    --link;
  }
  EraseTokens(tokens, link + 1, at - link - 1);
  (*tokens)[link] = StopLike((*tokens)[link]);
}

bool IsGap(std::string_view word) {
  return IsOneOf(word, {"hole", "gap", "clearing", "opening", "spot"});
}

// "A clearing of bare earth", "a hole in the middle with sand": a patch of it there. "A hole in the
// middle": a clearing.
void TurnGapOf(std::vector<Token>* tokens, std::size_t at) {
  if (!IsGap(WordAt(*tokens, at)) || at == 0 || MatchClassWord(*tokens, at).tokens > 1 ||
      IsOneOf(WordAt(*tokens, at - 1), {"water", "watering", "swimming"})) {
    return;
  }
  if (WordAt(*tokens, at + 1) == "of") {
    const bool filled = MatchClassWord(*tokens, at + 2).tokens > 0;
    if (filled) (*tokens)[at].text = "patch";
    return;
  }
  constexpr std::size_t kReach = 7;
  std::size_t with = at + 1;
  while (with < at + kReach && !IsPauseAt(*tokens, with) && WordAt(*tokens, with) != "with") ++with;
  const std::size_t noun = with + 1;
  const std::size_t length =
      WordAt(*tokens, with) == "with" && with > at + 1 ? MatchClassWord(*tokens, noun).tokens : 0;
  const bool placed = IsOneOf(WordAt(*tokens, at + 1), {"in", "at", "near", "on"});
  if (length > 0 && placed && IsPauseAt(*tokens, noun + length)) {
    std::vector<Token> said = {WordLike("patch", (*tokens)[at]), WordLike("of", (*tokens)[at])};
    for (const Token& token : TokensBetween(*tokens, noun, noun + length)) said.push_back(token);
    for (const Token& token : TokensBetween(*tokens, at + 1, with)) said.push_back(token);
    EraseTokens(tokens, at, noun + length - at);
    InsertTokens(tokens, at, said);
  } else if (IsOneOf(WordAt(*tokens, at), {"hole", "opening"}) && placed) {
    (*tokens)[at].text = "clearing";
  }
}

// "At the bottom a valley with a river": a river.
void TurnValleyWith(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"a", "the"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"valley", "place", "dale", "basin"}) ||
      WordAt(*tokens, at + 2) != "with" || MatchClassWord(*tokens, at + 1).tokens > 0) {
    return;
  }
  EraseTokens(tokens, at, 3);
}

}  // namespace

void TurnFills(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) TurnCommands(tokens, at);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnFilledParts(tokens, at);
    TurnFlanking(tokens, at);
    TurnGapOf(tokens, at);
    TurnValleyWith(tokens, at);
  }
}

}  // namespace latticeworld
