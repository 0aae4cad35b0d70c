#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain_turns.h"
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

constexpr std::size_t kPhrase = 5;  // words of "with a few houses"

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

// "Around it sand, around that forest": around the sand is forest.
void TurnAroundThat(std::vector<Token>* tokens, std::size_t at) {
  const bool opens = at > 0 && (IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and");
  if (!opens || WordAt(*tokens, at) != "around" || WordAt(*tokens, at + 1) != "that") return;
  const std::size_t length = MatchClassWord(*tokens, at + 2).tokens;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (length == 0 || !IsPauseAt(*tokens, at + 2 + length) || named.empty()) return;
  std::vector<std::string> words = {"the"};
  for (std::size_t i = named[0].begin; i < named[0].end; ++i) words.emplace_back((*tokens)[i].text);
  words.emplace_back("is");
  ReplaceTokens(tokens, at + 1, 1, {words.begin(), words.end()});
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
    TurnSizedOne(tokens, at);
    TurnOfWhich(tokens, at);
    TurnAroundThat(tokens, at);
    TurnBridge(tokens, at);
  }
}

}  // namespace latticeworld
