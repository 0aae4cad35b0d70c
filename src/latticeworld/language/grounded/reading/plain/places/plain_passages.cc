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

// What runs: what stands beside it, where lines meet, what they pass and how they lie.
namespace latticeworld {
namespace {

bool IsRunning(std::string_view word) {
  return IsOneOf(
      word, {"goes",      "go",       "runs",  "run",     "leads",   "lead",   "flows",  "flow",
             "stretches", "extends",  "winds", "crosses", "passes",  "comes",  "enters", "starts",
             "begins",    "meanders", "cuts",  "heads",   "stretch", "extend", "cross"});
}

// A line, or a strip of land, whose last word stands before `at`: where its first word stands; -1:
// none. "A strip of forest" too.
bool IsLineBefore(const std::vector<Token>& tokens, std::size_t at) {
  const std::vector<NamedThing> named = NamedBefore(tokens, at);
  if (named.empty() || named.front().end != at) return false;
  const std::size_t noun = named.front().begin;
  if (MatchClassWord(tokens, noun).is_line() || WordAt(tokens, noun) == "hedge") return true;
  return noun > 1 && WordAt(tokens, noun - 1) == "of" &&
         IsOneOf(WordAt(tokens, noun - 2), {"strip", "belt", "band", "ridge", "line", "chain"});
}

// "on both sides", "on its north side", "at its end", "along it": the token after them; 0: none.
std::size_t TakeBeside(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"on", "along", "at", "beside", "near", "to"})) return 0;
  if (IsOneOf(WordAt(tokens, at + 1), {"both", "either", "each"}) &&
      IsOneOf(WordAt(tokens, at + 2), {"side", "sides", "bank", "banks", "end", "ends", "flank"})) {
    const bool of_it = WordAt(tokens, at + 3) == "of" && WordAt(tokens, at + 4) == "it";
    return at + (of_it ? 5 : 3);
  }
  if (WordAt(tokens, at + 1) == "top") return at + 2;
  if (WordAt(tokens, at + 1) == "it") return at + 2;
  if (WordAt(tokens, at) != "to" && IsOneOf(WordAt(tokens, at + 1), {"its", "their"}) &&
      IsOneOf(WordAt(tokens, at + 2), {"end", "banks", "bank", "sides", "side", "ends"})) {
    return at + 3;
  }
  if (!IsOneOf(WordAt(tokens, at + 1), {"its", "the"})) return 0;
  Heading heading;
  const std::size_t side = TakeHeading(tokens, at + 1, &heading);
  if (side == 0) return 0;
  if (WordAt(tokens, side) == "of" && WordAt(tokens, side + 1) == "it") return side + 2;
  if (IsFlank(WordAt(tokens, side))) return WordAt(tokens, side + 1) == "of" ? 0 : side + 1;
  return WordAt(tokens, at + 1) == "its" ? side : 0;
}

// "A road with houses on both sides goes from the west edge to the east edge": a road goes there,
// with houses on both sides.
void TurnFlankedSubject(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "with" || at == 0) return;
  const bool comma = (*tokens)[at - 1].kind == TokenKind::kComma;
  const std::size_t begin = at - (comma ? 1 : 0);
  if (!IsLineBefore(*tokens, begin)) return;
  std::size_t beside = at + 1;
  constexpr std::size_t kLongest = 7;
  std::size_t end = 0;
  for (; beside < at + kLongest && end == 0 && !IsPauseAt(*tokens, beside); ++beside) {
    if (IsRunning(WordAt(*tokens, beside))) return;
    end = TakeBeside(*tokens, beside);
  }
  if (end == 0 || !NamesThing(*tokens, at + 1)) return;
  // "houses on its east side and fields on its west side"
  if (WordAt(*tokens, end) == "and" && NamesThing(*tokens, end + 1)) {
    std::size_t more = 0;
    for (beside = end + 1; beside < end + kLongest && more == 0 && !IsPauseAt(*tokens, beside);
         ++beside) {
      if (IsRunning(WordAt(*tokens, beside))) return;
      more = TakeBeside(*tokens, beside);
    }
    if (more == 0) return;
    end = more;
  }
  std::size_t verb = end;
  if (verb < tokens->size() && (*tokens)[verb].kind == TokenKind::kComma) ++verb;
  if (!IsRunning(WordAt(*tokens, verb))) return;
  std::vector<Token> moved = TokensBetween(*tokens, at, end);
  std::size_t to = PauseAfter(*tokens, verb);
  // "... and a lake is in the north": of something else.
  for (std::size_t i = verb + 1; i < to; ++i) {
    if (!IsOneOf(WordAt(*tokens, i), {"and", "but", "while", "whereas"})) continue;
    const std::size_t other = PhraseEnd(*tokens, i + 1);
    const bool clause =
        WordAt(*tokens, i + 1) == "there" ||
        (other > i + 1 && WordAt(*tokens, i + 1) != "it" &&
         (SkipBeing(*tokens, other) > other || IsRunning(WordAt(*tokens, other)) ||
          IsOneOf(WordAt(*tokens, other), {"has", "have", "covers", "cover", "fills", "fill",
                                           "surrounds", "surround", "occupies"})));
    if (!clause) continue;
    // The clause becomes a sentence of its own; if the phrase says "both", "either" or "each",
    // TurnRelatives makes it one.
    for (std::size_t k = at; k < end; ++k)
      if (IsOneOf(WordAt(*tokens, k), {"both", "either", "each"})) return;
    (*tokens)[i] = StopLike((*tokens)[i]);
    to = i;
  }
  // "..., turns south and ends there": it is told to the end of the sentence.
  // "a ridge of rock": what is no line is left in one phrase with its way.
  if (MatchClassWord(*tokens, NamedBefore(*tokens, begin).front().begin).is_line())
    moved.insert(moved.begin(), CommaLike((*tokens)[at]));
  if (to < tokens->size() && !IsStopAt(*tokens, to)) {
    const std::string_view next = WordAt(*tokens, to + 1);
    if (!IsOneOf(next, {"with", "and"}) || WordAt(*tokens, to + 2) == "then") {
      // There is no room for it before what goes on with the line.
      if (next == "then" || IsRunning(next)) return;
    }
  }
  InsertTokens(tokens, to, moved);
  EraseTokens(tokens, begin, verb - begin);
}

bool Joins(const std::vector<Token>& tokens, std::size_t at, std::size_t* end) {
  const std::string_view word = WordAt(tokens, at);
  *end = at + 1;
  if (IsOneOf(word, {"meet", "join", "unite", "converge", "merge"})) {
    while (IsOneOf(WordAt(tokens, *end), {"up", "together"})) ++*end;
    return true;
  }
  *end = at + 2;
  return IsOneOf(word, {"come", "flow", "run", "lead"}) && WordAt(tokens, at + 1) == "together";
}

// "Two rivers meet in the middle": rivers meet there; how many pieces they are, nobody says. "The
// roads cross at the center": they meet at a junction.
void TurnMeetingLines(std::vector<Token>* tokens, std::size_t at) {
  const bool counted = IsOneOf(WordAt(*tokens, at), {"two", "three", "four", "five", "several"}) ||
                       (at < tokens->size() && (*tokens)[at].kind == TokenKind::kNumber);
  const bool known = WordAt(*tokens, at) == "the" || WordAt(*tokens, at) == "all";
  if (!counted && !known) return;
  // "a mill where two roads meet", "the two roads", "a cross of two roads"
  if (at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"where", "the", "of", "these", "how"})) return;
  std::size_t noun = at + 1;
  if (known && IsOneOf(WordAt(*tokens, noun), {"the", "two", "three", "four"})) ++noun;
  while (IsSize(WordAt(*tokens, noun)) ||
         IsOneOf(WordAt(*tokens, noun), {"straight", "winding", "main"})) {
    ++noun;
  }
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  if (!match.is_line() || !match.plural) return;
  std::size_t verb = noun + match.tokens;
  if (IsOneOf(WordAt(*tokens, verb), {"all", "both"})) ++verb;
  std::size_t end = verb + 1;
  const bool cross = IsOneOf(WordAt(*tokens, verb), {"cross", "intersect"});
  if (cross) {
    if (match.word->suburb != 'R') return;
    if (WordAt(*tokens, end) == "each" && WordAt(*tokens, end + 1) == "other") end += 2;
    if (WordAt(*tokens, end) == "one" && WordAt(*tokens, end + 1) == "another") end += 2;
  } else if (!counted || !Joins(*tokens, verb, &end)) {
    return;
  }
  if (!IsPauseAt(*tokens, end) &&
      !IsOneOf(WordAt(*tokens, end), {"in", "at", "near", "and", "inside", "within", "beside"})) {
    return;
  }
  // "one from the west and one from the north": then each is a river of its own.
  for (std::size_t i = end; i < StopAfter(*tokens, end); ++i) {
    if (!cross && WordAt(*tokens, i) == "as" && IsOneOf(WordAt(*tokens, i + 1), {"one", "a"})) {
      const std::size_t last = PauseAfter(*tokens, i);
      std::size_t first = i;
      while (first > end && WordAt(*tokens, first) != "and") --first;
      if (first == end) return;
      EraseTokens(tokens, first, last - first);
      break;
    }
    if (IsOneOf(WordAt(*tokens, i), {"one", "another", "both", "each", "they", "first", "other"}))
      return;
  }
  const std::size_t stop = StopAfter(*tokens, end);
  if (stop < tokens->size() && IsOneOf(WordAt(*tokens, stop + 1), {"one", "both", "each", "the"}) &&
      !NamesThing(*tokens, stop + 1)) {
    return;
  }
  if (cross) {
    ReplaceTokens(tokens, verb, end - verb, {"meet", "at", "a", "junction"});
  } else {
    // "join in the north": the north is no end of them.
    if (WordAt(*tokens, verb) == "join" && WordAt(*tokens, end) == "in")
      ReplaceTokens(tokens, verb, end - verb, {"meet"});
    EraseTokens(tokens, at, 1);
  }
}

// "The road passes the village on the north side", "bypasses the town to the south": runs past the
// village on the north side of the village; passes south of the town.
void TurnPassing(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"passes", "pass", "passing", "bypasses", "bypass", "skirts",
                                     "bypassing", "skirting"})) {
    return;
  }
  std::size_t noun = at + 1;
  if (WordAt(*tokens, noun) == "by") ++noun;
  if (!IsOneOf(WordAt(*tokens, noun), {"the", "a", "this", "that"})) return;
  const std::size_t article = noun;
  ++noun;
  while (IsSize(WordAt(*tokens, noun))) ++noun;
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  const std::size_t on = noun + match.tokens;
  if (match.word == nullptr || !IsOneOf(WordAt(*tokens, on), {"on", "to", "in"}) ||
      !IsOneOf(WordAt(*tokens, on + 1), {"the", "its"})) {
    return;
  }
  Heading heading;
  std::size_t end = TakeHeading(*tokens, on + 1, &heading);
  if (end == 0) return;
  const bool flank = IsOneOf(WordAt(*tokens, end), {"side", "flank"});
  // "passes the village in the south": the village is there.
  if (WordAt(*tokens, on) != "to" && !flank) return;
  if (flank) ++end;
  if (!IsPauseAt(*tokens, end) && !IsOneOf(WordAt(*tokens, end), {"and", "before", "then"})) return;
  const std::string side(NameOf(heading));
  if (side.empty()) return;
  const bool far = WordAt(*tokens, at).substr(0, 4) == "bypa";
  const std::vector<Token> thing = TokensBetween(*tokens, article, on);
  std::vector<Token> said = SaidLike(
      far ? "passes " + side + " of the"
          : "runs past the " + JoinWords(*tokens, noun, on) + " on the " + side + " side of the",
      (*tokens)[at]);
  said.insert(said.end(), thing.begin() + 1, thing.end());
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "The streets of the town form a grid": in the town the streets form a grid.
void TurnOwnedLines(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "the" || (at > 0 && !IsPauseAt(*tokens, at - 1))) return;
  const ClassWordMatch line = MatchClassWord(*tokens, at + 1);
  const std::size_t of = at + 1 + line.tokens;
  if (!line.is_line() || !IsOneOf(WordAt(*tokens, of), {"of", "in"}) ||
      !IsOneOf(WordAt(*tokens, of + 1), {"the", "this", "that", "each"})) {
    return;
  }
  const ClassWordMatch owner = MatchClassWord(*tokens, of + 2);
  const std::size_t verb = of + 2 + owner.tokens;
  if (owner.word == nullptr || owner.is_line() ||
      !IsOneOf(WordAt(*tokens, verb), {"is", "are", "form", "forms", "make", "run", "runs"})) {
    return;
  }
  bool shape = false;
  for (std::size_t i = verb + 1; i < verb + 7 && !IsPauseAt(*tokens, i); ++i) {
    if (MatchClassWord(*tokens, i).tokens > 0) return;
    shape = shape || IsOneOf(WordAt(*tokens, i),
                             {"grid", "straight", "winding", "crooked", "gridded", "curved",
                              "meandering", "curvy", "twisty", "ring", "bent"});
  }
  if (!shape) return;
  std::vector<Token> said = TokensBetween(*tokens, of, verb);
  said.front().text = "in";
  EraseTokens(tokens, of, verb - of);
  InsertTokens(tokens, at, said);
}

// "The tree line runs from west to east, with rock above it and forest below it": rock north of
// forest.
void TurnTreeLine(std::vector<Token>* tokens, std::size_t at) {
  const bool two =
      IsOneOf(WordAt(*tokens, at), {"tree", "snow", "timber"}) && WordAt(*tokens, at + 1) == "line";
  if (!two && !IsOneOf(WordAt(*tokens, at), {"treeline", "snowline", "timberline"})) return;
  const std::size_t verb = at + (two ? 2 : 1);
  if (!IsRunning(WordAt(*tokens, verb)) && !IsPauseAt(*tokens, verb)) return;
  const std::size_t stop = StopAfter(*tokens, verb);
  for (std::size_t with = verb; with < stop; ++with) {
    if (!IsPauseAt(*tokens, with) && WordAt(*tokens, with) != "with") continue;
    const std::size_t first = with + 1 + (WordAt(*tokens, with + 1) == "with" ? 1 : 0);
    const std::size_t above = first + MatchClassWord(*tokens, first).tokens;
    if (above == first || !IsOneOf(WordAt(*tokens, above), {"above", "below"}) ||
        WordAt(*tokens, above + 1) != "it" || WordAt(*tokens, above + 2) != "and") {
      continue;
    }
    const std::size_t second = above + 3;
    const std::size_t below = second + MatchClassWord(*tokens, second).tokens;
    if (below == second || !IsOneOf(WordAt(*tokens, below), {"above", "below"}) ||
        !IsPauseAt(*tokens, below + (WordAt(*tokens, below + 1) == "it" ? 2 : 1))) {
      return;
    }
    const std::string said = JoinWords(*tokens, first, above) + " lies " +
                             (WordAt(*tokens, above) == "above" ? "north" : "south") + " of the " +
                             JoinWords(*tokens, second, below);
    const std::size_t begin = at - (at > 0 && WordAt(*tokens, at - 1) == "the" ? 1 : 0);
    const Token beside = (*tokens)[begin];
    EraseTokens(tokens, begin, below + (WordAt(*tokens, below + 1) == "it" ? 2 : 1) - begin);
    InsertTokens(tokens, begin, SaidLike(said, beside));
    return;
  }
}

// "A road loops around the pond", and no more of it is told: it goes around it.
void TurnLoop(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "loops" || !IsOneOf(WordAt(*tokens, at + 1), {"around", "round"}))
    return;
  const std::size_t end = PastThing(*tokens, at + 2);
  if (end == 0 || !IsStopAt(*tokens, end) || !IsLineBefore(*tokens, at)) return;
  const NamedThing line = NamedBefore(*tokens, at).front();
  const ClassWordMatch match = MatchClassWord(*tokens, line.begin);
  if (match.is_line() && match.word->suburb == 'R' &&
      line.begin <= SentenceBegin(*tokens, at) + 2) {
    (*tokens)[at].text = "goes";
  }
}

}  // namespace

void TurnPassages(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnFlankedSubject(tokens, at);
    TurnMeetingLines(tokens, at);
    TurnPassing(tokens, at);
    TurnOwnedLines(tokens, at);
    TurnTreeLine(tokens, at);
    TurnLoop(tokens, at);
  }
}

}  // namespace latticeworld
