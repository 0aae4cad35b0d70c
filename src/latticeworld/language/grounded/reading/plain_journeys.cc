#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Rows that are told as a journey, or as land that turns into other land.
namespace latticeworld {
namespace {

constexpr std::size_t kPhrase = 5;  // words before a noun: "a narrow strip of"

// Whether a thing is named within the next words, before a pause.
bool NamesThing(const std::vector<Token>& tokens, std::size_t at) {
  for (std::size_t i = at; i < at + kPhrase && !IsPauseAt(tokens, i); ++i)
    if (MatchClassWord(tokens, i).tokens > 0) return true;
  return false;
}

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
                  "ending",  "end",  "up",      "followed", "by",         "with",     "in"}) ||
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

std::string_view OppositeOf(std::string_view heading) {
  if (heading == "north") return "south";
  if (heading == "south") return "north";
  if (heading == "east") return "west";
  return heading == "west" ? "east" : "";
}

// "north", "northwards", "the top": one of four; "" where it is none.
std::string_view HeadingWord(std::string_view word) {
  for (const std::string_view heading : {"north", "south", "east", "west"}) {
    if (word.substr(0, heading.size()) != heading) continue;
    const std::string_view end = word.substr(heading.size());
    if (IsOneOf(end, {"", "ward", "wards", "ern"})) return heading;
  }
  return "";
}

std::string_view SideWord(std::string_view word) {
  if (IsOneOf(word, {"top", "upper"})) return "north";
  if (IsOneOf(word, {"bottom", "lower"})) return "south";
  if (word == "left") return "west";
  if (word == "right") return "east";
  return HeadingWord(word);
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

std::size_t StopAfter(const std::vector<Token>& tokens, std::size_t at) {
  while (!IsStopAt(tokens, at)) ++at;
  return at;
}

// "Walking north from the lake you pass a field, a wood and finally reach the village": from south
// to north, the lake, then a field, then a wood, then the village.
void TurnWalk(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
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
  if (IsOneOf(WordAt(*tokens, next), {"to", "towards"})) ++next;
  if (WordAt(*tokens, next) == "the") ++next;
  const std::string to(HeadingWord(WordAt(*tokens, next)));
  if (to.empty()) return;
  ++next;
  std::vector<Token> from;
  if (WordAt(*tokens, next) == "from") {
    const std::size_t begin = ++next;
    while (!IsPauseAt(*tokens, next) && !IsOneOf(WordAt(*tokens, next), {"you", "we", "one", "i"}))
      ++next;
    if (NamesThing(*tokens, begin)) from = TokensBetween(*tokens, begin, next);
  }
  if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"you", "we", "one", "i", "there"})) return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"first", "will", "would"})) ++next;
  if (!IsSeeing(WordAt(*tokens, next)) && !IsOneOf(WordAt(*tokens, next), {"is", "are", "comes"}))
    return;
  ++next;
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

// "From the north: snow, followed by rock, followed by forest": from north to south, snow, then ...
void TurnFromSide(std::vector<Token>* tokens, std::size_t at) {
  if ((at > 0 && !IsStopAt(*tokens, at - 1)) || WordAt(*tokens, at) != "from") return;
  std::size_t next = at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0);
  const std::string_view side = SideWord(WordAt(*tokens, next));
  if (side.empty()) return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"edge", "side", "end", "border"})) ++next;
  if (next >= tokens->size() || (*tokens)[next].kind != TokenKind::kComma) return;
  const std::size_t end = StopAfter(*tokens, next);
  bool rows = false;
  for (std::size_t i = next; i < end; ++i)
    rows = rows || WordAt(*tokens, i) == "followed" || WordAt(*tokens, i) == "then";
  const std::vector<Token> row = rows ? RowFrom(*tokens, next + 1, 2) : std::vector<Token>();
  if (!row.empty()) PutRow(tokens, at, end, OppositeOf(side), row);
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
  std::size_t begin = at;
  while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
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

// "The background is grass", "default terrain: forest", "a base of meadow", "grass fills in the
// gaps", "anything not mentioned is forest": the rest.
void TurnBase(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t the = IsOneOf(WordAt(*tokens, at), {"the", "a", "my", "our"}) ? 1 : 0;
  std::size_t next = at + the;
  if (IsOneOf(WordAt(*tokens, next), {"anything", "everything", "whatever", "what", "all"})) {
    const std::size_t first = next++;
    if (IsOneOf(WordAt(*tokens, next), {"that", "i"})) ++next;
    while (IsOneOf(WordAt(*tokens, next), {"is", "was", "has", "have", "did", "been"})) ++next;
    const bool denied = IsOneOf(WordAt(*tokens, next), {"not", "haven't", "didn't", "isn't"});
    if (IsOneOf(WordAt(*tokens, next), {"unmentioned", "unspecified", "unassigned", "empty"}) ||
        (denied && IsOneOf(WordAt(*tokens, next + 1),
                           {"mentioned", "specified", "mention", "specify", "assigned", "covered",
                            "named", "listed", "described", "used", "taken"}))) {
      ReplaceTokens(tokens, first, next + (denied ? 2 : 1) - first, {"everything", "else"});
    }
    return;
  }
  const bool opens = at == 0 || IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
  if (opens &&
      IsOneOf(WordAt(*tokens, next), {"background", "base", "default", "basis", "backdrop"})) {
    // With a foreground it is a place.
    for (const Token& token : *tokens)
      if (token.kind == TokenKind::kWord && token.text == "foreground") return;
    ++next;
    if (IsOneOf(WordAt(*tokens, next),
                {"terrain", "land", "layer", "ground", "cover", "class", "tile", "type"})) {
      ++next;
    }
    const bool says = IsOneOf(WordAt(*tokens, next), {"is", "should", "shall", "will", "must"}) ||
                      (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma &&
                       (*tokens)[next].text == ":");
    if (says) ReplaceTokens(tokens, at, next - at, {"the", "rest"});
    return;
  }
  if (IsOneOf(WordAt(*tokens, at), {"gaps", "gap", "holes", "blanks"}) && at > 0) {
    std::size_t begin = at - (WordAt(*tokens, at - 1) == "the" ? 1 : 0);
    if (begin == 0 || begin == at) return;
    if (WordAt(*tokens, begin - 1) == "in") --begin;
    if (begin == 0 || !IsOneOf(WordAt(*tokens, begin - 1), {"fill", "fills", "filling"})) return;
    std::size_t end = at + 1;
    if (IsOneOf(WordAt(*tokens, end), {"between", "in"}) &&
        IsOneOf(WordAt(*tokens, end + 1), {"them", "these", "those", "between"})) {
      end += 2;
    }
    ReplaceTokens(tokens, begin, end - begin, {"the", "rest"});
  }
}

struct Named {
  std::size_t begin, end;
};

// The things that are named before `at`, the nearest first, back to the sentence before.
std::vector<Named> NamedBefore(const std::vector<Token>& tokens, std::size_t at) {
  std::vector<Named> named;
  int stops = 0;
  for (std::size_t i = at; i-- > 0 && stops < 2;) {
    if (IsStopAt(tokens, i)) ++stops;
    std::size_t end = i + MatchClassWord(tokens, i).tokens;
    if (end == i || end > at) continue;
    // "corn field": the longest.
    if (!named.empty() && named.back().begin < end) {
      if (named.back().end <= end) named.back().begin = i;
      continue;
    }
    named.push_back({i, end});
  }
  return named;
}

void PutSideOf(std::vector<Token>* tokens, std::size_t at, std::size_t count,
               std::string_view heading, const Named& thing) {
  std::vector<std::string> words = {"to", "the", std::string(heading), "of", "the"};
  for (std::size_t i = thing.begin; i < thing.end; ++i) words.emplace_back((*tokens)[i].text);
  ReplaceTokens(tokens, at, count, {words.begin(), words.end()});
}

// "The fields east of it and the wood east of that", "... and the wood further east still": east of
// the fields.
void TurnFurther(std::vector<Token>* tokens, std::size_t at) {
  const bool further = IsOneOf(WordAt(*tokens, at), {"further", "farther"});
  const std::size_t side = at + (further ? 1 : 0);
  const std::string heading(SideWord(WordAt(*tokens, side)));
  if (heading.empty()) return;
  std::size_t end = side + 1;
  if (further) {
    if (IsOneOf(WordAt(*tokens, end), {"still", "again", "on", "yet"})) ++end;
    if (WordAt(*tokens, end) == "of") return;
  } else {
    if (WordAt(*tokens, end) != "of" ||
        !IsOneOf(WordAt(*tokens, end + 1), {"that", "those", "these", "this"})) {
      return;
    }
    end += 2;
  }
  std::size_t begin = at;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1),
                              {"to", "the", "on", "is", "are", "lies", "lie", "sits", "stands"})) {
    --begin;
  }
  const std::vector<Named> named = NamedBefore(*tokens, begin);
  const bool ends = IsPauseAt(*tokens, end) || WordAt(*tokens, end) == "and";
  const bool after_noun = !named.empty() && named.front().end == begin;
  if (after_noun && ends && named.size() > 1) {
    // What the clause before speaks of: its first thing.
    std::size_t thing = 1;
    const auto joined = [&](std::size_t i) {
      for (std::size_t k = named[i + 1].end; k < named[i].begin; ++k)
        if (IsPauseAt(*tokens, k) || WordAt(*tokens, k) == "and") return false;
      return true;
    };
    while (thing + 1 < named.size() && joined(thing)) ++thing;
    PutSideOf(tokens, at, end - at, heading, named[thing]);
    const bool said = at > 1 && WordAt(*tokens, at - 1) == "the" && WordAt(*tokens, at - 2) == "to";
    if (said) EraseTokens(tokens, at - 2, 2);
  } else if (further && !after_noun && !named.empty() && !ends && NamesThing(*tokens, end)) {
    PutSideOf(tokens, at, end - at, heading, named[0]);
  }
}

// "Divides the land into two halves, forest on the western side": crosses the map. "Two unequal
// halves": how large they are is told by the rest.
void TurnUnequal(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "two" && IsOneOf(WordAt(*tokens, at + 1), {"unequal", "uneven"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"parts", "halves", "pieces", "sides"})) {
    EraseTokens(tokens, at + 1, 1);
  }
  std::size_t next = at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, at), {"divides", "splits", "cuts", "parts", "bisects"}) ||
      !(IsMapWord(WordAt(*tokens, next)) ||
        IsOneOf(WordAt(*tokens, next), {"land", "country", "terrain", "region", "area", "valley",
                                        "landscape", "countryside"}))) {
    return;
  }
  ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"in", "into"}) || WordAt(*tokens, next + 1) != "two") return;
  next += 2;
  if (IsOneOf(WordAt(*tokens, next), {"unequal", "uneven", "equal"})) ++next;
  if (IsOneOf(WordAt(*tokens, next), {"parts", "halves", "pieces", "sides"})) ++next;
  const bool things_next = IsPauseAt(*tokens, next) && !IsStopAt(*tokens, next) &&
                           MatchClassWord(*tokens, next + 1).tokens > 0;
  Heading half;  // "...; the left one is forest": of TurnBanks
  if (next < tokens->size() && TakeHeading(*tokens, next + 1, &half) > 0) return;
  if (things_next) (*tokens)[next] = StopLike((*tokens)[next]);
  if (IsStopAt(*tokens, next)) ReplaceTokens(tokens, at, next - at, {"crosses", "the", "map"});
}

// "A forest in the western half; the other half is grass", "the top third is forest, the other two
// thirds are water": the eastern half, the southern two thirds. "One half is water, the other half
// is forest": half of the map.
void TurnOtherPart(std::vector<Token>* tokens) {
  std::string side, part;
  bool halved = false;  // "one half"
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const std::string_view word = WordAt(*tokens, at);
    const bool half = word == "half";
    if (!half && !IsOneOf(word, {"third", "thirds", "quarter", "quarters"})) continue;
    const std::string said(SideWord(WordAt(*tokens, at - 1)));
    if (!said.empty()) {
      side = said;
      part = word;
      continue;
    }
    halved = halved || (half && WordAt(*tokens, at - 1) == "one");
    const std::size_t other = at - (half ? 1 : 2);
    if (other >= at || other == 0 || WordAt(*tokens, other - 1) != "the" ||
        !IsOneOf(WordAt(*tokens, other), {"other", "opposite", "remaining"}) ||
        WordAt(*tokens, at + 1) == "of") {
      continue;
    }
    const bool rest =
        half ? part == "half"
             : (part == "third" && word == "thirds" && WordAt(*tokens, at - 1) == "two") ||
                   (part == "quarter" && word == "quarters" && WordAt(*tokens, at - 1) == "three");
    if (rest) {
      (*tokens)[other].text = std::string(OppositeOf(side)) + "ern";
      part.clear();
    } else if (half && halved && part.empty()) {
      ReplaceTokens(tokens, other - 1, 3, {"half", "of", "the", "map"});
      halved = false;
    }
  }
}

// "A road with houses on one side and fields on the other", "houses on one side of the road, fields
// on the other": on the other side of it.
void TurnTwoSides(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "one" ||
      WordAt(*tokens, at + 2) != "side") {
    return;
  }
  std::size_t next = at + 3;
  const bool own = WordAt(*tokens, next) == "of";
  if (!own) {
    // "a road with houses": whose sides they are.
    std::size_t with = at;
    while (with > 0 && with + kPhrase > at && WordAt(*tokens, with) != "with") --with;
    bool line = false;
    for (std::size_t i = with; i-- > 0 && i + 3 >= with && WordAt(*tokens, with) == "with";) {
      const ClassWordMatch noun = MatchClassWord(*tokens, i);
      line = line || (noun.word != nullptr && noun.word->shape == WordShape::kLine &&
                      i + noun.tokens == with);
    }
    if (!line) return;
  }
  for (std::size_t i = next; !IsStopAt(*tokens, i); ++i) {
    if (WordAt(*tokens, i) != "on" || WordAt(*tokens, i + 1) != "the" ||
        !IsOneOf(WordAt(*tokens, i + 2), {"other", "opposite"})) {
      continue;
    }
    std::size_t end = i + 3;
    if (WordAt(*tokens, end) == "side") ++end;
    if (!IsPauseAt(*tokens, end)) return;
    const Token beside = (*tokens)[at + 2];
    std::vector<Token> owner = {WordLike("of", beside), WordLike("it", beside)};
    if (own) {
      std::size_t close = next;
      while (!IsPauseAt(*tokens, close) && WordAt(*tokens, close) != "and") ++close;
      owner = TokensBetween(*tokens, next, close);
    }
    ReplaceTokens(tokens, i, end - i, {"on", "the", "other", "side"});
    InsertTokens(tokens, i + 4, owner);
    if (!own) InsertTokens(tokens, next, owner);
    return;
  }
}

// "Split into two halves: forest and grass": half forest and half grass.
void TurnHalvesOf(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "two" || WordAt(*tokens, at + 1) != "halves" ||
      at + 2 >= tokens->size() || (*tokens)[at + 2].text != ":") {
    return;
  }
  const std::size_t first = at + 3, one = MatchClassWord(*tokens, first).tokens;
  const std::size_t second = first + one + 1, other = MatchClassWord(*tokens, second).tokens;
  if (one == 0 || other == 0 || !IsStopAt(*tokens, second + other) ||
      (WordAt(*tokens, second - 1) != "and" && (*tokens)[second - 1].kind != TokenKind::kComma)) {
    return;
  }
  InsertTokens(tokens, second, {WordLike("half", (*tokens)[second])});
  ReplaceTokens(tokens, at, 3, {"x", "half"});
  (*tokens)[at] = StopLike((*tokens)[at]);
}

// "Keep the center empty", "leave the middle open": the center is grass.
void TurnKeptEmpty(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"keep", "leave"})) return;
  PlaceCursor cursor(*tokens, at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0));
  if (!TakeDirection(&cursor).found) return;
  std::size_t end = cursor.at();
  if (IsOneOf(WordAt(*tokens, end), {"half", "third", "quarter", "corner", "part", "edge", "side"}))
    ++end;
  if (!IsOneOf(WordAt(*tokens, end), {"empty", "open", "clear", "free"}) ||
      !IsPauseAt(*tokens, end + 1)) {
    return;
  }
  ReplaceTokens(tokens, end, 1, {"is", "grass"});
  EraseTokens(tokens, at, 1);
}

// "Two rivers, both N->S": they run so. "A lake, bigger than everything else": which says no more
// than that it is big.
void TurnAsides(std::vector<Token>* tokens, std::size_t at) {
  const auto is_letter = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i), {"n", "s", "e", "w"});
  };
  if (IsOneOf(WordAt(*tokens, at), {"both", "all", "each"}) && is_letter(at + 1) &&
      is_letter(at + 2)) {
    EraseTokens(tokens, at, 1);
    return;
  }
  // "both N->S": both from N to S
  if (IsOneOf(WordAt(*tokens, at), {"both", "all", "each"}) && is_letter(at + 1) &&
      WordAt(*tokens, at + 2) == "to" && is_letter(at + 3)) {
    ReplaceTokens(tokens, at, 1, {"from"});
    return;
  }
  const bool bigger = at > 0 && IsOneOf(WordAt(*tokens, at), {"bigger", "larger"}) &&
                      WordAt(*tokens, at + 1) == "than" &&
                      IsOneOf(WordAt(*tokens, at + 2), {"everything", "anything"}) &&
                      WordAt(*tokens, at + 3) == "else";
  if (bigger && (*tokens)[at - 1].kind == TokenKind::kComma) EraseTokens(tokens, at, 4);
}

// "In the shape of an S", "shaped like the letter S": S-shaped.
void TurnLetterShape(std::vector<Token>* tokens, std::size_t at) {
  std::size_t next = at;
  if (WordAt(*tokens, next) == "in" && WordAt(*tokens, next + 1) == "the" &&
      WordAt(*tokens, next + 2) == "shape" && WordAt(*tokens, next + 3) == "of") {
    next += 4;
  } else if (WordAt(*tokens, next) == "shaped" && WordAt(*tokens, next + 1) == "like") {
    next += 2;
  } else {
    return;
  }
  if (IsOneOf(WordAt(*tokens, next), {"a", "an", "the"})) ++next;
  if (WordAt(*tokens, next) == "letter") ++next;
  const std::string letter(WordAt(*tokens, next));
  if (IsOneOf(letter, {"s", "u", "c"}) && IsPauseAt(*tokens, next + 1))
    ReplaceTokens(tokens, at, next + 1 - at, {letter, "shaped"});
}

}  // namespace

void TurnJourneys(std::vector<Token>* tokens) {
  TurnOtherPart(tokens);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnWalk(tokens, at);
    TurnFromSide(tokens, at);
    TurnGivesWay(tokens, at);
    TurnStartingWith(tokens, at);
    TurnBase(tokens, at);
    TurnFurther(tokens, at);
    TurnUnequal(tokens, at);
    TurnTwoSides(tokens, at);
    TurnHalvesOf(tokens, at);
    TurnKeptEmpty(tokens, at);
    TurnAsides(tokens, at);
    TurnLetterShape(tokens, at);
  }
}

}  // namespace latticeworld
