#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Sides and things that words point to: "that", "which", "the other", "one", "the bridge".
namespace latticeworld {
namespace {

void PutSideOf(std::vector<Token>* tokens, std::size_t at, std::size_t count,
               std::string_view heading, const NamedThing& thing) {
  std::vector<std::string> words = {"to", "the", std::string(heading), "of", "the"};
  for (std::size_t i = thing.begin; i < thing.end; ++i) words.emplace_back((*tokens)[i].text);
  ReplaceTokens(tokens, at, count, {words.begin(), words.end()});
}

// "The fields east of it and the wood east of that", "... and the wood further east still": east of
// the fields.
void TurnFurther(std::vector<Token>* tokens, std::size_t at) {
  const bool further = IsOneOf(WordAt(*tokens, at), {"further", "farther"});
  std::size_t side = at + (further ? 1 : 0);
  if (further && WordAt(*tokens, side) == "to" && WordAt(*tokens, side + 1) == "the") side += 2;
  std::string heading(SideWord(WordAt(*tokens, side)));
  if (heading.empty()) return;
  std::size_t end = side + 1;
  // "further to the south-west"
  const bool rows = heading == "north" || heading == "south";
  if (rows && IsOneOf(WordAt(*tokens, end), {"east", "west"})) heading += WordAt(*tokens, end++);
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
  const std::vector<NamedThing> named = NamedBefore(*tokens, begin);
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

bool SaysAt(const std::vector<Token>& tokens, std::size_t at,
            std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words)
    if (WordAt(tokens, at++) != word) return false;
  return true;
}

constexpr std::size_t kPhrase = 5;  // words of "with a few houses"

// Returns the thing whose sides "on one side" are, at `at`: "a road with houses on one side", "a
// river divides the map in two: houses on one side". Empty: nobody's.
std::vector<Token> LineWithSides(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t with = at;
  while (with > 0 && with + kPhrase > at &&
         !IsOneOf(WordAt(tokens, with), {"with", "has", "have", "having"})) {
    --with;
  }
  if (IsOneOf(WordAt(tokens, with), {"with", "has", "have", "having"})) {
    if (with > 0 && IsOneOf(WordAt(tokens, with - 1), {"that", "which"})) --with;
    const std::vector<NamedThing> named = NamedBefore(tokens, with);
    const bool line =
        !named.empty() && named[0].end == with && MatchClassWord(tokens, named[0].begin).is_line();
    return line ? SaidLike("of it", tokens[at]) : std::vector<Token>();
  }
  // The clause before has one line and nothing else: "a river crosses the map", "splits it in two".
  std::size_t pause = at;
  while (pause > 0 && !IsPauseAt(tokens, pause)) --pause;
  if (pause == 0) return {};
  const std::vector<NamedThing> named = NamedBefore(tokens, pause);
  const std::size_t begin = SentenceBegin(tokens, pause);
  const bool alone =
      !named.empty() && named[0].begin >= begin && (named.size() == 1 || named[1].begin < begin);
  if (!alone || !MatchClassWord(tokens, named[0].begin).is_line()) return {};
  for (std::size_t i = named[0].end; i < pause; ++i) {
    if (!IsOneOf(WordAt(tokens, i), {"divides", "splits", "crosses", "cuts", "halves", "bisects",
                                     "runs", "flows", "separates", "parts"})) {
      continue;
    }
    return SaidLike("of the " + JoinWords(tokens, named[0].begin, named[0].end), tokens[at]);
  }
  return {};
}

// "A road with houses on one side and fields on the other", "houses on one side of the road, fields
// on the other", "... and on the other there is only meadow": on the other side of it.
void TurnTwoSides(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "one" ||
      WordAt(*tokens, at + 2) != "side") {
    return;
  }
  // The owner is said, "of the road", or is the line before.
  std::size_t next = at + 3;
  const bool own = WordAt(*tokens, next) == "of";
  std::vector<Token> owner;
  if (own) {
    std::size_t close = next;
    while (!IsPauseAt(*tokens, close) &&
           !IsOneOf(WordAt(*tokens, close), {"and", "there", "is", "are", "lies", "lie"})) {
      ++close;
    }
    owner = TokensBetween(*tokens, next, close);
  } else {
    owner = LineWithSides(*tokens, at);
  }
  if (owner.empty()) return;
  // "on the other" later in the sentence gets the side and the owner as well.
  for (std::size_t i = next; !IsStopAt(*tokens, i); ++i) {
    if (WordAt(*tokens, i) != "on" || WordAt(*tokens, i + 1) != "the" ||
        !IsOneOf(WordAt(*tokens, i + 2), {"other", "opposite"})) {
      continue;
    }
    std::size_t end = i + 3;
    if (WordAt(*tokens, end) == "side") ++end;
    std::size_t thing = end;
    while (IsOneOf(WordAt(*tokens, thing), {"there", "is", "are", "lies", "lie", "only", "just"}))
      ++thing;
    if (WordAt(*tokens, thing) == "nothing" && WordAt(*tokens, thing + 1) == "but") thing += 2;
    const bool joined = WordAt(*tokens, i - 1) == "and" && !IsMark(*tokens, i - 2);
    const bool told = own && (thing > end || joined) && TakeNounSpan(*tokens, thing).found() &&
                      !IsPauseAt(*tokens, next + owner.size());
    if (!IsPauseAt(*tokens, end) && !told) return;
    if (told) {
      ReplaceTokens(tokens, i, thing - i, {"on", "the", "other", "side", "there", "is"});
    } else {
      ReplaceTokens(tokens, i, end - i, {"on", "the", "other", "side"});
    }
    InsertTokens(tokens, i + 4, owner);
    if (!own) InsertTokens(tokens, next, owner);
    return;
  }
}

// "A river divides the map into two halves, one wooded and the other rocky": forest on one side of
// the river and rocks on the other side of it.
void TurnOneAndOther(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || WordAt(*tokens, at + 1) != "one") return;
  const std::size_t is = IsOneOf(WordAt(*tokens, at + 2), {"is", "of", "being"}) ? 1 : 0;
  const std::size_t and_at = at + 3 + is;
  if (!IsMark(*tokens, and_at) && WordAt(*tokens, and_at) != "and") return;
  const std::size_t other = and_at + (WordAt(*tokens, and_at + 1) == "and" ? 2 : 1);
  if (!SaysAt(*tokens, other, {"the", "other"})) return;
  const std::size_t second = other + 2 + (WordAt(*tokens, other + 2) == "is" ? 1 : 0);
  const std::string_view lands[] = {LandOfAdjective(WordAt(*tokens, at + 2 + is)),
                                    LandOfAdjective(WordAt(*tokens, second))};
  const std::vector<Token> owner = LineWithSides(*tokens, at + 1);
  if (lands[0].empty() || lands[1].empty() || owner.empty() || !IsPauseAt(*tokens, second + 1)) {
    return;
  }
  const std::string sides[] = {" on one side ", " on the other side "};
  std::string said = ".";
  for (int i = 0; i < 2; ++i) {
    said += (i == 0 ? " " : " and ") + std::string(lands[i]) + sides[i] +
            JoinWords(owner, 0, owner.size());
  }
  const std::vector<Token> turned = SaidLike(said, (*tokens)[at + 1]);
  EraseTokens(tokens, at, second + 1 - at);
  InsertTokens(tokens, at, turned);
}

// "The lake borders the forest on one side and the town on the other": both of them.
void TurnBordersTwo(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"borders", "border", "touches", "touch", "adjoins", "adjoin",
                                     "meets", "meet", "bordering", "touching"})) {
    return;
  }
  const NounSpan one = TakeNounSpan(*tokens, at + 1);
  if (!one.found() || !SaysAt(*tokens, one.end, {"on", "one", "side"})) return;
  std::size_t next = one.end + 3;
  if (IsMark(*tokens, next)) ++next;
  if (WordAt(*tokens, next) == "and") ++next;
  const NounSpan two = TakeNounSpan(*tokens, next);
  if (next == one.end + 3 || !two.found() || !SaysAt(*tokens, two.end, {"on", "the", "other"})) {
    return;
  }
  const std::size_t end = two.end + (WordAt(*tokens, two.end + 3) == "side" ? 4 : 3);
  if (!IsPauseAt(*tokens, end)) return;
  EraseTokens(tokens, two.end, end - two.end);
  ReplaceTokens(tokens, one.end, next - one.end, {"and"});
}

// "A small forest west of the house and a big one east of it": a big forest.
void TurnSizedOne(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "one" || at < 2 || !IsSize(WordAt(*tokens, at - 1)) ||
      !IsOneOf(WordAt(*tokens, at - 2), {"a", "the", "another"})) {
    return;
  }
  for (std::size_t i = at - 2; i-- > 0 && !IsStopAt(*tokens, i);) {
    const std::size_t length = MatchClassWord(*tokens, i + 1).tokens;
    if (!IsSize(WordAt(*tokens, i)) || length == 0) continue;
    std::vector<Token> name;
    for (std::size_t k = i + 1; k < i + 1 + length; ++k)
      name.push_back(WordLike((*tokens)[k].text, (*tokens)[at]));
    EraseTokens(tokens, at, 1);
    InsertTokens(tokens, at, name);
    return;
  }
}

// "A river, north of which everything is forest", "a lake from which a river flows": north of it,
// from it.
void TurnOfWhich(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "which" || at < 2) return;
  std::size_t begin = at - 1;
  if (WordAt(*tokens, begin) == "of") {
    --begin;
    if (HeadingWord(WordAt(*tokens, begin)).empty()) return;
    if (begin >= 2 && WordAt(*tokens, begin - 1) == "the" && WordAt(*tokens, begin - 2) == "to")
      begin -= 2;
  } else if (WordAt(*tokens, begin) != "from") {
    return;
  }
  if (begin == 0 || IsStopAt(*tokens, begin - 1)) return;
  (*tokens)[at].text = "it";
  if (WordAt(*tokens, begin - 1) == "and") --begin, EraseTokens(tokens, begin, 1);
  const bool comma = (*tokens)[begin - 1].kind == TokenKind::kComma;
  if (comma) {
    (*tokens)[begin - 1] = StopLike((*tokens)[begin - 1]);
  } else {
    InsertTokens(tokens, begin, {StopLike((*tokens)[begin])});
  }
}

// "Around it sand, around that forest", "and around that is rock": around the sand is forest.
void TurnAroundThat(std::vector<Token>* tokens, std::size_t at) {
  const bool opens = at > 0 && (IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and");
  if (!opens || WordAt(*tokens, at) != "around" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"that", "this", "those", "these"})) {
    return;
  }
  std::size_t verb = at + 2;
  while (IsOneOf(WordAt(*tokens, verb), {"there", "is", "are", "lies", "comes", "lie", "come"}))
    ++verb;
  const NounSpan span = TakeNounSpan(*tokens, verb);
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  const bool ends = IsPauseAt(*tokens, span.end) || WordAt(*tokens, span.end) == "and";
  if (!span.found() || !ends || named.empty()) return;
  if (verb == at + 2 && span.noun > span.begin) return;  // "around that old town"
  std::vector<std::string> words = {"the"};
  for (std::size_t i = named[0].begin; i < named[0].end; ++i) words.emplace_back((*tokens)[i].text);
  words.emplace_back("is");
  ReplaceTokens(tokens, at + 1, verb - at - 1, {words.begin(), words.end()});
}

// "Houses around the bridge", where a road and a river are named: near both.
void TurnBridge(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "close" && WordAt(*tokens, at + 1) == "to") ++at;
  if (!IsOneOf(WordAt(*tokens, at), {"around", "at", "by", "near", "beside", "to"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"the", "that", "this"}) ||
      WordAt(*tokens, at + 2) != "bridge" ||
      (WordAt(*tokens, at) == "to" && (at == 0 || WordAt(*tokens, at - 1) != "close"))) {
    return;
  }
  std::string road, river;
  for (std::size_t i = 0; i < tokens->size(); ++i) {
    const ClassWordMatch noun = MatchClassWord(*tokens, i);
    if (noun.tokens != 1 || noun.word->shape != WordShape::kLine) continue;
    (noun.word->wild == 'W' ? river : road) = (*tokens)[i].text;
  }
  if (road.empty() || river.empty() || road == "bridge") return;
  if (WordAt(*tokens, at) == "to") EraseTokens(tokens, --at, 1);
  ReplaceTokens(tokens, at, 3, {"near", "the", road, "and", "near", "the", river});
}

}  // namespace

void TurnPointers(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnFurther(tokens, at);
    TurnTwoSides(tokens, at);
    TurnBordersTwo(tokens, at);
    TurnOneAndOther(tokens, at);
    TurnSizedOne(tokens, at);
    TurnOfWhich(tokens, at);
    TurnAroundThat(tokens, at);
    TurnBridge(tokens, at);
  }
}

}  // namespace latticeworld
