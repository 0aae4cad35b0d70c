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

// This file rewrites how texts tell where lines begin, end and part.
namespace latticeworld {
namespace {

// The last line named before `at` in its sentence; an empty noun: none.
NamedThing LineBefore(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t begin = SentenceBegin(tokens, at);
  for (const NamedThing& named : NamedBefore(tokens, at))
    if (named.begin >= begin && MatchClassWord(tokens, named.begin).is_line()) return named;
  return {0, 0};
}

// "Roads run from the center to all four corners": to the four of them by their names. "To the two
// lower corners", "to every edge".
void TurnAllEnds(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "to" || LineBefore(*tokens, at).end == 0) return;
  std::size_t next = at + 1;
  const bool every = IsOneOf(WordAt(*tokens, next), {"every", "each"});
  const bool all = IsOneOf(WordAt(*tokens, next), {"all", "both"});
  if (every || all) ++next;
  while (IsOneOf(WordAt(*tokens, next), {"the", "of"})) ++next;
  const bool two = WordAt(*tokens, next) == "two" || WordAt(*tokens, at + 1) == "both";
  bool counted = two;
  if (IsOneOf(WordAt(*tokens, next), {"two", "four"}) ||
      (next < tokens->size() && (*tokens)[next].text == "4")) {
    counted = true;
    ++next;
  }
  const std::string side(two ? SideWord(WordAt(*tokens, next)) : std::string_view());
  if (!side.empty()) ++next;
  const std::string_view noun = WordAt(*tokens, next);
  const bool corner = IsOneOf(noun, {"corner", "corners"});
  if (!corner && !(every && IsOneOf(noun, {"edge", "side", "border"}))) return;
  if (two == side.empty() || (!every && !all && !counted)) return;
  std::size_t end = next + 1;
  if (WordAt(*tokens, end) == "of") {
    if (WordAt(*tokens, end + 1) != "the" || !IsMapWord(WordAt(*tokens, end + 2))) return;
    end += 3;
  }
  if (!IsPauseAt(*tokens, end)) return;
  // "Roads go to every corner": a cross of two, which is known.
  if (!corner || WordAt(*tokens, at + 1) == "every" || WordAt(*tokens, at + 1) == "each") {
    bool from = false;
    for (std::size_t i = at; i-- > SentenceBegin(*tokens, at);)
      from = from || WordAt(*tokens, i) == "from";
    if (!from) return;
  }
  std::string said;
  if (!corner) {
    said = "to the northern edge, the southern edge, the eastern edge and the western edge";
  } else {
    for (const std::string_view which : {"northwest", "northeast", "southwest", "southeast"}) {
      if (!side.empty() && which.find(side) == std::string_view::npos) continue;
      if (said.empty()) {
        said = "to the ";
      } else {
        said += which == "southeast" || (two && side == "north") || (two && side == "west")
                    ? " and the "
                    : ", the ";
      }
      said += std::string(which) + " corner";
    }
  }
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, SaidLike(said, beside));
}

// "The road splits; one arm goes to the east and the other to the south": one road goes there.
void TurnArmsOf(std::vector<Token>* tokens, std::size_t at) {
  const bool noun = IsOneOf(WordAt(*tokens, at), {"arm", "branch", "fork", "prong"});
  if (!noun || at == 0 || WordAt(*tokens, at - 1) != "one") return;
  // The arms are those of a line that splits in the words before.
  constexpr std::size_t kReach = 20;
  bool splits = false;
  for (std::size_t back = 1; back < kReach && back < at && !splits; ++back) {
    const std::size_t verb = at - back;
    splits = IsOneOf(WordAt(*tokens, verb),
                     {"splits", "forks", "divides", "branches", "split", "fork", "parts"});
    if (!splits) continue;
    // If it is told where the stem comes from, the first arm goes on from there.
    std::size_t first = SentenceBegin(*tokens, verb);
    if (first > 0) first = SentenceBegin(*tokens, first - 1);
    for (std::size_t i = first; i < at; ++i) {
      if (IsOneOf(WordAt(*tokens, i), {"from", "arrives", "enters", "comes", "starts", "begins"}))
        return;
    }
    const std::vector<NamedThing> named = NamedBefore(*tokens, verb);
    if (named.empty() || !MatchClassWord(*tokens, named.front().begin).is_line()) return;
    const std::string line = Singular(JoinWords(*tokens, named.front().begin, named.front().end));
    const Token beside = (*tokens)[at];
    const std::size_t begin = at - 1;
    EraseTokens(tokens, at, 1);
    InsertTokens(tokens, at, SaidLike(line, beside));
    const bool pause = begin > 0 && !IsStopAt(*tokens, begin - 1);
    const bool at_end = begin == verb + 1 || (pause && begin == verb + 2);
    // "splits, one arm ...": that it does needs no words.
    if (at_end) {
      EraseTokens(tokens, verb, begin - verb);
      InsertTokens(tokens, verb, {StopLike(beside)});
    } else if (pause) {
      if ((*tokens)[begin - 1].kind == TokenKind::kComma) EraseTokens(tokens, begin - 1, 1);
      InsertTokens(tokens, begin - ((*tokens)[begin].text == "one" ? 0 : 1), {StopLike(beside)});
    }
    return;
  }
}

// "A road that begins in the north ends in the south": begins there and ends in the south.
void TurnBeginning(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"that", "which"}) || at == 0 ||
      !IsOneOf(WordAt(*tokens, at + 1),
               {"begins", "starts", "enters", "comes", "begin", "start"})) {
    return;
  }
  const NamedThing line = LineBefore(*tokens, at);
  if (line.end != at) return;
  std::size_t end = at + 2;
  while (
      !IsPauseAt(*tokens, end) &&
      !IsOneOf(WordAt(*tokens, end), {"ends", "end", "stops", "leaves", "and", "goes", "runs"})) {
    ++end;
  }
  if (!IsOneOf(WordAt(*tokens, end), {"ends", "end", "stops", "leaves"})) return;
  if (!IsOneOf(WordAt(*tokens, end + 1), {"in", "at", "on", "near"})) return;
  InsertTokens(tokens, end, {WordLike("and", (*tokens)[end])});
  EraseTokens(tokens, at, 1);
}

// "One road from west to east and one that goes to the south": and another road. "There is another
// one that goes north": another road goes. "Another one goes": a second road goes.
void TurnAnotherOne(std::vector<Token>* tokens, std::size_t at) {
  const bool another = WordAt(*tokens, at) == "another" && WordAt(*tokens, at + 1) == "one";
  const bool one = WordAt(*tokens, at) == "one" && at > 0 && WordAt(*tokens, at - 1) == "and";
  if (!another && !one) return;
  const std::size_t next = at + (another ? 2 : 1);
  const std::size_t verb = next + (IsOneOf(WordAt(*tokens, next), {"that", "which"}) ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, verb), {"goes", "runs", "leads", "flows", "comes", "crosses"}))
    return;
  if (one && verb == next) return;
  if (WordAt(*tokens, verb + 1) == "along") return;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty()) return;
  // The last line, in this sentence or the one before.
  const NamedThing* line = nullptr;
  for (const NamedThing& thing : named)
    if (line == nullptr && MatchClassWord(*tokens, thing.begin).is_line()) line = &thing;
  if (line == nullptr || MatchClassWord(*tokens, line->begin).plural) return;
  const std::string said = "a second " + JoinWords(*tokens, line->begin, line->end);
  const std::size_t count = line->begin > 0 ? line->begin - 1 : 0;
  const bool counted = WordAt(*tokens, count) == "one" && count < line->begin;
  std::size_t begin = at;
  if (begin > 1 && IsOneOf(WordAt(*tokens, begin - 1), {"is", "runs"}) &&
      WordAt(*tokens, begin - 2) == "there") {
    begin -= 2;
  }
  if (begin > 0 && WordAt(*tokens, begin - 1) == "and") --begin;
  const bool stop = begin == 0 || IsStopAt(*tokens, begin - 1);
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, begin, verb - begin);
  std::vector<Token> words = SaidLike(said, beside);
  if (!stop) {
    if ((*tokens)[begin - 1].kind == TokenKind::kComma) EraseTokens(tokens, --begin, 1);
    words.insert(words.begin(), StopLike(beside));
  }
  InsertTokens(tokens, begin, words);
  if (counted) (*tokens)[count].text = "a";
}

// "A road goes all around the map", "a road circles the whole map": a ring road along the edges.
void TurnRoundMap(std::vector<Token>* tokens, std::size_t at) {
  // "circles the map", "goes all the way around the map"
  std::size_t verb = at;
  if (IsOneOf(WordAt(*tokens, verb), {"that", "which"})) ++verb;
  std::size_t next = verb + 1;
  const bool circles = IsOneOf(WordAt(*tokens, verb), {"circles", "encircles", "rings", "surrounds",
                                                       "rounds", "circling", "encircling"});
  if (!circles) {
    if (!IsOneOf(WordAt(*tokens, verb),
                 {"runs", "goes", "leads", "loops", "running", "going", "passes", "follows"})) {
      return;
    }
    if (IsOneOf(WordAt(*tokens, next), {"all", "right", "completely", "once"})) ++next;
    if (WordAt(*tokens, next) == "the" && WordAt(*tokens, next + 1) == "way") next += 2;
    if (!IsOneOf(WordAt(*tokens, next), {"around", "round"})) return;
    ++next;
  }
  if (WordAt(*tokens, next) != "the") return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"whole", "entire"})) ++next;
  const std::string_view what = WordAt(*tokens, next);
  // It may say of the map's edge, and that it keeps near it.
  const bool edge = IsOneOf(what, {"edge", "edges", "border", "perimeter", "rim", "outside"});
  if (edge && WordAt(*tokens, next + 1) == "of" && WordAt(*tokens, next + 2) == "the" &&
      IsMapWord(WordAt(*tokens, next + 3)) && !circles) {
    next += 3;
  } else if (!IsMapWord(what)) {
    return;
  }
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"near", "along", "at", "close"})) {
    std::size_t last = next + 1;
    while (IsOneOf(WordAt(*tokens, last), {"to", "the", "its"})) ++last;
    if (IsOneOf(WordAt(*tokens, last), {"edge", "edges", "border", "borders", "rim"}))
      next = last + 1;
  }
  if (!IsPauseAt(*tokens, next)) return;
  // The line must be one road, which stands right before.
  const NamedThing line = LineBefore(*tokens, at);
  if (line.end == 0 || line.end != at || MatchClassWord(*tokens, line.begin).plural) return;
  if (MatchClassWord(*tokens, line.begin).word->suburb != 'R') return;
  // It becomes a ring road along the edges.
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, at, next - at);
  InsertTokens(tokens, at, SaidLike("along the edges", beside));
  std::size_t begin = line.begin;
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"ring", "loop", "circular"})) --begin;
  ReplaceTokens(tokens, begin, line.end - begin, {"ring", "road"});
}

// "A belt of forest connects the forest in the north with the forest in the south": it runs from
// the north to the south.
void TurnBelt(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"connects", "links", "joins", "connecting", "linking"}))
    return;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty() || named.front().end != at) return;
  const std::size_t noun = named.front().begin;
  // "belt of trees" is one word of the list.
  const std::size_t belt = noun > 1 && WordAt(*tokens, noun - 1) == "of" ? noun - 2 : noun;
  if (!IsOneOf(WordAt(*tokens, belt),
               {"belt", "band", "strip", "corridor", "tongue", "ribbon", "stripe", "line"})) {
    return;
  }
  const ClassWord* land = MatchClassWord(*tokens, noun).word;
  std::string places[2];
  std::size_t next = at + 1;
  for (int i = 0; i < 2; ++i) {
    if (i == 1 && !IsOneOf(WordAt(*tokens, next++), {"with", "and", "to"})) return;
    if (WordAt(*tokens, next) == "the") ++next;
    const ClassWordMatch match = MatchClassWord(*tokens, next);
    const bool that = WordAt(*tokens, next) == "that" || WordAt(*tokens, next) == "one";
    if (!(that && i == 1)) {
      if (match.word == nullptr || land == nullptr || match.word->suburb != land->suburb ||
          match.word->wild != land->wild) {
        return;
      }
    }
    next += that && i == 1 ? 1 : match.tokens;
    if (!IsOneOf(WordAt(*tokens, next), {"in", "at", "on"})) return;
    std::size_t end = TakeSideWords(*tokens, next + 1, &places[i]);
    if (end == 0) {
      Heading heading;
      end = TakeHeading(*tokens, next + 1, &heading);
      if (end == 0) return;
      places[i] = NameOf(heading);
    }
    next = end + (WordAt(*tokens, end) == "corner" ? 1 : 0);
    if (next > end) places[i] += " corner";
  }
  if (!IsPauseAt(*tokens, next)) return;
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, at, next - at);
  InsertTokens(tokens, at, SaidLike("runs from the " + places[0] + " to the " + places[1], beside));
  (*tokens)[belt].text = "belt";
}

// "The robot follows a road from left to right": there is a road.
void TurnFollowed(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"robot", "rover", "vehicle", "car", "drone", "player", "agent",
                                     "hiker", "walker", "traveller", "traveler"})) {
    return;
  }
  std::size_t begin = at;
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"the", "a", "our"})) --begin;
  if (begin > 0 && !IsPauseAt(*tokens, begin - 1)) return;
  std::size_t next = at + 1;
  while (IsOneOf(WordAt(*tokens, next), {"should", "must", "can", "will", "has", "to"})) ++next;
  if (IsOneOf(WordAt(*tokens, next), {"follows", "follow", "uses", "use", "takes", "take"})) {
    ++next;
  } else if (IsOneOf(WordAt(*tokens, next), {"drives", "travels", "moves", "walks", "drive",
                                             "travel", "move", "walk", "goes", "go"}) &&
             IsOneOf(WordAt(*tokens, next + 1), {"along", "on", "down"})) {
    next += 2;
  } else {
    return;
  }
  const std::size_t article = next;
  if (!IsOneOf(WordAt(*tokens, next), {"a", "an"})) return;
  ++next;
  while (IsSize(WordAt(*tokens, next)) ||
         IsOneOf(WordAt(*tokens, next), {"straight", "winding", "single"})) {
    ++next;
  }
  if (!MatchClassWord(*tokens, next).is_line()) return;
  ReplaceTokens(tokens, begin, article - begin, {"there", "is"});
}

// "A road runs across the top third": from west to east in the top third. "Across the east": from
// north to south.
void TurnAcrossZone(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "across" || at == 0) return;
  if (!IsOneOf(WordAt(*tokens, at - 1), {"runs", "goes", "leads", "flows", "running"})) return;
  if (LineBefore(*tokens, at).end != at - 1) return;
  std::string place;
  std::size_t end = TakeSideWords(*tokens, at + 1, &place);
  if (end == 0 || place.find(' ') != std::string::npos) return;
  if (IsOneOf(WordAt(*tokens, end), {"third", "half", "quarter", "part"})) ++end;
  if (WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "the") {
    if (!IsMapWord(WordAt(*tokens, end + 2))) return;
    end += 3;
  }
  if (!IsPauseAt(*tokens, end)) return;
  const bool rows = place == "north" || place == "south";
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, at, 1);
  InsertTokens(tokens, at,
               SaidLike(rows ? "from west to east in" : "from north to south in", beside));
}

}  // namespace

void TurnArms(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAllEnds(tokens, at);
    TurnArmsOf(tokens, at);
    TurnBeginning(tokens, at);
    TurnAnotherOne(tokens, at);
    TurnRoundMap(tokens, at);
    TurnBelt(tokens, at);
    TurnFollowed(tokens, at);
    TurnAcrossZone(tokens, at);
  }
}

}  // namespace latticeworld
