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

// Phrases of place that stand before what they are about, and words put in between.
namespace latticeworld {
namespace {

struct PlacePhrase {
  std::size_t end = 0;    // 0: none
  bool to_thing = false;  // "south of the road", "beside it", and not "in the south"
};

// "in the south", "to its east", "south of it", "beside the forest", "facing the lake".
PlacePhrase TakePlacePhrase(const std::vector<Token>& tokens, std::size_t at) {
  const auto after_thing = [&](std::size_t thing) -> std::size_t {
    if (IsOneOf(WordAt(tokens, thing), {"it", "them", "that"})) return thing + 1;
    return TakeNounSpan(tokens, thing).end;
  };
  PlacePhrase phrase;
  std::size_t next = at;
  while (IsOneOf(WordAt(tokens, next), {"just", "right", "directly", "immediately"})) ++next;
  const std::string_view word = WordAt(tokens, next);
  std::size_t thing = 0;
  if (IsOneOf(word, {"below", "beneath", "above", "beside", "near", "by", "facing", "behind",
                     "alongside", "under", "opposite", "overlooking", "bordering", "touching"})) {
    thing = next + 1;
  } else if (IsOneOf(word, {"next", "close", "adjacent"}) && WordAt(tokens, next + 1) == "to") {
    thing = next + 2;
  }
  if (thing > 0) {
    phrase.end = after_thing(thing);
    phrase.to_thing = true;
    return phrase;
  }
  const bool in = IsOneOf(word, {"in", "on", "at", "to"});
  Heading heading;
  std::size_t end = TakeHeading(tokens, next + (in ? 1 : 0), &heading);
  if (end == 0) return phrase;
  const bool its = WordAt(tokens, next + (in ? 1 : 0)) == "its";
  if (in && (IsFlank(WordAt(tokens, end)) || IsOneOf(WordAt(tokens, end), {"corner", "edge"})))
    ++end;
  if (WordAt(tokens, end) == "of") {
    if (IsOneOf(WordAt(tokens, end + 1), {"the", "this"}) && IsMapWord(WordAt(tokens, end + 2)))
      return phrase;
    phrase.end = after_thing(end + 1);
    phrase.to_thing = true;
  } else if (its || (word == "in" && WordAt(tokens, next + 1) == "the")) {
    phrase.end = end;
    phrase.to_thing = its;
  }
  return phrase;
}

// "In the north a forest, and below it, next to the lake, houses": houses below it, next to the
// lake. "East of the lake, beside the forest, lies a village": a village lies there.
void TurnTwoPlaces(std::vector<Token>* tokens, std::size_t at) {
  std::size_t begin = at;
  if (WordAt(*tokens, begin) == "and") ++begin;
  if (at > 0 && !IsPauseAt(*tokens, at - 1) && begin == at) return;
  const PlacePhrase one = TakePlacePhrase(*tokens, begin);
  if (one.end == 0) return;
  // Three of them: left to the clauses.
  if (at > 1 && IsMark(*tokens, at - 1)) {
    std::size_t before = at - 1;
    while (before > 0 && !IsPauseAt(*tokens, before - 1)) --before;
    if (TakePlacePhrase(*tokens, before).end == at - 1) return;
  }
  const bool comma = IsMark(*tokens, one.end);
  if (!comma && WordAt(*tokens, one.end) != "and") return;
  const PlacePhrase two = TakePlacePhrase(*tokens, one.end + 1);
  if (two.end == 0 || (!one.to_thing && !two.to_thing)) return;
  // "behind the houses, in the east": the east tells where behind them is.
  if (IsOneOf(WordAt(*tokens, begin), {"behind", "opposite"}) && !two.to_thing) return;
  if (!comma && !(one.to_thing && two.to_thing)) return;
  std::size_t thing = two.end + (IsMark(*tokens, two.end) ? 1 : 0);
  const std::size_t verb = thing;
  while (IsOneOf(WordAt(*tokens, thing), {"there", "is", "are", "lies", "lie", "stands", "stand",
                                          "sits", "sit", "we", "find", "you", "should", "be"})) {
    ++thing;
  }
  const bool says = thing > verb;
  if (!says && thing == two.end) return;
  const NounSpan span = TakeNounSpan(*tokens, thing);
  const bool known = WordAt(*tokens, span.begin) == "the";
  if (!span.found() || !IsPauseAt(*tokens, span.end) || (known && !says)) return;
  // A list would be one of places: "west of the lake, east of the road, fields, ..."
  if (!says && !IsStopAt(*tokens, span.end)) return;
  const Token beside = (*tokens)[begin];
  const bool many = MatchClassWord(*tokens, span.noun).plural;
  std::vector<Token> said;
  const bool opens = at == 0 || IsStopAt(*tokens, at - 1);
  if (!opens && begin > at) said.push_back(StopLike(beside));
  const auto put = [&](std::size_t from, std::size_t end) {
    for (const Token& token : TokensBetween(*tokens, from, end)) said.push_back(token);
  };
  put(span.begin, span.end);
  said.push_back(WordLike(many ? "lie" : "lies", beside));
  put(begin, one.end);
  said.push_back(CommaLike(beside));
  put(one.end + 1, two.end);
  std::size_t first = at;
  if (!opens && IsMark(*tokens, first - 1)) {
    --first;
    if (begin == at) said.insert(said.begin(), StopLike(beside));
  }
  EraseTokens(tokens, first, span.end - first);
  InsertTokens(tokens, first, said);
}

// "A lake and, to its east, a forest": to its east a forest. "A road and, alongside it, a river": a
// river parallel to it.
void TurnSetOff(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "and" || !IsMark(*tokens, at + 1)) return;
  const PlacePhrase phrase = TakePlacePhrase(*tokens, at + 2);
  if (phrase.end == 0 || !phrase.to_thing || !IsMark(*tokens, phrase.end) ||
      WordAt(*tokens, phrase.end - 1) == "that") {
    return;
  }
  const NounSpan span = TakeNounSpan(*tokens, phrase.end + 1);
  if (!span.found() || WordAt(*tokens, span.begin) == "the") return;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  const bool lines = !named.empty() && MatchClassWord(*tokens, named[0].begin).is_line() &&
                     MatchClassWord(*tokens, span.noun).is_line();
  EraseTokens(tokens, phrase.end, 1);
  if (lines && WordAt(*tokens, at + 2) == "alongside")
    ReplaceTokens(tokens, at + 2, 1, {"parallel", "to"});
  EraseTokens(tokens, at + 1, 1);
}

// "The trees under them": below them.
void TurnUnderThem(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"under", "underneath"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"them", "these", "those"}) &&
      MatchClassWord(*tokens, at + 2).tokens == 0) {
    (*tokens)[at].text = "below";
  }
}

// "A river runs through the forest, right?", "So there is a river, right, and a town": no side.
void TurnRightFiller(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"right", "ok", "okay"}) || at == 0 ||
      !IsMark(*tokens, at - 1) || (*tokens)[at - 1].text != "," || !IsPauseAt(*tokens, at + 1)) {
    return;
  }
  bool sides = false, talks = false;
  for (std::size_t i = 0; i < tokens->size(); ++i) {
    sides = sides || IsOneOf(WordAt(*tokens, i), {"left", "top", "bottom", "middle", "center",
                                                  "centre", "upper", "lower"});
  }
  for (std::size_t i = SentenceBegin(*tokens, at); i + 1 < at; ++i)
    talks = talks || IsOneOf(WordAt(*tokens, i), {"so", "there", "we", "you", "i", "imagine"});
  const bool asks = at + 1 < tokens->size() && (*tokens)[at + 1].text == "?";
  const bool between = IsMark(*tokens, at + 1) && (*tokens)[at + 1].text == ",";
  if (sides || !(asks || (between && talks))) return;
  EraseTokens(tokens, at - 1, 2);
}

}  // namespace

void TurnInserts(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnRightFiller(tokens, at);
    TurnUnderThem(tokens, at);
    TurnSetOff(tokens, at);
    TurnTwoPlaces(tokens, at);
  }
}

}  // namespace latticeworld
