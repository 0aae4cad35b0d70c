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

// What roads and rivers do on their way.
namespace latticeworld {
namespace {

// "Follows the river from the top to the bottom on its east bank": follows the east bank of the
// river.
void TurnOnItsBank(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "its" ||
      !IsOneOf(WordAt(*tokens, at + 3), {"bank", "side"}) || !IsPauseAt(*tokens, at + 4)) {
    return;
  }
  const std::string side(SideWord(WordAt(*tokens, at + 2)));
  if (side.empty()) return;
  for (std::size_t i = at - (at > 0 && IsMark(*tokens, at - 1) ? 1 : 0);
       i-- > 0 && !IsPauseAt(*tokens, i);) {
    if (!IsOneOf(WordAt(*tokens, i), {"follows", "follow", "following", "accompanies"})) continue;
    const std::size_t noun = i + 2;
    if (WordAt(*tokens, i + 1) != "the" || !MatchClassWord(*tokens, noun).is_line()) return;
    EraseTokens(tokens, at, 4);
    if (at > 0 && IsMark(*tokens, at - 1)) EraseTokens(tokens, at - 1, 1);
    InsertTokens(tokens, noun,
                 {WordLike(side, (*tokens)[i]), WordLike("bank", (*tokens)[i]),
                  WordLike("of", (*tokens)[i]), WordLike("the", (*tokens)[i])});
    return;
  }
}

// "A side road branches off it to the north and ends at a farm": leads to a farm.
void TurnBranchesOff(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"branches", "forks", "turns", "splits", "goes"}) ||
      WordAt(*tokens, at + 1) != "off") {
    return;
  }
  std::size_t next = at + 2;
  while (!IsPauseAt(*tokens, next) && WordAt(*tokens, next) != "and") ++next;
  if (WordAt(*tokens, next) != "and") return;
  std::size_t goal = next + 1;
  if (!IsOneOf(WordAt(*tokens, goal), {"ends", "leads", "runs", "goes", "reaches", "stops"}))
    return;
  ++goal;
  while (IsOneOf(WordAt(*tokens, goal), {"at", "in", "to", "up", "near"})) ++goal;
  // A part of the map is a goal of its own.
  if (!IsOneOf(WordAt(*tokens, goal), {"a", "the", "an", "one"}) ||
      MatchClassWord(*tokens, goal + 1).tokens == 0) {
    return;
  }
  ReplaceTokens(tokens, at, goal - at, {"leads", "to"});
}

// "To the middle, where it ends at a village": to a village in the center.
void TurnWhereItEnds(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || WordAt(*tokens, at + 1) != "where" ||
      WordAt(*tokens, at + 2) != "it" ||
      !IsOneOf(WordAt(*tokens, at + 3), {"ends", "reaches", "meets", "stops", "flows", "joins"})) {
    return;
  }
  std::size_t noun = at + 4;
  while (IsOneOf(WordAt(*tokens, noun), {"at", "in", "near", "into"})) ++noun;
  const std::size_t end = PauseAfter(*tokens, noun);
  std::size_t to = at;
  while (to > 0 && !IsPauseAt(*tokens, to - 1) && WordAt(*tokens, to) != "to") --to;
  if (WordAt(*tokens, to) != "to" || !NamesThing(*tokens, noun) || !IsStopAt(*tokens, end)) return;
  PlaceCursor cursor(*tokens, to + (WordAt(*tokens, to + 1) == "the" ? 2 : 1));
  if (!TakeDirection(&cursor).found) return;
  std::size_t place_end = cursor.at();
  if (IsOneOf(WordAt(*tokens, place_end), {"edge", "corner", "side", "part"})) ++place_end;
  if (place_end != at) return;
  std::vector<Token> said = TokensBetween(*tokens, noun, end);
  said.push_back(WordLike("in", (*tokens)[at]));
  for (const Token& token : TokensBetween(*tokens, to + 1, at)) said.push_back(token);
  EraseTokens(tokens, to + 1, end - to - 1);
  InsertTokens(tokens, to + 1, said);
}

// "The river makes a loop around the village": bends around it. "Before it reaches the lake",
// "before leaving at the bottom": and reaches the lake, and leaves.
void TurnBefore(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"makes", "forms", "describes"}) &&
      WordAt(*tokens, at + 1) == "a" && WordAt(*tokens, at + 2) == "loop" &&
      IsOneOf(WordAt(*tokens, at + 3), {"around", "round"}) && at > 0) {
    if (IsOneOf(WordAt(*tokens, at - 1), {"river", "stream", "brook", "creek"}))
      ReplaceTokens(tokens, at, 3, {"bends"});
    return;
  }
  if (WordAt(*tokens, at) != "before" || at == 0) return;
  constexpr std::pair<std::string_view, std::string_view> kVerbs[] = {
      {"reaching", "reaches"}, {"leaving", "leaves"},   {"reaches", "reaches"},
      {"leaves", "leaves"},    {"entering", "enters"},  {"enters", "enters"},
      {"exiting", "exits"},    {"crossing", "crosses"}, {"crosses", "crosses"},
      {"flowing", "flows"},    {"emptying", "empties"}, {"ending", "ends"},
      {"ends", "ends"},        {"joining", "joins"},    {"flows", "flows"}};
  const std::size_t verb = at + (WordAt(*tokens, at + 1) == "it" ? 2 : 1);
  for (const auto& [said, plain] : kVerbs) {
    if (WordAt(*tokens, verb) != said) continue;
    const std::size_t begin =
        at - (IsOneOf(WordAt(*tokens, at - 1), {"just", "shortly", "right"}) ? 1 : 0);
    ReplaceTokens(tokens, begin, verb + 1 - begin, {"and", plain});
    return;
  }
}

// "Enters at the top, a third of the way from the left": at the top. "From the village straight
// north to the edge": it is the lane that is straight.
void TurnOnTheWay(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"third", "quarter"}) && WordAt(*tokens, at + 1) == "of" &&
      WordAt(*tokens, at + 2) == "the" && WordAt(*tokens, at + 3) == "way" && at > 0 &&
      IsOneOf(WordAt(*tokens, at - 1), {"a", "one"})) {
    std::size_t end = at + 4;
    while (IsOneOf(WordAt(*tokens, end), {"down", "up", "across", "along", "in", "over"})) ++end;
    if (WordAt(*tokens, end) == "from" && WordAt(*tokens, end + 1) == "the") {
      end += 2;
      while (!SideWord(WordAt(*tokens, end)).empty() ||
             IsOneOf(WordAt(*tokens, end), {"edge", "side", "corner"})) {
        ++end;
      }
    }
    std::size_t begin = at - 1;
    while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"about", "roughly", "some"})) --begin;
    if (begin > 0 && IsMark(*tokens, begin - 1)) --begin;
    EraseTokens(tokens, begin, end - begin);
    return;
  }
  if (WordAt(*tokens, at) != "straight" || SideWord(WordAt(*tokens, at + 1)).empty() || at == 0)
    return;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i) {
    if (!MatchClassWord(*tokens, i).is_line()) continue;
    const Token straight = WordLike("straight", (*tokens)[i]);
    EraseTokens(tokens, at, 1);
    InsertTokens(tokens, i, {straight});
    return;
  }
}

// "One river flows from north to south, another joins it from the east": a sentence each.
void TurnAnotherJoins(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "another" || at == 0) return;
  std::size_t verb = at + 1 + (WordAt(*tokens, at + 1) == "one" ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, verb), {"joins", "crosses", "meets", "enters", "flows"})) return;
  std::size_t begin = at;
  if (WordAt(*tokens, begin - 1) == "and") --begin;
  if (begin > 0 && IsMark(*tokens, begin - 1)) --begin;
  if (begin == at) return;
  std::string line;
  for (std::size_t i = SentenceBegin(*tokens, at); i < begin && line.empty(); ++i) {
    const ClassWordMatch match = MatchClassWord(*tokens, i);
    if (match.is_line()) line = JoinWords(*tokens, i, i + match.tokens);
  }
  if (line.empty()) return;
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, begin, verb - begin);
  InsertTokens(tokens, begin,
               {StopLike(beside), WordLike("another", beside), WordLike(line, beside)});
}

// "Goes past the lake to the eastern edge": to the eastern edge, past the lake. "Leading away from
// it": from it.
void TurnPastTo(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "away" && WordAt(*tokens, at + 1) == "from" && at > 0 &&
      IsOneOf(WordAt(*tokens, at - 1), {"leading", "leads", "lead", "running", "runs", "going"})) {
    EraseTokens(tokens, at, 1);
    return;
  }
  if (WordAt(*tokens, at) != "past" || !IsOneOf(WordAt(*tokens, at + 1), {"the", "a"})) return;
  const std::size_t to = at + 2 + MatchClassWord(*tokens, at + 2).tokens;
  if (to == at + 2 || WordAt(*tokens, to) != "to" || WordAt(*tokens, to + 1) != "the" ||
      SideWord(WordAt(*tokens, to + 2)).empty() ||
      !IsOneOf(WordAt(*tokens, to + 3), {"edge", "border", "corner"})) {
    return;
  }
  const std::vector<Token> past = TokensBetween(*tokens, at, to);
  InsertTokens(tokens, to + 4, past);
  EraseTokens(tokens, at, to - at);
}

// "Four roads leave the village, one in each direction": in all four directions. "To all four
// sides": to the northern edge, the southern edge, ... "No road reaches
// the village": touches it.
void TurnEachDirection(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "one" && WordAt(*tokens, at + 1) == "in" &&
      IsOneOf(WordAt(*tokens, at + 2), {"each", "every"}) &&
      IsOneOf(WordAt(*tokens, at + 3), {"direction", "compass"}) && at > 0 &&
      IsMark(*tokens, at - 1)) {
    const std::size_t end = at + (WordAt(*tokens, at + 3) == "compass" ? 5 : 4);
    ReplaceTokens(tokens, at - 1, end - at + 1, {"in", "all", "four", "directions"});
    return;
  }
  if (WordAt(*tokens, at) == "to" && WordAt(*tokens, at + 1) == "all" &&
      WordAt(*tokens, at + 2) == "four" &&
      IsOneOf(WordAt(*tokens, at + 3), {"sides", "edges", "borders"})) {
    std::size_t end = at + 4;
    if (WordAt(*tokens, end) == "of" && IsMapWord(WordAt(*tokens, end + 2))) end += 3;
    const Token comma = CommaLike((*tokens)[at]);
    ReplaceTokens(tokens, at, end - at,
                  {"to", "the", "northern", "edge", "the", "southern", "edge", "the", "eastern",
                   "edge", "and", "the", "western", "edge"});
    InsertTokens(tokens, at + 7, {comma});
    InsertTokens(tokens, at + 4, {comma});
    return;
  }
  if (WordAt(*tokens, at) != "no") return;
  const std::size_t verb = at + 1 + MatchClassWord(*tokens, at + 1).tokens;
  if (!MatchClassWord(*tokens, at + 1).is_line()) return;
  if (!IsOneOf(WordAt(*tokens, verb), {"reaches", "reach"}) ||
      !IsOneOf(WordAt(*tokens, verb + 1), {"the", "it", "them", "this"})) {
    return;
  }
  ReplaceTokens(tokens, verb, 1, {"touches"});
}

// "A road runs between the forest on its left and the lake on its right", "a river runs between
// them": lies between them.
void TurnRunsBetween(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "between" || at < 2 ||
      !IsOneOf(WordAt(*tokens, at - 1), {"runs", "passes", "goes", "leads", "running", "flows"})) {
    return;
  }
  if (WordAt(*tokens, at + 1) == "them" &&
      IsOneOf(WordAt(*tokens, at - 2), {"river", "stream", "brook", "creek", "canal"})) {
    // The words from where and to where it runs still tell of the river.
    ReplaceTokens(tokens, at - 1, 1, {"lies"});
    if (WordAt(*tokens, at + 2) == "from")
      InsertTokens(tokens, at + 2,
                   {WordLike("and", (*tokens)[at]), WordLike("runs", (*tokens)[at])});
    return;
  }
  for (std::size_t i = at; !IsPauseAt(*tokens, i); ++i) {
    if (WordAt(*tokens, i) != "its" || SideWord(WordAt(*tokens, i + 1)).empty()) continue;
    ReplaceTokens(tokens, at - 1, 1, {"lies"});
    return;
  }
}

// "First comes the forest, then the lake, going south": from north to south.
void TurnGoingLast(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !IsMark(*tokens, at - 1) ||
      !IsOneOf(WordAt(*tokens, at), {"going", "heading", "moving", "walking"}) ||
      !IsStopAt(*tokens, at + 2)) {
    return;
  }
  const std::string heading(HeadingWord(WordAt(*tokens, at + 1)));
  bool then = false;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i)
    then = then || WordAt(*tokens, i) == "then";
  if (heading.empty() || !then) return;
  ReplaceTokens(tokens, at, 2, {"from", OppositeOf(heading), "to", heading});
}

// "As you go north, forest turns to rock and rock to snow": from south to north, forest, then rock,
// then snow.
void TurnTurnsTo(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "as" || !IsOneOf(WordAt(*tokens, at + 1), {"you", "we", "one"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"go", "goes", "move", "head", "walk", "travel"})) {
    return;
  }
  const std::string heading(HeadingWord(WordAt(*tokens, at + 3)));
  if (heading.empty() || !IsMark(*tokens, at + 4)) return;
  std::vector<NamedThing> named;
  std::size_t next = at + 5;
  while (true) {
    while (IsOneOf(WordAt(*tokens, next), {"the", "turns", "changes", "gives", "way", "to", "into",
                                           "and", "then", "finally"}) ||
           IsMark(*tokens, next)) {
      ++next;
    }
    const std::size_t length = MatchClassWord(*tokens, next).tokens;
    if (length == 0) break;
    const std::string name = JoinWords(*tokens, next, next + length);
    if (named.empty() || JoinWords(*tokens, named.back().begin, named.back().end) != name)
      named.push_back({next, next + length});
    next += length;
  }
  if (named.size() < 3 || !IsStopAt(*tokens, next)) return;
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  for (const std::string_view word : {std::string_view("from"), OppositeOf(heading),
                                      std::string_view("to"), std::string_view(heading)}) {
    said.push_back(WordLike(word, beside));
  }
  for (std::size_t i = 0; i < named.size(); ++i) {
    said.push_back(CommaLike(beside));
    if (i > 0) said.push_back(WordLike("then", beside));
    for (const Token& token : TokensBetween(*tokens, named[i].begin, named[i].end))
      said.push_back(token);
  }
  EraseTokens(tokens, at, next - at);
  InsertTokens(tokens, at, said);
}

}  // namespace

void TurnMotions(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnOnItsBank(tokens, at);
    TurnBranchesOff(tokens, at);
    TurnWhereItEnds(tokens, at);
    TurnBefore(tokens, at);
    TurnOnTheWay(tokens, at);
    TurnAnotherJoins(tokens, at);
    TurnPastTo(tokens, at);
    TurnEachDirection(tokens, at);
    TurnRunsBetween(tokens, at);
    TurnGoingLast(tokens, at);
    TurnTurnsTo(tokens, at);
  }
}

}  // namespace latticeworld
