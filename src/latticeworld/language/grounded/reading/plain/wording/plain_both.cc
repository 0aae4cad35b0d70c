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

// This file rewrites "both", "neither" and "all" of what a list names, "the northern one" of two
// things, and "the other half".
namespace latticeworld {
namespace {

// "Both the wood and the lake are in the south": no number of woods. "Both lakes and the wood": two
// lakes.
void TurnBothAnd(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "both") return;
  const NounSpan one = TakeNounSpan(*tokens, at + 1);
  if (!one.found() || WordAt(*tokens, one.end) != "and") return;
  const NounSpan two = TakeNounSpan(*tokens, one.end + 1);
  if (!two.found()) return;
  const auto has_article = [&](const NounSpan& span) {
    return IsOneOf(WordAt(*tokens, span.begin), {"the", "a", "an", "its", "this", "that"});
  };
  if (one.plural && !has_article(one) && has_article(two)) return;
  EraseTokens(tokens, at, 1);
}

// "Snow above both of them": above them.
void TurnBothOfThem(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !IsOneOf(WordAt(*tokens, at), {"both", "each"}) ||
      WordAt(*tokens, at + 1) != "of" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"them", "these", "those"}) ||
      !IsOneOf(WordAt(*tokens, at - 1), {"above", "below", "beneath", "under", "around", "near",
                                         "beside", "to", "of", "from", "behind"})) {
    return;
  }
  ReplaceTokens(tokens, at, 3, {"them"});
}

// Whether the clause before `at` names two things or more, one of them behind an "and" or a comma.
bool EndsList(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t begin = SentenceBegin(tokens, at);
  const std::vector<NamedThing> named = NamedBefore(tokens, at);
  if (named.size() < 2 || named[1].begin < begin) return false;
  for (std::size_t i = named[1].end; i < named[0].begin; ++i)
    if (WordAt(tokens, i) == "and" || IsMark(tokens, i)) return true;
  return false;
}

bool IsTouch(std::string_view word) {
  return IsOneOf(word, {"touches", "touch", "borders", "border", "adjoins", "adjoin", "reaches",
                        "reach", "touching", "bordering"});
}

bool IsNear(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view word = WordAt(tokens, at);
  return IsOneOf(word, {"near", "beside", "by", "alongside"}) ||
         (IsOneOf(word, {"next", "close", "adjacent"}) && WordAt(tokens, at + 1) == "to");
}

// "A lake and a forest, neither of them near the road", "..., and neither touches the road": they
// are not near it. "..., both next to the road": both are.
void TurnOfTheList(std::vector<Token>* tokens, std::size_t at) {
  const bool neither = WordAt(*tokens, at) == "neither";
  if ((!neither && !IsOneOf(WordAt(*tokens, at), {"both", "all"})) || at < 2) return;
  std::size_t end = at + 1;
  if (WordAt(*tokens, end) == "three" && WordAt(*tokens, at) == "all") ++end;
  if (WordAt(*tokens, end) == "of" &&
      IsOneOf(WordAt(*tokens, end + 1), {"them", "these", "those", "which"})) {
    end += 2;
  }
  std::size_t begin = at;
  while (begin > 0 && (IsOneOf(WordAt(*tokens, begin - 1), {"and", "but", "with", "they", "are"}) ||
                       IsMark(*tokens, begin - 1))) {
    --begin;
  }
  const bool opens = begin == 0 || IsStopAt(*tokens, begin - 1);
  if (begin == at || (*tokens)[begin].text == "with") return;
  // "neither is", "neither of them lies"
  bool is = false;
  while (IsOneOf(WordAt(*tokens, end), {"is", "are", "lies", "lie", "stands", "being", "lying"})) {
    is = true;
    ++end;
  }
  const bool touch = IsTouch(WordAt(*tokens, end)) && !is;
  if (!IsNear(*tokens, end) && !(touch && neither)) return;
  // "two lakes, neither near the road"
  const std::vector<NamedThing> named = NamedBefore(*tokens, begin);
  bool many = neither && !named.empty() && MatchClassWord(*tokens, named[0].begin).plural;
  // "a town in the north, a second one in the south, and neither ..."
  for (std::size_t i = SentenceBegin(*tokens, begin); neither && i < begin; ++i)
    many = many || IsOneOf(WordAt(*tokens, i), {"second", "another", "other"});
  if (!opens && !many && !EndsList(*tokens, begin)) return;
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  if (!opens) said.push_back(StopLike(beside));
  for (const Token& token : SaidLike(neither ? "they are not" : "they are", beside))
    said.push_back(token);
  if (touch) {
    for (const Token& token : SaidLike("next to", beside)) said.push_back(token);
    ++end;
  }
  EraseTokens(tokens, begin, end - begin);
  InsertTokens(tokens, begin, said);
}

// "Two lakes. Neither is near the road": they are not.
void TurnNeitherOfThem(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "neither" || at == 0 || !IsStopAt(*tokens, at - 1)) return;
  std::size_t end = at + 1;
  if (WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "them") end += 2;
  if (!IsOneOf(WordAt(*tokens, end), {"is", "are", "lies"}) || !IsNear(*tokens, end + 1)) return;
  ReplaceTokens(tokens, at, end + 1 - at, {"they", "are", "not"});
}

// "A lake and a forest, with the village in between, all in the south": these three are.
void TurnAllOfIt(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "all" || at == 0 || !IsMark(*tokens, at - 1) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"in", "at", "near", "on"}) ||
      !IsStopAt(*tokens, PauseAfter(*tokens, at))) {
    return;
  }
  Heading heading;
  if (TakeHeading(*tokens, at + 2, &heading) == 0) return;
  const std::size_t begin = SentenceBegin(*tokens, at);
  bool with = false;
  for (std::size_t i = begin; i + 1 < at; ++i)
    with = with || (IsMark(*tokens, i) && WordAt(*tokens, i + 1) == "with");
  std::vector<NamedThing> named = NamedBefore(*tokens, at);
  while (!named.empty() && named.back().begin < begin) named.pop_back();
  if (!with || named.size() < 3) return;
  std::string names;
  for (std::size_t i = named.size(); i-- > 0;) {
    names += i + 1 == named.size() ? ". the " : i > 0 ? ", the " : " and the ";
    names += JoinWords(*tokens, named[i].begin, named[i].end);
  }
  const std::vector<Token> said = SaidLike(names + " are", (*tokens)[at]);
  EraseTokens(tokens, at - 1, 2);
  InsertTokens(tokens, at - 1, said);
}

// "The southern village lies on the river, the northern one in the forest": the northern village.
// "The lake with the village is in the north, the one without in the south": the other lake.
void TurnDirectedOne(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "one" || at < 2) return;
  std::size_t the = at - 1;
  Heading told;
  const bool without = WordAt(*tokens, the) == "the" && WordAt(*tokens, at + 1) == "without";
  while (!without && the > 0 && the + 3 > at && WordAt(*tokens, the) != "the") --the;
  if (WordAt(*tokens, the) != "the") return;
  if (!without && TakeHeading(*tokens, the, &told) != at) return;
  const std::size_t begin = SentenceBegin(*tokens, at);
  const std::size_t from = begin > 0 ? SentenceBegin(*tokens, begin - 1) : begin;
  for (std::size_t i = the; i-- > from;) {
    Heading other;
    const std::size_t noun = without ? i : TakeHeading(*tokens, i, &other);
    if (noun == 0 || (!without && WordAt(*tokens, i) != "the" && WordAt(*tokens, i) != "a")) {
      continue;
    }
    // The longest name: "mountain village".
    const NounSpan span = TakeNounSpan(*tokens, noun);
    if (!span.found() || span.noun != noun || span.plural) continue;
    if (without && WordAt(*tokens, span.end) != "with") continue;
    if (!without && other.east == told.east && other.south == told.south) continue;
    std::vector<Token> name;
    if (without) name.push_back(WordLike("other", (*tokens)[at]));
    for (std::size_t k = span.noun; k < span.end; ++k)
      name.push_back(WordLike((*tokens)[k].text, (*tokens)[at]));
    std::size_t end = at + (without ? 2 : 1);
    if (without && IsOneOf(WordAt(*tokens, end), {"it", "one"})) ++end;
    if (without && !IsOneOf(WordAt(*tokens, end), {"is", "lies", "in", "stands", "sits"})) return;
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, name);
    // "... is big and the lower one touches the village": no list of lakes.
    if (WordAt(*tokens, the - 1) == "and") (*tokens)[the - 1] = CommaLike((*tokens)[the - 1]);
    return;
  }
}

// "One half of the map is water and the other is forest": the other half.
void TurnOtherHalf(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "the" || WordAt(*tokens, at + 1) != "other" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"is", "has", "should", "consists", "must"})) {
    return;
  }
  // "the other is in the fields": the other of two things
  if (IsOneOf(WordAt(*tokens, SkipBeing(*tokens, at + 2)),
              {"in", "at", "on", "near", "to", "next", "by", "north", "south", "east", "west"})) {
    return;
  }
  const std::size_t begin = SentenceBegin(*tokens, at);
  const std::size_t from = begin == at && begin > 0 ? SentenceBegin(*tokens, begin - 1) : begin;
  for (std::size_t i = from; i + 1 < at; ++i) {
    if (WordAt(*tokens, i) != "one" || WordAt(*tokens, i + 1) != "half") continue;
    if (WordAt(*tokens, i + 2) == "of" && !IsMapWord(WordAt(*tokens, i + 4))) return;
    for (std::size_t k = i + 2; k < at; ++k)
      if (WordAt(*tokens, k) == "one") return;
    // "the other has a lake": nobody says how much of it
    if (WordAt(*tokens, at + 2) == "has")
      ReplaceTokens(tokens, at, 3, {"there", "is"});
    else
      InsertTokens(tokens, at + 2, {WordLike("half", (*tokens)[at + 1])});
    return;
  }
}

}  // namespace

void TurnBoth(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnBothAnd(tokens, at);
    TurnBothOfThem(tokens, at);
    TurnNeitherOfThem(tokens, at);
    TurnOfTheList(tokens, at);
    TurnAllOfIt(tokens, at);
    TurnDirectedOne(tokens, at);
    TurnOtherHalf(tokens, at);
  }
}

}  // namespace latticeworld
