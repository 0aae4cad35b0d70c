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

// What a thing is without, keeps away from, is neither near nor next to.
namespace latticeworld {
namespace {

// What a thing that was named does or is; no noun is among them.
bool IsAssertion(std::string_view word) {
  return IsOneOf(
      word, {"is",      "are",       "lies",     "lie",       "stands",    "stand",    "sits",
             "sit",     "surrounds", "surround", "encircles", "encircle",  "encloses", "enclose",
             "rings",   "runs",      "run",      "crosses",   "cross",     "borders",  "border",
             "touches", "touch",     "covers",   "cover",     "fills",     "fill",     "occupies",
             "occupy",  "separates", "separate", "connects",  "connect",   "leads",    "lead",
             "flows",   "flow",      "divides",  "divide",    "splits",    "split",    "follows",
             "follow",  "stretches", "stretch",  "extends",   "extend",    "adjoins",  "adjoin",
             "reaches", "reach",     "takes",    "take",      "dominates", "dominate", "goes",
             "should",  "must",      "shall",    "will",      "frames",    "frame",    "links",
             "link",    "joins",     "join",     "winds",     "spreads",   "spread",   "lines"});
}

// The token after "without any", "free of", "which has no"; `at`: none of them.
std::size_t SkipLack(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  if (IsOneOf(WordAt(tokens, next), {"which", "that"})) {
    ++next;
    if (IsOneOf(WordAt(tokens, next), {"has", "have"})) {
      return WordAt(tokens, next + 1) == "no" ? next + 2 : at;
    }
    if (!IsOneOf(WordAt(tokens, next), {"is", "are"})) return at;
    ++next;
  }
  while (IsOneOf(WordAt(tokens, next), {"completely", "entirely", "totally", "wholly"})) ++next;
  const std::string_view word = WordAt(tokens, next), of = WordAt(tokens, next + 1);
  if (IsOneOf(word, {"without", "lacking"})) {
    ++next;
  } else if ((word == "with" && of == "no") || (word == "free" && of == "from") ||
             (IsOneOf(word, {"free", "devoid", "bare", "empty", "void", "clear"}) && of == "of")) {
    next += 2;
  } else {
    return at;
  }
  while (IsOneOf(WordAt(tokens, next), {"any", "a", "an", "single"})) ++next;
  return next;
}

// Whether other words than those between `begin` and `end` name the same class.
bool IsNamedBeside(const std::vector<Token>& tokens, const ClassWord& word, std::size_t begin,
                   std::size_t end) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i >= begin && i < end) continue;
    const ClassWordMatch match = MatchClassWord(tokens, i);
    if (match.word == nullptr) continue;
    if (match.word->suburb == word.suburb && match.word->wild == word.wild) return true;
    i += match.tokens - 1;
  }
  return false;
}

// "treeless"; "": no word for it.
std::string_view WithoutIt(const ClassWord& word) {
  if (word.wild == 'S') return "snowless";
  switch (word.suburb_exact ? word.suburb : '\0') {
    case 'F':
      return "treeless";
    case 'B':
      return "unbuilt";
    case 'R':
      return "roadless";
    case 'W':
      return "waterless";
    case 'A':
      return "unfarmed";
    default:
      return "";
  }
}

// "A meadow without trees surrounds the town": a treeless meadow. "A road without houses crosses
// the forest": the road does.
void TurnWithout(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t first = SkipLack(*tokens, at);
  // "a meadow clear of the forest": of that which there is
  if (first == at || at == 0) return;
  const bool clear = first > 1 && WordAt(*tokens, first - 2) == "clear";
  if (clear && WordAt(*tokens, first) == "the") return;
  const std::size_t before = IsMark(*tokens, at - 1) ? at - 1 : at;
  const std::vector<NamedThing> named = NamedBefore(*tokens, before);
  if (named.empty() || named.front().end != before) return;
  std::vector<const ClassWord*> lacked;
  std::vector<Token> others;  // "no bushes"
  std::size_t end = first;
  for (std::size_t next = first;;) {
    const NounSpan span = TakeNounSpan(*tokens, next);
    if (!span.found()) break;
    const ClassWord* word = MatchClassWord(*tokens, span.noun).word;
    end = span.end;
    lacked.push_back(word);
    if (WithoutIt(*word).empty()) {
      for (const char* no : {".", "no"}) {
        others.push_back(no[0] == '.' ? StopLike((*tokens)[at]) : WordLike(no, (*tokens)[at]));
      }
      for (const Token& token : TokensBetween(*tokens, next, end)) others.push_back(token);
    }
    const bool on = IsOneOf(WordAt(*tokens, end), {"or", "and", "nor"}) &&
                    !IsOneOf(WordAt(*tokens, end + 1), {"a", "an", "the"});
    if (!on) break;
    next = end + 1;
  }
  while (IsOneOf(WordAt(*tokens, end), {"at", "all", "whatsoever", "inside", "anywhere"})) ++end;
  if (IsOneOf(WordAt(*tokens, end), {"in", "on"}) && WordAt(*tokens, end + 1) == "it") end += 2;
  const std::size_t verb = end + (before < at && IsMark(*tokens, end) ? 1 : 0);
  if (lacked.empty() || !IsAssertion(WordAt(*tokens, verb))) return;
  const NamedThing thing = named.front();
  const ClassWordMatch noun = MatchClassWord(*tokens, thing.begin);
  std::vector<std::string_view> adjectives;
  bool told = noun.is_line();
  for (const ClassWord* word : lacked) {
    told = told || IsNamedBeside(*tokens, *word, at, verb);
    if (!WithoutIt(*word).empty()) adjectives.push_back(WithoutIt(*word));
  }
  if (!told) InsertTokens(tokens, StopAfter(*tokens, verb), others);
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, before, verb - before);
  if (told) return;
  std::vector<Token> said;
  for (const std::string_view word : adjectives) said.push_back(WordLike(word, beside));
  InsertTokens(tokens, thing.begin, said);
  // "an unbuilt meadow", "a treeless island"
  if (!said.empty() && thing.begin > 0 && IsOneOf(WordAt(*tokens, thing.begin - 1), {"a", "an"}))
    (*tokens)[thing.begin - 1].text = said.front().text[0] == 'u' ? "an" : "a";
}

// "The houses avoid the lake", "roads should avoid the water": they are away from it.
void TurnAvoid(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "avoid" || at == 0) return;
  std::size_t begin = at;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1),
                              {"should", "must", "shall", "may",   "will",   "to",   "ought",
                               "has",    "have", "need",  "needs", "always", "also", "carefully",
                               "all",    "both", "are",   "is",    "tries",  "try",  "can"})) {
    --begin;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, begin);
  const bool subject = (!named.empty() && named.front().end == begin) ||
                       (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"it", "they", "which"}));
  if (!subject || !TakeNounSpan(*tokens, at + 1).found()) return;
  ReplaceTokens(tokens, begin, at + 1 - begin, {"are", "away", "from"});
}

// "near", "next to": the token after it; `at`: no such words.
std::size_t SkipCloseness(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view word = WordAt(tokens, at);
  if (IsOneOf(word, {"near", "beside", "by", "alongside"})) return at + 1;
  const bool to = IsOneOf(word, {"next", "close", "adjacent"}) && WordAt(tokens, at + 1) == "to";
  return to ? at + 2 : at;
}

bool IsTouching(std::string_view word) {
  return IsOneOf(word, {"touches", "touch", "borders", "border", "adjoins", "adjoin", "meets",
                        "meet", "reaches", "reach"});
}

// "The road touches neither the lake nor the wood", "is near neither", "lies neither near the lake
// nor the wood": not next to the lake and not next to the wood.
void TurnTouchesNeither(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "neither" || at == 0) return;
  const Token beside = (*tokens)[at];
  std::size_t begin = at, first = at + 1;
  std::vector<Token> how;
  const std::size_t close = SkipCloseness(*tokens, at + 1);
  if (close > at + 1) {
    how = SaidLike("not " + JoinWords(*tokens, at + 1, close), beside);
    first = close;
  } else if (IsTouching(WordAt(*tokens, at - 1))) {
    how = SaidLike("not next to", beside);
    --begin;
  } else if (IsOneOf(WordAt(*tokens, at - 1), {"crosses", "cross"})) {
    how = SaidLike("does not cross", beside);
    --begin;
  } else {
    for (std::size_t back = 1; back <= 2 && back <= at; ++back)
      if (SkipCloseness(*tokens, at - back) == at) begin = at - back;
    if (begin == at) return;
    how = SaidLike("not " + JoinWords(*tokens, begin, at), beside);
  }
  const NounSpan one = TakeNounSpan(*tokens, first);
  if (!one.found() || WordAt(*tokens, one.end) != "nor") return;
  std::size_t second = one.end + 1;
  if (close > at + 1) second = SkipCloseness(*tokens, second);
  if (!TakeNounSpan(*tokens, second).found()) return;
  std::vector<Token> again = {WordLike("and", beside)};
  again.insert(again.end(), how.begin(), how.end());
  EraseTokens(tokens, one.end, second - one.end);
  InsertTokens(tokens, one.end, again);
  EraseTokens(tokens, begin, first - begin);
  InsertTokens(tokens, begin, how);
}

// "Neither the lake nor the wood is near the road", "... lies in the north": the lake and the wood
// are not.
void TurnNeitherIs(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "neither") return;
  const NounSpan one = TakeNounSpan(*tokens, at + 1);
  if (!one.found() || WordAt(*tokens, one.end) != "nor") return;
  const NounSpan two = TakeNounSpan(*tokens, one.end + 1);
  if (!two.found()) return;
  std::size_t verb = two.end;
  const bool modal = IsOneOf(WordAt(*tokens, verb), {"should", "must", "may", "shall", "can"});
  if (modal) ++verb;
  const std::string_view word = WordAt(*tokens, verb);
  if (IsOneOf(word, {"is", "are", "lies", "lie", "stands", "stand", "sits", "sit", "be"})) {
    const std::size_t to = verb + 1;
    // "neither trees nor houses are in the north" asks for none of them.
    const bool known = WordAt(*tokens, one.begin) == "the" && WordAt(*tokens, two.begin) == "the";
    const bool place = SkipCloseness(*tokens, to) > to ||
                       (known && IsOneOf(WordAt(*tokens, to), {"in", "at", "on"}));
    if (!place) return;
    ReplaceTokens(tokens, two.end, to - two.end, {"are", "not"});
  } else if (IsTouching(word) && modal) {
    ReplaceTokens(tokens, two.end, verb + 1 - two.end, {"are", "not", "next", "to"});
  } else if (IsOneOf(word, {"crosses", "cross"})) {
    ReplaceTokens(tokens, two.end, verb + 1 - two.end, {"do", "not", "cross"});
  } else {
    return;
  }
  (*tokens)[one.end].text = "and";
  EraseTokens(tokens, at, 1);
}

}  // namespace

void TurnNegatives(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnWithout(tokens, at);
    TurnAvoid(tokens, at);
    TurnTouchesNeither(tokens, at);
    TurnNeitherIs(tokens, at);
  }
}

}  // namespace latticeworld
