#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Numbers and words whose noun is named before.
namespace latticeworld {
namespace {

// "in", "by", "north of".
bool IsPlacing(std::string_view word) {
  if (!HeadingWord(word).empty()) return true;
  return IsOneOf(word, {"in", "on", "at", "by", "near", "along", "beside", "next"});
}

// "Three houses in the north and two in the south": five houses, three of them in the north and two
// of them in the south.
void TurnMoreOfThem(std::vector<Token>* tokens, std::size_t at) {
  const NumberMatch first = MatchNumber(*tokens, at);
  if (first.tokens == 0 || first.value < 2) return;
  const std::size_t noun = at + first.tokens;
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  const std::size_t noun_end = noun + match.tokens;
  if (match.word == nullptr || !match.plural || !IsPlacing(WordAt(*tokens, noun_end))) return;
  std::size_t next = noun_end;
  // ", one in the north-west and one in the south-west" are two of those that were counted.
  while (!IsPauseAt(*tokens, next) && WordAt(*tokens, next) != "and") ++next;
  // "three houses in the north, two in the south": of opposite sides
  const auto side_before = [&](std::size_t i) { return SideWord(WordAt(*tokens, i - 1)); };
  const std::size_t stop = StopAfter(*tokens, next);
  const bool opposite = IsMark(*tokens, next) && PauseAfter(*tokens, next + 1) == stop &&
                        !side_before(next).empty() &&
                        OppositeOf(side_before(next)) == side_before(stop) && stop - next <= 6;
  if (WordAt(*tokens, next) != "and" && !opposite) return;
  ++next;
  const NumberMatch second = MatchNumber(*tokens, next);
  std::size_t end = next + second.tokens;
  if (second.tokens == 0) return;
  // "and one lake in the east"
  const ClassWordMatch same = MatchClassWord(*tokens, end);
  if (same.word == match.word) end += same.tokens;
  if (!IsPlacing(WordAt(*tokens, end)) || WordAt(*tokens, end + 1) == "each") return;
  for (std::size_t i = end; !IsStopAt(*tokens, i); ++i) {
    const bool further = IsOneOf(WordAt(*tokens, i), {"other", "others", "rest"}) ||
                         (WordAt(*tokens, i) == "and" && MatchNumber(*tokens, i + 1).tokens > 0);
    if (further) return;
  }
  const Token beside = (*tokens)[at];
  const std::vector<Token> first_number = TokensBetween(*tokens, at, noun);
  const std::vector<Token> of_them = {WordLike("of", beside), WordLike("them", beside)};
  EraseTokens(tokens, next + second.tokens, end - next - second.tokens);
  InsertTokens(tokens, next + second.tokens, of_them);
  std::vector<Token> said = {CommaLike(beside)};
  said.insert(said.end(), first_number.begin(), first_number.end());
  said.insert(said.end(), of_them.begin(), of_them.end());
  InsertTokens(tokens, noun_end, said);
  EraseTokens(tokens, at, first.tokens);
  InsertTokens(
      tokens, at,
      {{TokenKind::kNumber, std::to_string(first.value + second.value), beside.begin, beside.end}});
}

// "Three lakes: a big one in the middle and two small ones in the north": two of them. "The
// northern corners are forest, the southern ones fields": the southern corners are.
void TurnOnes(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "ones" || at < 2) return;
  if (IsSize(WordAt(*tokens, at - 1))) {
    const NumberMatch number = MatchNumber(*tokens, at - 2);
    if (number.tokens != 1 || number.value < 2) return;
    ReplaceTokens(tokens, at - 1, 2, {"of", "them"});
    return;
  }
  if (SideWord(WordAt(*tokens, at - 1)).empty()) return;
  for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i);) {
    if (!IsOneOf(WordAt(*tokens, i), {"corners", "quarters", "edges", "quadrants"})) continue;
    const std::string noun((*tokens)[i].text);
    const bool bare = MatchClassWord(*tokens, at + 1).tokens > 0;
    ReplaceTokens(tokens, at, 1, {noun});
    if (bare) InsertTokens(tokens, at + 1, {WordLike("are", (*tokens)[at])});
    return;
  }
}

// "Half of the houses are by the lake, the others by the road", "most of the houses are in the
// west, a few in the east": and houses by the road.
void TurnOthersBy(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at)) return;
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"and", "but", "while"})) ++next;
  if (WordAt(*tokens, next) == "the" &&
      IsOneOf(WordAt(*tokens, next + 1), {"others", "rest", "remaining", "other"})) {
    next += 2;
    if (IsOneOf(WordAt(*tokens, next), {"half", "ones"})) ++next;
  } else if (WordAt(*tokens, next) == "a" && WordAt(*tokens, next + 1) == "few") {
    next += 2;
  } else if (IsOneOf(WordAt(*tokens, next), {"some", "others"})) {
    ++next;
  } else {
    return;
  }
  if (IsOneOf(WordAt(*tokens, next), {"are", "lie", "stand"})) ++next;
  if (!IsPlacing(WordAt(*tokens, next))) return;
  const std::size_t begin = [&] {
    std::size_t i = at;
    while (i > 0 && !IsStopAt(*tokens, i - 1)) --i;
    return i;
  }();
  if (!IsOneOf(WordAt(*tokens, begin), {"half", "some", "most", "many"})) return;
  std::size_t noun = begin + 1;
  while (IsOneOf(WordAt(*tokens, noun), {"of", "the"})) ++noun;
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  if (match.word == nullptr || !match.plural) return;
  const std::string name = JoinWords(*tokens, noun, noun + match.tokens);
  ReplaceTokens(tokens, at + 1, next - at - 1, {"and", name});
}

// "Five houses, of which two stand by the lake", "of the three lakes two are in the north": five
// houses, two of them by the lake. "Six houses in two rows of three": six houses.
void TurnOfWhich(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "in" && IsOneOf(WordAt(*tokens, at + 2), {"rows", "lines"}) &&
      WordAt(*tokens, at + 3) == "of" && MatchNumber(*tokens, at + 4).tokens == 1) {
    EraseTokens(tokens, at, 5);
    return;
  }
  if (WordAt(*tokens, at) != "of") return;
  const auto verb_end = [&](std::size_t i) {
    while (IsOneOf(WordAt(*tokens, i),
                   {"are", "is", "lie", "lies", "stand", "stands", "should", "be"})) {
      ++i;
    }
    return i;
  };
  if (WordAt(*tokens, at + 1) == "which" && at > 0 && IsMark(*tokens, at - 1)) {
    const NumberMatch number = MatchNumber(*tokens, at + 2);
    const std::size_t end = verb_end(at + 2 + number.tokens);
    if (number.tokens != 1 || !IsPlacing(WordAt(*tokens, end))) return;
    const std::string words = JoinWords(*tokens, at + 2, at + 3);
    ReplaceTokens(tokens, at, end - at, {words, "of", "them"});
    return;
  }
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  const std::size_t count = at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1);
  const NumberMatch all = MatchNumber(*tokens, count);
  const std::size_t noun = count + all.tokens;
  std::size_t next = noun + MatchClassWord(*tokens, noun).tokens;
  if (all.tokens == 0 || next == noun) return;
  const std::size_t noun_end = next;
  if (IsMark(*tokens, next)) ++next;
  const NumberMatch number = MatchNumber(*tokens, next);
  const std::size_t end = verb_end(next + number.tokens);
  if (number.tokens != 1 || !IsPlacing(WordAt(*tokens, end))) return;
  const std::string words = JoinWords(*tokens, next, next + 1);
  ReplaceTokens(tokens, next, end - next, {words, "of", "them"});
  if (noun_end == next) InsertTokens(tokens, noun_end, {CommaLike((*tokens)[at])});
  EraseTokens(tokens, at, count - at);
}

// "The forest should take up the most space, followed by the fields": mostly forest, more forest
// than fields. "More water than houses, but less than forest": more forest than water.
void TurnMostThenNext(std::vector<Token>* tokens, std::size_t at) {
  // "more water than houses, but less than forest"
  if (IsOneOf(WordAt(*tokens, at), {"less", "fewer"}) && WordAt(*tokens, at + 1) == "than" &&
      at > 1) {
    const std::size_t other = at + 2 + (WordAt(*tokens, at + 2) == "the" ? 1 : 0);
    const std::size_t other_end = other + MatchClassWord(*tokens, other).tokens;
    std::size_t more = at;
    while (more > 0 && !IsStopAt(*tokens, more - 1) && WordAt(*tokens, more) != "more") --more;
    const std::size_t length = MatchClassWord(*tokens, more + 1).tokens;
    std::size_t begin = at;
    while (begin > 0 && (IsMark(*tokens, begin - 1) ||
                         IsOneOf(WordAt(*tokens, begin - 1), {"but", "and", "yet"}))) {
      --begin;
    }
    if (WordAt(*tokens, more) != "more" || length == 0 || other_end == other || begin == at ||
        !IsPauseAt(*tokens, other_end)) {
      return;
    }
    const std::string first = JoinWords(*tokens, more + 1, more + 1 + length);
    const std::string second = JoinWords(*tokens, other, other_end);
    const Token beside = (*tokens)[at];
    ReplaceTokens(tokens, begin, other_end - begin, {"more", second, "than", first});
    InsertTokens(tokens, begin, {StopLike(beside)});
    return;
  }
  // "the most space, followed by"
  if (WordAt(*tokens, at) != "the" || WordAt(*tokens, at + 1) != "most" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"space", "area", "land", "room", "ground"}) ||
      !IsMark(*tokens, at + 3) || WordAt(*tokens, at + 4) != "followed" ||
      WordAt(*tokens, at + 5) != "by") {
    return;
  }
  // What has most was named before, what comes next follows.
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  const std::size_t next = at + 6 + (WordAt(*tokens, at + 6) == "the" ? 1 : 0);
  const std::size_t end = next + MatchClassWord(*tokens, next).tokens;
  std::size_t begin = at;
  while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
  if (named.empty() || named.front().begin < begin || end == next) return;
  const std::string most = JoinWords(*tokens, named.front().begin, named.front().end);
  const std::string less = JoinWords(*tokens, next, end);
  const Token beside = (*tokens)[at];
  ReplaceTokens(tokens, begin, end - begin, {"mostly", most, "more", most, "than", less});
  InsertTokens(tokens, begin + 2, {StopLike(beside)});
}

// "On both sides of the river and a path along its left side": along the left side of the river.
void TurnItsSideOfBoth(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"along", "on"}) || WordAt(*tokens, at + 1) != "its" ||
      !IsOneOf(WordAt(*tokens, at + 3), {"side", "bank"}) || !IsPauseAt(*tokens, at + 4) ||
      SideWord(WordAt(*tokens, at + 2)).empty()) {
    return;
  }
  for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i);) {
    if (WordAt(*tokens, i) != "both" || WordAt(*tokens, i + 2) != "of" ||
        WordAt(*tokens, i + 3) != "the") {
      continue;
    }
    const std::size_t length = MatchClassWord(*tokens, i + 4).tokens;
    if (length == 0) return;
    const Token beside = (*tokens)[at];
    std::vector<Token> said = {WordLike("of", beside), WordLike("the", beside)};
    for (const Token& token : TokensBetween(*tokens, i + 4, i + 4 + length))
      said.push_back(WordLike(token.text, beside));
    InsertTokens(tokens, at + 4, said);
    (*tokens)[at + 1].text = "the";
    return;
  }
}

// "On the left there are three houses, on the right only one": four houses, and houses on the
// right.
void TurnOnlyMore(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"only", "just"}) || at < 3) return;
  const NumberMatch number = MatchNumber(*tokens, at + 1);
  if (number.tokens == 0 || !IsStopAt(*tokens, at + 1 + number.tokens)) return;
  std::size_t place = at;
  while (place > 0 && !IsPauseAt(*tokens, place - 1) && WordAt(*tokens, place - 1) != "and")
    --place;
  if (!IsPlacing(WordAt(*tokens, place))) return;
  for (std::size_t i = place; i-- > 0 && !IsStopAt(*tokens, i);) {
    const NumberMatch known = MatchNumber(*tokens, i);
    const std::size_t noun = i + known.tokens;
    const ClassWordMatch match = MatchClassWord(*tokens, noun);
    if (known.tokens == 0 || known.value < 2 || match.word == nullptr || !match.plural) continue;
    const std::vector<Token> things = TokensBetween(*tokens, noun, noun + match.tokens);
    const Token beside = (*tokens)[i];
    EraseTokens(tokens, at, 1 + number.tokens);
    InsertTokens(tokens, at, things);
    EraseTokens(tokens, i, known.tokens);
    InsertTokens(tokens, i,
                 {{TokenKind::kNumber, std::to_string(known.value + number.value), beside.begin,
                   beside.end}});
    return;
  }
}

// The nouns of tokens [begin, end), the longest of each.
std::vector<NamedThing> NamedIn(const std::vector<Token>& tokens, std::size_t begin,
                                std::size_t end) {
  std::vector<NamedThing> named;
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t length = MatchClassWord(tokens, i).tokens;
    if (length == 0) continue;
    named.push_back({i, i + length});
    i += length - 1;
  }
  return named;
}

// "In the west a forest, in the east a lake, in between a village": between them. "Top: forest.
// Bottom: fields. Between them a river": between the forest and the fields.
void TurnBetweenThem(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0) return;
  if (WordAt(*tokens, at) == "in" && WordAt(*tokens, at + 1) == "between" &&
      (IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and") &&
      IsOneOf(WordAt(*tokens, at + 2), {"a", "an", "there", "lies", "is", "runs", "flows"})) {
    ReplaceTokens(tokens, at, 2, {"between", "them"});
  }
  if (!IsStopAt(*tokens, at - 1) || WordAt(*tokens, at) != "between" ||
      WordAt(*tokens, at + 1) != "them") {
    return;
  }
  std::size_t second = at - 1;
  while (second > 0 && !IsStopAt(*tokens, second - 1)) --second;
  if (second < 2) return;
  std::size_t first = second - 1;
  while (first > 0 && !IsStopAt(*tokens, first - 1)) --first;
  const std::vector<NamedThing> one = NamedIn(*tokens, first, second - 1);
  const std::vector<NamedThing> other = NamedIn(*tokens, second, at - 1);
  if (one.size() != 1 || other.size() != 1) return;
  const std::string names[2] = {JoinWords(*tokens, one[0].begin, one[0].end),
                                JoinWords(*tokens, other[0].begin, other[0].end)};
  ReplaceTokens(tokens, at + 1, 1, {"the", names[0], "and", "the", names[1]});
}

}  // namespace

void TurnCounts(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnMoreOfThem(tokens, at);
    TurnOnlyMore(tokens, at);
    TurnOnes(tokens, at);
    TurnOthersBy(tokens, at);
    TurnOfWhich(tokens, at);
    TurnMostThenNext(tokens, at);
    TurnItsSideOfBoth(tokens, at);
    TurnBetweenThem(tokens, at);
  }
}

}  // namespace latticeworld
