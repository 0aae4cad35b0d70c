#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Sides of things that are told like sides of the map.
namespace latticeworld {
namespace {

Heading Against(Heading heading) { return {-heading.east, -heading.south}; }

// "to the north", "on its northern side": the token after it, 0: no such words. "To the north of
// the lake" names whose side it is.
std::size_t TakeSideOf(const std::vector<Token>& tokens, std::size_t at, Heading* heading) {
  if (!IsOneOf(WordAt(tokens, at), {"to", "on"}) ||
      !IsOneOf(WordAt(tokens, at + 1), {"the", "its", "their"})) {
    return 0;
  }
  std::size_t end = TakeHeading(tokens, at + 1, heading);
  if (end == 0) return 0;
  if (IsFlank(WordAt(tokens, end))) ++end;
  return WordAt(tokens, end) == "of" ? 0 : end;
}

// "seen from the south", "if you look from the south": the token after it, 0: no such words.
std::size_t TakeView(const std::vector<Token>& tokens, std::size_t at, Heading* heading) {
  while (IsOneOf(WordAt(tokens, at), {"when", "as", "if", "you", "one", "we"})) ++at;
  if (!IsOneOf(WordAt(tokens, at), {"seen", "viewed", "look", "looks", "looking", "looked", "see",
                                    "come", "coming", "approached", "watched"})) {
    return 0;
  }
  ++at;
  if (IsOneOf(WordAt(tokens, at), {"at", "on"}) && PhraseEnd(tokens, at + 1) > at + 1)
    at = PhraseEnd(tokens, at + 1);
  if (WordAt(tokens, at) != "from") return 0;
  const std::size_t end = TakeHeading(tokens, at + 1, heading);
  return end > 0 && IsPauseAt(tokens, end) ? end : 0;
}

// "Behind the lake, seen from the south": to the north of the lake.
void TurnSeenFrom(std::vector<Token>* tokens, std::size_t at) {
  Heading heading;
  // "Seen from the south, the wood stands behind the lake."
  const std::size_t view_end =
      at == 0 || IsStopAt(*tokens, at - 1) ? TakeView(*tokens, at, &heading) : 0;
  if (view_end > 0) {
    const std::size_t end = view_end;
    if (!IsMark(*tokens, end)) return;
    const std::vector<Token> view = TokensBetween(*tokens, at, end);
    for (std::size_t i = end; !IsStopAt(*tokens, i); ++i) {
      const std::size_t thing = i + (WordAt(*tokens, i) == "in" ? 3 : 1);
      const bool side = WordAt(*tokens, i) == "behind" ||
                        (WordAt(*tokens, i) == "in" && WordAt(*tokens, i + 1) == "front");
      const std::size_t last = side ? PhraseEnd(*tokens, thing) : thing;
      if (!side || last == thing || !IsPauseAt(*tokens, last)) continue;
      InsertTokens(tokens, last, view);
      EraseTokens(tokens, at, end + 1 - at);
      return;
    }
    return;
  }
  const bool behind = WordAt(*tokens, at) == "behind";
  const bool front = WordAt(*tokens, at) == "in" && WordAt(*tokens, at + 1) == "front" &&
                     WordAt(*tokens, at + 2) == "of";
  if (!behind && !front) return;
  const std::size_t thing = at + (front ? 3 : 1);
  const std::size_t view = PhraseEnd(*tokens, thing);
  if (view == thing) return;
  const std::size_t end = TakeView(*tokens, view + (IsMark(*tokens, view) ? 1 : 0), &heading);
  if (end == 0) return;
  EraseTokens(tokens, view, end - view);
  const std::string_view side = NameOf(behind ? Against(heading) : heading);
  ReplaceTokens(tokens, at, thing - at, {"to", "the", side, "of"});
}

// "All sides of the lake are forest except the north": forest surrounds the lake.
void TurnSidesAre(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"all", "every"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"side", "sides"}) || WordAt(*tokens, at + 2) != "of" ||
      (at > 0 && !IsPauseAt(*tokens, at - 1) && WordAt(*tokens, at - 1) != "and")) {
    return;
  }
  const std::size_t end = PhraseEnd(*tokens, at + 3);
  if (end == at + 3 || !IsOneOf(WordAt(*tokens, end), {"is", "are"})) return;
  const ClassWord* owner = NounBefore(*tokens, end);
  const std::size_t land = end + 1, last = land + MatchClassWord(*tokens, land).tokens;
  if (last == land || owner == nullptr || owner->shape == WordShape::kLine) return;
  std::vector<Token> said = TokensBetween(*tokens, land, last);
  said.push_back(WordLike("surrounds", (*tokens)[at]));
  for (const Token& token : TokensBetween(*tokens, at + 3, end)) said.push_back(token);
  EraseTokens(tokens, at, last - at);
  InsertTokens(tokens, at, said);
}

// "The forest surrounds the lake except on the west": surrounds the lake.
void TurnSideExcept(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  std::size_t thing = at + 1;
  if (word == "on" && IsOneOf(WordAt(*tokens, at + 1), {"all", "every"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"side", "sides"}) && WordAt(*tokens, at + 3) == "of") {
    thing = at + 4;
  } else if (!IsOneOf(word, {"surrounds", "surround", "surrounding", "encircles", "encircle",
                             "encloses", "enclose", "rings", "around"})) {
    return;
  }
  const std::size_t end = PhraseEnd(*tokens, thing);
  if (end == thing) return;
  // "around the lake on all sides but the west"
  if (WordAt(*tokens, end) == "on" && IsOneOf(WordAt(*tokens, end + 1), {"all", "every"}) &&
      IsOneOf(WordAt(*tokens, end + 2), {"side", "sides"})) {
    EraseTokens(tokens, end, 3);
  }
  std::size_t side = end + (IsMark(*tokens, end) ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, side), {"except", "but", "save", "bar"})) return;
  ++side;
  while (IsOneOf(WordAt(*tokens, side), {"for", "not", "on", "in", "to", "at", "towards"})) ++side;
  Heading heading;
  std::size_t last = TakeHeading(*tokens, side, &heading);
  if (last == 0) return;
  if (IsFlank(WordAt(*tokens, last))) ++last;
  if (IsStopAt(*tokens, last)) {
    EraseTokens(tokens, end, last - end);
    return;
  }
  // "..., where there is a town": to the west of the lake there is a town.
  if (!IsMark(*tokens, last) || WordAt(*tokens, last + 1) != "where") return;
  const std::size_t there = SkipBeing(*tokens, last + 2);
  if (!NamesThing(*tokens, there)) return;
  const ClassWord* noun = NounBefore(*tokens, end);
  if (noun == nullptr) return;
  const Token beside = (*tokens)[end];
  const std::vector<Token> owner = TokensBetween(*tokens, thing, end);
  std::vector<Token> said = {StopLike(beside)};
  for (const std::string_view name :
       {std::string_view("to"), std::string_view("the"), NameOf(heading), std::string_view("of")}) {
    said.push_back(WordLike(name, beside));
  }
  for (const Token& token : owner) said.push_back(token);
  for (const char* name : {"there", "is"}) said.push_back(WordLike(name, beside));
  EraseTokens(tokens, end, there - end);
  InsertTokens(tokens, end, said);
}

// "A mountain with snow on top": on top of it. "Snow on top, rock below" are parts of the map.
void TurnOnTop(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "with") return;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty() || named.front().begin < SentenceBegin(*tokens, at)) return;
  const std::string high = Singular(WordAt(*tokens, named.front().end - 1));
  const bool low = IsOneOf(high, {"rock", "cliff", "ridge", "crag"});
  if (!low && !IsOneOf(high, {"mountain", "hill", "peak", "mound", "massif"})) return;
  const std::size_t on = PhraseEnd(*tokens, at + 1);
  if (on == at + 1 || !IsOneOf(WordAt(*tokens, on), {"on", "at"})) return;
  const std::size_t top = on + (IsOneOf(WordAt(*tokens, on + 1), {"the", "its", "their"}) ? 2 : 1);
  if (!IsOneOf(WordAt(*tokens, top), {"top", "tops", "summit", "peak", "crest", "crown"}) ||
      !IsPauseAt(*tokens, top + 1)) {
    return;
  }
  // "the rock with snow at the top": of the map
  const bool one = named.front().end == at && named.front().begin > 0 &&
                   IsOneOf(WordAt(*tokens, named.front().begin - 1), {"a", "an", "one"});
  if (low && !one && !IsOneOf(WordAt(*tokens, on + 1), {"its", "their"})) return;
  for (std::size_t i = SentenceBegin(*tokens, at); !IsStopAt(*tokens, i); ++i) {
    if (IsMapWord(WordAt(*tokens, i)) ||
        IsOneOf(WordAt(*tokens, i), {"below", "bottom", "under", "beneath", "lower", "mostly",
                                     "everywhere", "mainly", "everything"})) {
      return;
    }
  }
  ReplaceTokens(tokens, on, top + 1 - on, {"on", "top", "of", "it"});
}

// "The road bypasses the town to the north", "passes it on the north side": passes north of it.
void TurnBypass(std::vector<Token>* tokens, std::size_t at) {
  std::size_t thing = at + 1;
  if (IsOneOf(WordAt(*tokens, thing), {"by", "around", "round"})) ++thing;
  if (!IsOneOf(WordAt(*tokens, at),
               {"bypasses", "bypass", "bypassing", "passes", "pass", "passing", "skirts",
                "skirting", "circumvents", "circumventing", "rounds", "rounding"})) {
    return;
  }
  const std::size_t side = PhraseEnd(*tokens, thing);
  Heading heading;
  const std::size_t end = side > thing ? TakeSideOf(*tokens, side, &heading) : 0;
  if (end == 0 || (!IsPauseAt(*tokens, end) && WordAt(*tokens, end) != "and")) return;
  EraseTokens(tokens, side, end - side);
  ReplaceTokens(tokens, at, thing - at, {"passes", NameOf(heading), "of"});
}

// The sides that are listed from `at`, "forest to the north and water to the south", become its
// own: "on its north side". The number of them; less than `least`: they are left as they are.
int OwnSides(std::vector<Token>* tokens, std::size_t at, int least) {
  std::vector<Token> said = *tokens;
  for (int count = 0;;) {
    const std::size_t side = PhraseEnd(said, at);
    Heading heading;
    const std::size_t end = side > at ? TakeSideOf(said, side, &heading) : 0;
    const bool goes_on =
        end > 0 && WordAt(said, end) == "and" && PhraseEnd(said, end + 1) > end + 1;
    if (end > 0 && (IsPauseAt(said, end) || goes_on)) {
      ReplaceTokens(&said, side, end - side, {"on", "its", NameOf(heading), "side"});
      ++count;
      at = side + 5;
      if (goes_on) continue;
    }
    if (count >= least) *tokens = said;
    return count;
  }
}

// "The town overlooks a lake to the south": it lies to the south of the town.
void TurnOverlooked(std::vector<Token>* tokens, std::size_t at) {
  std::size_t thing = at + 1;
  if (IsOneOf(WordAt(*tokens, at), {"looks", "look", "looking"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"onto", "over", "on", "at"})) {
    ++thing;
    if (IsOneOf(WordAt(*tokens, thing), {"to"})) ++thing;
  } else if (IsOneOf(WordAt(*tokens, at), {"next", "close"}) && WordAt(*tokens, at + 1) == "to") {
    ++thing;
  } else if (!IsOneOf(WordAt(*tokens, at), {"overlooks", "overlooking", "overlook", "faces",
                                            "facing", "beside", "near", "by", "alongside"})) {
    return;
  }
  const std::size_t side = PhraseEnd(*tokens, thing);
  if (side == thing || WordAt(*tokens, side) != "to" || WordAt(*tokens, side + 1) != "the") return;
  // A road to the north leads there.
  const ClassWord* noun = NounBefore(*tokens, side);
  if (noun == nullptr || noun->shape == WordShape::kLine) return;
  const std::size_t being = BeingBegin(*tokens, at);
  if (being == 0 || NounBefore(*tokens, being) == nullptr) return;
  Heading heading;
  const std::size_t end = TakeSideOf(*tokens, side, &heading);
  if (end == 0) return;
  const bool linked = WordAt(*tokens, end) == "and";
  if (linked && OwnSides(tokens, thing, 2) > 1) {
    ReplaceTokens(tokens, at, thing - at, {"with"});
    return;
  }
  if (!IsPauseAt(*tokens, end) && !(linked && PhraseEnd(*tokens, end + 1) > end + 1)) return;
  // The new sentence goes to the end of the text, so that what "it" means stays as it was.
  const NamedThing owner = NamedBefore(*tokens, being).front();
  const NamedThing other = NamedBefore(*tokens, side).front();
  const Token beside = (*tokens)[side];
  std::vector<Token> said;
  if (tokens->back().kind != TokenKind::kStop) said.push_back(StopLike(beside));
  const std::string verb = MatchClassWord(*tokens, other.begin).plural ? " are" : " is";
  for (const Token& token : SaidLike("the " + JoinWords(*tokens, other.begin, other.end) + verb +
                                         " to the " + std::string(NameOf(heading)) + " of the " +
                                         JoinWords(*tokens, owner.begin, owner.end) + " .",
                                     beside)) {
    said.push_back(token);
  }
  InsertTokens(tokens, tokens->size(), said);
  EraseTokens(tokens, side, end - side);
  if (linked) InsertTokens(tokens, side, {CommaLike(beside)});
}

// "Walled by rock to the east", "hemmed in by rock on its northern side": with rock on its east
// side. "Enclosed by rock on three sides": surrounded by rock. "Walled by it on two": bordered.
void TurnPartlyWalled(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"walled", "hemmed", "fenced", "closed", "shut", "enclosed",
                                     "surrounded", "ringed", "framed", "sheltered"}) ||
      at == 0) {
    return;
  }
  std::size_t by = at + 1;
  if (IsOneOf(WordAt(*tokens, by), {"in", "off"})) ++by;
  if (!IsOneOf(WordAt(*tokens, by), {"by", "with"})) return;
  const std::size_t on = PhraseEnd(*tokens, by + 1);
  if (on == by + 1) return;
  const bool three = WordAt(*tokens, on) == "on" &&
                     IsOneOf(WordAt(*tokens, on + 1), {"two", "three", "most"}) &&
                     WordAt(*tokens, on + 2) == "sides" && IsPauseAt(*tokens, on + 3);
  if (three) {
    for (std::size_t i = on; i < tokens->size(); ++i)
      if (IsOneOf(WordAt(*tokens, i), {"fourth", "other", "last"})) return;
    const bool around = WordAt(*tokens, on + 1) != "two" &&
                        IsOneOf(WordAt(*tokens, at), {"surrounded", "enclosed", "ringed"});
    EraseTokens(tokens, on, 3);
    ReplaceTokens(tokens, at, by + 1 - at, {around ? "surrounded" : "bordered", "by"});
    return;
  }
  const bool is = IsOneOf(WordAt(*tokens, at - 1), {"is", "are"});
  if (NounBefore(*tokens, is ? at - 1 : at) == nullptr || OwnSides(tokens, by + 1, 1) == 0) return;
  ReplaceTokens(tokens, is ? at - 1 : at, by + 1 - (is ? at - 1 : at), {is ? "has" : "with"});
}

// "Houses line the northern shore; on the southern shore there are no buildings": nothing of the
// south of the map.
void TurnBareShore(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "the") return;
  Heading heading;
  std::size_t end = TakeHeading(*tokens, at + 1, &heading);
  if (end == 0 || !IsOneOf(WordAt(*tokens, end), {"shore", "bank"})) return;
  ++end;
  if (WordAt(*tokens, end) == "of" && PhraseEnd(*tokens, end + 1) > end + 1)
    end = PhraseEnd(*tokens, end + 1);
  const std::size_t begin = SentenceBegin(*tokens, at);
  // The first sentence stays: without one before it, nothing would be left of the water.
  if (begin == 0) return;
  if (begin != at && !IsOneOf(WordAt(*tokens, at - 1), {"but", "and", "while"})) return;
  const std::size_t no = SkipBeing(*tokens, end);
  if (WordAt(*tokens, no) != "no") return;
  const std::size_t last = PhraseEnd(*tokens, no + 1);
  if (last > no + 1 && IsStopAt(*tokens, last)) EraseTokens(tokens, at, last - at);
}

}  // namespace

void TurnVantage(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnSeenFrom(tokens, at);
    TurnSidesAre(tokens, at);
    TurnSideExcept(tokens, at);
    TurnOnTop(tokens, at);
    TurnBypass(tokens, at);
    TurnOverlooked(tokens, at);
    TurnPartlyWalled(tokens, at);
    TurnBareShore(tokens, at);
  }
}

}  // namespace latticeworld
