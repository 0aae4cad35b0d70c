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

// What lies on all sides of a thing, and on which of its sides.
namespace latticeworld {
namespace {

bool IsEnclosing(std::string_view word) {
  return IsOneOf(word,
                 {"surround", "surrounds", "surrounding", "encircle", "encircles", "encircling",
                  "enclose", "encloses", "enclosing", "ring", "rings", "frame", "frames"});
}

// "borders the lake on all sides" surrounds it.
bool IsBordering(std::string_view word) {
  return IsOneOf(word, {"border", "borders", "bordering", "touch",   "touches", "touching",
                        "flank",  "flanks",  "hug",       "hugs",    "fringe",  "fringes",
                        "bound",  "bounds",  "adjoin",    "adjoins", "line",    "lines",
                        "edge",   "edges",   "abut",      "abuts"});
}

bool IsEnclosed(std::string_view word) {
  return IsOneOf(word, {"surrounded", "enclosed", "encircled", "ringed", "bordered", "bounded",
                        "framed", "hemmed", "flanked", "edged", "fringed", "girded", "walled",
                        "closed", "beset", "boxed", "shut", "fenced"});
}

// The token after "on all sides", "from every side"; 0: no such words, or others come with them.
std::size_t AfterAllSides(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"on", "from", "at", "to"})) return 0;
  std::size_t next = at + 1;
  if (!IsOneOf(WordAt(tokens, next), {"all", "every", "each"})) return 0;
  ++next;
  while (IsOneOf(WordAt(tokens, next), {"of", "its", "their", "the", "four", "single"})) ++next;
  if (!IsOneOf(WordAt(tokens, next), {"side", "sides"})) return 0;
  ++next;
  if (WordAt(tokens, next) == "of" && WordAt(tokens, next + 1) == "it") next += 2;
  const std::size_t but = next + (IsMark(tokens, next) ? 1 : 0);
  const bool other = WordAt(tokens, next) == "of" ||
                     IsOneOf(WordAt(tokens, but), {"but", "except", "save", "apart", "other"});
  return other ? 0 : next;
}

// "Hemmed in on all sides by woods", "on all sides surrounded by fields": surrounded by them.
// False: no such words stand around [at, end).
bool TurnEnclosedOnAllSides(std::vector<Token>* tokens, std::size_t at, std::size_t end) {
  const std::size_t begin = SentenceBegin(*tokens, at);
  if (WordAt(*tokens, end) == "by") {
    const bool two = at > begin + 1 && IsOneOf(WordAt(*tokens, at - 1), {"in", "off", "up"});
    const std::size_t part = at - (two ? 2 : 1);
    if (IsEnclosed(WordAt(*tokens, part)) && NamesThing(*tokens, end + 1)) {
      ReplaceTokens(tokens, part, end + 1 - part, {"surrounded", "by"});
    }
    return true;
  }
  if (at > begin && IsEnclosed(WordAt(*tokens, end)) && WordAt(*tokens, end + 1) == "by" &&
      NamesThing(*tokens, end + 2)) {
    ReplaceTokens(tokens, at, end + 1 - at, {"surrounded"});
    return true;
  }
  return false;
}

// The first token of the phrase that names a thing right before `at`, in a sentence from `begin`
// on; `at`: there is none.
std::size_t NounPhraseBefore(const std::vector<Token>& tokens, std::size_t begin, std::size_t at) {
  std::size_t noun = at;
  for (std::size_t i = at; i-- > begin && i + 6 > at;) {
    const std::string_view before = i > begin ? WordAt(tokens, i - 1) : std::string_view();
    if (TakeNounSpan(tokens, i).end == at) noun = i;
    if (noun == i && (IsEnclosing(before) || IsBordering(before))) break;
  }
  return noun;
}

// "Borders the lake on all sides": surrounds it. A line has two sides: "lines the road on all
// sides", on both sides.
void TurnBorderingAllSides(std::vector<Token>* tokens, std::size_t verb, std::size_t at,
                           std::size_t end) {
  const bool it = IsOneOf(WordAt(*tokens, at - 1), {"it", "them"});
  if (!it && MatchClassWord(*tokens, NamedBefore(*tokens, at).front().begin).is_line()) {
    ReplaceTokens(tokens, at, end - at, {"on", "both", "sides"});
    if (!IsOneOf(WordAt(*tokens, verb), {"line", "lines", "flank", "flanks"}))
      ReplaceTokens(tokens, verb, 1, {"border"});
    return;
  }
  EraseTokens(tokens, at, end - at);
  ReplaceTokens(tokens, verb, 1, {"surrounds"});
}

// "The lake has houses on all sides", "a lake with houses on all sides": it is surrounded by them.
void TurnHavingOnAllSides(std::vector<Token>* tokens, std::size_t verb, std::size_t at,
                          std::size_t end) {
  const std::size_t begin = SentenceBegin(*tokens, at);
  const std::vector<NamedThing> named = NamedBefore(*tokens, verb);
  const bool mark = IsMark(*tokens, verb - 1);
  const bool pronoun = IsOneOf(WordAt(*tokens, verb - 1), {"it", "they"});
  const bool own = !named.empty() && IsPauseAt(*tokens, end) &&
                   (pronoun || (named[0].begin >= begin && named[0].end == verb - (mark ? 1 : 0)));
  if (!own || IsOneOf(WordAt(*tokens, at - 1), {"island", "islands"})) return;
  // "a village in the wood, with fields on all sides": of which of the two?
  if (mark && named.size() > 1 && named[1].begin >= begin) return;
  const bool with = WordAt(*tokens, verb) == "with";
  if (!with && !IsOneOf(WordAt(*tokens, verb), {"has", "have"})) return;
  // "roads from every side": no ring of them.
  const bool line = MatchClassWord(*tokens, NamedBefore(*tokens, at).front().begin).is_line();
  if (line && IsOneOf(WordAt(*tokens, at), {"from", "to"})) return;
  if (MatchClassWord(*tokens, named[0].begin).is_line()) {
    ReplaceTokens(tokens, at, end - at, {"on", "both", "sides"});
    return;
  }
  EraseTokens(tokens, at, end - at);
  if (with) {
    ReplaceTokens(tokens, verb, 1, {"surrounded", "by"});
    if (mark) EraseTokens(tokens, verb - 1, 1);
  } else {
    ReplaceTokens(tokens, verb, 1, {"is", "surrounded", "by"});
  }
}

// "Forest surrounds the lake on all sides", "borders it on every side": surrounds it. "The lake has
// houses on all sides": it is surrounded by them. "Hemmed in on all sides by woods": surrounded.
void TurnAllSides(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t end = AfterAllSides(*tokens, at);
  if (end == 0 || at == 0 || TurnEnclosedOnAllSides(tokens, at, end)) return;
  const std::size_t begin = SentenceBegin(*tokens, at);
  const bool it = at > begin && IsOneOf(WordAt(*tokens, at - 1), {"it", "them"});
  const std::size_t noun = it ? at - 1 : NounPhraseBefore(*tokens, begin, at);
  if (noun == at || noun <= begin + 1) return;
  const std::size_t verb = noun - 1;
  const std::string_view word = WordAt(*tokens, verb);
  if (IsEnclosing(word) || IsOneOf(word, {"around", "round"})) {
    EraseTokens(tokens, at, end - at);
  } else if (IsBordering(word)) {
    TurnBorderingAllSides(tokens, verb, at, end);
  } else if (word == "on" && verb > begin + 1 && WordAt(*tokens, verb - 1) == "in" &&
             IsOneOf(WordAt(*tokens, verb - 2), {"press", "presses", "close", "closes", "crowd",
                                                 "crowds", "closing", "pressing"})) {
    // "press in on the town from every side"
    EraseTokens(tokens, at, end - at);
    ReplaceTokens(tokens, verb - 2, 3, {"surrounds"});
  } else if (it) {
    return;
  } else if (word == "by") {
    const bool two = IsOneOf(WordAt(*tokens, verb - 1), {"in", "off", "up"});
    const std::size_t part = verb - (two ? 2 : 1);
    if (!IsEnclosed(WordAt(*tokens, part))) return;
    EraseTokens(tokens, at, end - at);
    ReplaceTokens(tokens, part, verb + 1 - part, {"surrounded", "by"});
  } else {
    TurnHavingOnAllSides(tokens, verb, at, end);
  }
}

struct Side {
  Heading heading;
  std::size_t end = 0;  // 0: none
};
// "on the north", "to its left side", "on the northern edge". What has a side of something else, or
// two of them, is none.
Side TakeSideOf(const std::vector<Token>& tokens, std::size_t at, bool may_be_in) {
  Side side;
  if (!IsOneOf(WordAt(tokens, at), {"on", "to", "at", "along"}) &&
      !(may_be_in && WordAt(tokens, at) == "in")) {
    return side;
  }
  if (!IsOneOf(WordAt(tokens, at + 1), {"the", "its", "their"})) return side;
  std::size_t end = TakeHeading(tokens, at + 1, &side.heading);
  if (end == 0) return side;
  if (IsFlank(WordAt(tokens, end)) || IsOneOf(WordAt(tokens, end), {"edge", "border"})) ++end;
  Heading more;
  if (WordAt(tokens, end) == "of") {
    if (WordAt(tokens, end + 1) != "it" && WordAt(tokens, end + 1) != "them") return side;
    end += 2;
  }
  const bool two =
      IsOneOf(WordAt(tokens, end), {"and", "or"}) && TakeHeading(tokens, end + 1, &more) > 0;
  if (!two) side.end = end;
  return side;
}

// "A lake bordered on the north by woods", "the village is bounded by a river to the north and a
// road to the south": with woods on its northern side, has a river on its northern side ...
void TurnBorderedOn(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"bordered", "bounded", "flanked", "edged", "fringed", "hemmed",
                                     "skirted", "limited", "enclosed", "framed", "walled"})) {
    return;
  }
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) == "in" && WordAt(*tokens, next + 1) != "the") ++next;
  const bool fronted = WordAt(*tokens, next) != "by";
  std::vector<Token> said;
  std::size_t end = next;
  const Token beside = (*tokens)[at];
  // The sides are those of what stands right before, or of what the sentence names.
  std::size_t begin = at;
  bool which = false;
  const bool is = begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"is", "are"});
  if (is) --begin;
  if (is && begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"which", "that"})) {
    --begin;
    which = true;
  }
  const std::size_t before = begin - (begin > 0 && IsMark(*tokens, begin - 1) ? 1 : 0);
  const std::vector<NamedThing> named = NamedBefore(*tokens, before);
  const bool it = is && begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"it", "they"});
  if (named.empty() || (!it && named[0].begin < SentenceBegin(*tokens, at))) return;
  if (before > 0 && IsMapWord(WordAt(*tokens, before - 1))) return;
  if (is && !which && !it && named[0].end != before) return;
  const bool many =
      MatchClassWord(*tokens, named[0].begin).plural || WordAt(*tokens, begin - 1) == "they";
  for (bool more = false;;) {
    std::size_t from = next;
    if (more && is && IsOneOf(WordAt(*tokens, from), {"it", "is"})) ++from;
    Side side;
    if (fronted) {
      side = TakeSideOf(*tokens, from, true);
      if (side.end == 0 || WordAt(*tokens, side.end) != "by") break;
      from = side.end + 1;
    } else if (WordAt(*tokens, from) == "by") {
      ++from;
    } else if (!more) {
      break;
    }
    const NounSpan span = TakeNounSpan(*tokens, from);
    if (!span.found()) break;
    std::size_t close = span.end;
    if (!fronted) {
      side = TakeSideOf(*tokens, close, false);
      if (side.end == 0) break;
      close = side.end;
    }
    if (more) {
      const bool comma = IsMark(*tokens, end);
      said.push_back(comma ? CommaLike(beside) : WordLike("and", beside));
    }
    for (const Token& token : TokensBetween(*tokens, from, span.end)) said.push_back(token);
    const std::string name(NameOf(side.heading));
    for (const Token& token :
         SaidLike((many ? "on their " : "on its ") + name + "ern side", beside)) {
      said.push_back(token);
    }
    end = close;
    next = end;
    if (IsMark(*tokens, next)) ++next;
    if (WordAt(*tokens, next) == "and") ++next;
    if (next == end) break;
    more = true;
  }
  if (said.empty()) return;
  const std::size_t first = which ? begin : is ? at - 1 : at;
  EraseTokens(tokens, first, end - first);
  said.insert(said.begin(), WordLike(!is || which ? "with" : many ? "have" : "has", beside));
  // "the houses, bounded to the south by a road, lie in the center": they lie there, with ...
  const bool aside = !is && first > 0 && IsMark(*tokens, first - 1) && IsMark(*tokens, first) &&
                     IsOneOf(WordAt(*tokens, first + 1), {"lies", "lie", "is", "are", "stands",
                                                          "stand", "sits", "covers", "fills"});
  if (aside) {
    EraseTokens(tokens, first - 1, 2);
    said.insert(said.begin(), CommaLike(beside));
  }
  InsertTokens(tokens, aside ? PauseAfter(*tokens, first) : first, said);
}

}  // namespace

void TurnBorders(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAllSides(tokens, at);
    TurnBorderedOn(tokens, at);
  }
}

}  // namespace latticeworld
