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

// Sides, sizes and shapes of what words point to: "that", "which", "the other", "one".
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

bool IsSize(std::string_view word) {
  return IsOneOf(word, {"small", "smaller", "little", "tiny", "big", "bigger", "large", "larger",
                        "huge", "long", "short", "wide", "narrow"});
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

// "South of all three", "in the land between them", "a lake besides the wood", "a road round our
// town", "a track splitting it down the middle": south of them, between them, beside the wood,
// around our town, down the middle.
void TurnLooseWords(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at), next = WordAt(*tokens, at + 1);
  const bool after_word = at > 0 && !IsPauseAt(*tokens, at - 1);
  if (word == "of" && next == "all" &&
      IsOneOf(WordAt(*tokens, at + 2), {"three", "four", "five"}) && IsPauseAt(*tokens, at + 3)) {
    ReplaceTokens(tokens, at + 1, 2, {"them"});
  } else if (word == "in" && next == "the" &&
             IsOneOf(WordAt(*tokens, at + 2), {"land", "space", "area", "gap", "country"}) &&
             WordAt(*tokens, at + 3) == "between") {
    EraseTokens(tokens, at, 3);
  } else if (word == "besides" && after_word && IsOneOf(next, {"the", "a", "my", "our"})) {
    (*tokens)[at].text = "beside";
  } else if (word == "round" && after_word && IsOneOf(next, {"the", "a", "my", "our", "its"}) &&
             !IsOneOf(WordAt(*tokens, at - 1), {"a", "the", "very", "perfectly", "all"})) {
    (*tokens)[at].text = "around";
  } else if (IsOneOf(word, {"splitting", "dividing", "cutting", "bisecting"}) && next == "it" &&
             IsOneOf(WordAt(*tokens, at + 2), {"down", "through", "in"})) {
    EraseTokens(tokens, at, 2);
  } else if (word == "on" && next == "the" && WordAt(*tokens, at + 2) == "other" &&
             WordAt(*tokens, at + 3) == "hand") {
    // With the commas around it.
    const bool before = at > 0 && (*tokens)[at - 1].kind == TokenKind::kComma;
    const bool after = IsPauseAt(*tokens, at + 4) && !IsStopAt(*tokens, at + 4);
    EraseTokens(tokens, at - (before ? 1 : 0), 4 + (before ? 1 : 0) + (after ? 1 : 0));
  } else if (word == "times" && next == "the" && WordAt(*tokens, at + 2) == "size" &&
             WordAt(*tokens, at + 3) == "of" && at > 0 && !IsPauseAt(*tokens, at - 1)) {
    ReplaceTokens(tokens, at - 1, 5, {"larger", "than"});
  } else if (word == "all" && next == "the" && WordAt(*tokens, at + 2) == "way" &&
             IsOneOf(WordAt(*tokens, at + 3), {"round", "around"}) && IsPauseAt(*tokens, at + 4)) {
    EraseTokens(tokens, at, 4);
  } else if (word == "cells" && next == "at" && at > 1 && IsPauseAt(*tokens, at - 2)) {
    // "well away from it, ten cells at the very least"
    std::size_t end = at + 2;
    while (IsOneOf(WordAt(*tokens, end), {"the", "very", "least"})) ++end;
    if (WordAt(*tokens, end - 1) == "least" && !IsStopAt(*tokens, at - 2))
      EraseTokens(tokens, at - 2, end - at + 2);
  } else if (IsOneOf(word, {"is", "are"}) && next == "used" && WordAt(*tokens, at + 2) == "for" &&
             IsOneOf(WordAt(*tokens, at + 3),
                     {"farming", "agriculture", "crops", "cultivation", "grazing", "housing"})) {
    const std::string_view use = WordAt(*tokens, at + 3);
    const std::string_view land = use == "grazing"   ? "pasture"
                                  : use == "housing" ? "houses"
                                                     : "farmland";
    ReplaceTokens(tokens, at + 1, 3, {land});
  } else if (IsOneOf(word, {"leave", "give"}) && next == "the" &&
             IsOneOf(WordAt(*tokens, at + 2), {"rest", "remainder"}) &&
             WordAt(*tokens, at + 3) == "to") {
    (*tokens)[at + 3].text = "is";
    EraseTokens(tokens, at, 1);
  } else if (IsOneOf(word, {"first", "second"}) && at > 0 &&
             IsOneOf(next, {"from", "going", "running"}) &&
             (word == "first" ? IsPauseAt(*tokens, at - 1) : WordAt(*tokens, at - 1) == "and")) {
    (*tokens)[at].text = "one";
  } else if (IsOneOf(word, {"splits", "divides", "forks"}) && IsOneOf(next, {"in", "into"}) &&
             WordAt(*tokens, at + 2) == "two" &&
             IsOneOf(WordAt(*tokens, at + 3), {"arms", "branches", "channels"}) &&
             WordAt(*tokens, at + 4) == "around") {
    ReplaceTokens(tokens, at, 5, {"surrounds"});
  } else if (IsOneOf(word, {"spit", "tongue", "bar", "neck"}) && next == "of" &&
             NamesThing(*tokens, at + 2)) {
    (*tokens)[at].text = "strip";
  }
}

// "Nor are there any roads", "lake-free", "never saw a house, a stream or so much as a puddle": no
// roads, no lake, no house, no stream, no puddle.
void TurnNone(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "nor" && IsOneOf(WordAt(*tokens, at + 1), {"are", "is"}) &&
      WordAt(*tokens, at + 2) == "there") {
    std::size_t end = at + 3;
    if (IsOneOf(WordAt(*tokens, end), {"any", "a"})) ++end;
    if (MatchClassWord(*tokens, end).tokens > 0) ReplaceTokens(tokens, at, end - at, {"no"});
    return;
  }
  const std::size_t length = MatchClassWord(*tokens, at).tokens;
  const std::size_t free = at + length;
  if (length > 0 && WordAt(*tokens, free) == "free" &&
      (IsPauseAt(*tokens, free + 1) || WordAt(*tokens, free + 1) == "and") &&
      (at == 0 || IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and")) {
    EraseTokens(tokens, free, 1);
    InsertTokens(tokens, at, {WordLike("no", (*tokens)[at])});
    return;
  }
  if (WordAt(*tokens, at) != "never" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"saw", "see", "met", "found"})) {
    return;
  }
  bool more = false;
  for (std::size_t i = at + 2; !IsStopAt(*tokens, i); ++i) {
    if (WordAt(*tokens, i) == "so" && WordAt(*tokens, i + 1) == "much") {
      EraseTokens(tokens, i, WordAt(*tokens, i + 2) == "as" ? 3 : 2);
    }
    if (!IsOneOf(WordAt(*tokens, i), {"a", "an", "any"})) continue;
    if (WordAt(*tokens, i - 1) == "or") (*tokens)[i - 1].text = "and";
    (*tokens)[i].text = "no";
    more = true;
  }
  if (more) EraseTokens(tokens, at, 2);
}

// "Snow 30, rock 30, all figures in percent": 30 percent each.
void TurnFigures(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "all" ||
        !IsOneOf(WordAt(*tokens, at + 1), {"figures", "numbers", "values"}) ||
        WordAt(*tokens, at + 2) != "in" || !IsOneOf(WordAt(*tokens, at + 3), {"percent", "per"})) {
      continue;
    }
    std::size_t end = at + 4;
    if (WordAt(*tokens, end) == "cent") ++end;
    std::size_t begin = at;
    if (begin > 0 && IsPauseAt(*tokens, begin - 1)) --begin;
    EraseTokens(tokens, begin, end - begin);
    for (std::size_t i = begin; i-- > 0 && !IsStopAt(*tokens, i);)
      if ((*tokens)[i].kind == TokenKind::kNumber)
        InsertTokens(tokens, i + 1, {WordLike("percent", (*tokens)[i])});
    return;
  }
}

// "A road leads from the south up to a couple of sheds": to them, not at most so many.
void TurnUpTo(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "up" || WordAt(*tokens, at + 1) != "to" || at == 0 ||
      WordAt(*tokens, at - 1) == "from") {
    return;
  }
  for (std::size_t i = at; i-- > 0 && !IsPauseAt(*tokens, i);) {
    if (!IsOneOf(WordAt(*tokens, i), {"leads", "goes", "runs", "climbs", "winds", "leading",
                                      "going", "running", "lead", "go", "run"})) {
      continue;
    }
    EraseTokens(tokens, at, 1);
    return;
  }
}

// "Mostly bare ground, like a quarry": which is a likeness.
void TurnLikeA(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || (*tokens)[at].kind != TokenKind::kComma || WordAt(*tokens, at + 1) != "like" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"a", "an"}) ||
      MatchClassWord(*tokens, at + 3).tokens == 0) {
    return;
  }
  EraseTokens(tokens, at, PauseAfter(*tokens, at + 1) - at);
}

// "Trees line the shore of the lake all around": surround the lake.
void TurnLinedAround(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"line", "lines", "follow", "follows"})) return;
  const std::size_t pause = PauseAfter(*tokens, at);
  if (pause < at + 4 || !IsOneOf(WordAt(*tokens, pause - 1), {"around", "round"}) ||
      WordAt(*tokens, pause - 2) != "all") {
    return;
  }
  EraseTokens(tokens, pause - 2, 2);
  (*tokens)[at].text = "surround";
  for (std::size_t i = at + 1; i + 1 < pause - 2; ++i)
    if (IsOneOf(WordAt(*tokens, i), {"shore", "shores", "banks", "edge"}) &&
        WordAt(*tokens, i + 1) == "of") {
      EraseTokens(tokens, at + 1, i + 1 - at);
      return;
    }
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

// "Lake. Big. Middle.": a sentence.
void TurnTerse(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || at + 2 >= tokens->size() || !IsStopAt(*tokens, at) || (*tokens)[at].text != "." ||
      !IsStopAt(*tokens, at + 2)) {
    return;
  }
  const std::string_view word = WordAt(*tokens, at + 1);
  std::size_t begin = at;  // of the sentence before, which is as terse
  while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
  const bool terse = at - begin <= 2 && MatchClassWord(*tokens, begin).tokens > 0;
  if (terse && (IsSize(word) || !SideWord(word).empty() || IsCenterWord(word)))
    EraseTokens(tokens, at, 1);
}

}  // namespace

void TurnPointers(std::vector<Token>* tokens) {
  TurnFigures(tokens);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnFurther(tokens, at);
    TurnTwoSides(tokens, at);
    TurnSizedOne(tokens, at);
    TurnOfWhich(tokens, at);
    TurnAroundThat(tokens, at);
    TurnAsides(tokens, at);
    TurnLetterShape(tokens, at);
    TurnLooseWords(tokens, at);
    TurnLikeA(tokens, at);
    TurnUpTo(tokens, at);
    TurnNone(tokens, at);
    TurnLinedAround(tokens, at);
    TurnBridge(tokens, at);
    TurnTerse(tokens, at);
  }
}

}  // namespace latticeworld
