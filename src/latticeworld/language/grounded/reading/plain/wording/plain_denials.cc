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

// What things do not have and where they do not go.
namespace latticeworld {
namespace {

bool IsCourseWord(std::string_view word) {
  return IsOneOf(
      word, {"through", "to", "into", "across", "over", "towards", "toward", "past", "around"});
}

// "Through the forest but not through the village", "through the forest and not the village": and
// never through the village. "Houses along the road but not along the river": but not near it.
void TurnButNot(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "not" || at == 0) return;
  const bool but = IsOneOf(WordAt(*tokens, at - 1), {"but", "yet"});
  const bool comma = (*tokens)[at - 1].kind == TokenKind::kComma;
  if (!but && !comma && WordAt(*tokens, at - 1) != "and") return;
  const std::string_view next = WordAt(*tokens, at + 1);
  if (next == "along") {
    if (but && PastThing(*tokens, at + 2) > 0) (*tokens)[at + 1].text = "near";
    return;
  }
  // `way` is the word for the course that the line does take.
  std::string_view way;
  for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i) && way.empty();)
    if (IsCourseWord(WordAt(*tokens, i)) && PastThing(*tokens, i + 1) > 0) way = WordAt(*tokens, i);
  if (way.empty()) return;
  if (IsCourseWord(next) && PastThing(*tokens, at + 2) > 0) {
    ReplaceTokens(tokens, at - 1, 2, {"and", "never"});
    return;
  }
  const std::size_t end = next == "the" ? PastThing(*tokens, at + 1) : 0;
  const bool after_thing =
      !NamedBefore(*tokens, at - 1).empty() && NamedBefore(*tokens, at - 1).front().end == at - 1;
  if (end > 0 && after_thing && (IsPauseAt(*tokens, end) || WordAt(*tokens, end) == "and")) {
    const std::string said(way);
    ReplaceTokens(tokens, at - 1, 2, {"and", "never", said});
  }
}

// "There are not any houses": there are no houses.
void TurnNotAny(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "not" || WordAt(*tokens, at + 1) != "any" || at == 0 ||
      !IsOneOf(WordAt(*tokens, at - 1), {"is", "are"}) || !NamesThing(*tokens, at + 2)) {
    return;
  }
  ReplaceTokens(tokens, at, 2, {"no"});
}

// "no", "without any", "has no", "with no", "there is no": the token after it, and where it
// begins; `at` where it is none of them.
struct Lack {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool there = false;  // "there is no"
};
Lack LackAt(const std::vector<Token>& tokens, std::size_t at) {
  Lack lack;
  lack.begin = at;
  if (WordAt(tokens, at) == "without") {
    lack.end = at + 1 + (IsOneOf(WordAt(tokens, at + 1), {"a", "any"}) ? 1 : 0);
    return lack;
  }
  if (WordAt(tokens, at) != "no") return lack;
  lack.end = at + 1;
  if (at == 0) return lack;
  if (WordAt(tokens, at - 1) == "with") lack.begin = at - 1;
  if (IsOneOf(WordAt(tokens, at - 1), {"has", "have", "makes", "make"})) {
    lack.begin = at - 1;
    if (at > 1 && IsOneOf(WordAt(tokens, at - 2), {"and", "that", "which", "it", "but"})) {
      lack.begin = at - 2;
      const bool it = WordAt(tokens, at - 2) == "it";
      if (it && at > 2 && IsOneOf(WordAt(tokens, at - 3), {"and", "but"})) lack.begin = at - 3;
    }
  }
  if (at > 1 && IsOneOf(WordAt(tokens, at - 1), {"is", "are"}) &&
      WordAt(tokens, at - 2) == "there") {
    lack.begin = at - 2;
    lack.there = true;
  }
  return lack;
}

// "A river without a bridge", "there are no bridges over the river": a river. No crossing.
void TurnNoBridge(std::vector<Token>* tokens, std::size_t at) {
  const Lack lack = LackAt(*tokens, at);
  if (lack.end == 0 || !IsOneOf(WordAt(*tokens, lack.end), {"bridge", "bridges", "ford", "fords"}))
    return;
  std::size_t end = lack.end + 1;
  const bool of_it =
      WordAt(*tokens, lack.begin) == "without" || WordAt(*tokens, lack.begin) == "with";
  // "a river without a bridge crosses the forest": the river does
  const bool spans = IsOneOf(WordAt(*tokens, end), {"crosses", "cross", "spans", "span"});
  const bool over = (spans && !of_it) ||
                    IsOneOf(WordAt(*tokens, end), {"over", "across", "on", "crossing", "spanning"});
  if (over) ++end;
  const bool ends = IsPauseAt(*tokens, end) || WordAt(*tokens, end) == "and" || (of_it && spans) ||
                    (of_it && !NamesThing(*tokens, end)) ||
                    (of_it && IsOneOf(WordAt(*tokens, end), {"separates", "divides", "flows",
                                                             "runs", "splits", "leads", "goes"}));
  if (!over && !ends) return;
  if (lack.there && over) {
    const std::size_t verb = lack.end - 1;  // "there is the river"
    EraseTokens(tokens, verb, end - verb);
    return;
  }
  // "and over it there is no bridge": all of it goes.
  const std::size_t thing = over ? PastThing(*tokens, end) : 0;
  std::size_t begin = lack.begin;
  if (over && lack.begin > 0 && thing > 0 && !IsStopAt(*tokens, lack.begin - 1)) end = thing;
  if (over && IsOneOf(WordAt(*tokens, end), {"it", "them"})) ++end;
  const bool linked = begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"and", "but"});
  if (linked && IsPauseAt(*tokens, end)) --begin;
  const bool comma = begin > 0 && (*tokens)[begin - 1].kind == TokenKind::kComma;
  if (comma && IsPauseAt(*tokens, end)) --begin;
  EraseTokens(tokens, begin, end - begin);
}

bool IsBendWord(std::string_view word) {
  return IsOneOf(word, {"bend", "bends", "curve", "curves", "turn", "turns", "twist", "twists",
                        "winding", "windings", "meander", "meanders", "kinks", "corners", "loops"});
}

// "It never bends", "that does not curve": is straight.
void TurnNeverBends(std::vector<Token>* tokens, std::size_t at) {
  std::size_t begin = at;
  if (WordAt(*tokens, at) == "not") {
    if (at == 0 || !IsOneOf(WordAt(*tokens, at - 1), {"does", "do"})) return;
    --begin;
  }
  const bool bends = IsOneOf(WordAt(*tokens, at + 1), {"bends", "bend", "curves", "curve", "winds",
                                                       "wind", "meanders", "meander"});
  if (bends && (IsPauseAt(*tokens, at + 2) ||
                IsOneOf(WordAt(*tokens, at + 2),
                        {"and", "at", "goes", "runs", "leads", "flows", "crosses"}))) {
    ReplaceTokens(tokens, begin, at + 2 - begin, {"is", "straight"});
  }
}

// The token after "sharp bends or turns at all", where they are what is lacked; 0: they are not.
std::size_t AfterBends(const std::vector<Token>& tokens, const Lack& lack) {
  std::size_t noun = lack.end;
  if (IsOneOf(WordAt(tokens, noun), {"sharp", "big", "real", "single"})) ++noun;
  if (!IsBendWord(WordAt(tokens, noun))) return 0;
  std::size_t end = noun + 1;
  if (!IsPauseAt(tokens, end) && MatchClassWord(tokens, end).tokens > 0) return 0;
  if (IsOneOf(WordAt(tokens, end), {"or", "and"}) && IsBendWord(WordAt(tokens, end + 1))) end += 2;
  if (WordAt(tokens, end) == "at" && WordAt(tokens, end + 1) == "all") end += 2;
  return end;
}

// The token after what lacks something.
std::size_t OwnerEnd(const std::vector<Token>& tokens, const Lack& lack) {
  return lack.begin - (lack.begin > 0 && IsMark(tokens, lack.begin - 1) ? 1 : 0);
}

// What lacks bends: a line, or a pronoun or nothing that may stand for one; `thing` is the line
// where it is named.
struct Bent {
  bool line = false;
  NamedThing thing = {0, 0};
};
Bent BentBefore(const std::vector<Token>& tokens, const Lack& lack, bool has) {
  const std::size_t before = OwnerEnd(tokens, lack);
  const bool pronoun =
      has && IsOneOf(WordAt(tokens, lack.begin), {"it", "they", "which", "that", "and", "but"});
  const std::size_t sentence = SentenceBegin(tokens, lack.begin);
  Bent bent;
  bent.line = pronoun || before == sentence;
  for (const NamedThing& named : NamedBefore(tokens, before)) {
    if (bent.line || named.begin < sentence) break;
    bent.line = MatchClassWord(tokens, named.begin).is_line();
    if (bent.line) bent.thing = named;
    // "a road from the village to the lake without bends"
    const std::size_t first = PhraseBegin(tokens, named.end);
    if (!bent.line && named.end == before &&
        (first == 0 || !IsOneOf(WordAt(tokens, first - 1), {"to", "from", "past", "through",
                                                            "across", "towards", "between"}))) {
      break;
    }
  }
  return bent;
}

// "A town without any bends in the river": with a straight river. Nothing else is straight: "a lake
// with no corners" is a lake. `end` is the token after the bends.
void TurnBendsOfOther(std::vector<Token>* tokens, const Lack& lack, std::size_t end) {
  const std::size_t in = WordAt(*tokens, end) == "in" ? PastThing(*tokens, end + 1) : 0;
  const NamedThing other = in > 0 ? NamedBefore(*tokens, in).front() : NamedThing{0, 0};
  if (in > 0 && MatchClassWord(*tokens, other.begin).is_line()) {
    const Token beside = (*tokens)[lack.begin];
    const bool many = MatchClassWord(*tokens, other.begin).plural;
    const std::string name = JoinWords(*tokens, other.begin, other.end);
    EraseTokens(tokens, lack.begin, in - lack.begin);
    InsertTokens(tokens, lack.begin,
                 SaidLike((many ? "with straight " : "with a straight ") + name, beside));
  } else if (IsPauseAt(*tokens, end) || WordAt(*tokens, end) == "and") {
    EraseTokens(tokens, lack.begin, end - lack.begin);
  }
}

// "A road without bends": in a straight line. "It has no curves", "that never bends": is straight.
void TurnNoBends(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"never", "not"})) {
    TurnNeverBends(tokens, at);
    return;
  }
  const Lack lack = LackAt(*tokens, at);
  if (lack.end == 0 || lack.there) return;
  const std::size_t end = AfterBends(*tokens, lack);
  if (end == 0) return;
  std::size_t verb = lack.begin;
  while (verb < lack.begin + 3 && !IsOneOf(WordAt(*tokens, verb), {"has", "have"})) ++verb;
  const bool has = verb < lack.begin + 3;
  const Bent bent = BentBefore(*tokens, lack, has);
  if (!bent.line) {
    if (!has) TurnBendsOfOther(tokens, lack, end);
  } else if (has) {
    ReplaceTokens(tokens, verb, end - verb, {"is", "straight"});
  } else if (bent.thing.end > 0 && bent.thing.end < OwnerEnd(*tokens, lack)) {
    // "a road from the village to the lake without bends": a straight road
    EraseTokens(tokens, lack.begin, end - lack.begin);
    InsertTokens(tokens, bent.thing.begin, {WordLike("straight", (*tokens)[bent.thing.begin])});
  } else {
    ReplaceTokens(tokens, lack.begin, end - lack.begin, {"in", "a", "straight", "line"});
  }
}

// "No river, only a lake in the north": a lake.
void TurnOnlyOne(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"only", "just"}) || at < 2 ||
      !IsOneOf(WordAt(*tokens, at + 1), {"a", "an"})) {
    return;
  }
  const bool after = (*tokens)[at - 1].kind == TokenKind::kComma ||
                     IsOneOf(WordAt(*tokens, at - 1), {"but", "and"});
  const std::size_t noun = PastArticle(*tokens, at + 1);
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  if (!after || match.word == nullptr || match.word->shape == WordShape::kMass) return;
  bool none = false;
  for (std::size_t i = at - 1; i-- > 0 && !IsStopAt(*tokens, i) && !none;)
    none = WordAt(*tokens, i) == "no" && MatchClassWord(*tokens, i + 1).tokens > 0;
  if (!none) return;
  EraseTokens(tokens, at, 1);
}

}  // namespace

void TurnDenials(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnButNot(tokens, at);
    TurnNotAny(tokens, at);
    TurnNoBridge(tokens, at);
    TurnNoBends(tokens, at);
    TurnOnlyOne(tokens, at);
  }
}

}  // namespace latticeworld
