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

// Sides and things that are left out of what surrounds, of what is missing.
namespace latticeworld {
namespace {

// "except", "apart from", "but": the token after such words; `at`: none of them.
std::size_t SkipExcept(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view word = WordAt(tokens, at), next = WordAt(tokens, at + 1);
  if (IsOneOf(word, {"apart", "aside"}) && next == "from") return at + 2;
  if (word == "other" && next == "than") return at + 2;
  if (!IsOneOf(word, {"except", "but", "save", "besides", "bar", "excepting"})) return at;
  return at + (next == "for" ? 2 : 1);
}

// "A village with forest on all sides but the west", "surrounded by forest on every side except the
// south, where there are fields": surrounded by forest; to the south of it there are fields.
void TurnAllSidesBut(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || !IsOneOf(WordAt(*tokens, at + 1), {"all", "every"})) return;
  std::size_t next = at + 2;
  if (WordAt(*tokens, next) == "its") ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"side", "sides"})) return;
  ++next;
  if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "it") next += 2;
  std::size_t but = next + (IsMark(*tokens, next) ? 1 : 0);
  const std::size_t left_out = SkipExcept(*tokens, but);
  if (left_out == but) return;
  std::size_t side = left_out;
  while (IsOneOf(WordAt(*tokens, side), {"on", "in", "to", "at", "towards", "the"})) ++side;
  const std::string heading(SideWord(WordAt(*tokens, side)));
  std::size_t end = side + 1;
  if (IsFlank(WordAt(*tokens, end))) ++end;
  if (heading.empty() || !IsPauseAt(*tokens, end)) return;
  // The words before tell whose sides they are, and what lies there: "surrounded by forest", "has
  // fields", "with fields".
  const std::size_t begin = SentenceBegin(*tokens, at);
  std::size_t with = at;
  while (with > begin && !IsOneOf(WordAt(*tokens, with), {"by", "with", "has"})) --with;
  const std::vector<NamedThing> named = NamedBefore(*tokens, with);
  if (with == begin || named.empty() || named.front().begin < begin ||
      !NamesThing(*tokens, with + 1)) {
    return;
  }
  const std::string owner = JoinWords(*tokens, named.front().begin, named.front().end);
  const Token beside = (*tokens)[at];
  // "..., where there are fields"
  if (IsMark(*tokens, end) && WordAt(*tokens, end + 1) == "where") {
    std::size_t there = end + 2;
    const bool is = IsOneOf(WordAt(*tokens, there), {"there", "it"});
    while (IsOneOf(WordAt(*tokens, there), {"there", "is", "are", "it", "touches", "meets", "has",
                                            "you", "find", "lie", "lies"})) {
      ++there;
    }
    if (NamesThing(*tokens, there)) {
      EraseTokens(tokens, end, there - end);
      InsertTokens(
          tokens, end,
          SaidLike(". to the " + heading + " of the " + owner + (is ? " there is" : ""), beside));
    }
  }
  EraseTokens(tokens, at, end - at);
  if (WordAt(*tokens, with) == "by") return;
  const bool has = WordAt(*tokens, with) == "has";
  ReplaceTokens(tokens, with, 1, {has ? "is" : "which", has ? "surrounded" : "is"});
  InsertTokens(tokens, with + 2, SaidLike(has ? "by" : "surrounded by", beside));
}

// "No buildings at all except one farm in the south": one farm in the south, no other buildings.
// "No houses apart from one": except one. "No forest except in the north": forest only in the
// north.
void TurnNoneBut(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "no") return;
  const ClassWordMatch none = MatchClassWord(*tokens, at + 1);
  if (none.word == nullptr) return;
  const std::size_t noun_end = at + 1 + none.tokens;
  std::size_t next = noun_end;
  while (IsOneOf(WordAt(*tokens, next), {"at", "all", "anywhere", "whatsoever"})) ++next;
  const std::size_t but = next + (IsMark(*tokens, next) ? 1 : 0);
  const std::size_t thing = SkipExcept(*tokens, but);
  if (thing == but) return;
  // "no forest except in the north": forest only there
  PlaceCursor cursor(*tokens, thing + (WordAt(*tokens, thing + 1) == "the" ? 2 : 1));
  if (IsOneOf(WordAt(*tokens, thing), {"in", "on", "at"}) && TakeDirection(&cursor).found) {
    EraseTokens(tokens, noun_end, thing - noun_end);
    InsertTokens(tokens, noun_end, {WordLike("only", (*tokens)[at])});
    EraseTokens(tokens, at, 1);
    return;
  }
  const bool one = IsOneOf(WordAt(*tokens, thing), {"one", "a", "an", "two", "three", "some"});
  if (!one) return;
  std::size_t noun = thing + 1;
  while (IsSize(WordAt(*tokens, noun)) || WordAt(*tokens, noun) == "single") ++noun;
  const ClassWordMatch left = MatchClassWord(*tokens, noun);
  const std::string_view place = WordAt(*tokens, thing + 1);
  if (left.word == nullptr && !IsOneOf(place, {"in", "on", "at", "near", "by", "along", "next"}))
    return;
  if (left.word == nullptr || left.word->suburb == none.word->suburb) {
    EraseTokens(tokens, noun_end, thing - noun_end);
    InsertTokens(tokens, noun_end, {WordLike("except", (*tokens)[at])});
    return;
  }
  const std::size_t end = PauseAfter(*tokens, noun);
  std::vector<Token> said = TokensBetween(*tokens, thing, end);
  for (const Token& token : SaidLike(". no", (*tokens)[at])) said.push_back(token);
  for (const Token& token : TokensBetween(*tokens, at + 1, noun_end)) said.push_back(token);
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "West of the road there are only houses, east of it only meadows": there are houses.
void TurnOnlyBeside(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "only" || MatchClassWord(*tokens, at + 1).tokens == 0) return;
  std::size_t end = at;
  while (end > 0 && IsOneOf(WordAt(*tokens, end - 1), {"there", "is", "are"})) --end;
  std::size_t side = end;
  while (side > 0 && !IsPauseAt(*tokens, side - 1) && side + 4 > end) {
    --side;
    if (!SideWord(WordAt(*tokens, side)).empty() && WordAt(*tokens, side + 1) == "of" &&
        !IsMapWord(WordAt(*tokens, side + 3))) {
      EraseTokens(tokens, at, 1);
      return;
    }
  }
}

// "Surrounded by forest on three sides and by fields on the fourth": surrounded by forest, and next
// to fields.
void TurnThreeSides(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "three" ||
      WordAt(*tokens, at + 2) != "sides" || WordAt(*tokens, at + 3) != "and") {
    return;
  }
  bool surrounded = false;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i)
    surrounded = surrounded || WordAt(*tokens, i) == "surrounded";
  std::size_t fourth = at + 4;
  while (!IsPauseAt(*tokens, fourth) && WordAt(*tokens, fourth) != "fourth") ++fourth;
  if (!surrounded || WordAt(*tokens, fourth) != "fourth" || !IsPauseAt(*tokens, fourth + 1)) return;
  std::size_t noun = at + 4;
  if (IsOneOf(WordAt(*tokens, noun), {"by", "with"})) ++noun;
  std::size_t end = fourth;
  while (IsOneOf(WordAt(*tokens, end - 1), {"the", "on"})) --end;
  if (!NamesThing(*tokens, noun) || end <= noun) return;
  const std::vector<Token> other = TokensBetween(*tokens, noun, end);
  const Token beside = (*tokens)[at];
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.size() < 2) return;
  const std::string owner = JoinWords(*tokens, named[1].begin, named[1].end);
  std::vector<Token> said = SaidLike(". the " + owner + " is next to", beside);
  for (const Token& token : other) said.push_back(token);
  EraseTokens(tokens, at, fourth + 1 - at);
  InsertTokens(tokens, at, said);
}

// "Only the northern part is forested": forest only in the northern part.
void TurnOnlyThePart(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "only" || WordAt(*tokens, at + 1) != "the" ||
      (at > 0 && !IsPauseAt(*tokens, at - 1) && WordAt(*tokens, at - 1) != "and")) {
    return;
  }
  PlaceCursor cursor(*tokens, at + 2);
  if (!TakeDirection(&cursor).found) return;
  std::size_t place_end = cursor.at();
  while (IsFlank(WordAt(*tokens, place_end)) ||
         IsOneOf(WordAt(*tokens, place_end), {"edge", "corner", "third", "quarter"})) {
    ++place_end;
  }
  if (!IsOneOf(WordAt(*tokens, place_end), {"is", "has"})) return;
  const std::size_t land = place_end + 1;
  const std::string adjective(LandOfAdjective(WordAt(*tokens, land)));
  const std::size_t end =
      land + (adjective.empty() ? MatchClassWord(*tokens, land).tokens : std::size_t{1});
  if (end == land || !IsPauseAt(*tokens, end)) return;
  const Token beside = (*tokens)[at];
  std::vector<Token> said = adjective.empty() ? TokensBetween(*tokens, land, end)
                                              : std::vector<Token>{WordLike(adjective, beside)};
  for (const std::string_view word : {"only", "in"}) said.push_back(WordLike(word, beside));
  for (const Token& token : TokensBetween(*tokens, at + 1, place_end)) said.push_back(token);
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "Trees grow along the road only", "houses in the north only": only along the road.
void TurnTrailingOnly(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "only" || !IsStopAt(*tokens, at + 1) || at < 3) return;
  std::size_t place = at;
  while (place > 0 && !IsPauseAt(*tokens, place - 1) && place + 9 > at &&
         !IsOneOf(WordAt(*tokens, place), {"in", "on", "at", "along", "near", "by"})) {
    --place;
  }
  if (!IsOneOf(WordAt(*tokens, place), {"in", "on", "at", "along", "near", "by"})) return;
  std::size_t noun_end = place;
  while (noun_end > 0 && IsOneOf(WordAt(*tokens, noun_end - 1), {"grow", "grows", "stand", "stands",
                                                                 "are", "is", "lie", "lies"})) {
    --noun_end;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, noun_end);
  if (named.empty() || named.front().end != noun_end) return;
  const Token only = WordLike("only", (*tokens)[place - 1]);
  EraseTokens(tokens, at, 1);
  InsertTokens(tokens, place, {only});
}

// "Apart from the lake and the village the map is all grass": a comma before "the map".
void TurnLeadingComma(std::vector<Token>* tokens, std::size_t at) {
  if ((at > 0 && !IsStopAt(*tokens, at - 1)) || SkipExcept(*tokens, at) == at) return;
  for (std::size_t i = at + 2; !IsPauseAt(*tokens, i); ++i) {
    const bool map = WordAt(*tokens, i) == "the" && IsMapWord(WordAt(*tokens, i + 1)) &&
                     WordAt(*tokens, i + 2) == "is";
    const bool all =
        IsOneOf(WordAt(*tokens, i), {"everything", "it"}) && WordAt(*tokens, i + 1) == "is";
    if (!map && !all) continue;
    InsertTokens(tokens, i, {CommaLike((*tokens)[i])});
    return;
  }
}

// "None of the houses is in the forest": no houses in the forest.
void TurnNoneOf(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "none" || WordAt(*tokens, at + 1) != "of" ||
      WordAt(*tokens, at + 2) != "the") {
    return;
  }
  const std::size_t noun_end = at + 3 + MatchClassWord(*tokens, at + 3).tokens;
  std::size_t verb = noun_end;
  while (IsOneOf(WordAt(*tokens, verb),
                 {"is", "are", "lies", "lie", "stands", "stand", "should", "may", "must", "be"})) {
    ++verb;
  }
  if (noun_end == at + 3 || verb == noun_end ||
      !IsOneOf(WordAt(*tokens, verb), {"in", "on", "near", "at", "by", "next", "close"})) {
    return;
  }
  EraseTokens(tokens, noun_end, verb - noun_end);
  EraseTokens(tokens, at + 1, 2);
  (*tokens)[at].text = "no";
}

}  // namespace

void TurnLeftOut(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAllSidesBut(tokens, at);
    TurnNoneBut(tokens, at);
    TurnNoneOf(tokens, at);
    TurnOnlyBeside(tokens, at);
    TurnThreeSides(tokens, at);
    TurnOnlyThePart(tokens, at);
    TurnTrailingOnly(tokens, at);
    TurnLeadingComma(tokens, at);
  }
}

}  // namespace latticeworld
