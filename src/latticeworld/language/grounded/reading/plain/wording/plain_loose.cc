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

// Words that are used loosely, left over or left out.
namespace latticeworld {
namespace {

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
  if (IsOneOf(letter, {"s", "u", "c", "l"}) && IsPauseAt(*tokens, next + 1))
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
    // "On the other hand" goes together with the commas around it.
    const bool before = at > 0 && (*tokens)[at - 1].kind == TokenKind::kComma;
    const bool after = IsPauseAt(*tokens, at + 4) && !IsStopAt(*tokens, at + 4);
    EraseTokens(tokens, at - (before ? 1 : 0), 4 + (before ? 1 : 0) + (after ? 1 : 0));
  } else if (word == "times" && next == "the" && WordAt(*tokens, at + 2) == "size" &&
             WordAt(*tokens, at + 3) == "of" && at > 0 && !IsPauseAt(*tokens, at - 1)) {
    ReplaceTokens(tokens, at - 1, 5, {"larger", "than"});
  } else if (word == "all" && next == "the" && WordAt(*tokens, at + 2) == "way" &&
             WordAt(*tokens, at + 3) == "around" && IsPauseAt(*tokens, at + 4)) {
    EraseTokens(tokens, at + 1, 2);
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
      !IsOneOf(WordAt(*tokens, at + 1), {"saw", "see", "met", "found"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"a", "an", "any"})) {
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

void TurnLoose(std::vector<Token>* tokens) {
  TurnFigures(tokens);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAsides(tokens, at);
    TurnLetterShape(tokens, at);
    TurnLooseWords(tokens, at);
    TurnLikeA(tokens, at);
    TurnLinedAround(tokens, at);
    TurnUpTo(tokens, at);
    TurnNone(tokens, at);
    TurnTerse(tokens, at);
  }
}

}  // namespace latticeworld
