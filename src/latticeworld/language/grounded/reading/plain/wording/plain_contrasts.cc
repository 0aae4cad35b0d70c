#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What is denied only to say what there is instead, or of what stands beside a thing.
namespace latticeworld {
namespace {

// "in the middle", "near the town": the place of what stands before an aside.
bool BeginsPlace(std::string_view word) {
  return IsOneOf(word, {"in",    "at",      "on",     "to",     "near",       "by",     "next",
                        "along", "between", "around", "beside", "inside",     "within", "north",
                        "south", "east",    "west",   "behind", "surrounded", "right",  "close"});
}

bool SameClass(const ClassWord* one, const ClassWord* other) {
  return one != nullptr && other != nullptr && one->suburb == other->suburb &&
         one->wild == other->wild;
}

// "I want a lake, not a river, in the middle", "a lake in the middle, not a river": a lake in the
// middle. "A lake, no houses, in the middle": a lake in the middle, and no houses.
void TurnAsideNot(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || at == 0) return;
  std::size_t denied = at + 1;
  if (IsOneOf(WordAt(*tokens, denied), {"and", "but"})) ++denied;
  const bool no = WordAt(*tokens, denied) == "no";
  if (!no && WordAt(*tokens, denied) != "not") return;
  const std::size_t end = PhraseEnd(*tokens, denied + 1);
  const ClassWord* noun = NounBefore(*tokens, end);
  if (end == denied + 1 || noun == nullptr) return;
  if (!no && IsStopAt(*tokens, end)) {
    // A river is no other class than a lake.
    for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i) {
      if (!SameClass(MatchClassWord(*tokens, i).word, noun)) continue;
      EraseTokens(tokens, at, end - at);
      return;
    }
  }
  const bool aside = IsMark(*tokens, end) && BeginsPlace(WordAt(*tokens, end + 1)) &&
                     NounBefore(*tokens, at) != nullptr;
  if (!aside) return;
  if (no) {
    // What follows may be of a thing of its own.
    if (NamesThing(*tokens, end + 1) || !IsStopAt(*tokens, PauseAfter(*tokens, end + 1))) return;
    std::vector<Token> said = {StopLike((*tokens)[denied])};
    for (std::size_t i = denied; i < end; ++i) said.push_back((*tokens)[i]);
    InsertTokens(tokens, StopAfter(*tokens, end), said);
  }
  EraseTokens(tokens, at, end + 1 - at);
}

// "Not a lake but a forest in the middle": a forest in the middle.
void TurnNotBut(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "not") return;
  const std::size_t end = PhraseEnd(*tokens, at + 1);
  if (end == at + 1 || WordAt(*tokens, end - 1) == "it") return;
  const std::size_t but = end + (IsMark(*tokens, end) ? 1 : 0);
  if (WordAt(*tokens, but) != "but" || PhraseEnd(*tokens, but + 1) == but + 1) return;
  EraseTokens(tokens, at, but + 1 - at);
}

// "near", "next to": the token after such words; `at`: none of them.
std::size_t SkipBeside(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view word = WordAt(tokens, at);
  if (IsOneOf(word, {"next", "close", "adjacent"}) && WordAt(tokens, at + 1) == "to") return at + 2;
  if (word == "all" && WordAt(tokens, at + 1) == "around") return at + 2;
  return IsOneOf(word, {"near", "around", "round", "beside", "by", "touching"}) ? at + 1 : at;
}

// "The two villages are not connected by a road": the two villages. "A town by a lake, but not
// surrounded by it": a town by a lake.
void TurnNotRelated(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "not" || at == 0) return;
  std::size_t verb = at + 1;
  while (IsOneOf(WordAt(*tokens, verb), {"completely", "entirely", "fully", "wholly", "quite",
                                         "directly", "totally", "all"})) {
    ++verb;
  }
  const bool joined = IsOneOf(WordAt(*tokens, verb), {"connected", "linked", "joined"});
  if (!joined && !IsOneOf(WordAt(*tokens, verb), {"surrounded", "enclosed", "encircled", "ringed"}))
    return;
  const std::size_t by = verb + 1;
  if (WordAt(*tokens, by) != "by") return;
  const std::size_t end = PhraseEnd(*tokens, by + 1);
  if (end == by + 1 || (!IsPauseAt(*tokens, end) && WordAt(*tokens, end) != "and")) return;
  std::size_t begin = at;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1),
                              {"is", "are", "be", "should", "must", "shall", "which", "that"})) {
    --begin;
  }
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"but", "and", "though"})) --begin;
  if (begin > 1 && IsMark(*tokens, begin - 1) && IsPauseAt(*tokens, end)) --begin;
  EraseTokens(tokens, begin, end - begin);
}

// "There was once a lake here, but now it is only grass": it is only grass.
void TurnOnce(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  std::size_t next = at;
  bool once = WordAt(*tokens, next) == "once";
  if (once) ++next;
  if (WordAt(*tokens, next) != "there") return;
  ++next;
  if (WordAt(*tokens, next) == "once") {
    once = true;
    ++next;
  }
  if (IsOneOf(WordAt(*tokens, next), {"was", "were"})) {
    once = once || WordAt(*tokens, next + 1) == "once";
  } else if (WordAt(*tokens, next) == "used" && WordAt(*tokens, next + 1) == "to") {
    once = true;
  } else {
    return;
  }
  for (std::size_t now = next; once && !IsStopAt(*tokens, now); ++now) {
    if (WordAt(*tokens, now) != "now" || IsPauseAt(*tokens, now + 1)) continue;
    // "but now it is grass", "but there is now grass", "now there is grass", "now a meadow"
    std::size_t first = now + 1;
    while (IsOneOf(WordAt(*tokens, first), {"it", "there", "is", "are"})) ++first;
    ReplaceTokens(tokens, at, first - at, {"there", "is"});
    return;
  }
}

// "Next to", "between": the token after a relation; `at`: none.
std::size_t SkipRelation(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t beside = SkipBeside(tokens, at);
  if (beside > at) return beside;
  return IsOneOf(WordAt(tokens, at),
                 {"between", "along", "alongside", "behind", "beyond", "inside", "within"})
             ? at + 1
             : at;
}

// "Around the lake no trees, only meadow": around the lake only meadow. "Nothing between the lake
// and the town but grass": grass between the lake and the town.
void TurnNothingBut(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "no" && at > 2) {
    const std::size_t comma = PhraseEnd(*tokens, at + 1);
    const bool only =
        IsOneOf(WordAt(*tokens, comma + 1), {"only", "just"}) ||
        (WordAt(*tokens, comma + 1) == "nothing" && WordAt(*tokens, comma + 2) == "but");
    const std::size_t thing = PhraseBegin(*tokens, BeingBegin(*tokens, at));
    if (comma == at + 1 || !IsMark(*tokens, comma) || !only || thing == 0) return;
    const std::size_t clause = thing - (WordAt(*tokens, thing - 1) == "to" && thing > 1 ? 2 : 1);
    if (SkipRelation(*tokens, clause) != thing) return;
    EraseTokens(tokens, at, comma + 1 - at);
    return;
  }
  if (WordAt(*tokens, at) != "nothing") return;
  const std::size_t thing = SkipRelation(*tokens, at + 1);
  if (thing == at + 1) return;
  std::size_t end = PhraseEnd(*tokens, thing);
  if (end == thing) return;
  if (WordAt(*tokens, end) == "and" && PhraseEnd(*tokens, end + 1) > end + 1)
    end = PhraseEnd(*tokens, end + 1);
  std::size_t but = end + (IsMark(*tokens, end) ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, but), {"but", "except", "save"})) return;
  ++but;
  if (WordAt(*tokens, but) == "for") ++but;
  const std::size_t last = PhraseEnd(*tokens, but);
  if (last == but) return;
  std::vector<Token> said = TokensBetween(*tokens, but, last);
  for (const Token& token : TokensBetween(*tokens, at + 1, end)) said.push_back(token);
  EraseTokens(tokens, at, last - at);
  InsertTokens(tokens, at, said);
}

}  // namespace

void TurnContrasts(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAsideNot(tokens, at);
    TurnNotBut(tokens, at);
    TurnNotRelated(tokens, at);
    TurnOnce(tokens, at);
    TurnNothingBut(tokens, at);
  }
}

}  // namespace latticeworld
