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

// Rows that are told as a journey, as land that turns into other land, or as rings.
namespace latticeworld {
namespace {

bool IsSeeing(std::string_view word) {
  return IsOneOf(word, {"pass", "cross", "meet", "find", "see", "reach", "encounter", "traverse",
                        "enter", "get", "have", "come", "go", "walk", "hit", "leave"});
}

// Words between two things of a row that add nothing: ", and finally reach".
std::size_t SkipLinks(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at),
                 {"and",     "then", "finally", "lastly",   "eventually", "next",     "after",
                  "that",    "at",   "last",    "you",      "we",         "one",      "to",
                  "through", "into", "over",    "before",   "reaching",   "arriving", "arrive",
                  "ending",  "end",  "up",      "followed", "by",         "with",     "in",
                  "across",  "onto", "past",    "first"}) ||
         IsSeeing(WordAt(tokens, at))) {
    ++at;
  }
  return at;
}

// A row from `at` up to the stop, its things parted by ", then"; empty: it has fewer than `least`.
std::vector<Token> RowFrom(const std::vector<Token>& tokens, std::size_t at, std::size_t least) {
  std::vector<Token> row;
  std::size_t things = 1;
  std::size_t next = SkipLinks(tokens, at);
  if (!NamesThing(tokens, next)) return {};
  while (!IsStopAt(tokens, next)) {
    const bool comma = tokens[next].kind == TokenKind::kComma;
    const bool link = comma || IsOneOf(WordAt(tokens, next), {"and", "then", "followed", "before"});
    const std::size_t thing = link ? SkipLinks(tokens, next + 1) : next;
    const bool parts = link && NamesThing(tokens, thing) && thing > next;
    if (!parts) {
      row.push_back(tokens[next++]);
      continue;
    }
    row.push_back(CommaLike(tokens[next]));
    row.push_back(WordLike("then", tokens[next]));
    ++things;
    next = thing;
  }
  return things >= least ? row : std::vector<Token>();
}

std::vector<Token> SpanLike(std::string_view to, const Token& beside) {
  std::vector<Token> span;
  for (const std::string_view word :
       {std::string_view("from"), OppositeOf(to), std::string_view("to"), to})
    span.push_back(WordLike(word, beside));
  span.push_back(CommaLike(beside));
  return span;
}

// Puts "from ... to ..., <row>" in the place of [at, end).
void PutRow(std::vector<Token>* tokens, std::size_t at, std::size_t end, std::string_view to,
            const std::vector<Token>& row) {
  std::vector<Token> said = SpanLike(to, (*tokens)[at]);
  said.insert(said.end(), row.begin(), row.end());
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "Walking north from the lake you pass a field, a wood and finally reach the village": from south
// to north, the lake, then a field, then a wood, then the village.
void TurnWalk(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  // "If you walk", "heading"
  std::size_t next = at;
  if (IsOneOf(WordAt(*tokens, next), {"if", "as", "when"}) &&
      IsOneOf(WordAt(*tokens, next + 1), {"you", "we", "one", "i"})) {
    next += 2;
  }
  if (!IsOneOf(WordAt(*tokens, next),
               {"walking", "heading", "going", "travelling", "traveling", "driving", "moving",
                "hiking", "walk", "head", "go", "travel", "drive", "move", "hike"})) {
    return;
  }
  ++next;
  // "towards the north"
  if (IsOneOf(WordAt(*tokens, next), {"to", "towards"})) ++next;
  if (WordAt(*tokens, next) == "the") ++next;
  const std::string to(HeadingWord(WordAt(*tokens, next)));
  if (to.empty()) return;
  ++next;
  // "from the lake"
  std::vector<Token> from;
  if (WordAt(*tokens, next) == "from") {
    const std::size_t begin = ++next;
    while (!IsPauseAt(*tokens, next) && !IsOneOf(WordAt(*tokens, next), {"you", "we", "one", "i"}))
      ++next;
    if (NamesThing(*tokens, begin)) from = TokensBetween(*tokens, begin, next);
  }
  if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
  // "you first pass"
  if (!IsOneOf(WordAt(*tokens, next), {"you", "we", "one", "i", "there"})) return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"first", "will", "would"})) ++next;
  if (!IsSeeing(WordAt(*tokens, next)) && !IsOneOf(WordAt(*tokens, next), {"is", "are", "comes"}))
    return;
  ++next;
  // What one passes stands in a row in that direction, behind where one starts.
  const std::vector<Token> row = RowFrom(*tokens, next, from.empty() ? 2 : 1);
  if (row.empty()) return;
  const std::size_t end = StopAfter(*tokens, next);
  std::vector<Token> all = from;
  if (!from.empty()) {
    all.push_back(CommaLike(row.front()));
    all.push_back(WordLike("then", row.front()));
  }
  all.insert(all.end(), row.begin(), row.end());
  PutRow(tokens, at, end, to, all);
}

// "Runners go north: across a field, then through a wood, then up to a village", "you run north:
// fields first, then the town": from south to north, a field, then ...
void TurnGoing(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at),
               {"go", "goes", "run", "runs", "walk", "walks", "head", "heads", "travel", "drive",
                "drives", "ride", "march", "climb", "move", "moves"})) {
    return;
  }
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"to", "towards"})) ++next;
  if (WordAt(*tokens, next) == "the") ++next;
  const std::string to(HeadingWord(WordAt(*tokens, next)));
  if (to.empty() || ++next >= tokens->size() || (*tokens)[next].text != ":") return;
  std::size_t begin = SentenceBegin(*tokens, at);
  const std::size_t end = StopAfter(*tokens, next);
  // "fields first, then the town"
  for (std::size_t i = next; i < end && !IsPauseAt(*tokens, i + 1); ++i) {
    if (WordAt(*tokens, i + 1) != "first" || !IsPauseAt(*tokens, i + 2)) continue;
    EraseTokens(tokens, i + 1, 1);
    TurnGoing(tokens, at);
    return;
  }
  const std::vector<Token> row = RowFrom(*tokens, next + 1, 2);
  if (!row.empty() && !NamesThing(*tokens, begin)) PutRow(tokens, begin, end, to, row);
}

// "From the north: snow, followed by rock, followed by forest", "from the northern edge inwards:
// snow, rock, forest": from north to south, snow, then ... "From the center outwards: a lake, sand,
// forest": concentric rings.
void TurnFromSide(std::vector<Token>* tokens, std::size_t at) {
  if ((at > 0 && !IsStopAt(*tokens, at - 1)) || WordAt(*tokens, at) != "from") return;
  std::size_t next = at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0);
  const bool middle = IsOneOf(WordAt(*tokens, next), {"center", "middle", "inside"});
  if (middle && IsOneOf(WordAt(*tokens, next + 1), {"outward", "outwards", "out"})) {
    ReplaceTokens(tokens, at, next + 2 - at, {"concentric", "rings"});
    return;
  }
  const std::string_view side = SideWord(WordAt(*tokens, next));
  if (side.empty()) return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"edge", "side", "end", "border"})) ++next;
  const bool inward = IsOneOf(WordAt(*tokens, next), {"inward", "inwards", "in", "on", "onwards"});
  if (inward && RowFrom(*tokens, next + 2, 2).empty()) return;
  if (inward) EraseTokens(tokens, next, 1);
  if (next >= tokens->size() || (*tokens)[next].kind != TokenKind::kComma) return;
  const std::size_t end = StopAfter(*tokens, next);
  bool rows = inward;
  for (std::size_t i = next; i < end; ++i)
    rows = rows || WordAt(*tokens, i) == "followed" || WordAt(*tokens, i) == "then";
  const std::vector<Token> row = rows ? RowFrom(*tokens, next + 1, 2) : std::vector<Token>();
  if (!row.empty()) PutRow(tokens, at, end, OppositeOf(side), row);
}

// "From west to east I'd like first a forest, then fields": from west to east, a forest, then
// fields.
void TurnSpanWish(std::vector<Token>* tokens, std::size_t at) {
  if ((at > 0 && !IsStopAt(*tokens, at - 1)) || WordAt(*tokens, at) != "from") return;
  const auto side_at = [&](std::size_t i) { return i + (WordAt(*tokens, i) == "the" ? 1 : 0); };
  const std::size_t first = side_at(at + 1), to = first + 1, second = side_at(to + 1);
  if (SideWord(WordAt(*tokens, first)).empty() || WordAt(*tokens, to) != "to" ||
      SideWord(WordAt(*tokens, second)).empty()) {
    return;
  }
  const std::size_t begin = second + 1;
  std::size_t next = begin;
  while (IsOneOf(
      WordAt(*tokens, next),
      {"i",     "i'd",    "d",  "we",     "we'd",  "would", "like", "want", "need", "wish",
       "there", "should", "be", "please", "first", "to",    "have", "put",  "you",  "see"})) {
    ++next;
  }
  bool rows = false;
  for (std::size_t i = next; !IsStopAt(*tokens, i); ++i)
    rows = rows || WordAt(*tokens, i) == "then";
  if (next == begin || !rows || !NamesThing(*tokens, next)) return;
  const Token beside = (*tokens)[begin];
  EraseTokens(tokens, begin, next - begin);
  InsertTokens(tokens, begin, {CommaLike(beside)});
}

// "at the north edge", "in the top right": the first of its words that is a side, within a phrase.
std::string_view SideIn(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i + 1 < end; ++i) {
    if (!IsOneOf(WordAt(tokens, i), {"in", "at", "on", "along"})) continue;
    const std::size_t word = i + 1 + (WordAt(tokens, i + 1) == "the" ? 1 : 0);
    const std::string_view side = IsOneOf(WordAt(tokens, word), {"far", "very"})
                                      ? SideWord(WordAt(tokens, word + 1))
                                      : SideWord(WordAt(tokens, word));
    if (!side.empty()) return side;
  }
  return "";
}

// "Snow in the north gradually gives way to rock, then to forest and finally to a lake": from north
// to south, snow in the north, then rock, then forest, then a lake.
void TurnGivesWay(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"gives", "give", "turns", "changes", "turn", "change"}))
    return;
  const bool way = IsOneOf(WordAt(*tokens, at), {"gives", "give"});
  if (way ? WordAt(*tokens, at + 1) != "way" || WordAt(*tokens, at + 2) != "to"
          : WordAt(*tokens, at + 1) != "into") {
    return;
  }
  std::size_t begin = SentenceBegin(*tokens, at);
  std::size_t verb = at;
  while (verb > begin && IsOneOf(WordAt(*tokens, verb - 1),
                                 {"gradually", "slowly", "soon", "quickly", "then", "which"})) {
    --verb;
  }
  const std::size_t next = at + (way ? 3 : 2);
  const std::size_t end = StopAfter(*tokens, next);
  for (std::size_t i = begin; i < end; ++i)
    if (IsOneOf(WordAt(*tokens, i), {"as", "when", "while"})) return;
  const std::vector<Token> row = RowFrom(*tokens, next, 2);
  if (row.empty() || !NamesThing(*tokens, begin)) return;
  std::string to(OppositeOf(SideIn(*tokens, begin, verb)));
  if (to.empty()) to = SideIn(*tokens, next, end);
  if (to.empty()) return;
  std::vector<Token> all = TokensBetween(*tokens, begin, verb);
  all.push_back(CommaLike(row.front()));
  all.push_back(WordLike("then", row.front()));
  all.insert(all.end(), row.begin(), row.end());
  PutRow(tokens, begin, end, to, all);
}

// "Starting in the south-west with fields, moving through a village in the middle and ending with a
// forest in the north-east": fields in the south-west, a village ..., a forest ...
void TurnStartingWith(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  if (!IsOneOf(WordAt(*tokens, at), {"starting", "beginning", "start", "begin"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"in", "at", "on"})) {
    return;
  }
  std::size_t with = at + 2;
  while (!IsPauseAt(*tokens, with) && WordAt(*tokens, with) != "with" && with < at + 8) ++with;
  if (WordAt(*tokens, with) != "with") return;
  PlaceCursor cursor(*tokens, at + 2 + (WordAt(*tokens, at + 2) == "the" ? 1 : 0));
  if (!TakeDirection(&cursor).found) return;
  const std::size_t pause = PauseAfter(*tokens, with);
  if (!NamesThing(*tokens, with + 1)) return;
  std::vector<Token> said = TokensBetween(*tokens, with + 1, pause);
  for (const Token& token : TokensBetween(*tokens, at + 1, with)) said.push_back(token);
  EraseTokens(tokens, at, pause - at);
  InsertTokens(tokens, at, said);
  // What comes on the way and at the end.
  for (std::size_t i = at + said.size(); !IsStopAt(*tokens, i); ++i) {
    if (!IsPauseAt(*tokens, i) && WordAt(*tokens, i) != "and") continue;
    std::size_t next = i + 1 + (WordAt(*tokens, i + 1) == "and" ? 1 : 0);
    const std::size_t first = next;
    if (IsOneOf(WordAt(*tokens, next),
                {"moving", "going", "passing", "continuing", "ending", "finishing", "then"})) {
      ++next;
      if (IsOneOf(WordAt(*tokens, next), {"through", "with", "past", "by", "to", "into", "up"}))
        ++next;
      if (WordAt(*tokens, next) == "with") ++next;
    }
    if (next > first && NamesThing(*tokens, next)) EraseTokens(tokens, first, next - first);
  }
}

// "Concentric rings: water in the middle, then sand, then forest": around the water sand, around
// the sand forest.
void TurnConcentric(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "concentric") return;
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"rings", "circles", "bands", "zones", "belts"})) ++next;
  if (next >= tokens->size() || (*tokens)[next].text != ":") return;
  std::vector<Token> said;
  NamedThing inner = {0, 0};
  for (std::size_t begin = next + 1; begin < tokens->size();) {
    const std::size_t end = PauseAfter(*tokens, begin);
    std::size_t thing = SkipLinks(*tokens, begin);
    while (thing < end && MatchClassWord(*tokens, thing).tokens == 0) ++thing;
    if (thing == end) return;
    const Token beside = (*tokens)[begin];
    if (inner.end > 0) {
      said.push_back(StopLike(beside));
      for (const std::string_view word : {"around", "the"}) said.push_back(WordLike(word, beside));
      for (std::size_t i = inner.begin; i < inner.end; ++i)
        said.push_back(WordLike((*tokens)[i].text, beside));
      said.push_back(WordLike("is", beside));
    }
    for (std::size_t i = SkipLinks(*tokens, begin); i < end; ++i) said.push_back((*tokens)[i]);
    inner = {thing, thing + MatchClassWord(*tokens, thing).tokens};
    if (IsStopAt(*tokens, end)) {
      EraseTokens(tokens, at, end - at);
      InsertTokens(tokens, at, said);
      return;
    }
    begin = end + 1;
  }
}

}  // namespace

void TurnJourneys(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnWalk(tokens, at);
    TurnGoing(tokens, at);
    TurnFromSide(tokens, at);
    TurnSpanWish(tokens, at);
    TurnGivesWay(tokens, at);
    TurnStartingWith(tokens, at);
    TurnConcentric(tokens, at);
  }
}

}  // namespace latticeworld
